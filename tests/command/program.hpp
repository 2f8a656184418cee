// The built program, run as people run it.
#pragma once

#include "tests/export/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace hs::tests {

struct Outcome {
    int status = 0; ///< as the shell sees it: 128 + n when killed by signal n
    std::string out;
    std::string err;
};

/// Runs `halfspace` with arguments, none of which needs a shell's attention. `prelude` goes before
/// it in a shell: "ulimit -f 8; ", `redirect` behind: "| head -1".
Outcome run_program(
    const std::vector<std::string>& arguments,
    const std::string& prelude = "",
    const std::string& redirect = ""
);

/// Runs it, expects status 2, nothing on stdout and exactly one line on stderr, which is returned
/// without the program's name.
std::string complaint(const std::vector<std::string>& arguments, const std::string& prelude = "");

/// A scene that comes with the program.
std::string scene(const std::string& name);

} // namespace hs::tests
