// Search: which vertices, triangles, fragments or steps are so, and where.
#include "app/viewer/panels.hpp"
#include "app/viewer/search.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <vector>

namespace hs::viewer {
namespace {

/// A question people ask often.
struct Example {
    std::string words;
    std::string expression;
};

std::vector<Example> examples_for(const State& state) {
    std::vector<Example> list{
        {"a depth test fails", "fragment.fate == 'depth failed'"},
        {"a triangle is clipped", "triangle.clip_planes ~= 0"},
        {"a triangle is not drawn", "triangle.verdict ~= 'drawn'"},
        {"a vertex lies behind the eye", "vertex.clip.w <= 0"},
        {"a pixel is asked in vain", "step.kind == 'edge test' and step.covered == 0"}};
    if (state.selected) {
        const PixelPos p = *state.selected;
        list.insert(
            list.begin(),
            {fmt::format("pixel {},{} is written", p.x, p.y),
             fmt::format(
                 "fragment.pixel.x == {} and fragment.pixel.y == {} and fragment.fate == 'written'",
                 p.x,
                 p.y
             )}
        );
    }
    return list;
}

/// The line to write the expression in; Enter begins.
void draw_field(Context& context) {
    const Theme& theme = context.theme;
    SearchField& field = context.state.search;
    if (field.wants_keyboard) {
        ImGui::SetKeyboardFocusHere();
        field.wants_keyboard = false;
    }
    const UseFont use{theme.fonts.small_mono};
    ImGui::SetNextItemWidth(-1.0F);
    const bool begin = ImGui::InputTextWithHint(
        "##search",
        "fragment.depth < 0.5",
        &field.text,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll
    );
    if (begin) {
        context.viewer.start_search();
    }
}

void draw_buttons(Context& context) {
    const Theme& theme = context.theme;
    for (const Command command : {Command::previous_match, Command::next_match}) {
        const CommandInfo& info = command_info(command);
        const std::string tip = fmt::format("{} ({})", info.name, to_string(info.key));
        const char* const label = command == Command::next_match ? "next" : "previous";
        if (button(theme, label, tip, context.viewer.why_not(command))) {
            context.viewer.run(command);
        }
        ImGui::SameLine();
    }
    if (button(theme, "clear", "forget the search and its marks")) {
        context.viewer.search().clear();
    }
}

void draw_summary(Context& context, const Search& search) {
    const Theme& theme = context.theme;
    if (search.running()) {
        ImGui::ProgressBar(static_cast<float>(search.progress()), {-1.0F, theme.units(2)}, "");
    }
    const auto printed = [](std::size_t n) { return explain::whole(static_cast<std::int64_t>(n)); };
    words(
        theme,
        fmt::format(
            "{} of {} {}", printed(search.count()), printed(search.size()), name_of(search.rows())
        )
    );
    if (!search.problem().empty()) {
        caption(theme, search.problem(), Tone::fail);
    }
    if (search.count() > search.kept()) {
        caption(theme, fmt::format("The first {} are kept.", printed(search.kept())));
    }
}

/// One line per match; a click goes there.
void draw_matches(Context& context, Search& search) {
    const Theme& theme = context.theme;
    const trace::StepId now = context.document.player().step();
    const UseFont use{theme.fonts.small_mono};
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(search.kept()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const trace::Step& step = search.address(static_cast<std::size_t>(i));
            const std::string path = trace::step_path(step);
            const std::string label = shorten(
                theme.fonts.small_mono,
                fmt::format("#{}  {}", step.id, path),
                ImGui::GetContentRegionAvail().x
            );
            ImGui::PushID(i);
            if (ImGui::Selectable(label.c_str(), step.id == now)) {
                context.viewer.seek(step.id);
            }
            tooltip(path);
            ImGui::PopID();
        }
    }
}

void draw_examples(Context& context) {
    const Theme& theme = context.theme;
    heading(theme, "For example");
    for (const Example& example : examples_for(context.state)) {
        const std::string label =
            shorten(theme.fonts.text, "› " + example.words, ImGui::GetContentRegionAvail().x);
        if (ImGui::Selectable(label.c_str())) {
            context.state.search.text = example.expression;
            context.viewer.start_search();
        }
        tooltip(example.expression);
    }
    caption(
        theme,
        "Comparisons and arithmetic are Lua's: == ~= < <= and or not. A triangle's corners are a, "
        "b "
        "and c; a fragment knows its triangle."
    );
}

/// "fragment" and everything it has, group by group.
void draw_names(Context& context) {
    const Theme& theme = context.theme;
    heading(theme, "Names");
    std::string group;
    std::string line;
    const auto print = [&] {
        if (!group.empty() && group != "b" && group != "c") { // like a
            caption(theme, line);
        }
    };
    for (const search::KnownName& name : search::known_names(context.document.player())) {
        const std::size_t dot = name.path.find('.');
        if (name.path.substr(0, dot) != group) {
            print();
            group = name.path.substr(0, dot);
            line = group + ":";
        }
        line += ' ' + name.path.substr(dot);
    }
    print();
}

} // namespace

void draw_search(Context& context) {
    const Theme& theme = context.theme;
    Search& search = context.viewer.search();
    draw_field(context);
    if (!context.state.search.complaint.empty()) {
        caption(theme, context.state.search.complaint, Tone::fail);
    }
    if (!search.is_of(context.document)) {
        draw_examples(context);
        draw_names(context);
        return;
    }
    draw_summary(context, search);
    draw_buttons(context);
    if (search.kept() > 0 && !search.running()) {
        draw_matches(context, search);
    } else if (!search.running()) {
        caption(theme, "Nothing matches.");
    }
}

} // namespace hs::viewer
