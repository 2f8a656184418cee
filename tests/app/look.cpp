// What people see: text that fits, colors that can be told apart, keys that are all listed.
#include "app/viewer/commands.hpp"
#include "app/viewer/theme.hpp"
#include "app/viewer/widgets.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"

#include <set>

using namespace hs;
using test::Window;
using viewer::Tone;

namespace {

/// Every panel in every state that a person can put it into by choosing.
template <typename Visit>
void for_each_view(Window& window, Visit&& visit) {
    viewer::State& state = window.viewer.state();
    for (int tab = 0; tab < viewer::inspector_tab_count; ++tab) {
        state.tab = static_cast<viewer::InspectorTab>(tab);
        state.space.space = static_cast<viewer::Space>(tab % viewer::space_count);
        state.screen.content =
            static_cast<viewer::ScreenContent>(tab * 2 % viewer::screen_content_count);
        window.settle();
        visit();
    }
}

} // namespace

TEST_CASE("no panel cuts its text at 1280 × 720 and 1920 × 1080", "[app]") {
    for (const std::pair<int, int>& size : {std::pair{1280, 720}, std::pair{1920, 1080}}) {
        const auto window = Window::with_scene(size.first, size.second);
        window->viewer.select({8, 3});
        for (const char* step :
             {"start",
              "vertex stage / object 0 / vertex 1",
              "object 0 / triangle 0 / outcodes",
              "object 1 / triangle 1 / setup",
              "object 1 / triangle 1 / pixel 9,3",
              "object 1 / triangle 1 / fragment 3,3 / depth test",
              "end"}) {
            REQUIRE_FALSE(window->viewer.go_to(step));
            for_each_view(*window, [&] {
                INFO(size.first << " × " << size.second << " at " << step);
                for (const host::CutGlyph& cut : window->host.cut_text()) {
                    FAIL_CHECK("cut at " << cut.x << ", " << cut.y);
                }
            });
        }
    }
}

TEST_CASE("empty panels, the sheet of keys and prompts fit, in large type too", "[app]") {
    Window window{1920, 1080};
    for (const float presentation : {1.0F, 1.5F}) {
        window.viewer.state().presentation = presentation;
        window.settle();
        CHECK(window.host.cut_text().empty());
        window.viewer.run(viewer::Command::keys);
        window.settle();
        CHECK(window.host.cut_text().empty());
        window.viewer.run(viewer::Command::keys);
        window.viewer.run(viewer::Command::open);
        window.settle();
        CHECK(window.host.cut_text().empty());
        window.viewer.run(viewer::Command::close);
    }
}

TEST_CASE("text has a contrast of at least 4.5 to 1 in both themes", "[app]") {
    for (const viewer::ThemeKind kind : {viewer::ThemeKind::dark, viewer::ThemeKind::light}) {
        viewer::Theme theme;
        theme.kind = kind;
        for (const Tone ground : {Tone::panel, Tone::raised}) {
            for (const Tone text : {Tone::text, Tone::quiet, Tone::accent}) {
                INFO(static_cast<int>(kind) << " " << static_cast<int>(text));
                CHECK(viewer::contrast(theme[text], theme[ground]) >= 4.5F);
            }
        }
        for (const Tone text :
             {Tone::pass, Tone::fail, Tone::vertex_0, Tone::vertex_1, Tone::vertex_2}) {
            CHECK(viewer::contrast(theme[text], theme[Tone::panel]) >= 4.5F);
        }
        for (int i = 0; i < trace::stage_count; ++i) {
            const ImU32 hue = theme.stage(static_cast<trace::Stage>(i));
            CHECK(viewer::contrast(hue, theme[Tone::raised]) >= 4.5F);
        }
    }
}

TEST_CASE("the table of tones lists every tone in order with a name of its own", "[app]") {
    std::set<std::string_view> names;
    const auto table = viewer::tone_table();
    REQUIRE(table.size() == static_cast<std::size_t>(viewer::tone_count));
    for (std::size_t i = 0; i < table.size(); ++i) {
        CHECK(static_cast<std::size_t>(table[i].tone) == i);
        names.insert(table[i].name);
    }
    CHECK(names.size() == table.size());
}

TEST_CASE("every command has a name and a key of its own", "[app]") {
    std::set<std::string> keys;
    for (const viewer::CommandInfo& info : viewer::command_table()) {
        CHECK_FALSE(info.name.empty());
        CHECK(keys.insert(viewer::to_string(info.key)).second);
        CHECK(viewer::find_command(info.key) == info.command);
    }
    CHECK(keys.size() == static_cast<std::size_t>(viewer::command_count));
}

TEST_CASE("a command that cannot run says why", "[app]") {
    Window window;
    for (const viewer::CommandInfo& info : viewer::command_table()) {
        const bool stepping = info.group == viewer::CommandGroup::stepping;
        const bool of_lesson = info.group == viewer::CommandGroup::lesson;
        if (stepping || of_lesson) {
            CHECK_FALSE(window.viewer.why_not(info.command).empty());
            window.viewer.run(info.command); // and does nothing
        }
    }
}

TEST_CASE("? opens the sheet of keys and Esc closes it", "[app]") {
    Window window;
    window.host.text("?");
    window.settle();
    CHECK(window.state().show_keys);
    window.key(viewer::Key::escape);
    CHECK_FALSE(window.state().show_keys);
}

TEST_CASE("text that does not fit is shortened with an ellipsis", "[app]") {
    Window window;
    ImFont* font = window.viewer.theme().fonts.text;
    const std::string text = "a step path of a certain length";
    const float room = viewer::text_size(font, text).x * 0.5F;
    for (const std::string& shown :
         {viewer::shorten(font, text, room), viewer::shorten_front(font, text, room)}) {
        CHECK(shown.find("…") != std::string::npos);
        CHECK(viewer::text_size(font, shown).x <= room);
    }
    CHECK(viewer::shorten(font, text, 1.0e6F) == text);
}
