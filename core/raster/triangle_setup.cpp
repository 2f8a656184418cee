#include "core/raster/triangle_setup.hpp"

#include "core/base/check.hpp"

#include <algorithm>

namespace hs::raster {
namespace {

PixelRect bounds_of(const std::array<FixedPosition, 3>& v) {
    const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
    return {
        first_center_at_or_after(min_x),
        first_center_at_or_after(min_y),
        end_of_centers_up_to(max_x),
        end_of_centers_up_to(max_y),
    };
}

} // namespace

TriangleSetup set_up(
    const std::array<FixedPosition, 3>& vertices,
    std::int64_t signed_doubled_area,
    const PixelRect& image
) {
    HS_DCHECK(signed_doubled_area != 0, "a degenerate triangle has no setup");
    TriangleSetup setup;
    setup.vertices = vertices;
    const bool negate = signed_doubled_area < 0;

    // Coefficients of the three edge functions, positive inside whatever the winding
    setup.edges[0] = edge_through(vertices[0], vertices[1], negate);
    setup.edges[1] = edge_through(vertices[1], vertices[2], negate);
    setup.edges[2] = edge_through(vertices[2], vertices[0], negate);

    // Bias edges so that a shared edge is owned by exactly one triangle
    for (unsigned k = 0; k < 3; ++k) {
        setup.top_left_bias[k] = setup.edges[k].owns_ties() ? 0 : -1;
    }

    // Bounding box of the pixel centers, and the area that turns edge values into weights
    setup.bounds = intersect(bounds_of(vertices), image);
    setup.doubled_area = negate ? -signed_doubled_area : signed_doubled_area;
    setup.inv_doubled_area = 1.0F / static_cast<float>(setup.doubled_area);
    return setup;
}

} // namespace hs::raster
