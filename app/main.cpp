// The command line. Without a command the viewer opens on the lessons.
#include "app/command/command.hpp"
#include "core/base/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <exception>
#include <vector>

namespace {

using hs::command::Command;
using hs::command::Common;

void add_common_options(CLI::App& program, Common& common) {
    program.add_option("--set", common.set, "change any entry of the scene: KEY=VALUE, repeatable")
        ->take_all()
        ->allow_extra_args(false);
    program.add_option("--size", common.size, "size of the image (for shot: the window): WxH");
    program.add_option("--threads", common.threads, "how many threads may work; 0: all");
    program.add_flag("--quiet", common.quiet, "no progress, no summaries");
    program.add_flag("--json", common.json, "print one JSON document");
}

std::vector<Command> add_commands(CLI::App& program, const Common& common) {
    using namespace hs::command;
    return {
        add_open(program, common),
        add_render(program, common),
        add_record(program, common),
        add_export(program, common),
        add_history(program, common),
        add_shot(program, common),
        add_check(program, common),
        add_bench(program, common)};
}

/// Usage errors become the same one line as all others.
int report(const CLI::App& program, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        return program.exit(error); // --help and --version
    }
    return hs::command::fail({{.message = fmt::format("{}; see halfspace --help", error.what())}});
}

int run(int argc, char** argv) {
    CLI::App program{"Watch the graphics pipeline think.", "halfspace"};
    program.footer(
        "A step is a path like 'object 0 / triangle 12 / fragment 31,17 / depth test', #NUMBER, "
        "start or end.\nExit status: 0 done, 1 the answer is no, 2 usage or bad input."
    );
    program.set_version_flag("--version", std::string{hs::program_version()});
    program.fallthrough();
    program.require_subcommand(0, 1);
    Common common;
    add_common_options(program, common);
    const std::vector<Command> commands = add_commands(program, common);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        for (const Command& command : commands) {
            if (command.app->parsed()) {
                return report(*command.app, error);
            }
        }
        return report(program, error);
    }
    for (const Command& command : commands) {
        if (command.app->parsed()) {
            return command.run();
        }
    }
    return hs::command::open_lessons(common);
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return hs::command::fail({{.message = "not enough memory; use a smaller size"}});
    } catch (const std::exception& error) {
        return hs::command::fail({{.message = error.what()}});
    }
}
