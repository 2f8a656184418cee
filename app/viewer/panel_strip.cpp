// The pipeline strip: every stage with what went in and came out up to the playhead.
#include "app/viewer/lesson_pointer.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/pipeline/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace hs::viewer {
namespace {

/// For large type: the only name that does not fit everywhere.
std::string_view short_name(trace::Stage stage) {
    return stage == trace::Stage::application ? "app" : name_of(stage);
}

/// What a stage took in and gave out, and what is counted.
struct Flow {
    std::uint64_t in = 0;
    std::uint64_t out = 0;
    const char* unit_in = "";
    const char* unit_out = "";
};

/// Short enough that every stage has room: exact up to a limit, then 100k, 12.3M.
std::string compact(std::uint64_t n, std::uint64_t exact_up_to) {
    if (n <= exact_up_to) {
        return fmt::format("{}", n);
    }
    const auto value = static_cast<double>(n);
    if (n < 1'000'000) {
        return fmt::format("{:.0f}k", value / 1.0e3);
    }
    if (n < 1'000'000'000) {
        return fmt::format("{:.1f}M", value / 1.0e6);
    }
    return fmt::format("{:.1f}G", value / 1.0e9);
}

/// Where scanlines or rays decide what is visible, for the stages that differ.
std::optional<Flow>
swept_flow(trace::Stage stage, const trace::Counters& c, const trace::Recording& recording) {
    if (!recording.settings().sweeps()) {
        return std::nullopt;
    }
    if (stage == trace::Stage::visibility) {
        const std::uint64_t decisions =
            std::accumulate(c.sweeps.begin(), c.sweeps.end(), std::uint64_t{0});
        return Flow{decisions, c.fragments, "decisions", "pixels that show a triangle"};
    }
    if (stage == trace::Stage::traverse) {
        return Flow{c.fragments, c.fragments, "fragments", "fragments interpolated"};
    }
    const std::size_t kept = recording.order.sweep->triangles.size();
    if (stage == trace::Stage::cull && kept > 0) {
        return Flow{
            c.pieces_faced,
            std::min<std::uint64_t>(c.pieces_faced, kept),
            "triangles",
            "triangles kept"};
    }
    return std::nullopt;
}

Flow flow_of(trace::Stage stage, const trace::Counters& c, const trace::Recording& recording) {
    using trace::Stage;
    if (const std::optional<Flow> swept = swept_flow(stage, c, recording)) {
        return *swept;
    }
    std::uint64_t vertices = 0;
    for (const trace::ObjectRange& object : recording.objects) {
        vertices += object.vertex_count;
    }
    switch (stage) {
    case Stage::application: return {recording.objects.size(), vertices, "objects", "vertices"};
    case Stage::vertex: return {vertices, c.vertices, "vertices waiting", "vertices in clip space"};
    case Stage::visibility:
        return {
            recording.order.polygons.size(),
            c.decisions[static_cast<std::size_t>(visibility::OrderEventKind::emit)],
            "polygons to order",
            "polygons in their order"};
    case Stage::clip: return {c.triangles, c.pieces, "triangles", "triangles after clipping"};
    case Stage::divide: return {c.pieces, c.pieces, "triangles", "triangles divided by w"};
    case Stage::viewport:
        return {c.pieces, c.pieces_mapped, "triangles", "triangles in the window"};
    case Stage::cull: return {c.pieces_faced, c.pieces_set_up, "triangles", "triangles kept"};
    case Stage::setup: return {c.pieces_set_up, c.pieces_set_up, "triangles", "triangles set up"};
    case Stage::traverse: return {c.traversal.pixels, c.fragments, "pixels visited", "fragments"};
    case Stage::shade: return {c.fragments, c.fragments_shaded, "fragments", "fragments shaded"};
    case Stage::test:
        return {c.fragments_tested, c.fates[0], "fragments tested", "fragments passed"};
    case Stage::merge: return {c.fates[0], c.fates[0], "fragments", "pixels written"};
    }
    HS_CHECK(false, "every stage has a flow");
    return {};
}

/// What a lesson may point at among a stage's counts.
std::vector<std::string_view> counted_by(trace::Stage stage) {
    using trace::Stage;
    switch (stage) {
    case Stage::vertex: return {"vertices"};
    case Stage::clip: return {"triangles", "pieces"};
    case Stage::traverse: return {"visits", "fragments"};
    case Stage::test: return {"fragments failed"};
    case Stage::merge: return {"fragments written"};
    case Stage::application:
    case Stage::visibility:
    case Stage::divide:
    case Stage::viewport:
    case Stage::cull:
    case Stage::setup:
    case Stage::shade: return {};
    }
    HS_CHECK(false, "every stage is handled");
    return {};
}

struct Cell {
    trace::Stage stage = trace::Stage::application;
    Rect rect;
    bool lit = false;
    std::string counts;
    std::string short_counts; ///< where those do not fit
    std::string tip;
};

void draw_cell(Context& context, const Cell& cell) {
    const Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 min{cell.rect.x, cell.rect.y};
    const ImVec2 max{cell.rect.right(), cell.rect.bottom()};
    const bool hovered = ImGui::IsItemHovered();
    const ImU32 hue = theme.stage(cell.stage);
    if (cell.lit || hovered) {
        list.AddRectFilled(min, max, theme[hovered ? Tone::hovered : Tone::raised]);
    }
    const float bar = theme.pixels(cell.lit ? 4 : 2);
    list.AddRectFilled({min.x, max.y - bar}, {max.x - theme.pixels(1), max.y}, hue);
    const float x = min.x + theme.units(2);
    const float room = cell.rect.width - theme.units(3);
    const bool fits = text_size(theme.fonts.text, name_of(cell.stage)).x <= room;
    ImFont* const font = fits ? theme.fonts.text : theme.fonts.small;
    draw_text(
        list,
        font,
        {x, min.y + theme.units(1)},
        cell.lit ? hue : theme[Tone::text],
        fitting(font, {name_of(cell.stage), short_name(cell.stage)}, room)
    );
    const std::string counts =
        fitting(theme.fonts.small_mono, {cell.counts, cell.short_counts}, room);
    const ImVec2 at{x, min.y + theme.units(6)};
    if (points_at_any(context.viewer, counted_by(cell.stage))) {
        const ImVec2 size = text_size(theme.fonts.small_mono, counts);
        draw_pointing_frame(list, theme, at, {at.x + size.x, at.y + size.y});
    }
    draw_text(list, theme.fonts.small_mono, at, theme[Tone::quiet], counts);
}

/// The vertex stage of the vertex that the inspector shows of the current triangle.
std::optional<trace::StepId> vertex_of_triangle(Context& context) {
    const trace::VertexDetail* vertex = context.document.vertex_detail(context.state.corner);
    if (vertex == nullptr) {
        return std::nullopt;
    }
    const auto step = trace::find_step(
        context.document.recording(),
        fmt::format("vertex stage / object {} / vertex {}", vertex->object, vertex->vertex)
    );
    return step ? std::optional{*step} : std::nullopt;
}

/// Where a click leads: to the same triangle's earlier stages, else to the next such stage, else
/// to the one before.
std::optional<trace::StepId> find_stage(Context& context, trace::Stage stage) {
    using trace::Direction;
    trace::Player& player = context.document.player();
    const trace::Step& current = player.current();
    const bool earlier = current.in_triangle() && stage < trace::stage_of(current.kind);
    if (earlier && stage == trace::Stage::vertex) {
        if (const auto vertex = vertex_of_triangle(context)) {
            return vertex;
        }
    }
    const Direction first = earlier ? Direction::backward : Direction::forward;
    const Direction second = earlier ? Direction::forward : Direction::backward;
    const std::optional<trace::StepId> found = player.find_stage(stage, first);
    return found ? found : player.find_stage(stage, second);
}

void go_to_stage(Context& context, trace::Stage stage) {
    trace::Player& player = context.document.player();
    if (stage == trace::Stage::application) {
        player.seek(0);
        return;
    }
    if (const std::optional<trace::StepId> found = find_stage(context, stage)) {
        player.seek(*found);
    } else {
        context.state.notice =
            fmt::format("No triangle of this frame gets to stage {}.", name_of(stage));
    }
}

} // namespace

