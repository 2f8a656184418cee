#pragma once

// The only place that names Catch2's header, so that moving to version 3 changes one file.
#include <catch2/catch.hpp>

// Version 2's INFO and WARN bring a semicolon of their own, beside the one that the reader and
// clang-format expect.
#ifdef __clang__
#pragma clang diagnostic ignored "-Wextra-semi-stmt"
#endif
