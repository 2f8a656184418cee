#include "app/viewer/screen_overlay.hpp"

#include "app/lesson/session.hpp"
#include "app/viewer/layout.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/lesson_pointer.hpp"
#include "app/viewer/order_overlay.hpp"
#include "app/viewer/sample_overlay.hpp"
#include "app/viewer/screen_picture.hpp"
#include "app/viewer/search.hpp"
#include "app/viewer/sweep_overlay.hpp"
#include "app/viewer/traversal_overlay.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

constexpr float grid_zoom = 6.0F;     ///< window pixels per image pixel from which a grid helps
constexpr float samples_zoom = 16.0F; ///< from which sample centers show
constexpr std::array corner_tones{Tone::vertex_0, Tone::vertex_1, Tone::vertex_2};

/// The drawing under way: where image positions fall.
struct Canvas {
    ImDrawList& list;
    const ScreenView& view;
    const Theme& theme;
    ImVec2 origin;
    PixelRect visible; ///< pixels of the image that are at least partly in the area

    [[nodiscard]] ImVec2 at(float x, float y) const {
        return {origin.x + x * view.zoom, origin.y + y * view.zoom};
    }
    [[nodiscard]] ImVec2 corner(int x, int y) const {
        return at(static_cast<float>(x), static_cast<float>(y));
    }
    [[nodiscard]] ImVec2 center(PixelPos p) const {
        return at(static_cast<float>(p.x) + 0.5F, static_cast<float>(p.y) + 0.5F);
    }
};

Canvas make_canvas(Context& context) {
    const ScreenView& view = context.state.screen;
    const PixelRect image = context.document.recording().settings().image();
    return {
        *ImGui::GetWindowDrawList(),
        view,
        context.theme,
        image_origin(view),
        visible_pixels(view, image)};
}

/// A line that shows on any ground: dark below, bright above.
void line_with_halo(const Canvas& canvas, ImVec2 a, ImVec2 b, ImU32 color) {
    canvas.list.AddLine(a, b, canvas.theme.faded(Tone::halo, 0.7F), canvas.theme.pixels(3));
    canvas.list.AddLine(a, b, color, canvas.theme.pixels(1.25F));
}

void frame_with_halo(const Canvas& canvas, PixelPos pixel, ImU32 color, float width) {
    const ImVec2 a = canvas.corner(pixel.x, pixel.y);
    const ImVec2 b = canvas.corner(pixel.x + 1, pixel.y + 1);
    const float least = canvas.theme.pixels(3); // small pixels are marked by a frame around them
    const float grow = std::max(0.0F, least - canvas.view.zoom * 0.5F);
    const ImVec2 min{a.x - grow, a.y - grow};
    const ImVec2 max{b.x + grow, b.y + grow};
    canvas.list.AddRect(
        min, max, canvas.theme.faded(Tone::halo, 0.8F), 0.0F, 0, canvas.theme.pixels(width + 2.0F)
    );
    canvas.list.AddRect(min, max, color, 0.0F, 0, canvas.theme.pixels(width));
}

void draw_grid(const Canvas& canvas) {
    const PixelRect& v = canvas.visible;
    const ImU32 color = canvas.theme.faded(Tone::grid, 0.55F);
    for (int x = v.x0; x <= v.x1; ++x) {
        const ImVec2 top = canvas.corner(x, v.y0);
        canvas.list.AddLine(top, {top.x, canvas.corner(x, v.y1).y}, color);
    }
    for (int y = v.y0; y <= v.y1; ++y) {
        const ImVec2 left = canvas.corner(v.x0, y);
        canvas.list.AddLine(left, {canvas.corner(v.x1, y).x, left.y}, color);
    }
}

void draw_samples(const Canvas& canvas) {
    const PixelRect& v = canvas.visible;
    const float radius = canvas.theme.pixels(1.5F);
    for (int y = v.y0; y < v.y1; ++y) {
        for (int x = v.x0; x < v.x1; ++x) {
            const ImVec2 c = canvas.center({x, y});
            canvas.list.AddRectFilled(
                {c.x - radius, c.y - radius},
                {c.x + radius, c.y + radius},
                canvas.theme.faded(Tone::grid, 0.9F)
            );
        }
    }
}

