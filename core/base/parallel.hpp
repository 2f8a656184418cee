// Independent work on two or more threads. Only for pure functions of an index: the result never
// depends on the number of threads, time does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace hs {

/// As many threads as the machine runs at once, at least one.
[[nodiscard]] inline unsigned hardware_threads() {
    return std::max(1U, std::thread::hardware_concurrency());
}

/// Calls `work(first, last)` for contiguous ranges that together make [0, count), each on a thread
/// of its own; the caller's thread takes the first. Ranges of fewer than `grain` elements are not
/// worth a thread. `work` must not throw.
template <typename Work>
void parallel_ranges(std::size_t count, unsigned threads, std::size_t grain, const Work& work) {
    const std::size_t parts =
        std::clamp<std::size_t>(count / std::max<std::size_t>(grain, 1), 1, std::max(threads, 1U));
    const auto begin_of = [count, parts](std::size_t part) { return count * part / parts; };
    std::vector<std::jthread> others;
    others.reserve(parts - 1);
    for (std::size_t part = 1; part < parts; ++part) {
        others.emplace_back([&work, first = begin_of(part), last = begin_of(part + 1)] {
            work(first, last);
        });
    }
    work(std::size_t{0}, begin_of(1));
}

} // namespace hs
