#include "app/bench/timing.hpp"

#include <algorithm>
#include <ctime>

namespace hs::bench {

double thread_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

double quantile(std::vector<double> values, double part) {
    const auto at = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(
        values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end()
    );
    return values[at];
}

std::vector<double>
take_turns(std::span<const Contestant> contestants, std::size_t fewest, double seconds) {
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t most = 41;
    std::vector<std::vector<double>> times(contestants.size());
    for (const Contestant& contestant : contestants) {
        contestant();
    }
    const Clock::time_point start = Clock::now();
    const auto time_is_left = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count() < seconds;
    };
    for (std::size_t round = 0; round < fewest || (round < most && time_is_left()); ++round) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            times[i].push_back(contestants[i]());
        }
    }
    std::vector<double> medians(times.size());
    std::ranges::transform(times, medians.begin(), [](const auto& t) { return median(t); });
    return medians;
}

} // namespace hs::bench
