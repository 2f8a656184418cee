// `halfspace bench`: this program held to its budgets, beside OSMesa and the machine's limits.
#pragma once

#include <filesystem>
#include <string>

namespace hs::bench {

struct BenchOptions {
    std::string only;           ///< measure what has a name that begins like this; "": everything
    bool json = false;          ///< one JSON document instead of a table
    bool quiet = false;         ///< nothing but the result
    std::filesystem::path data; ///< folder of the shared meshes; "": HALFSPACE_DATA, or beside us
};

/// Measures and prints. 0: every budget holds; 1: some does not; 2: nothing has such a name.
int run_bench(const BenchOptions& options);

} // namespace hs::bench
