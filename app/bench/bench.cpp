#include "app/bench/bench.hpp"

#include "app/bench/report.hpp"
#include "app/bench/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace hs::bench {

int run_bench(const BenchOptions& options) {
    Session session(options);
    measure_limits(session);
    measure_frames(session);
    measure_playhead(session);
    measure_memory(session);
    measure_viewer(session);
    measure_startup(session);
    measure_growth(session);

    const Results& results = session.results();
    if (results.measurements.empty()) {
        for (const std::string& sentence : results.remarks) {
            fmt::print(stderr, "{}\n", sentence);
        }
        fmt::print(stderr, "There is no measurement whose name begins with '{}'.\n", options.only);
        return 2;
    }
    fmt::print("{}", options.json ? to_json(results) : to_table(results));
    const bool all_hold = std::ranges::all_of(results.measurements, [](const Measurement& m) {
        return m.holds().value_or(true);
    });
    return all_hold ? 0 : 1;
}

} // namespace hs::bench
