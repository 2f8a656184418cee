#include "app/viewer/lesson_pointer.hpp"

#include "app/lesson/quantity.hpp"
#include "app/lesson/session.hpp"
#include "app/viewer/viewer.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace hs::viewer {
namespace {

std::span<const std::string> highlighted(Viewer& viewer) {
    const lesson::Session* session = viewer.session();
    return session == nullptr ? std::span<const std::string>{}
                              : std::span<const std::string>{session->step().highlight};
}

} // namespace

bool points_at(Viewer& viewer, std::string_view quantity) {
    return std::ranges::any_of(highlighted(viewer), [quantity](const std::string& named) {
        return lesson::is_in_group(quantity, named);
    });
}

bool points_at_any(Viewer& viewer, const std::vector<std::string_view>& quantities) {
    return std::ranges::any_of(quantities, [&viewer](std::string_view quantity) {
        return points_at(viewer, quantity);
    });
}

void draw_pointing_frame(ImDrawList& list, const Theme& theme, ImVec2 min, ImVec2 max) {
    const float out = theme.pixels(2);
    const ImVec2 a{min.x - out, min.y - theme.pixels(1)};
    const ImVec2 b{max.x + out, max.y + theme.pixels(1)};
    list.AddRectFilled(a, b, theme.faded(Tone::accent, 0.16F), theme.pixels(3));
    list.AddRect(a, b, theme[Tone::accent], theme.pixels(3), 0, theme.pixels(1.5F));
}

void frame_if_pointed(const Context& context, const std::vector<std::string_view>& quantities) {
    if (points_at_any(context.viewer, quantities)) {
        draw_pointing_frame(
            *ImGui::GetWindowDrawList(),
            context.theme,
            ImGui::GetItemRectMin(),
            ImGui::GetItemRectMax()
        );
    }
}

std::vector<PixelPos> pointed_pixels(Viewer& viewer) {
    std::vector<PixelPos> pixels;
    const trace::Player& player = viewer.document().player();
    for (const std::string& name : highlighted(viewer)) {
        if (!name.ends_with(" pixels") || viewer.session()->is_hidden(name)) {
            continue;
        }
        const auto value = lesson::read_quantity(name, "", player.recording(), player.current());
        const auto* set = value ? std::get_if<lesson::PixelSet>(&*value) : nullptr;
        if (set != nullptr) {
            pixels.insert(pixels.end(), set->begin(), set->end());
        }
    }
    return pixels;
}

} // namespace hs::viewer
