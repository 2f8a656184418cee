#include "tests/command/program.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

namespace hs::tests {
namespace {

std::string shell_word(const std::string& text) {
    std::string result = "'";
    for (const char letter : text) {
        result += letter == '\'' ? std::string{"'\\''"} : std::string{letter};
    }
    return result + "'";
}

} // namespace

Outcome run_program(
    const std::vector<std::string>& arguments,
    const std::string& prelude,
    const std::string& redirect
) {
    const auto program = test::program();
    REQUIRE(program);
    const TemporaryFolder folder;
    std::string command = prelude + shell_word(program->string());
    for (const std::string& argument : arguments) {
        command += ' ' + shell_word(argument);
    }
    command += fmt::format(" 2>{} ", (folder / "err").string());
    command += redirect.empty() ? ">" + (folder / "out").string() : redirect;
    // A shell of its own, so that limits set in it end with it
    const std::string in_shell = "sh -c " + shell_word(command);
    const int status = std::system(in_shell.c_str()); // NOLINT(concurrency-mt-unsafe,cert-env33-c)
    return {
        WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
        read_text(folder / "out"),
        read_text(folder / "err")};
}

std::string complaint(const std::vector<std::string>& arguments, const std::string& prelude) {
    const Outcome outcome = run_program(arguments, prelude);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    INFO(outcome.err);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    const std::string name = "halfspace: ";
    REQUIRE(outcome.err.starts_with(name));
    return outcome.err.substr(name.size(), outcome.err.size() - name.size() - 1);
}

std::string scene(const std::string& name) {
    return (test::source_dir() / "lessons/scenes" / name).string();
}

} // namespace hs::tests
