// What a command is. Each has a file of its own that describes its options to CLI11 and carries
// them out.
#pragma once

#include "app/command/input.hpp"
#include "app/command/output.hpp"

#include <CLI/App.hpp>

#include <functional>
#include <memory>
#include <string_view>

namespace hs::command {

/// A command's description and what it does. `run` keeps the options that the description fills.
struct Command {
    CLI::App* app = nullptr;
    std::function<int()> run; ///< returns the exit status
    /// It asks `stop_requested` now and then, so that a signal need not end it at once.
    bool stops_cleanly = false;
};

Command add_open(CLI::App& program, const Common& common);
Command add_render(CLI::App& program, const Common& common);
Command add_record(CLI::App& program, const Common& common);
Command add_export(CLI::App& program, const Common& common);
Command add_history(CLI::App& program, const Common& common);
Command add_explain(CLI::App& program, const Common& common);
Command add_narrate(CLI::App& program, const Common& common);
Command add_query(CLI::App& program, const Common& common);
Command add_why(CLI::App& program, const Common& common);
Command add_shot(CLI::App& program, const Common& common);
Command add_compare(CLI::App& program, const Common& common);
Command add_check(CLI::App& program, const Common& common);
Command add_bench(CLI::App& program, const Common& common);

/// The viewer on the lessons: what the program does without a command.
int open_lessons(const Common& common);

/// What the help of every command says about FILE and --at.
inline constexpr const char* file_help =
    "scene (.toml), mesh (.obj .off .ply .stl .om) or lesson folder";
inline constexpr const char* at_help =
    "step path, #NUMBER, start or end; without it the end of the frame";

inline constexpr const char* beside_help = "key=value: a second frame with this setting, or this "
                                           "entry of camera or object, changed, stepped "
                                           "beside the first";

} // namespace hs::command
