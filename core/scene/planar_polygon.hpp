// One polygon of a mesh, laid into a plane: what triangulation decides with.
//
// Sources: Newell's normal, in Sutherland, Sproull and Schumacker 1974; mean value coordinates,
// Floater 2003; two ears, Meisters 1975, cut as in Eberly 2002.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hs::scene {

/// Corners in order, counter-clockwise as seen from the side the polygon's normal points to.
using PlanarPolygon = std::vector<glm::dvec2>;

/// Three corner numbers of one polygon.
using CornerTriangle = std::array<std::size_t, 3>;

/// Drops the coordinate that the polygon's normal faces most. Nothing for a polygon without area or
/// with w <= 0.
std::optional<PlanarPolygon> lay_flat(std::span<const glm::vec4> corners);

/// The lowest-numbered corner from which a fan has only triangles of positive area.
std::optional<std::size_t> find_fan_corner(const PlanarPolygon& polygon);

/// A point well inside the kernel, the region that sees the whole polygon; nothing when the kernel
/// has no area.
std::optional<glm::dvec2> find_kernel_point(const PlanarPolygon& polygon);

/// Weights of the corners, positive and of sum 1, that make `inside` of them. Precondition:
/// `inside` lies in the kernel.
std::vector<double> mean_value_weights(const PlanarPolygon& polygon, const glm::dvec2& inside);

/// n - 2 triangles, always cutting the lowest-numbered ear; what has no ear is fanned.
std::vector<CornerTriangle> clip_ears(const PlanarPolygon& polygon);

} // namespace hs::scene
