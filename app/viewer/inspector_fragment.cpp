// The inspector's tabs for a fragment, for a pixel's history and for the state it ran under.
#include "app/viewer/formula_view.hpp"
#include "app/viewer/inspector_samples.hpp"
#include "app/viewer/lesson_pointer.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/formulas.hpp"
#include "core/explain/lighting.hpp"
#include "core/explain/line.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/samples.hpp"
#include "core/explain/sentence.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

void color_row(const Theme& theme, const char* label, const glm::vec4& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    ImGui::SameLine(theme.units(16));
    swatch(theme, color);
    ImGui::SameLine();
    mono(theme, explain::point(color));
}

/// What the test of a sample computed.
void draw_step_formulas(Context& context) {
    const trace::Step& step = context.document.player().current();
    if (step.kind != trace::StepKind::sample_test) {
        return;
    }
    const trace::StepDetail& detail = context.document.player().detail();
    for (const explain::Formula& formula :
         explain::formulas(detail, step, context.document.settings())) {
        draw_formula(context, formula, true);
    }
}

void draw_visit(Context& context, const trace::VisitDetail& visit) {
    const trace::PieceDetail* piece = context.document.piece_detail();
    const bool here = context.document.player().current().kind == trace::StepKind::edge_test;
    const trace::StepDetail& detail = context.document.player().detail();
    if (!detail.samples.empty()) {
        draw_sample_edges(context, detail);
        draw_step_formulas(context);
        return;
    }
    if (piece == nullptr || !piece->setup) {
        return;
    }
    const bool squares = context.document.settings().sampling == scene::Sampling::conservative;
    const auto formulas = squares
                              ? explain::square_formulas(*piece->setup, visit.pixel, visit.edges)
                              : explain::edge_formulas(*piece->setup, visit);
    for (const explain::Formula& formula : formulas) {
        draw_formula(context, formula, here);
    }
}

/// Which of a fragment's formulas the current step computed.
bool is_of_step(const explain::Formula& formula, std::span<const explain::Formula> step) {
    return std::ranges::any_of(step, [&formula](const explain::Formula& lit) {
        return lit.title == formula.title;
    });
}

void draw_life(Context& context, const trace::FragmentDetail& fragment) {
    const Theme& theme = context.theme;
    const trace::PieceDetail* piece = context.document.piece_detail();
    const trace::Recording& recording = context.document.recording();
    const bool written = fragment.fate == fragment::FragmentFate::written;
    row(theme, "fate", std::string{name_of(fragment.fate)}, written ? Tone::pass : Tone::fail);
    frame_if_pointed(context, {"fate"});
    caption(theme, std::string{named(fragment.fate).explanation} + ".");
    const trace::PixelBefore before = trace::pixel_before(recording, fragment.index);
    color_row(theme, "before", before.color);
    if (fragment.shaded) {
        color_row(theme, "source", fragment.shaded->color);
        frame_if_pointed(context, {"color.r", "color.g", "color.b", "color.a"});
    }
    color_row(theme, "after", fragment.merge ? fragment.merge->after : before.color);
    if (recording.samples.active()) {
        draw_sample_fates(context, context.document.player().detail());
    }
    ImGui::Separator();
    if (piece == nullptr) {
        return;
    }
    const scene::Settings& settings = context.document.settings();
    const auto of_step = explain::formulas(
        context.document.player().detail(), context.document.player().current(), settings
    );
    // What this step computed comes first, so that it is in sight
    auto all = explain::fragment_formulas(fragment, *piece, settings);
    const auto mixed =
        explain::mixed_color_formulas(*context.document.triangle_detail(), fragment, settings);
    all.insert(all.end(), mixed.begin(), mixed.end());
    for (const bool lit : {true, false}) {
        for (const explain::Formula& formula : all) {
            if (is_of_step(formula, of_step) == lit) {
                draw_formula(context, formula, lit);
            }
        }
    }
}

/// How the frame beside this one came by its color, at the same fragment.
void draw_life_beside(Context& context, PixelPos pixel) {
    if (!context.viewer.shows_beside()) {
        return;
    }
    const Theme& theme = context.theme;
    Document& beside = context.viewer.beside().document();
    const trace::StepDetail& detail = beside.player().detail();
    const scene::Assignment& change = *context.viewer.beside().change();
    heading(theme, fmt::format("Beside: {} = {}", change.path, change.value));
    if (!detail.fragment || detail.fragment->fragment.pixel != pixel) {
        caption(theme, "It stands on no fragment of this pixel.");
        return;
    }
    const trace::FragmentDetail& fragment = *detail.fragment;
    row(theme, "fate", std::string{name_of(fragment.fate)});
    if (fragment.shaded) {
        color_row(theme, "source", fragment.shaded->color);
    }
    Context other{context.viewer, beside, context.state, context.theme, context.textures};
    std::vector<explain::Formula> list =
        explain::mixed_color_formulas(*detail.triangle, fragment, beside.settings());
    if (fragment.lit) {
        list = explain::lighting_formulas(*fragment.shaded->terms, *fragment.lit);
    }
    for (const explain::Formula& formula : list) {
        draw_formula(other, formula, false);
    }
}

