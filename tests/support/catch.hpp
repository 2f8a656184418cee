#pragma once

// The only place that names Catch2's header, so that moving to version 3 changes one file.
#include <catch2/catch.hpp>
