// The command line. Without a command the viewer opens on the lessons.
#include "app/command/command.hpp"
#include "app/command/interrupt.hpp"
#include "core/base/spelling.hpp"
#include "core/base/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <malloc.h>

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace {

using hs::command::Command;
using hs::command::Common;

constexpr const char* footer =
    R"(A step is a path like 'object 0 / triangle 12 / fragment 31,17 / depth test', #NUMBER, start or end.
These options may stand behind the command, too; 'halfspace COMMAND --help' tells its own.

Examples:
  halfspace open scene.toml
  halfspace render bunny.obj --size 1920x1080 -o bunny.png
  halfspace export scene.toml --at '#184467' --what depth -o depth.exr
  halfspace history scene.toml --pixel 31,17 --set depth.test=always

Exit status: 0 done, 1 the answer is no, 2 usage or bad input (one line on stderr).)";

/// Memory let go by one recording is kept for the next: the system hands pages out one by one and
/// clears each, which for a frame at 1080p takes as long as drawing it. A slider re-records many
/// frames a second.
void keep_freed_memory() {
    constexpr int megabyte = 1 << 20;
    // NOLINTBEGIN(concurrency-mt-unsafe): main calls this before any thread is started
    mallopt(M_MMAP_MAX, 0);                    // large blocks come from the heap, too, which
    mallopt(M_TRIM_THRESHOLD, 256 * megabyte); // keeps this much at its end
    mallopt(M_TOP_PAD, 16 * megabyte);         // and grows in steps of this
    mallopt(M_ARENA_MAX, 1);                   // one heap: other threads allocate rarely
    // NOLINTEND(concurrency-mt-unsafe)
}

void add_common_options(CLI::App& program, Common& common) {
    program.add_option("--set", common.set, "KEY=VALUE: change any entry of the scene; repeatable")
        ->take_all()
        ->allow_extra_args(false);
    program.add_option("--size", common.size, "WxH: size of the image (shot: of the window)");
    constexpr unsigned most_threads = 256;
    program.add_option("--threads", common.threads, "how many threads may work; 0: all there are")
        ->check(CLI::Range(0U, most_threads));
    program.add_flag("--quiet", common.quiet, "no progress, no summaries");
    program.add_flag("--json", common.json, "print one JSON document");
}

std::vector<Command> add_commands(CLI::App& program, const Common& common) {
    using namespace hs::command; // NOLINT(google-build-using-namespace): for one list
    return {
        add_open(program, common),
        add_render(program, common),
        add_record(program, common),
        add_export(program, common),
        add_history(program, common),
        add_explain(program, common),
        add_why(program, common),
        add_narrate(program, common),
        add_query(program, common),
        add_compare(program, common),
        add_shot(program, common),
        add_check(program, common),
        add_bench(program, common)};
}

const Command* chosen(const std::vector<Command>& commands) {
    for (const Command& command : commands) {
        if (command.app->parsed()) {
            return &command;
        }
    }
    return nullptr;
}

/// The first word that is neither a command nor an option's, when no command was given.
std::string unknown_command(const CLI::App& program, const std::vector<Command>& commands) {
    const std::vector<std::string> left_over = program.remaining(true);
    if (left_over.empty() || left_over.front().starts_with('-')) {
        return "";
    }
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const Command& command : commands) {
        names.push_back(command.app->get_name());
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return fmt::format(
        "'{}' is not a command{}", left_over.front(), hs::did_you_mean(left_over.front(), views)
    );
}

/// Help and version are answers; usage errors become the same one line as all others.
int answer(
    const CLI::App& program, const std::vector<Command>& commands, const CLI::ParseError& error
) {
    const Command* command = chosen(commands);
    const CLI::App& asked = command == nullptr ? program : *command->app;
    if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr) {
        return hs::command::print(asked.help(command == nullptr ? "" : program.get_name()));
    }
    if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) {
        return hs::command::print(fmt::format("{}\n", hs::program_version()));
    }
    std::string message = command == nullptr ? unknown_command(program, commands) : "";
    if (message.empty()) {
        message = error.what();
    }
    if (!message.ends_with('?')) {
        message += fmt::format(
            "; see halfspace {}--help", command == nullptr ? "" : asked.get_name() + ' '
        );
    }
    return hs::command::fail({{.message = message}});
}

int run(int argc, char** argv) {
    CLI::App program{"Watch the graphics pipeline think.", "halfspace"};
    program.footer(footer);
    program.set_version_flag("--version", std::string{hs::program_version()});
    program.fallthrough();
    program.require_subcommand(0, 1);
    Common common;
    add_common_options(program, common);
    const std::vector<Command> commands = add_commands(program, common);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return answer(program, commands, error);
    }
    const Command* command = chosen(commands);
    if (command == nullptr) {
        return hs::command::open_lessons(common);
    }
    if (command->stops_cleanly) {
        hs::command::stop_on_signals();
    }
    return command->run();
}

} // namespace

int main(int argc, char** argv) {
    int status = hs::command::status_bad_input;
    try {
        keep_freed_memory();
        hs::command::ignore_failed_writes();
        status = run(argc, argv);
    } catch (const std::bad_alloc&) {
        status = hs::command::fail({{.message = "not enough memory; use a smaller size"}});
    } catch (const std::exception& error) {
        status = hs::command::fail({{.message = error.what()}});
    }
    hs::command::die_of_signal();
    return status;
}
