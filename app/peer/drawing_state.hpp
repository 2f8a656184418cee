// DrawOptions in OpenGL's words. Each draw sets all of the state, so that no picture depends on the
// one before it.
#pragma once

#include "gl_functions.hpp"
#include "osmesa.hpp"

namespace hs::peer {

/// Clears color, triangle ids and depth of the bound target, all of it.
void clear(const Gl& gl, const DrawOptions& options);

/// Everything around the programs: viewport, culling, tests, blending.
void set_fixed_functions(const Gl& gl, const DrawOptions& options);

/// Uploads the levels to this texture object and binds it to unit 0.
void set_texture(const Gl& gl, GLuint name, const Texture& texture);

} // namespace hs::peer