/// True when numbers were drawn: the cells are large enough to hold them.
bool draw_numbers(Context& context, const Canvas& canvas, const ScreenPicture& picture) {
    ImFont* font = context.theme.fonts.small_mono;
    const ScreenContent content = context.state.screen.content;
    const bool three = content == ScreenContent::color || content == ScreenContent::barycentric;
    const float line = font->FontSize;
    const float needed_width = text_size(font, "0.0000").x + context.theme.pixels(4);
    const float needed = std::max(needed_width, three ? 3.0F * line : line);
    if (!context.state.screen.show_numbers || canvas.view.zoom < needed) {
        return false;
    }
    const PixelRect& v = canvas.visible;
    for (int y = v.y0; y < v.y1; ++y) {
        for (int x = v.x0; x < v.x1; ++x) {
            const std::vector<std::string> lines = pixel_numbers(context.document, content, {x, y});
            const ImVec2 c = canvas.center({x, y});
            float top = c.y - static_cast<float>(lines.size()) * line * 0.5F;
            for (const std::string& text : lines) {
                const float width = text_size(font, text).x;
                draw_text(
                    canvas.list,
                    font,
                    {c.x - width * 0.5F, top},
                    ink_on(picture.shown({x, y})),
                    text
                );
                top += line;
            }
        }
    }
    return true;
}

/// The current triangle's piece at its snapped, sub-pixel position, vertices named.
void draw_triangle_outline(const Canvas& canvas, const trace::PieceDetail& piece) {
    std::array<ImVec2, 3> corners;
    for (unsigned k = 0; k < 3; ++k) {
        const geometry::WindowVertex& v = piece.window[k];
        if (v.status != geometry::WindowStatus::placed) {
            return;
        }
        corners[k] = canvas.at(to_pixels(v.fixed.x), to_pixels(v.fixed.y));
    }
    const ImU32 color = canvas.theme[Tone::outline];
    const unsigned count = !piece.line ? 3 : piece.line->from == piece.line->to ? 1 : 2;
    for (unsigned k = 0; k < 3; ++k) {
        line_with_halo(canvas, corners[k], corners[(k + 1) % 3], color);
    }
    ImFont* font = canvas.theme.fonts.small_mono;
    for (unsigned k = 0; k < count; ++k) {
        const std::string name = fmt::format("v{}", k);
        const ImVec2 size = text_size(font, name);
        const float pad = canvas.theme.pixels(3);
        const Rect& area = canvas.view.area;
        const ImVec2 place{
            keep_within(corners[k].x + pad, area.x, area.right() - size.x - 2.0F * pad),
            keep_within(corners[k].y - size.y - pad, area.y, area.bottom() - size.y)};
        canvas.list.AddRectFilled(
            {place.x - pad, place.y},
            {place.x + size.x + pad, place.y + size.y},
            canvas.theme[Tone::panel],
            canvas.theme.pixels(2)
        );
        draw_text(canvas.list, font, place, canvas.theme[corner_tones[k]], name);
        canvas.list.AddCircleFilled(
            corners[k], canvas.theme.pixels(3), canvas.theme[corner_tones[k]], 12
        );
    }
}

/// The line where an edge function is 0, with the signs of its sides.
void draw_edge_line(const Canvas& canvas, const trace::PieceDetail& piece, unsigned edge) {
    const auto place = [&](unsigned k) {
        const geometry::WindowVertex& v = piece.window[k];
        return canvas.at(to_pixels(v.fixed.x), to_pixels(v.fixed.y));
    };
    const ImVec2 a = place(edge);
    const ImVec2 b = place((edge + 1) % 3);
    const ImVec2 d{b.x - a.x, b.y - a.y};
    const float length = std::hypot(d.x, d.y);
    if (length < 1.0F || !piece.setup) {
        return;
    }
    const float far = 4.0F * (canvas.view.area.width + canvas.view.area.height) / length;
    const ImU32 color = canvas.theme[Tone::text];
    line_with_halo(
        canvas,
        {a.x - d.x * far, a.y - d.y * far},
        {b.x + d.x * far, b.y + d.y * far},
        IM_COL32(255, 255, 255, 255)
    );

    // The gradient (a, b) of the edge function points to its positive side
    const raster::EdgeFunction& e = piece.setup->edges[edge];
    const auto ga = static_cast<float>(e.a);
    const auto gb = static_cast<float>(e.b);
    const float g = std::hypot(ga, gb);
    const float away = canvas.theme.units(5);
    const ImVec2 middle{(a.x + b.x) * 0.5F, (a.y + b.y) * 0.5F};
    for (const float side : {1.0F, -1.0F}) {
        const float radius = canvas.theme.units(2);
        const Rect& area = canvas.view.area;
        const ImVec2 at{
            keep_within(middle.x + side * away * ga / g, area.x + radius, area.right() - radius),
            keep_within(middle.y + side * away * gb / g, area.y + radius, area.bottom() - radius)};
        canvas.list.AddCircleFilled(at, radius, canvas.theme[Tone::panel], 16);
        const char* const sign = side > 0.0F ? "+" : "−";
        const ImVec2 size = text_size(canvas.theme.fonts.mono, sign);
        draw_text(
            canvas.list,
            canvas.theme.fonts.mono,
            {at.x - size.x * 0.5F, at.y - size.y * 0.5F},
            color,
            sign
        );
    }
}

