#include "app/viewer/screen_view.hpp"

#include "app/lesson/session.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/screen_picture.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

constexpr float largest_zoom = 256.0F;
constexpr float smallest_zoom = 0.05F;

/// Large images start whole, small ones as large as whole pixels allow.
void fit(ScreenView& view, ImVec2 room, const PixelRect& image) {
    const auto width = static_cast<float>(image.width());
    const auto height = static_cast<float>(image.height());
    const float zoom = std::min(room.x / width, room.y / height) * 0.96F;
    view.zoom = zoom >= 1.0F ? std::floor(zoom) : std::max(smallest_zoom, zoom);
    view.center = {width * 0.5F, height * 0.5F};
}

/// Zooms so that the image position under the mouse stays there.
void zoom_at(ScreenView& view, ImVec2 mouse, float notches) {
    const float before = view.zoom;
    const float factor = std::pow(1.25F, notches);
    view.zoom = std::clamp(view.zoom * factor, smallest_zoom, largest_zoom);
    const float dx = mouse.x - (view.area.x + view.area.width * 0.5F);
    const float dy = mouse.y - (view.area.y + view.area.height * 0.5F);
    view.center.x += dx / before - dx / view.zoom;
    view.center.y += dy / before - dy / view.zoom;
    view.fitted = false;
}

std::optional<PixelPos> pixel_under(const ScreenView& view, ImVec2 mouse, const PixelRect& image) {
    const ImVec2 origin = image_origin(view);
    const PixelPos pixel{
        static_cast<int>(std::floor((mouse.x - origin.x) / view.zoom)),
        static_cast<int>(std::floor((mouse.y - origin.y) / view.zoom))};
    return image.contains(pixel) ? std::optional{pixel} : std::nullopt;
}

/// Whether the open question asks for pixels, so that clicks answer it.
bool answers_pixels(Viewer& viewer) {
    lesson::Session* session = viewer.session();
    if (session == nullptr || !session->step().question) {
        return false;
    }
    const bool open = session->state() == lesson::QuestionState::open ||
                      session->state() == lesson::QuestionState::retry;
    return open && session->step().question->kind == lesson::QuestionKind::pixels;
}

void pick(Context& context, PixelPos pixel, bool left) {
    if (left && answers_pixels(context.viewer)) {
        context.viewer.lesson_form().toggle(pixel);
        return;
    }
    context.viewer.select(pixel);
}

void take_mouse(Context& context, const PixelRect& image) {
    ScreenView& view = context.state.screen;
    ImGui::SetCursorScreenPos({view.area.x, view.area.y});
    ImGui::InvisibleButton(
        "pixels",
        {view.area.width, view.area.height},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight
    );
    ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        view.fitted = false;
        view.center.x -= io.MouseDelta.x / view.zoom;
        view.center.y -= io.MouseDelta.y / view.zoom;
    }
    if (!ImGui::IsItemHovered()) {
        return;
    }
    if (io.MouseWheel != 0.0F) {
        zoom_at(view, io.MousePos, io.MouseWheel);
    }
    context.state.hovered = pixel_under(view, io.MousePos, image);
    const float still = io.MouseDragThreshold * io.MouseDragThreshold;
    const bool clicked = ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                         ImGui::IsItemDeactivated() &&
                         io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < still;
    if (context.state.hovered && (clicked || ImGui::IsMouseClicked(ImGuiMouseButton_Right))) {
        pick(context, *context.state.hovered, clicked);
    }
}

std::string values_of(Context& context, PixelPos pixel) {
    std::string text;
    for (const std::string& line :
         pixel_numbers(context.document, context.state.screen.content, pixel)) {
        text += (text.empty() ? "" : " ") + line;
    }
    return text;
}

} // namespace

void draw_screen_view(Context& context, ImVec2 room, ScreenPicture& picture) {
    ScreenView& view = context.state.screen;
    const PixelRect image = context.document.recording().settings().image();
    if (view.fitted) {
        fit(view, room, image);
    }
    take_mouse(context, image);
    picture.update(
        context.document, view, visible_pixels(view, image), context.theme, context.textures
    );
    draw_pixels(context, picture);
    draw_overlays(context, picture);
}

void draw_readout(Context& context, const Rect& rect) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = context.theme;
    const std::optional<PixelPos> pixel =
        context.state.hovered ? context.state.hovered : context.state.selected;
    const float y = rect.y + theme.pixels(2);
    const std::string origin = "origin top-left";
    const float origin_width = text_size(theme.fonts.small, origin).x;
    draw_text(
        list, theme.fonts.small, {rect.right() - origin_width, y}, theme[Tone::quiet], origin
    );
    const float room = rect.width - origin_width - theme.units(2);
    if (!pixel) {
        const std::string hint = fitting(
            theme.fonts.small,
            {"click a pixel to pick it · wheel zooms · drag pans",
             "click picks · wheel zooms · drag pans",
             "click a pixel to pick it",
             "click picks",
             ""},
            room
        );
        draw_text(list, theme.fonts.small, {rect.x, y}, theme[Tone::quiet], hint);
        return;
    }
    const std::string text = fmt::format(
        "{} {}  {} {}",
        context.state.hovered ? "pixel" : "picked",
        explain::pixel(*pixel),
        name_of(context.state.screen.content),
        values_of(context, *pixel)
    );
    draw_text(
        list,
        theme.fonts.small_mono,
        {rect.x, y},
        theme[Tone::text],
        shorten(theme.fonts.small_mono, text, room)
    );
}

} // namespace hs::viewer
