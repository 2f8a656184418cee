// Mesa's llvmpipe as every oracle test meets it.
#pragma once

#include "app/peer/osmesa.hpp"

namespace hs::tests {

/// One context for the whole run; null, with a warning, where Mesa cannot be used.
peer::Context* mesa();

} // namespace hs::tests
