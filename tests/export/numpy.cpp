#include "tests/export/numpy.hpp"

#include "tests/export/temporary_folder.hpp"
#include "tests/support/catch.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace hs::tests {

std::optional<std::string> python_with_numpy() {
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        const std::string question = fmt::format("{} -c 'import numpy' 2>/dev/null", python);
        if (std::system(question.c_str()) == 0) { // NOLINT(concurrency-mt-unsafe,cert-env33-c)
            return python;
        }
    }
    WARN("skipped: there is no Python with NumPy (python3-numpy)");
    return std::nullopt;
}

std::string
run_numpy(const std::string& python, const std::filesystem::path& file, const std::string& script) {
    const TemporaryFolder folder;
    const std::filesystem::path program = folder.write(
        "script.py",
        fmt::format("import json, numpy as np\nt = np.load('{}')\n{}\n", file.string(), script)
    );
    const std::filesystem::path output = folder / "output.txt";
    const std::string command =
        fmt::format("{} {} >{} 2>&1", python, program.string(), output.string());
    const int status = std::system(command.c_str()); // NOLINT(concurrency-mt-unsafe,cert-env33-c)
    return read_text(output) + (status == 0 ? "" : fmt::format("(status {})\n", status));
}

} // namespace hs::tests