/// At its center, or at one of its samples where there are several.
bool covered_by_triangle(const trace::StepDetail& detail) {
    const auto covered = [](const trace::SampleDetail& sample) { return sample.covered; };
    return detail.samples.empty() ? detail.visit->inside
                                  : std::ranges::any_of(detail.samples, covered);
}

// ---- pixel history

/// The pixel before or after all fragments; the lesson may point at what it holds in the end.
void end_row(
    Context& context, const char* label, const glm::vec4& color, float depth, bool pointed
) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    swatch(context.theme, color);
    ImGui::SameLine();
    ImGui::TextUnformatted(label);
    if (pointed) {
        frame_if_pointed(
            context, {"pixel color.r", "pixel color.g", "pixel color.b", "pixel color.a"}
        );
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(explain::number(depth).c_str());
    if (pointed) {
        frame_if_pointed(context, {"pixel depth"});
    }
    ImGui::TableNextColumn();
}

std::string comparison(const trace::HistoryRow& row, const scene::Settings& settings) {
    const std::string_view sign = explain::symbol(settings.depth_test());
    if (settings.visibility != scene::Visibility::z_buffer || sign.empty()) {
        return std::string{name_of(row.fate)};
    }
    const auto [depth, stored] = explain::compared(row.depth, row.stored_depth);
    return fmt::format("{} {} {}: {}", depth, sign, stored, name_of(row.fate));
}

void history_row(Context& context, const trace::HistoryRow& row) {
    const Theme& theme = context.theme;
    trace::Player& player = context.document.player();
    const bool passed = row.fate == fragment::FragmentFate::written;
    const trace::Step& step = player.current();
    const bool current = step.in_fragment() && step.fragment == row.fragment;
    ImGui::TableNextRow();
    if (current) {
        ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, theme[Tone::changed]);
    }
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(row.fragment));
    const bool clicked = ImGui::Selectable(
        "##row", false, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick
    );
    if (clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        player.seek(trace::last_step_of_fragment(player.recording(), row.fragment));
    }
    const scene::Settings& settings =
        context.document.recording().frame->calls()[row.object].settings;
    tooltip(fmt::format(
        "{}\n{}\ndouble click goes to this step",
        trace::primitive_path(context.document.recording(), row.object, row.triangle),
        comparison(row, settings)
    ));
    ImGui::PopID();
    const float line = ImGui::GetTextLineHeight();
    draw_mark(
        *ImGui::GetWindowDrawList(),
        {at.x + line * 0.5F, at.y + line * 0.5F},
        theme.pixels(4),
        passed,
        theme
    );
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({at.x + line + theme.units(1), at.y});
    swatch(theme, row.after);
    ImGui::SameLine();
    const bool several = context.document.recording().objects.size() > 1;
    const std::string number = several ? fmt::format("{} / {}", row.object, row.triangle)
                                       : fmt::format("{}", row.triangle);
    ImGui::TextUnformatted(number.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(explain::number(row.depth).c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, theme[passed ? Tone::pass : Tone::fail]);
    ImGui::TextUnformatted(name_of(row.fate).data());
    ImGui::PopStyleColor();
}

void draw_rows(Context& context, const trace::PixelHistory& history) {
    const ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
    const UseFont use{context.theme.fonts.small_mono};
    if (!ImGui::BeginTable("history", 3, flags)) {
        return;
    }
    const bool several = context.document.recording().objects.size() > 1;
    ImGui::TableSetupColumn(several ? "object / tri" : "triangle", 0, 1.2F);
    ImGui::TableSetupColumn("depth", 0, 0.8F);
    ImGui::TableSetupColumn("fate", 0, 1.1F);
    ImGui::TableHeadersRow();
    end_row(context, "initial", history.initial_color, history.initial_depth, false);
    ImGuiListClipper clipper; // a pixel may have thousands of fragments
    clipper.Begin(static_cast<int>(history.rows.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            history_row(context, history.rows[static_cast<std::size_t>(i)]);
        }
    }
    end_row(context, "final", history.final_color, history.final_depth, true);
    ImGui::EndTable();
}

