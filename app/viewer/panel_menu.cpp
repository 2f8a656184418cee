// The menu, and beside it what is open and where the playhead stands.
#include "app/lesson/library.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/setting_text.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

namespace hs::viewer {
namespace {

void menu_item(Context& context, Command command) {
    const CommandInfo& info = command_info(command);
    const std::string why = context.viewer.why_not(command);
    const std::string key = to_string(info.key);
    const std::string name{info.name};
    if (ImGui::MenuItem(name.c_str(), key.c_str(), false, why.empty())) {
        context.viewer.run(command);
    }
    tooltip(why);
}

void file_menu(Context& context) {
    menu_item(context, Command::open);
    if (ImGui::BeginMenu("recent", !context.state.recent.empty())) {
        const std::vector<std::filesystem::path> recent = context.state.recent;
        for (const std::filesystem::path& file : recent) {
            if (ImGui::MenuItem(file.filename().string().c_str())) {
                context.viewer.open(file);
            }
            tooltip(file.string());
        }
        ImGui::EndMenu();
    }
    tooltip(context.state.recent.empty() ? "Nothing was opened yet." : "");
    menu_item(context, Command::export_shown);
    menu_item(context, Command::undo);
    menu_item(context, Command::redo);
    ImGui::Separator();
    menu_item(context, Command::quit);
}

/// The pairs people ask for most, one click away; the panel has all.
void beside_menu(Context& context) {
    const bool open = context.document.is_open();
    if (!ImGui::BeginMenu("beside", open)) {
        tooltip(open ? "" : "Nothing is open yet.");
        return;
    }
    const scene::Settings& settings = context.document.scene().settings;
    for (const char* const key :
         {"clip.enabled", "shading", "interpolation", "traversal", "depth.format"}) {
        if (ImGui::BeginMenu(key)) {
            for (const std::string& value : values_beside(settings, key)) {
                if (ImGui::MenuItem(value.c_str())) {
                    context.viewer.show_beside({key, value});
                }
            }
            ImGui::EndMenu();
        }
    }
    ImGui::EndMenu();
}

void view_menu(Context& context) {
    for (const Command command :
         {Command::fit,
          Command::zoom_in,
          Command::zoom_out,
          Command::next_view,
          Command::toggle_grid,
          Command::toggle_numbers,
          Command::toggle_helpers,
          Command::toggle_side,
          Command::next_side,
          Command::morph,
          Command::toggle_side_view,
          Command::toggle_beside,
          Command::toggle_difference}) {
        menu_item(context, command);
    }
    beside_menu(context);
    ImGui::Separator();
    menu_item(context, Command::presentation);
    menu_item(context, Command::theme);
}

void lessons_menu(Context& context) {
    menu_item(context, Command::lesson_next);
    menu_item(context, Command::lesson_previous);
    menu_item(context, Command::lesson_answer);
    menu_item(context, Command::lesson_give_up);
    ImGui::Separator();
    // Looked up while the menu is open only: a folder listing, not a part of every frame
    const auto lessons = lesson::find_lessons(lesson::lessons_folder());
    for (const std::filesystem::path& folder : lessons) {
        if (ImGui::MenuItem(folder.filename().string().c_str())) {
            context.viewer.open(folder);
        }
    }
    if (lessons.empty()) {
        ImGui::MenuItem("no lessons are installed", nullptr, false, false);
    }
}

void help_menu(Context& context) {
    menu_item(context, Command::keys);
    menu_item(context, Command::go_to);
    menu_item(context, Command::why);
}

/// Right of the menus: scene name · size · step path, shortened from the front when need be.
void draw_place(Context& context, const Rect& rect, float from) {
    const Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float right = rect.right() - theme.units(3);
    const float gap = theme.units(4);
    if (!context.document.is_open()) {
        return;
    }
    const scene::Settings& settings = context.document.recording().settings();
    const std::string name =
        fmt::format("{} · {} × {}", context.document.scene().name, settings.width, settings.height);
    ImFont* font = theme.fonts.text;
    ImFont* mono = theme.fonts.small_mono;
    const float room = right - from - gap;
    const std::string path =
        shorten_front(mono, trace::step_path(context.document.player().current()), room * 0.6F);
    const float path_width = text_size(mono, path).x;
    const std::string shown = shorten(font, name, room - path_width - gap);
    const float name_width = text_size(font, shown).x;
    const auto middle = [&](const ImFont* f) {
        return rect.y + (rect.height - f->FontSize) * 0.5F;
    };
    draw_text(list, mono, {right - path_width, middle(mono)}, theme[Tone::quiet], path);
    draw_text(
        list, font, {right - path_width - gap - name_width, middle(font)}, theme[Tone::text], shown
    );
}

} // namespace

void draw_menu(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    ImGui::PushStyleVar(
        ImGuiStyleVar_FramePadding,
        {theme.units(2), (rect.height - theme.fonts.text->FontSize) * 0.5F}
    );
    ImGui::BeginChild(
        "menu",
        {rect.width, rect.height},
        false,
        ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar
    );
    if (ImGui::BeginMenuBar()) {
        ImGui::PopStyleVar();
        const auto menu = [&](const char* label, void (*draw)(Context&)) {
            if (ImGui::BeginMenu(label)) {
                draw(context);
                ImGui::EndMenu();
            }
        };
        menu("File", file_menu);
        menu("View", view_menu);
        menu("Lessons", lessons_menu);
        menu("Help", help_menu);
        draw_place(context, rect, ImGui::GetCursorScreenPos().x);
        ImGui::PushStyleVar(
            ImGuiStyleVar_FramePadding,
            {theme.units(2), (rect.height - theme.fonts.text->FontSize) * 0.5F}
        );
        ImGui::EndMenuBar();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

} // namespace hs::viewer
