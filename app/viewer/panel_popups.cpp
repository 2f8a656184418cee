// What appears above the panels: the sheet of keys, prompts, problems, progress.
#include "app/viewer/panels.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace hs::viewer {
namespace {

/// A window in the middle, above everything, as high as its content; `height` 0 or a fixed one.
void begin_sheet(const Theme& theme, const char* name, ImVec2 window, float width, float height) {
    const float fitted = std::min(width, window.x - theme.units(4));
    ImGui::SetNextWindowPos(
        {std::floor(window.x * 0.5F), std::floor(window.y * 0.42F)}, ImGuiCond_Always, {0.5F, 0.5F}
    );
    ImGui::SetNextWindowSize({fitted, std::min(height, window.y - theme.units(4))});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.units(5), theme.units(4)});
    ImGui::Begin(
        name,
        nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
    );
    ImGui::PopStyleVar(2);
}

void draw_group(const Theme& theme, CommandGroup group) {
    heading(theme, title(group));
    for (const CommandInfo& info : command_table()) {
        if (info.group != group) {
            continue;
        }
        {
            const UseFont use{theme.fonts.mono};
            ImGui::TextUnformatted(to_string(info.key).c_str());
        }
        ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + theme.units(30));
        ImGui::TextUnformatted(info.name.data(), info.name.data() + info.name.size());
    }
}

void draw_key_sheet(Context& context, ImVec2 window) {
    const Theme& theme = context.theme;
    begin_sheet(theme, "keys", window, theme.units(232), 0.0F);
    heading(theme, "Keys");
    ImGui::Columns(2, "key columns", false);
    draw_group(theme, CommandGroup::stepping);
    caption(theme, "Shift reverses every stepping key.");
    draw_group(theme, CommandGroup::pixel);
    draw_group(theme, CommandGroup::lesson);
    ImGui::NextColumn();
    draw_group(theme, CommandGroup::view);
    draw_group(theme, CommandGroup::program);
    ImGui::Columns(1);
    ImGui::Dummy({0.0F, theme.units(1)});
    caption(
        theme,
        "Mouse: click or right click picks a pixel, left drag pans, wheel zooms; in the space view "
        "drag turns. Drag along the timeline to scrub."
    );
    if (button(theme, "close", "Esc")) {
        context.state.show_keys = false;
    }
    ImGui::End();
}

void accept_prompt(Context& context) {
    State& state = context.state;
    if (state.prompt == Prompt::open_file) {
        context.viewer.open(state.prompt_text);
        state.prompt = Prompt::none;
        return;
    }
    const std::optional<std::string> complaint =
        state.prompt == Prompt::export_file ? context.viewer.export_shown(state.prompt_text)
                                            : context.viewer.go_to(state.prompt_text);
    if (complaint) {
        state.prompt_error = *complaint;
    } else {
        state.prompt = Prompt::none;
    }
}

void draw_recent(Context& context) {
    const std::vector<std::filesystem::path> recent = context.state.recent;
    if (!recent.empty()) {
        caption(context.theme, "recent");
    }
    for (const std::filesystem::path& file : recent) {
        const float room = ImGui::GetContentRegionAvail().x;
        const std::string label = shorten_front(context.theme.fonts.text, file.string(), room);
        if (ImGui::Selectable(label.c_str())) {
            context.state.prompt = Prompt::none;
            context.viewer.open(file);
        }
    }
}

struct PromptText {
    const char* title;
    const char* verb;
    const char* explanation;
};

PromptText text_of(Prompt prompt) {
    switch (prompt) {
    case Prompt::none: break;
    case Prompt::open_file:
        return {
            "Open",
            "open",
            "Path of a scene (.toml), a mesh (.obj .off .ply .stl .om) or a lesson's folder. Files "
            "can also be dropped on the window."};
    case Prompt::export_file:
        return {
            "Export what the screen view shows",
            "export",
            "File to write, as the buffer is after this step: .exr and .npz keep every number, "
            ".csv is a table, .png a picture. A file of that name is replaced."};
    case Prompt::go_to:
        return {
            "Go to",
            "go",
            "A pixel \"31,17\" (origin top-left), a step \"object 0 / triangle 12 / fragment "
            "31,17\", a number \"#184467\", \"start\" or \"end\"."};
    }
    HS_CHECK(false, "every prompt has a text");
    return {};
}

void draw_prompt(Context& context, ImVec2 window) {
    const Theme& theme = context.theme;
    State& state = context.state;
    const PromptText text = text_of(state.prompt);
    begin_sheet(theme, "prompt", window, theme.units(150), 0.0F);
    heading(theme, text.title);
    caption(theme, text.explanation);
    if (!state.prompt_appeared) {
        ImGui::SetKeyboardFocusHere();
        state.prompt_appeared = true;
    }
    ImGui::SetNextItemWidth(-1.0F);
    bool accepted = false;
    {
        const UseFont use{theme.fonts.mono};
        accepted = ImGui::InputText(
            "##prompt",
            &state.prompt_text,
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll
        );
    }
    if (!state.prompt_error.empty()) {
        caption(theme, state.prompt_error, Tone::fail);
    }
    const char* const why = state.prompt_text.empty() ? "Type something first." : "";
    accepted = button(theme, text.verb, "Enter", why) || accepted;
    ImGui::SameLine();
    if (button(theme, "cancel", "Esc")) {
        state.prompt = Prompt::none;
    } else if (accepted && !state.prompt_text.empty()) {
        accept_prompt(context);
    }
    if (state.prompt == Prompt::open_file) {
        draw_recent(context);
    }
    ImGui::End();
}

void draw_problems(Context& context, ImVec2 window) {
    const Theme& theme = context.theme;
    const Diagnostics& problems = context.state.problems;
    begin_sheet(theme, "problems", window, theme.units(200), theme.units(90));
    heading(
        theme,
        problems.size() == 1 ? std::string{"This file has a problem"}
                             : fmt::format("This file has {} problems", problems.size())
    );
    ImGui::BeginChild("list", {0.0F, -theme.units(11)});
    for (const Diagnostic& problem : problems) {
        mono(theme, problem.to_string());
        ImGui::Dummy({0.0F, theme.units(1)});
    }
    ImGui::EndChild();
    if (button(theme, "close", "Esc")) {
        context.state.problems.clear();
    }
    ImGui::End();
}

void draw_progress(Context& context, ImVec2 window) {
    const Theme& theme = context.theme;
    const Background& work = context.viewer.background();
    begin_sheet(theme, "progress", window, theme.units(90), 0.0F);
    words(theme, work.title());
    ImGui::ProgressBar(static_cast<float>(work.progress()), {-1.0F, theme.units(5)}, "");
    if (button(theme, "stop", "Esc")) {
        context.viewer.cancel_background_work();
    }
    ImGui::End();
}

} // namespace

void draw_popups(Context& context, ImVec2 window) {
    if (context.state.show_keys) {
        draw_key_sheet(context, window);
    }
    if (context.state.prompt != Prompt::none) {
        draw_prompt(context, window);
    }
    if (!context.state.problems.empty()) {
        draw_problems(context, window);
    }
    if (context.viewer.busy()) {
        draw_progress(context, window);
    }
}

} // namespace hs::viewer
