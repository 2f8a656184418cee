#include "app/viewer/commands.hpp"

#include "core/base/check.hpp"

#include <array>

namespace hs::viewer {
namespace {

constexpr KeyPress plain(Key key) {
    return {.key = key};
}
constexpr KeyPress ctrl(Key key) {
    return {.key = key, .ctrl = true};
}
constexpr KeyPress alt(Key key) {
    return {.key = key, .alt = true};
}

using enum CommandGroup;

// clang-format off
constexpr std::array<CommandInfo, command_count> table{{
    {Command::step_forward,      stepping, "step forward at the chosen granularity", plain(Key::right), Command::step_back},
    {Command::step_back,         stepping, "step back at the chosen granularity",    plain(Key::left),  Command::step_forward},
    {Command::operation_forward, stepping, "one operation forward",     plain(Key::period), Command::operation_back},
    {Command::operation_back,    stepping, "one operation back",        plain(Key::comma),  Command::operation_forward},
    {Command::triangle_forward,  stepping, "to the next triangle",      ctrl(Key::right),   Command::triangle_back},
    {Command::triangle_back,     stepping, "to the previous triangle",  ctrl(Key::left),    Command::triangle_forward},
    {Command::coarser,           stepping, "coarser steps",             plain(Key::up),     Command::finer},
    {Command::finer,             stepping, "finer steps",               plain(Key::down),   Command::coarser},
    {Command::go_start,          stepping, "to the cleared framebuffer", plain(Key::home),  Command::go_end},
    {Command::go_end,            stepping, "to the finished frame",     plain(Key::end),    Command::go_start},
    {Command::play,              stepping, "play and pause",            plain(Key::space),  {}},
    {Command::nudge_left,        pixel,    "picked pixel to the left",  alt(Key::left),     {}},
    {Command::nudge_right,       pixel,    "picked pixel to the right", alt(Key::right),    {}},
    {Command::nudge_up,          pixel,    "picked pixel up",           alt(Key::up),       {}},
    {Command::nudge_down,        pixel,    "picked pixel down",         alt(Key::down),     {}},
    {Command::go_to,             pixel,    "go to a pixel or a step",   ctrl(Key::g),       {}},
    {Command::find,              pixel,    "search by an expression",   ctrl(Key::f),       {}},
    {Command::next_match,        pixel,    "to the next match of the search", plain(Key::f5), Command::previous_match},
    {Command::previous_match,    pixel,    "to the previous match",     {Key::f5, false, true, false}, {}},
    {Command::why,               pixel,    "why this color, why not that triangle", plain(Key::w), {}},
    {Command::next_value,        pixel,    "next value of the step",    plain(Key::e),      Command::previous_value},
    {Command::previous_value,    pixel,    "previous value of the step", {Key::e, false, true, false}, {}},
    {Command::next_operand,      pixel,    "next operand of the value", plain(Key::o),      Command::previous_operand},
    {Command::previous_operand,  pixel,    "previous operand of the value", {Key::o, false, true, false}, {}},
    {Command::follow_operand,    pixel,    "to where the operand came from", plain(Key::l), {}},
    {Command::value_back,        pixel,    "back to the value you came from", plain(Key::backspace), {}},
    {Command::fit,               view,     "fit the image to the panel", plain(Key::f),     {}},
    {Command::zoom_in,           view,     "larger pixels",             plain(Key::plus),   {}},
    {Command::zoom_out,          view,     "smaller pixels",            plain(Key::minus),  {}},
    {Command::next_view,         view,     "next screen view",          plain(Key::v),      Command::previous_view},
    {Command::previous_view,     view,     "previous screen view",      {Key::v, false, true, false}, {}},
    {Command::toggle_grid,       view,     "pixel grid on and off",     plain(Key::g),      {}},
    {Command::toggle_numbers,    view,     "numbers on pixels on and off", plain(Key::n),   {}},
    {Command::toggle_helpers,    view,     "helper pixels of derivatives on and off", plain(Key::h), {}},
    {Command::toggle_side,       view,     "side panel on and off",     ctrl(Key::d),       {}},
    {Command::next_side,         view,     "space, beside, projection, depth, clip …", plain(Key::s), {}},
    {Command::morph,             view,     "from the pyramid of view to NDC and back", plain(Key::m), {}},
    {Command::toggle_side_view,  view,     "space view from the side and around", {Key::m, false, true, false}, {}},
    {Command::toggle_beside,     view,     "another configuration beside", plain(Key::b),   {}},
    {Command::toggle_difference, view,     "mark pixels that differ beside", plain(Key::d), {}},
    {Command::lesson_next,       lesson,   "next lesson step",          plain(Key::page_down), Command::lesson_previous},
    {Command::lesson_previous,   lesson,   "previous lesson step",      plain(Key::page_up),   Command::lesson_next},
    {Command::lesson_answer,     lesson,   "answer the question",       plain(Key::enter),   {}},
    {Command::lesson_give_up,    lesson,   "answer \"I don't know\"",   ctrl(Key::enter),    {}},
    {Command::lesson_choose_next, lesson,  "choose the next answer",    plain(Key::c),       Command::lesson_choose_previous},
    {Command::lesson_choose_previous, lesson, "choose the previous answer", {Key::c, false, true, false}, {}},
    {Command::lesson_mark,       lesson,   "answer with the picked pixel, or not", plain(Key::x), {}},
    {Command::undo,              program,  "undo the last change of the scene", ctrl(Key::z), Command::redo},
    {Command::redo,              program,  "redo it",                   {Key::z, true, true, false}, {}},
    {Command::open,              program,  "open a scene, mesh or lesson", ctrl(Key::o),    {}},
    {Command::export_shown,      program,  "export what the screen view shows", ctrl(Key::e), {}},
    {Command::presentation,      program,  "large type for the lecture hall", plain(Key::p), {}},
    {Command::theme,             program,  "dark or light",             plain(Key::t),      {}},
    {Command::keys,              program,  "this list of keys",         plain(Key::question), {}},
    {Command::close,             program,  "close what is open on top", plain(Key::escape), {}},
    {Command::quit,              program,  "quit",                      ctrl(Key::q),       {}},
}};
// clang-format on

const CommandInfo* find_key(const KeyPress& press) {
    for (const CommandInfo& info : table) {
        if (info.key == press) {
            return &info;
        }
    }
    return nullptr;
}

} // namespace

std::string_view title(CommandGroup group) {
    switch (group) {
    case stepping: return "Stepping";
    case pixel: return "Picking";
    case view: return "Views";
    case lesson: return "Lesson";
    case program: return "Program";
    }
    HS_CHECK(false, "every group has a title");
    return "";
}

std::span<const CommandInfo> command_table() {
    return table;
}

const CommandInfo& command_info(Command command) {
    const CommandInfo& info = table[static_cast<std::size_t>(command)];
    HS_DCHECK(info.command == command, "the table lists commands in order");
    return info;
}

std::optional<Command> find_command(const KeyPress& press) {
    if (const CommandInfo* info = find_key(press)) {
        return info->command;
    }
    if (press.shift) {
        KeyPress without = press;
        without.shift = false;
        const CommandInfo* info = find_key(without);
        if (info != nullptr && info->reverse) {
            return info->reverse;
        }
    }
    return std::nullopt;
}

} // namespace hs::viewer