/// A pixel of a line: the decision that led to it, and its fragment.
void draw_line_pixel(Context& context, const trace::StepDetail& detail) {
    const Theme& theme = context.theme;
    const trace::PieceDetail* piece = context.document.piece_detail();
    const raster::LineStep& step = *detail.traversal->line;
    heading(
        theme,
        fmt::format(
            "Pixel {} of {}",
            explain::pixel(step.pixel),
            trace::primitive_name(context.document.player().current())
        )
    );
    const bool here = context.document.player().current().kind == trace::StepKind::line_step;
    const auto algorithm = context.document.settings().line_algorithm;
    for (const explain::Formula& formula :
         explain::line_step_formulas(*piece->line, step, algorithm)) {
        draw_formula(context, formula, here);
    }
    if (detail.fragment) {
        draw_life(context, *detail.fragment);
        draw_life_beside(context, step.pixel);
    }
}

} // namespace

void swatch(const Theme& theme, const glm::vec4& color) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + side, at.y + side}, framebuffer::pack(color) | IM_COL32_A_MASK);
    list.AddRect(at, {at.x + side, at.y + side}, theme[Tone::hairline]);
    ImGui::Dummy({side, side});
}

void draw_fragment_tab(Context& context) {
    const Theme& theme = context.theme;
    const trace::StepDetail& detail = context.document.player().detail();
    if (detail.resolve) {
        draw_resolve(context, *detail.resolve);
        return;
    }
    if (detail.traversal && detail.traversal->line) {
        draw_line_pixel(context, detail);
        return;
    }
    if (!detail.visit && detail.fragment) { // a ray's: no edges were asked
        const PixelPos pixel = detail.fragment->fragment.pixel;
        heading(theme, fmt::format("Fragment {}", explain::pixel(pixel)));
        draw_life(context, *detail.fragment);
        draw_life_beside(context, pixel);
        return;
    }
    if (!detail.visit) {
        empty_note(
            theme,
            "Step to a pixel or a fragment (↓ makes steps finer, → goes on) to see its weights, "
            "tests and colors."
        );
        return;
    }
    if (!detail.fragment) {
        heading(theme, fmt::format("Pixel {}", explain::pixel(detail.visit->pixel)));
        caption(
            theme,
            covered_by_triangle(detail) ? "covered: a fragment follows"
                                        : "not covered: no fragment here"
        );
        draw_visit(context, *detail.visit);
        return;
    }
    heading(theme, fmt::format("Fragment {}", explain::pixel(detail.visit->pixel)));
    draw_life(context, *detail.fragment);
    draw_life_beside(context, detail.visit->pixel);
    heading(theme, "Coverage");
    draw_visit(context, *detail.visit);
    const auto quad = trace::quad_detail(
        context.document.recording(), *detail.triangle, context.document.player().current()
    );
    if (quad) {
        draw_quad(context, *quad);
    }
}

void draw_history_tab(Context& context) {
    const Theme& theme = context.theme;
    const trace::Step& step = context.document.player().current();
    std::optional<PixelPos> pixel = context.state.selected;
    if (!pixel && step.has_pixel()) {
        pixel = step.pixel;
    }
    if (!pixel) {
        empty_note(
            theme, "Click a pixel in the screen view to see every fragment that ever reached it."
        );
        return;
    }
    const trace::PixelHistory& history = context.document.history(*pixel);
    heading(theme, fmt::format("Pixel {}", explain::pixel(*pixel)));
    caption(
        theme,
        fmt::format(
            "{}, origin top-left; {} fragments in the whole frame",
            context.state.selected ? "picked" : "visited by this step",
            history.rows.size() + history.left_out
        )
    );
    frame_if_pointed(context, {"pixel fragments", "pixel triangle"});
    if (history.left_out > 0) {
        caption(theme, fmt::format("{} earlier ones are left out", history.left_out), Tone::fail);
    }
    draw_rows(context, history);
    if (history.rows.empty()) {
        empty_note(theme, "No triangle covers this pixel's center.");
    }
    draw_why(context, *pixel);
}

void draw_state_tab(Context& context) {
    const Theme& theme = context.theme;
    const scene::Settings& settings = context.document.settings();
    const trace::Recording& recording = context.document.recording();
    const trace::Step& step = context.document.player().current();
    heading(
        theme,
        step.in_triangle() || step.in_vertex_stage()
            ? fmt::format("State of object {}", step.object)
            : std::string{"State of the frame"}
    );
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        const bool own = scene::print_setting(settings, info.key) !=
                         scene::print_setting(recording.settings(), info.key);
        row(theme,
            info.key,
            scene::read_setting(settings, info.key) ? scene::print_setting(settings, info.key)
                                                    : std::string{"–"},
            own ? Tone::accent : Tone::text);
        tooltip(info.explanation);
    }
    heading(theme, "Recording");
    row(theme, "steps", explain::whole(static_cast<std::int64_t>(recording.end_step)));
    row(theme, "fragments", explain::whole(static_cast<std::int64_t>(recording.fragments.size())));
    row(theme, "memory", fmt::format("{:.1f} MB", static_cast<double>(recording.bytes()) / 1.0e6));
    row(theme, "recorded in", fmt::format("{:.1f} ms", recording.seconds * 1.0e3));
}

} // namespace hs::viewer
