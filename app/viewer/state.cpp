#include "app/viewer/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

float station(Space space) {
    return static_cast<float>(space) - static_cast<float>(Space::eye);
}

} // namespace

void show_space(SpaceView& view, Space space, float seconds) {
    const bool walks = seconds > 0.0F && is_on_the_way(view.space) && is_on_the_way(space);
    if (!walks) {
        view.space = space;
        view.morph_goal.reset();
        view.morph = is_on_the_way(space) ? station(space) : 0.0F;
        return;
    }
    view.morph_goal = station(space);
    view.morph_seconds = seconds;
}

void set_morph(SpaceView& view, float morph) {
    constexpr float last = 2.0F;
    view.morph = std::clamp(morph, 0.0F, last);
    const int nearest = static_cast<int>(std::lround(view.morph));
    view.space = static_cast<Space>(static_cast<int>(Space::eye) + nearest);
}

void move_on(SpaceView& view, float seconds) {
    if (!view.morph_goal) {
        const bool astray =
            is_on_the_way(view.space) && std::fabs(view.morph - station(view.space)) > 0.5F;
        if (astray) {
            show_space(view, view.space); // `space` was set by a lesson
        }
        return;
    }
    const float step = seconds * 2.0F / view.morph_seconds;
    const float left = *view.morph_goal - view.morph;
    if (std::fabs(left) <= step) {
        set_morph(view, *view.morph_goal);
        view.morph_goal.reset();
    } else {
        set_morph(view, view.morph + std::copysign(step, left));
    }
}

} // namespace hs::viewer

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
        {Space::eye, "eye", "the eye at the origin: the view volume is a pyramid"},
        {Space::clip,
         "clip",
         "x, y and w before the divide: the view volume is a pyramid of |x|, |y| ≤ w"},
        {Space::ndc, "NDC", "after the divide by w: the view volume is a box"},
    }};
    return table;
}

template <>
std::span<const Named<viewer::SidePanel>> names<viewer::SidePanel>() {
    using viewer::SidePanel;
    static constexpr std::array<Named<SidePanel>, viewer::side_panel_count> table{{
        {SidePanel::space, "space", "the meshes in every coordinate space, with the view volume"},
        {SidePanel::beside, "beside", "the same frame with one setting changed, in step"},
        {SidePanel::projection,
         "projection",
         "what the projection matrix does to one point, number by number"},
        {SidePanel::precision,
         "depth",
         "how depth values are spread between the near and the far plane"},
        {SidePanel::clipping, "clip", "the triangle against each plane of the view volume"},
        {SidePanel::cost, "cost", "what the traversal spends, beside all others"},
        {SidePanel::registers,
         "registers",
         "the edge values that an incremental traversal keeps and adds to"},
        {SidePanel::normals,
         "normals",
         "one normal moved by the matrix and by its inverse transpose"},
        {SidePanel::order, "order", "how the order in which triangles are drawn is found"},
        {SidePanel::search, "search", "vertices, triangles, fragments and steps that match"},
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
        {InspectorTab::values, "values", "every value of this step, with where it came from"},
        {InspectorTab::history, "pixel", "every fragment that reached the picked pixel"},
        {InspectorTab::state, "state", "the settings of the current object"},
    }};
    return table;
}

} // namespace hs
