// A viewer in a window of the desktop: GLFW and OpenGL 3.3.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hs::viewer {
class Viewer;
}

namespace hs::host {

struct WindowOptions {
    int width = 1440;
    int height = 900;
    /// For tests of the window itself: close after so many drawn frames; 0: when the user does.
    int frames = 0;
};

/// Runs until the window is closed. Returns the program's exit status: 0, or 2 after a sentence on
/// stderr when there is no display or no OpenGL 3.3.
int run_in_window(viewer::Viewer& viewer, const WindowOptions& options = {});

} // namespace hs::host
