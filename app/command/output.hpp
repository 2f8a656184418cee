// What a command says: results on stdout, one line of complaint on stderr, progress on a terminal.
#pragma once

#include "core/base/diagnostic.hpp"

#include <string_view>

namespace hs::command {

inline constexpr int status_done = 0;
inline constexpr int status_no = 1;
inline constexpr int status_bad_input = 2;

/// Prints the first diagnostic in one line on stderr, and how many more there are; returns
/// status_bad_input.
int fail(const Diagnostics& diagnostics);

/// Writes to stdout and returns `status`. A reader that has gone away, as in `… | head`, is no
/// mistake; a full disk behind the redirection is, and returns fail's status.
int print(std::string_view text, int status = status_done);

/// A bar on stderr, drawn over itself; nothing where stderr is no terminal.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ProgressBar(ProgressBar&&) = delete;
    ProgressBar& operator=(ProgressBar&&) = delete;
    ~ProgressBar();
    /// `part` of the work is done, in [0, 1].
    void show(double part) const;

private:
    bool shown_;
};

} // namespace hs::command