/// The visited pixel is framed; a filled dot says covered, an empty one not. A pixel being resolved
/// is framed, too.
void draw_visit(const Canvas& canvas, const trace::Step& step, bool several_samples) {
    const ImU32 color = canvas.theme[step.covered ? Tone::pass : Tone::fail];
    frame_with_halo(canvas, step.pixel, color, 2.0F);
    if (several_samples) {
        return; // they are marked one by one
    }
    const float radius = std::clamp(canvas.view.zoom * 0.12F, 2.0F, canvas.theme.units(2));
    const ImVec2 c = canvas.center(step.pixel);
    canvas.list.AddCircleFilled(c, radius + 1.5F, canvas.theme.faded(Tone::halo, 0.8F), 16);
    if (step.covered) {
        canvas.list.AddCircleFilled(c, radius, color, 16);
    } else {
        canvas.list.AddCircle(c, radius, color, 16, canvas.theme.pixels(1.5F));
    }
}

void mark_pixels(
    const Canvas& canvas, const std::vector<PixelPos>& pixels, Tone tone, const char* sign
) {
    ImFont* font = canvas.theme.fonts.small_mono;
    for (const PixelPos pixel : pixels) {
        frame_with_halo(canvas, pixel, canvas.theme[tone], 1.5F);
        const ImVec2 size = text_size(font, sign);
        const ImVec2 c = canvas.center(pixel);
        if (canvas.view.zoom > size.y) {
            const float pad = canvas.theme.pixels(1);
            const ImVec2 min{c.x - size.x * 0.5F - pad, c.y - size.y * 0.5F};
            canvas.list.AddRectFilled(
                min, {min.x + size.x + 2.0F * pad, min.y + size.y}, canvas.theme[Tone::panel], 2.0F
            );
            draw_text(canvas.list, font, {min.x + pad, min.y}, canvas.theme[tone], sign);
        }
    }
}

/// Where rounding of depth decides who is seen, while the panel about that is open.
void draw_fighting(Context& context, const Canvas& canvas) {
    if (!context.state.show_side || context.state.side != SidePanel::precision) {
        return;
    }
    const ImU32 color = canvas.theme.faded(Tone::selected, 0.6F);
    const float half = std::max(1.0F, canvas.view.zoom * 0.7F) * 0.5F;
    const bool every_other = canvas.view.zoom < grid_zoom; // so that the picture shows through
    int left = 20000;                                      // more marks than anyone can tell apart
    for (const PixelPos pixel : context.document.fighting_pixels()) {
        const bool skipped = every_other && (pixel.x + pixel.y) % 2 != 0;
        if (skipped || !canvas.visible.contains(pixel) || left-- <= 0) {
            continue;
        }
        const ImVec2 c = canvas.center(pixel);
        canvas.list.AddRectFilled({c.x - half, c.y - half}, {c.x + half, c.y + half}, color);
    }
}

/// Where the finished picture beside this one differs.
void draw_difference(Context& context, const Canvas& canvas) {
    if (!context.state.beside.show_difference || !context.viewer.shows_beside()) {
        return;
    }
    const ImU32 color = canvas.theme.faded(Tone::selected, 0.6F);
    const float half = std::max(1.0F, canvas.view.zoom * 0.5F) * 0.5F;
    int left = 20000; // more marks than anyone can tell apart
    for (const PixelPos pixel : context.viewer.beside().difference().color) {
        if (canvas.visible.contains(pixel) && left-- > 0) {
            const ImVec2 c = canvas.center(pixel);
            canvas.list.AddRectFilled({c.x - half, c.y - half}, {c.x + half, c.y + half}, color);
        }
    }
}

/// Where fragments or steps match the search, while its panel is open.
void draw_matches(Context& context, const Canvas& canvas) {
    if (!context.state.show_side || context.state.side != SidePanel::search ||
        !context.viewer.search().is_of(context.document)) {
        return;
    }
    const ImU32 color = canvas.theme.faded(Tone::selected, 0.6F);
    const float half = std::max(1.0F, canvas.view.zoom * 0.5F) * 0.5F;
    int left = 20000; // more marks than anyone can tell apart
    for (const PixelPos pixel : context.viewer.search().pixels()) {
        if (canvas.visible.contains(pixel) && left-- > 0) {
            const ImVec2 c = canvas.center(pixel);
            canvas.list.AddRectFilled({c.x - half, c.y - half}, {c.x + half, c.y + half}, color);
        }
    }
}

