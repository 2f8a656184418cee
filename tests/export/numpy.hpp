// NumPy as the other program that opens our arrays.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hs::tests {

/// The command of a Python that has NumPy; nothing, with a warning, where there is none.
std::optional<std::string> python_with_numpy();

/// Runs a script with `numpy` as `np` and the file's arrays as `t`; what it printed, or what went
/// wrong.
std::string
run_numpy(const std::string& python, const std::filesystem::path& file, const std::string& script);

} // namespace hs::tests
