#include "app/bench/machine.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace hs::bench {
namespace {

/// "model name : …" of Linux; other systems do without.
std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return {};
}

std::string compiler_name() {
#ifdef __clang__
    return "clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

} // namespace

Machine this_machine() {
    std::array<double, 1> load{};
    if (getloadavg(load.data(), 1) != 1) {
        load[0] = 0.0;
    }
    return {processor_name(), std::thread::hardware_concurrency(), compiler_name(), load[0]};
}

} // namespace hs::bench
