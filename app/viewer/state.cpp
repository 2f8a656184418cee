#include "app/viewer/state.hpp"

#include <array>

namespace hs {

template <>
std::span<const Named<viewer::ScreenContent>> names<viewer::ScreenContent>() {
    using viewer::ScreenContent;
    static constexpr std::array<Named<ScreenContent>, viewer::screen_content_count> table{{
        {ScreenContent::color, "color", "the color buffer as it is after this step"},
        {ScreenContent::depth, "depth", "the depth buffer as it is after this step"},
        {ScreenContent::triangle, "triangle", "which triangle owns each pixel"},
        {ScreenContent::overdraw, "overdraw", "how many fragments were written to each pixel"},
        {ScreenContent::complexity,
         "complexity",
         "how many fragments each pixel got, written or not"},
        {ScreenContent::edge0,
         "E01",
         "the edge function of vertices 0 and 1: positive on the triangle's side"},
        {ScreenContent::edge1,
         "E12",
         "the edge function of vertices 1 and 2: positive on the triangle's side"},
        {ScreenContent::edge2,
         "E20",
         "the edge function of vertices 2 and 0: positive on the triangle's side"},
        {ScreenContent::barycentric,
         "weights",
         "barycentric weights: how near each pixel is to each vertex"},
    }};
    return table;
}

template <>
std::span<const Named<viewer::Space>> names<viewer::Space>() {
    using viewer::Space;
    static constexpr std::array<Named<Space>, viewer::space_count> table{{
        {Space::object, "object", "as modeled, before any matrix"},
        {Space::world, "world", "where the scene stands, with the camera's view volume"},
        {Space::eye, "eye", "the eye at the origin"},
        {Space::clip,
         "clip",
         "x, y and w before the divide: the view volume is a pyramid of |x|, |y| ≤ w"},
        {Space::ndc, "NDC", "after the divide by w: the view volume is a box"},
    }};
    return table;
}

template <>
std::span<const Named<viewer::InspectorTab>> names<viewer::InspectorTab>() {
    using viewer::InspectorTab;
    static constexpr std::array<Named<InspectorTab>, viewer::inspector_tab_count> table{{
        {InspectorTab::vertex, "vertex", "one vertex through all spaces"},
        {InspectorTab::triangle, "triangle", "clipping, facing and edge functions"},
        {InspectorTab::fragment, "fragment", "weights, tests and colors of one fragment"},
        {InspectorTab::history, "pixel", "every fragment that reached the picked pixel"},
        {InspectorTab::state, "state", "the settings of the current object"},
    }};
    return table;
}

} // namespace hs
