// Everything the keyboard can do, in one table: it binds the keys, fills the menus and the sheet
// of keys.
#pragma once

#include "app/viewer/keys.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace hs::viewer {

enum class Command : std::uint8_t {
    step_forward,
    step_back,
    operation_forward,
    operation_back,
    triangle_forward,
    triangle_back,
    coarser,
    finer,
    go_start,
    go_end,
    play,
    nudge_left,
    nudge_right,
    nudge_up,
    nudge_down,
    go_to,
    find,
    next_match,
    previous_match,
    why,
    next_value,
    previous_value,
    next_operand,
    previous_operand,
    follow_operand,
    value_back,
    fit,
    zoom_in,
    zoom_out,
    next_view,
    previous_view,
    toggle_grid,
    toggle_numbers,
    toggle_helpers,
    toggle_side,
    next_side,
    morph,
    toggle_side_view,
    toggle_beside,
    toggle_difference,
    lesson_next,
    lesson_previous,
    lesson_answer,
    lesson_give_up,
    lesson_choose_next,
    lesson_choose_previous,
    lesson_mark,
    undo,
    redo,
    open,
    export_shown,
    presentation,
    theme,
    keys,
    close,
    quit,
};
inline constexpr int command_count = static_cast<int>(Command::quit) + 1;

enum class CommandGroup : std::uint8_t {
    stepping,
    pixel,
    view,
    lesson,
    program
};
std::string_view title(CommandGroup group);

struct CommandInfo {
    Command command = Command::step_forward;
    CommandGroup group = CommandGroup::stepping;
    std::string_view name;
    KeyPress key;
    std::optional<Command> reverse; ///< what Shift makes of it
};

std::span<const CommandInfo> command_table();
const CommandInfo& command_info(Command command);

/// The command a key runs, with Shift reversing stepping keys.
std::optional<Command> find_command(const KeyPress& press);

} // namespace hs::viewer
