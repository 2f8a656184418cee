// GLFW's keys as the viewer's.
#pragma once

#include "app/viewer/keys.hpp"

namespace hs::host {

/// Letters and digits by what the keyboard's layout prints on them, the others by place.
viewer::KeyPress translate_key(int key, int scancode, int mods);

} // namespace hs::host
