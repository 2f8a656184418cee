#include "core/base/parallel.hpp"

#include "tests/support/catch.hpp"

#include <algorithm>
#include <vector>

using namespace hs;

TEST_CASE("every index is worked on exactly once, whatever the threads", "[base]") {
    for (const unsigned threads : {0U, 1U, 2U, 3U, 8U}) {
        for (const std::size_t count : {0U, 1U, 7U, 100U, 1001U}) {
            std::vector<int> done(count, 0);
            parallel_ranges(count, threads, 10, [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) {
                    ++done[i]; // ranges do not overlap, so no other thread touches it
                }
            });
            INFO(count << " indices on " << threads << " threads");
            CHECK(std::ranges::count(done, 1) == static_cast<std::ptrdiff_t>(count));
        }
    }
}
