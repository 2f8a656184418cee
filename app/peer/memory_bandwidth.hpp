// How fast this machine copies memory: the limit below which no renderer can go.
#pragma once

namespace hs::peer {

/// In GB/s (10⁹ bytes), each byte copied counted once although the memory both reads and writes it.
struct MemoryBandwidth {
    double one_thread = 0.0;
    double two_threads = 0.0;
};

/// Median of seven memcpy of a block much larger than the caches, 256 MB in memory while it runs.
/// Takes about half a second.
[[nodiscard]] MemoryBandwidth memory_bandwidth();

} // namespace hs::peer
