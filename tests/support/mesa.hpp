// Mesa's llvmpipe as every oracle test meets it.
#pragma once

#include "app/peer/osmesa.hpp"
#include "tests/support/soup_scene.hpp"

namespace hs::tests {

/// One context for the whole run; null, with a warning, where Mesa cannot be used.
peer::Context* mesa();

/// How wide the viewport is that Mesa draws through.
enum class Sides {
    clip,
    do_not_clip, ///< the same picture; for a soup drawn with `clip_enabled = false`
};

/// The same soup with the same settings. Depth convention and traversal have no counterpart.
peer::Image drawn_by(
    peer::Context& mesa,
    const Soup& soup,
    const scene::Settings& settings,
    Sides sides,
    const scene::Texture* texture = nullptr
);

} // namespace hs::tests