void draw_strip(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    begin_panel("strip", rect, theme, false);
    ImGui::PopStyleVar();
    const bool open = context.document.is_open();
    const trace::Counters counters =
        open ? context.document.player().counters() : trace::Counters{};
    const std::vector<trace::Stage> stages =
        strip_stages(open ? context.document.recording().settings() : scene::Settings{});
    const float width = rect.width / static_cast<float>(stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const trace::Stage stage = stages[i];
        Cell cell{
            .stage = stage,
            .rect = {},
            .lit = false,
            .counts = "–",
            .short_counts = "–",
            .tip = ""};
        const auto x0 = static_cast<float>(static_cast<int>(width * static_cast<float>(i)));
        const auto x1 = static_cast<float>(static_cast<int>(width * static_cast<float>(i + 1)));
        cell.rect = {rect.x + x0, rect.y, x1 - x0, rect.height};
        cell.tip = std::string{named(stage).explanation} + ".";
        if (open) {
            const Flow flow = flow_of(stage, counters, context.document.recording());
            cell.lit = trace::stage_of(context.document.player().current().kind) == stage;
            constexpr std::uint64_t five_digits = 99999;
            constexpr std::uint64_t three_digits = 999;
            cell.counts = compact(flow.in, five_digits) + " → " + compact(flow.out, five_digits);
            cell.short_counts =
                compact(flow.in, three_digits) + "→" + compact(flow.out, three_digits);
            cell.tip += fmt::format(
                "\n{} {} → {} {}, up to this step.\nClick to go there.",
                flow.in,
                flow.unit_in,
                flow.out,
                flow.unit_out
            );
        }
        ImGui::SetCursorScreenPos({cell.rect.x, cell.rect.y});
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::InvisibleButton("stage", {cell.rect.width, cell.rect.height}) && open) {
            go_to_stage(context, stage);
        }
        tooltip(cell.tip);
        draw_cell(context, cell);
        ImGui::PopID();
    }
    end_panel();
}

} // namespace hs::viewer