/// The answer to a question about pixels: picked so far, and once graded what was missed.
void draw_answer(Context& context, const Canvas& canvas) {
    lesson::Session* session = context.viewer.session();
    if (session == nullptr || !session->step().question ||
        session->step().question->kind != lesson::QuestionKind::pixels) {
        return;
    }
    mark_pixels(canvas, context.viewer.lesson_form().picked, Tone::accent, "●");
    if (session->state() == lesson::QuestionState::revealed && session->grade() != nullptr) {
        mark_pixels(canvas, session->grade()->missing, Tone::fail, "○");
        mark_pixels(canvas, session->grade()->extra, Tone::fail, "×");
    }
}

void draw_ramp(
    Context& context, const Rect& rect, const std::string& low, const std::string& high, bool gray
) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = context.theme;
    ImFont* font = theme.fonts.small_mono;
    const float text_y = rect.y + (rect.height - font->FontSize) * 0.5F;
    draw_text(list, font, {rect.x, text_y}, theme[Tone::text], low);
    const float texts = text_size(font, low).x + text_size(font, high).x + theme.units(4);
    const float start = rect.x + text_size(font, low).x + theme.units(2);
    const float width = keep_within(rect.width - texts, theme.units(4), theme.units(30));
    constexpr int steps = 32;
    for (int i = 0; i < steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(steps - 1);
        const float v = 0.12F + 0.85F * t;
        const framebuffer::Rgba8 color =
            gray ? framebuffer::pack({v, v, v, 1.0F})
                 : count_color(static_cast<std::uint32_t>(i), steps - 1);
        const float x0 = start + width * static_cast<float>(i) / static_cast<float>(steps);
        list.AddRectFilled(
            {std::floor(x0), rect.y + theme.units(1)},
            {std::floor(x0 + width / static_cast<float>(steps)) + 1.0F,
             rect.bottom() - theme.units(1)},
            color
        );
    }
    draw_text(list, font, {start + width + theme.units(2), text_y}, theme[Tone::text], high);
}

void draw_keys(
    Context& context, const Rect& rect, std::span<const std::pair<Tone, std::string>> keys
) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = context.theme;
    ImFont* font = theme.fonts.small;
    float x = rect.x;
    const float text_y = rect.y + (rect.height - font->FontSize) * 0.5F;
    for (const auto& [tone, label] : keys) {
        const float side = theme.units(3);
        const float y = rect.y + (rect.height - side) * 0.5F;
        const float needed = side + theme.units(1) + text_size(font, label).x;
        if (x + needed > rect.right()) {
            return;
        }
        list.AddRectFilled({x, y}, {x + side, y + side}, theme[tone], theme.pixels(2));
        draw_text(list, font, {x + side + theme.units(1), text_y}, theme[Tone::text], label);
        x += needed + theme.units(3);
    }
}

/// With a count, where samples are asked.
std::string covered_label(Context& context) {
    const std::string samples = covered_samples_label(context);
    return samples.empty() ? "covered" : samples;
}

/// The color of the picked pixel is that of helper pixels, too.
std::string selected_label(Context& context) {
    if (!context.state.screen.show_helpers) {
        return "picked";
    }
    const trace::HelperPixels& helpers = context.document.helper_pixels();
    return helpers.whole ? fmt::format("picked, {} helpers", helpers.helpers.size())
                         : std::string{"picked; too large for helpers"};
}

} // namespace

ImVec2 image_origin(const ScreenView& view) {
    const float x = view.area.x + view.area.width * 0.5F - view.center.x * view.zoom;
    const float y = view.area.y + view.area.height * 0.5F - view.center.y * view.zoom;
    return {std::floor(x), std::floor(y)};
}

PixelRect visible_pixels(const ScreenView& view, const PixelRect& image) {
    const ImVec2 origin = image_origin(view);
    const auto first = [&](float area, float start) {
        return static_cast<int>(std::floor((area - start) / view.zoom));
    };
    const PixelRect seen{
        first(view.area.x, origin.x),
        first(view.area.y, origin.y),
        first(view.area.right(), origin.x) + 1,
        first(view.area.bottom(), origin.y) + 1};
    return intersect(seen, image);
}

