// Depth precision: how stored values are spread between near and far, how far apart surfaces must
// be to be told apart, and the pixels in which rounding decides.
#include "app/viewer/panels.hpp"
#include "app/viewer/plot.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/depth_precision.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::viewer {
namespace {

using explain::DepthCurve;

/// The curve of the frame, or of the planes that are being dragged.
DepthCurve shown_curve(const Context& context) {
    scene::Camera camera = context.document.scene().camera;
    if (context.state.planes) {
        camera.projection.near = context.state.planes->near;
        camera.projection.far = context.state.planes->far;
    }
    return explain::depth_curve(camera, context.document.recording().settings().depth_convention);
}

/// The middle of what the frame shows, else of the depth values.
double seen_distance(const Context& context, const DepthCurve& curve) {
    const ValueRange& seen = context.document.ranges().depth;
    const double middle = static_cast<double>(seen.low + seen.high) * 0.5;
    const DepthCurve recorded = explain::depth_curve(
        context.document.scene().camera, context.document.recording().settings().depth_convention
    );
    return middle > 0.0 && middle < 1.0 ? recorded.distance(middle)
                                        : explain::distance_of_half(curve);
}

/// Where the close look is taken: at the current vertex, else at what the frame shows.
double looked_at(const Context& context, const DepthCurve& curve) {
    const trace::VertexDetail* vertex = context.document.vertex_detail(context.state.corner);
    const float forward = scene::forward_sign(context.document.scene().camera);
    const double distance = vertex == nullptr ? seen_distance(context, curve)
                                              : static_cast<double>(forward * vertex->work.eye.z);
    const bool between = distance > curve.near && distance < curve.far;
    return between ? distance : explain::distance_of_half(curve);
}

/// Drags show their effect on the curve at once; letting go records the frame anew.
void plane_slider(Context& context, const char* label, bool near_plane) {
    const scene::Projection& projection = context.document.scene().camera.projection;
    PlanesDraft planes =
        context.state.planes.value_or(PlanesDraft{projection.near, projection.far});
    float& value = near_plane ? planes.near : planes.far;
    constexpr float nearest = 0.001F;
    constexpr float farthest = 100000.0F;
    constexpr float apart = 1.01F;
    const float low = near_plane ? nearest : planes.near * apart;
    const float high = near_plane ? planes.far / apart : farthest;
    ImGui::PushID(label);
    ImGui::AlignTextToFramePadding();
    caption(context.theme, label);
    ImGui::SameLine(context.theme.units(13));
    ImGui::SetNextItemWidth(-1.0F);
    const UseFont use{context.theme.fonts.small_mono};
    const ImGuiSliderFlags flags = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;
    if (ImGui::SliderFloat("##plane", &value, low, high, "%.4g", flags)) {
        context.state.planes = planes;
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        scene::Camera camera = context.document.scene().camera;
        camera.projection.near = planes.near;
        camera.projection.far = planes.far;
        context.viewer.change_camera(camera);
    }
    tooltip("What if? Letting go records the frame anew with this plane.");
    ImGui::PopID();
}

/// Sixteen equal parts of all depth values, and the distances they are spent on.
void draw_curve(Context& context, const DepthCurve& curve, double looked) {
    const Theme& theme = context.theme;
    const bool logarithmic = context.state.log_distance && curve.near > 0.0;
    const Plot plot{
        theme, theme.units(44), {curve.near, curve.far, logarithmic}, {0.0, 1.0, false}};
    constexpr int parts = 16;
    for (int i = 1; i < parts; ++i) {
        const double depth = static_cast<double>(i) / parts;
        const double distance = curve.distance(depth);
        const ImU32 color = theme.faded(Tone::quiet, i == parts / 2 ? 0.9F : 0.4F);
        plot.line(curve.near, depth, distance, depth, color, 1.0F);
        plot.line(distance, depth, distance, 0.0, color, 1.0F);
    }
    plot.curve([&](double d) { return curve.depth(d); }, theme[Tone::accent], 2.0F);
    plot.vertical(looked, theme[Tone::vertex_0], 1.0F);
    plot.label_left(0.0, "0", theme[Tone::quiet]);
    plot.label_left(1.0, "1", theme[Tone::quiet]);
    plot.label_left(0.5, "depth", theme[Tone::quiet]);
    plot.label_below(curve.near, fmt::format("{:.3g}", curve.near), theme[Tone::text]);
    plot.label_below(curve.far, fmt::format("distance {:.3g}", curve.far), theme[Tone::text]);
    caption(
        theme,
        fmt::format(
            "Each line is 1/16 of all depth values. Half of them are spent before distance {:.4g}, "
            "the other half on the rest up to {:.4g}.",
            explain::distance_of_half(curve),
            curve.far
        )
    );
}

/// The stairs of the format around one distance.
void draw_stairs(
    Context& context, const DepthCurve& curve, double looked, scene::DepthFormat format
) {
    const Theme& theme = context.theme;
    const double step = explain::depth_step(curve.depth(looked), format);
    const double first = std::floor(curve.depth(looked) / step) - 4.0;
    constexpr int stairs = 9;
    const auto boundary = [&](int i) {
        const double depth = std::clamp((first + i - 0.5) * step, 0.0, 1.0);
        return curve.distance(depth);
    };
    const double start = std::min(boundary(0), boundary(stairs));
    const double end = std::max(boundary(0), boundary(stairs));
    if (!(end > start)) {
        return;
    }
    const double low = (first - 1.0) * step;
    const double high = (first + stairs) * step;
    const Plot plot{theme, theme.units(34), {start, end, false}, {low, high, false}};
    plot.curve([&](double d) { return curve.depth(d); }, theme.faded(Tone::quiet, 0.8F), 1.0F);
    for (int i = 0; i < stairs; ++i) {
        const double depth = (first + i) * step;
        plot.line(boundary(i), depth, boundary(i + 1), depth, theme[Tone::accent], 2.0F);
    }
    plot.vertical(looked, theme[Tone::vertex_0], 1.0F);
    plot.label_below(start, fmt::format("{:.6g}", start), theme[Tone::text]);
    plot.label_below(end, fmt::format("{:.6g}", end), theme[Tone::text]);
    plot.label_left(high, "stored", theme[Tone::quiet]);
    caption(
        theme,
        fmt::format(
            "Close up, with {}: all distances on one stair are the same to the buffer. A stair "
            "here is {:.3g} deep.",
            name_of(format),
            explain::resolved_distance(curve, looked, format)
        )
    );
}

void draw_table(
    Context& context, const DepthCurve& curve, double looked, scene::DepthFormat current
) {
    const Theme& theme = context.theme;
    constexpr std::array formats{
        scene::DepthFormat::unorm16, scene::DepthFormat::unorm24, scene::DepthFormat::float32};
    caption(theme, "How far apart two surfaces must be at a distance:");
    if (!ImGui::BeginTable("resolved", 4, ImGuiTableFlags_SizingStretchSame)) {
        return;
    }
    ImGui::TableNextColumn();
    caption(theme, "distance");
    for (const scene::DepthFormat format : formats) {
        ImGui::TableNextColumn();
        caption(theme, name_of(format), format == current ? Tone::accent : Tone::quiet);
    }
    const double middle = std::sqrt(curve.near * curve.far);
    std::array distances{curve.near, looked, middle, curve.far};
    if (curve.near <= 0.0) {
        distances[2] = (curve.near + curve.far) * 0.5;
    }
    std::ranges::sort(distances);
    const UseFont use{theme.fonts.small_mono};
    for (const double distance : distances) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(
            ImGuiCol_Text, theme[distance == looked ? Tone::vertex_0 : Tone::text]
        );
        ImGui::TextUnformatted(fmt::format("{:.4g}", distance).c_str());
        ImGui::PopStyleColor();
        for (const scene::DepthFormat format : formats) {
            ImGui::TableNextColumn();
            const double apart = explain::resolved_distance(curve, distance, format);
            ImGui::TextUnformatted(fmt::format("{:.3g}", apart).c_str());
        }
    }
    ImGui::EndTable();
}

