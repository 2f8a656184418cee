// A triangle evaluated in double precision straight from its clip coordinates, without clipping,
// dividing or snapping: Olano and Greer, Triangle Scan Conversion Using 2D Homogeneous Coordinates,
// 1997.
//
// At a point of the window, a holds the weights with Σ a_i (x_i, y_i, w_i) = (x_ndc, y_ndc, 1).
// They are affine in the window; all positive inside the triangle, and only in front of the eye.
#pragma once

#include "core/base/pixel.hpp"
#include "core/scene/settings.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace hs::tests {

/// Closed.
struct Range {
    double low = 0.0;
    double high = 0.0;
};

/// value = gradient · point + offset, over the window in pixels.
struct Affine {
    glm::dvec2 gradient{0.0};
    double offset = 0.0;

    [[nodiscard]] double operator()(const glm::dvec2& p) const {
        return gradient.x * p.x + gradient.y * p.y + offset;
    }
    /// |d/dx| + |d/dy|: by how much the value can change per pixel.
    [[nodiscard]] double slope() const;
};

class ExactTriangle {
public:
    /// Three clip positions; `planes` are user planes in clip space.
    ExactTriangle(
        std::span<const glm::vec4> corners,
        const PixelRect& viewport,
        std::span<const glm::vec4> planes = {}
    );

    /// False where the triangle is seen edge-on: it covers nothing then.
    [[nodiscard]] bool has_area() const { return has_area_; }

    /// Weights for what is linear in the window.
    [[nodiscard]] glm::dvec3 linear_weights(const glm::dvec2& p) const;
    /// Weights for what is linear in eye space.
    [[nodiscard]] glm::dvec3 perspective_weights(const glm::dvec2& p) const;
    /// What a rasterizer may interpolate at p that rounds its vertices to 1/256 pixel: in the
    /// snapped triangle, p has the weights that some point at most 1/512 pixel away in x and in y
    /// has in this one, so it gets that point's value. Values at the corners of that square bound
    /// those within; where the square reaches a point with 1/w <= 0, all the triangle's values are
    /// allowed.
    [[nodiscard]] Range
    near_snap(const glm::dvec2& p, const glm::dvec3& values, bool perspective) const;

    /// Window depth: ½ z_ndc + ½.
    [[nodiscard]] double depth(const glm::dvec2& p) const { return depth_(p); }
    [[nodiscard]] double depth_slope() const { return depth_.slope(); }

    /// Inside the triangle, the near and the far plane and the user planes. (The sides of the view
    /// volume are the image's.)
    [[nodiscard]] bool covers(const glm::dvec2& p) const;
    /// Whether an edge of the clipped polygon passes within `distance` pixels.
    [[nodiscard]] bool edge_within(const glm::dvec2& p, double distance) const;

private:
    [[nodiscard]] bool all_inside(const glm::dvec2& p, double tolerance) const;

    bool has_area_ = false;
    glm::dvec3 w_{1.0};
    std::vector<Affine> weights_; ///< a_0, a_1, a_2
    Affine depth_;
    std::vector<Affine> bounds_; ///< in pixels: distance to each line that bounds the polygon
};

/// By how much the stored depth of two honest implementations may differ: the last bit of the
/// format, the float arithmetic of a plane over the image, and what snapping moves. Computed for
/// each triangle; a flat number would hide errors on gentle triangles and blame steep ones.
double depth_tolerance(const ExactTriangle& triangle, const scene::Settings& settings);

} // namespace hs::tests
