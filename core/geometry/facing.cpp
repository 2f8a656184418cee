#include "core/geometry/facing.hpp"

namespace hs {

template <>
std::span<const Named<geometry::TriangleVerdict>> names<geometry::TriangleVerdict>() {
    using geometry::TriangleVerdict;
    static constexpr std::array<Named<TriangleVerdict>, 10> table{{
        {TriangleVerdict::drawn, "drawn", "it covered at least one pixel center"},
        {TriangleVerdict::outside, "outside", "nothing of it lies inside the view volume"},
        {TriangleVerdict::back_facing,
         "back-facing",
         "it shows its back, and back faces are culled"},
        {TriangleVerdict::front_facing,
         "front-facing",
         "it shows its front, and front faces are culled"},
        {TriangleVerdict::degenerate, "degenerate", "its snapped vertices enclose no area"},
        {TriangleVerdict::no_sample_covered,
         "no sample covered",
         "it passes between the pixel centers"},
        {TriangleVerdict::behind_the_eye,
         "behind the eye",
         "a vertex with w = 0 has no place in the window"},
        {TriangleVerdict::too_large,
         "too large",
         "a vertex lies millions of pixels away, beyond exact arithmetic"},
        {TriangleVerdict::stuck,
         "stuck",
         "the ordering found no moment at which it could be drawn"},
        {TriangleVerdict::unseen,
         "unseen",
         "at no pixel center is it the nearest, or it covers none"},
    }};
    return table;
}

} // namespace hs
