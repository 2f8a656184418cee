// What finding the covered pixels costs, counted the same way for every traversal.
//
// Counted is what a traversal does between setup and fragments:
//   evaluation      a·x + b·y + c afresh at a pixel center: 2 multiplications, 2 additions
//   product, sum    every other multiplication and addition: an edge value moved to the next pixel,
//                   the x of an edge moved to the next scanline
//   division        of integers: where an edge meets its first scanline, and how far it moves
// Not counted: what all traversals share (the setup of the edge functions), comparisons, loop
// variables, and shifts (a pixel is 2^8 units wide).
#pragma once

#include <cstdint>

namespace hs::raster {

struct Cost {
    std::uint64_t pixels = 0; ///< visited, whether asked or known to be covered
    std::uint64_t tiles = 0;  ///< tested
    std::uint64_t evaluations = 0;
    std::uint64_t products = 0; ///< beyond those of the evaluations
    std::uint64_t sums = 0;     ///< beyond those of the evaluations
    std::uint64_t divisions = 0;

    [[nodiscard]] std::uint64_t multiplications() const { return 2 * evaluations + products; }
    [[nodiscard]] std::uint64_t additions() const { return 2 * evaluations + sums; }

    Cost& operator+=(const Cost& other) {
        pixels += other.pixels;
        tiles += other.tiles;
        evaluations += other.evaluations;
        products += other.products;
        sums += other.sums;
        divisions += other.divisions;
        return *this;
    }
    friend bool operator==(const Cost&, const Cost&) = default;
};

/// A pixel asked by evaluating its three edge functions.
inline constexpr Cost cost_of_asking{.pixels = 1, .evaluations = 3};
/// Three edge values moved to a neighboring pixel.
inline constexpr Cost cost_of_moving{.sums = 3};

} // namespace hs::raster
