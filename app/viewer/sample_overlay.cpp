#include "app/viewer/sample_overlay.hpp"

#include "app/viewer/screen_overlay.hpp"
#include "app/viewer/viewer.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace hs::viewer {
namespace {

constexpr float points_zoom = 12.0F; ///< window pixels per image pixel from which samples show
constexpr float helpers_zoom = 4.0F; ///< from which helper pixels can be told apart

/// The drawing under way: where image positions fall.
struct Sheet {
    ImDrawList& list;
    const Theme& theme;
    ImVec2 origin;
    float zoom = 1.0F;

    [[nodiscard]] ImVec2 at(float x, float y) const {
        return {origin.x + x * zoom, origin.y + y * zoom};
    }
    [[nodiscard]] ImVec2 sample(PixelPos p, const raster::SampleOffset& offset) const {
        const auto place = [](int pixel, std::int32_t by) {
            return static_cast<float>(pixel) + 0.5F +
                   static_cast<float>(by) / static_cast<float>(subpixel_scale);
        };
        return at(place(p.x, offset.x), place(p.y, offset.y));
    }
    [[nodiscard]] float radius() const { return std::min(zoom * 0.08F, theme.pixels(7)); }
    /// Of the ring around a sample that was asked, and from there to that of the current one.
    [[nodiscard]] float gap() const { return std::min(zoom * 0.05F, theme.pixels(3)); }
};

Sheet make_sheet(Context& context) {
    const ScreenView& view = context.state.screen;
    return {*ImGui::GetWindowDrawList(), context.theme, image_origin(view), view.zoom};
}

/// What every sample holds.
void draw_held(Context& context, const Sheet& sheet) {
    const trace::Player& player = context.document.player();
    const scene::Settings& settings = context.document.recording().settings();
    const auto pattern = raster::sample_pattern(settings.samples);
    const PixelRect visible = visible_pixels(context.state.screen, settings.image());
    for (int y = visible.y0; y < visible.y1; ++y) {
        for (int x = visible.x0; x < visible.x1; ++x) {
            if (player.resolved({x, y})) {
                continue;
            }
            const framebuffer::PixelSamples held = player.samples({x, y});
            for (int s = 0; s < held.count; ++s) {
                const ImVec2 c = sheet.sample({x, y}, pattern[static_cast<std::size_t>(s)]);
                const ImU32 color = framebuffer::pack(held[s].color) | IM_COL32_A_MASK;
                sheet.list.AddCircleFilled(
                    c, sheet.radius() + sheet.theme.pixels(1), sheet.theme[Tone::grid], 16
                );
                sheet.list.AddCircleFilled(c, sheet.radius(), color, 16);
            }
        }
    }
}

/// Rings around the samples the traversal asked or knows to be covered, double around the current
/// one.
void draw_asked(Context& context, const Sheet& sheet) {
    const trace::Step& step = context.document.player().current();
    const auto pattern = raster::sample_pattern(context.document.recording().settings().samples);
    for (const trace::TrailVisit& visit : context.document.trail().visits) {
        for (int s = 0; s < static_cast<int>(pattern.size()); ++s) {
            const bool covered = raster::has_sample(visit.samples, s);
            if (s >= visit.samples_asked && !covered) {
                continue;
            }
            const ImVec2 c = sheet.sample(visit.pixel, pattern[static_cast<std::size_t>(s)]);
            const ImU32 color = sheet.theme[covered ? Tone::pass : Tone::fail];
            const float width = std::min(sheet.gap(), sheet.theme.pixels(covered ? 2.5F : 1.25F));
            const float radius = sheet.radius() + sheet.gap();
            sheet.list.AddCircle(c, radius, color, 16, width);
            if (visit.pixel == step.pixel && step.sample == s) {
                sheet.list.AddCircle(
                    c, radius + 2.0F * sheet.gap(), color, 20, sheet.theme.pixels(2)
                );
            }
        }
    }
}

} // namespace

void draw_sample_points(Context& context) {
    if (!context.document.recording().samples.active() || context.state.screen.zoom < points_zoom) {
        return;
    }
    const Sheet sheet = make_sheet(context);
    draw_held(context, sheet);
    draw_asked(context, sheet);
}

void draw_helper_pixels(Context& context) {
    const ScreenView& view = context.state.screen;
    if (!view.show_helpers || view.zoom < helpers_zoom) {
        return;
    }
    const Sheet sheet = make_sheet(context);
    const PixelRect image = context.document.recording().settings().image();
    const PixelRect visible = visible_pixels(view, image);
    for (const PixelPos p : context.document.helper_pixels().helpers) {
        if (!visible.contains(p)) {
            continue;
        }
        // Hatched, so that the picture shows through
        const auto x = static_cast<float>(p.x);
        const auto y = static_cast<float>(p.y);
        const ImU32 color = sheet.theme.faded(Tone::selected, 0.8F);
        for (const float t : {0.25F, 0.5F, 0.75F, 1.0F}) {
            sheet.list.AddLine(
                sheet.at(x, y + t), sheet.at(x + t, y), color, sheet.theme.pixels(1)
            );
        }
        sheet.list.AddRect(sheet.at(x, y), sheet.at(x + 1.0F, y + 1.0F), color);
    }
}

std::string covered_samples_label(Context& context) {
    const auto& visits = context.document.trail().visits;
    if (!context.document.recording().samples.active() || visits.empty()) {
        return {};
    }
    std::int64_t covered = 0;
    for (const trace::TrailVisit& visit : visits) {
        covered += std::popcount(visit.samples);
    }
    return fmt::format("{} samples covered", explain::whole(covered));
}

} // namespace hs::viewer
