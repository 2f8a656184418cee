// Limits: what no renderer on this machine can go below.
#include "app/bench/session.hpp"
#include "app/peer/memory_bandwidth.hpp"

namespace hs::bench {

void measure_limits(Session& session) {
    if (!session.wants_any("limit.memcpy.")) {
        return;
    }
    session.progress("memory bandwidth");
    const peer::MemoryBandwidth bandwidth = peer::memory_bandwidth();
    session.add({.name = "limit.memcpy.one-thread", .value = bandwidth.one_thread, .unit = "GB/s"});
    session.add({.name = "limit.memcpy.two-threads", .value = bandwidth.two_threads, .unit = "GB/s"}
    );
}

} // namespace hs::bench
