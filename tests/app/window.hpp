// A viewer in the headless host, with scenes small enough to know every number of.
#pragma once

#include "app/host/headless.hpp"
#include "app/viewer/viewer.hpp"

#include <memory>
#include <string_view>

namespace hs::test {

/// Two triangles on 16 × 16 pixels, clip coordinates given directly: the far one (z = 0.5) drawn
/// first, the near one (z = −0.5) over its upper half.
inline constexpr std::string_view two_layers = R"(
name = "two layers"
[settings]
size = [16, 16]
[camera]
projection = { kind = "identity" }
[[object]]
name = "far"
vertices = [[-1, -1, 0.5], [1, -1, 0.5], [1, 1, 0.5], [-1, 1, 0.5]]
polygons = [[0, 1, 2, 3]]
colors = [[1, 0, 0], [1, 0, 0], [1, 0, 0], [1, 0, 0]]
[[object]]
name = "near"
vertices = [[-1, 0, -0.5], [1, 0, -0.5], [1, 1, -0.5], [-1, 1, -0.5]]
polygons = [[0, 1, 2, 3]]
colors = [[0, 0, 1], [0, 0, 1], [0, 0, 1], [0, 0, 1]]
)";

std::shared_ptr<const trace::Recording> record_text(std::string_view toml);

class Window {
public:
    explicit Window(int width = 1280, int height = 720);

    /// With `two_layers` open, the playhead on the end.
    static std::unique_ptr<Window> with_scene(int width = 1280, int height = 720);

    void settle() { host.settle(viewer); }
    void key(viewer::Key key, bool ctrl = false, bool shift = false, bool alt = false);
    void click(ImVec2 at, host::MouseButton button = host::MouseButton::left);
    [[nodiscard]] const viewer::State& state() const { return viewer.state(); }
    [[nodiscard]] trace::StepId step() const { return viewer.document().player().step(); }

    host::HeadlessHost host;
    viewer::Viewer viewer;
};

} // namespace hs::test
