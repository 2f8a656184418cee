// What the commands share: how they are given input, and how they end.
//
// Exit status 0: done. 1: the answer is no. 2: usage or bad input, said in one located line on
// stderr.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/scene.hpp"
#include "core/trace/player.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hs::command {

inline constexpr int status_done = 0;
inline constexpr int status_no = 1;
inline constexpr int status_bad_input = 2;

/// Options any command takes, before or behind its name.
struct Common {
    std::vector<std::string> set; ///< key=value
    std::string size;             ///< WIDTHxHEIGHT
    unsigned threads = 0;         ///< 0: as many as the machine has
    bool quiet = false;           ///< no progress
    bool json = false;            ///< one JSON document instead of text
};

/// A command's description and what it does. The description's options are stored by the command.
struct Command {
    CLI::App* app = nullptr;
    std::function<int()> run; ///< returns the exit status
};

// Each command in a file of its own
Command add_open(CLI::App& program, const Common& common);
Command add_render(CLI::App& program, const Common& common);
Command add_record(CLI::App& program, const Common& common);
Command add_export(CLI::App& program, const Common& common);
Command add_history(CLI::App& program, const Common& common);
Command add_shot(CLI::App& program, const Common& common);
Command add_check(CLI::App& program, const Common& common);
Command add_bench(CLI::App& program, const Common& common);

/// The viewer on the lessons: what the program does without a command.
int open_lessons(const Common& common);

/// Prints the first diagnostic, and how many more there are, on stderr; returns status_bad_input.
int fail(const Diagnostics& diagnostics);

/// "1280x720" to width and height.
struct Size {
    int width = 0;
    int height = 0;
};
Result<Size> parse_size(const std::string& text);

/// "31,17" to a pixel.
Result<PixelPos> parse_pixel(const std::string& text);

/// A scene, a mesh, or a lesson (its first scene), with --set and --size applied.
Result<std::shared_ptr<const scene::Scene>>
load_input(const std::filesystem::path& file, const Common& common, bool size_is_image = true);

/// Loads and records, with a progress bar where stderr is a terminal.
Result<std::shared_ptr<const trace::Recording>>
record_input(const std::filesystem::path& file, const Common& common, bool size_is_image = true);

/// Stands on the written step; "" is the end.
Result<std::shared_ptr<trace::Player>>
stand_on(std::shared_ptr<const trace::Recording> recording, const std::string& at);

} // namespace hs::command
