// Where another recording of the same scene stands when one stands on a step, so that two
// configurations are stepped side by side; and where their pictures differ.
//
// Two runs of one scene with one setting changed need not have the same steps: another traversal
// asks other pixels, another clipping makes other pieces. What they share are vertices, triangles
// and pixels, so the counterpart is the first of these that exists: the step of the same path, the
// last step of the same triangle at the same pixel (a tile stands for its first pixel), the last
// step of the same triangle on the same scanline, the last step of the triangle or vertex.
#pragma once

#include "core/trace/player.hpp"

#include <cstdint>
#include <vector>

namespace hs::trace {

/// How nearly the other recording stands where the first one does.
enum class Match : std::uint8_t {
    same_step,
    same_pixel,
    same_scanline,
    same_part,
    same_count
};

struct Counterpart {
    StepId step = 0;
    Match match = Match::same_step;
    friend bool operator==(const Counterpart&, const Counterpart&) = default;
};

/// The step of `other` that corresponds to a step of another recording of the same scene.
Counterpart counterpart(const Recording& other, const Step& step);

/// As many steps into the same triangle, at most to its end: who is done first? Outside of
/// triangles the same as `counterpart`.
Counterpart
counterpart_by_count(const Recording& other, const Recording& recording, const Step& step);

/// Pixels whose final color differs, and how many final depths do.
/// Precondition: the pictures have the same size.
struct Difference {
    std::vector<PixelPos> color; ///< from the top left, row by row
    std::size_t depths = 0;
};
Difference difference(const Recording& a, const Recording& b);

} // namespace hs::trace

namespace hs {
template <>
std::span<const Named<trace::Match>> names<trace::Match>();
} // namespace hs