void draw_pixels(Context& context, const ScreenPicture& picture) {
    const Canvas canvas = make_canvas(context);
    const Rect& area = canvas.view.area;
    canvas.list.AddRectFilled(
        {area.x, area.y}, {area.right(), area.bottom()}, context.theme[Tone::canvas]
    );
    const PixelRect& v = canvas.visible;
    if (v.empty()) {
        return;
    }
    const PixelRect image = context.document.recording().settings().image();
    const int block = picture.block();
    const auto texels = [block](int size) {
        const int blocks = (size + block - 1) / block;
        return static_cast<float>(blocks * block);
    };
    const float width = texels(image.width());
    const float height = texels(image.height());
    ImGui::PushClipRect({area.x, area.y}, {area.right(), area.bottom()}, true);
    canvas.list.AddImage(
        picture.texture(),
        canvas.corner(v.x0, v.y0),
        canvas.corner(v.x1, v.y1),
        {static_cast<float>(v.x0) / width, static_cast<float>(v.y0) / height},
        {static_cast<float>(v.x1) / width, static_cast<float>(v.y1) / height}
    );
    ImGui::PopClipRect();
}

void draw_overlays(Context& context, const ScreenPicture& picture) {
    const Canvas canvas = make_canvas(context);
    const ScreenView& view = canvas.view;
    ImGui::PushClipRect({view.area.x, view.area.y}, {view.area.right(), view.area.bottom()}, true);
    const bool numbers = draw_numbers(context, canvas, picture);
    if (view.show_grid && view.zoom >= grid_zoom) {
        draw_grid(canvas);
    }
    const bool several = context.document.recording().samples.active();
    if (!numbers && !several && view.zoom >= samples_zoom) {
        draw_samples(canvas);
    }
    draw_fighting(context, canvas);
    draw_difference(context, canvas);
    draw_matches(context, canvas);
    if (const trace::PieceDetail* piece = context.document.piece_detail()) {
        const bool edge =
            is_of_triangle(view.content) && view.content != ScreenContent::barycentric;
        if (view.show_outline) {
            draw_triangle_outline(canvas, *piece);
        }
        if (edge) {
            const unsigned k =
                static_cast<unsigned>(view.content) - static_cast<unsigned>(ScreenContent::edge0);
            draw_edge_line(canvas, *piece, k);
        }
    }
    draw_ordered_pair(context);
    draw_swept_row(context);
    draw_helper_pixels(context);
    draw_traversal(context);
    draw_sample_points(context);
    const trace::Step& step = context.document.player().current();
    if (step.has_pixel() || step.kind == trace::StepKind::resolve) {
        draw_visit(canvas, step, several);
    }
    if (context.state.selected) {
        frame_with_halo(canvas, *context.state.selected, context.theme[Tone::selected], 1.5F);
    }
    for (const PixelPos pixel : pointed_pixels(context.viewer)) {
        frame_with_halo(canvas, pixel, context.theme[Tone::accent], 1.5F);
    }
    draw_answer(context, canvas);
    ImGui::PopClipRect();
}

void draw_legend(Context& context, const ScreenPicture& picture, const Rect& rect) {
    using Swatch = std::pair<Tone, std::string>;
    const ScreenContent content = context.state.screen.content;
    const ValueRange range = picture.range();
    if (content == ScreenContent::depth) {
        draw_ramp(
            context, rect, explain::number(range.low), explain::number(range.high) + " depth", true
        );
    } else if (content == ScreenContent::overdraw || content == ScreenContent::complexity) {
        const char* const unit = content == ScreenContent::overdraw ? " written" : " fragments";
        draw_ramp(context, rect, "0", fmt::format("{:.0f}{}", range.high, unit), false);
    } else if (content == ScreenContent::barycentric) {
        const std::array keys{
            Swatch{Tone::vertex_0, "λ0"},
            Swatch{Tone::vertex_1, "λ1"},
            Swatch{Tone::vertex_2, "λ2"}};
        draw_keys(context, rect, keys);
    } else if (is_of_triangle(content)) {
        const std::array keys{
            Swatch{Tone::pass, "E ≥ 0: the triangle's side"}, Swatch{Tone::fail, "E < 0"}};
        draw_keys(context, rect, keys);
    } else {
        const std::array keys{
            Swatch{Tone::outline, "triangle"},
            Swatch{Tone::pass, covered_label(context)},
            Swatch{Tone::fail, "not covered"},
            Swatch{Tone::selected, selected_label(context)}};
        draw_keys(context, rect, keys);
    }
}

} // namespace hs::viewer
