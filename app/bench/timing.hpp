// Clocks and medians. Machines differ and are noisy: what is compared runs in turns, and the
// median of the turns counts.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace hs::bench {

/// Milliseconds the calling thread has computed so far.
double thread_milliseconds();

/// Milliseconds that `run` takes.
template <typename Run>
double milliseconds(Run&& run) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    run();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Milliseconds that the calling thread computes in `run`: what it costs, however busy the machine
/// is with other work.
template <typename Run>
double computing_milliseconds(Run&& run) {
    const double start = thread_milliseconds();
    run();
    return thread_milliseconds() - start;
}

/// The value below which `part` (0 … 1) of the values lie; the median at 0.5.
/// Precondition: there are values.
double quantile(std::vector<double> values, double part);
[[nodiscard]] inline double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

/// Returns its own milliseconds, so that it can prepare and clean up unmeasured.
using Contestant = std::function<double()>;

/// The medians of all contestants, who run in turns: at least `fewest` rounds, and more while
/// `seconds` are not over, at most 41. A first round is not counted.
std::vector<double>
take_turns(std::span<const Contestant> contestants, std::size_t fewest, double seconds);

} // namespace hs::bench
