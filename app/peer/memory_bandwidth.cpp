#include "memory_bandwidth.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <span>
#include <thread>
#include <vector>

namespace hs::peer {

namespace {

void copy(std::span<const std::byte> source, std::span<std::byte> destination) {
    std::memcpy(destination.data(), source.data(), source.size());
}

/// The first half by a thread of its own, which costs some 50 µs to start: below one percent of the
/// copy.
void copy_with_two_threads(std::span<const std::byte> source, std::span<std::byte> destination) {
    const std::size_t half = source.size() / 2;
    const std::jthread helper([&] { copy(source.first(half), destination.first(half)); });
    copy(source.subspan(half), destination.subspan(half));
}

/// Median of seven, in GB/s.
template <typename Copy>
double measure(std::size_t bytes, Copy&& run) {
    using Clock = std::chrono::steady_clock;
    std::array<double, 7> rates{};
    for (double& rate : rates) {
        const Clock::time_point start = Clock::now();
        run();
        const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
        rate = static_cast<double>(bytes) / elapsed.count();
    }
    std::ranges::nth_element(rates, rates.begin() + 3);
    return rates[3];
}

} // namespace

MemoryBandwidth memory_bandwidth() {
    constexpr std::size_t block_size = 128'000'000;
    // Filled, so that every page exists before the first measurement.
    const std::vector<std::byte> source(block_size, std::byte{1});
    std::vector<std::byte> destination(block_size, std::byte{2});
    return {
        .one_thread = measure(block_size, [&] { copy(source, destination); }),
        .two_threads = measure(block_size, [&] { copy_with_two_threads(source, destination); }),
    };
}

} // namespace hs::peer
