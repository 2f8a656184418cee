// Where a polygon lies with respect to a plane.
#pragma once

#include <cstdint>

namespace hs::visibility {

/// Corners within the tolerance of the plane lie on it and take no side.
enum class Side : std::uint8_t {
    on,      ///< every corner lies on the plane: coplanar
    front,   ///< none lies behind
    back,    ///< none lies in front
    spanning ///< some in front, some behind: only a split separates them
};

} // namespace hs::visibility
