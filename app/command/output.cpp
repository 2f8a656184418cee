#include "app/command/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace hs::command {

int fail(const Diagnostics& diagnostics) {
    std::string line = diagnostics.front().to_string();
    if (diagnostics.size() > 1) {
        line += fmt::format(" (and {} more)", diagnostics.size() - 1);
    }
    // Libraries like to speak in paragraphs
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::fputs(("halfspace: " + line + '\n').c_str(), stderr);
    return status_bad_input;
}

int print(std::string_view text, int status) {
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (written || errno == EPIPE) {
        return status;
    }
    return fail(
        {{.file = "standard output",
          .message = "cannot be written: " + std::generic_category().message(errno)}}
    );
}

ProgressBar::ProgressBar(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (shown_) {
        std::fputs("\r\033[K", stderr);
    }
}

void ProgressBar::show(double part) const {
    constexpr int width = 40;
    if (shown_) {
        const auto full = static_cast<int>(part * width);
        const std::string bar =
            fmt::format("\rrecording [{:=<{}}{: <{}}]", "", full, "", width - full);
        std::fputs(bar.c_str(), stderr);
    }
}

} // namespace hs::command