void draw_fighting(Context& context) {
    const Theme& theme = context.theme;
    const std::size_t count = context.document.fighting_pixels().size();
    if (count == 0) {
        caption(theme, "No pixel of this frame has its two nearest surfaces within two steps.");
        return;
    }
    words(
        theme,
        fmt::format(
            "▼ {} pixels fight: their two nearest fragments are at most two steps apart, so "
            "rounding decides who is seen. They are marked in the screen view.",
            count
        ),
        Tone::fail
    );
}

} // namespace

void draw_precision(Context& context) {
    const Theme& theme = context.theme;
    const scene::Settings& settings = context.document.recording().settings();
    const bool identity =
        context.document.scene().camera.projection.kind == scene::ProjectionKind::identity;
    const DepthCurve curve = shown_curve(context);
    const double looked = looked_at(context, curve);
    heading(theme, "Depth between near and far");
    if (identity) {
        caption(theme, "There is no camera, so no planes to move: depth is linear in z.");
    } else {
        plane_slider(context, "near", true);
        plane_slider(context, "far", false);
    }
    if (curve.near > 0.0) {
        const char* const tip = "equal steps on the axis are equal factors of distance";
        if (button(theme, "log distance", tip, {}, context.state.log_distance)) {
            context.state.log_distance = !context.state.log_distance;
        }
    }
    draw_curve(context, curve, looked);
    draw_stairs(context, curve, looked, settings.depth_format);
    draw_table(context, curve, looked, settings.depth_format);
    heading(theme, "Fighting");
    draw_fighting(context);
}

} // namespace hs::viewer
