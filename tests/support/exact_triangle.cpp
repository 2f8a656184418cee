#include "tests/support/exact_triangle.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hs::tests {
namespace {

Affine combined(const std::vector<Affine>& weights, const glm::dvec3& factors) {
    Affine sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = factors[static_cast<int>(i)];
        sum.gradient += factor * weights[i].gradient;
        sum.offset += factor * weights[i].offset;
    }
    return sum;
}

std::optional<Affine> in_pixels(const Affine& line) {
    const double length = glm::length(line.gradient);
    if (!(length > 0.0)) {
        return std::nullopt; // the same everywhere: bounds nothing, or everything
    }
    return Affine{line.gradient / length, line.offset / length};
}

glm::dvec2 foot(const Affine& line, const glm::dvec2& p) {
    return p - line(p) * line.gradient;
}

std::optional<glm::dvec2> crossing(const Affine& l, const Affine& m) {
    const double determinant = l.gradient.x * m.gradient.y - l.gradient.y * m.gradient.x;
    if (determinant == 0.0) {
        return std::nullopt;
    }
    return glm::dvec2{
        (l.gradient.y * m.offset - m.gradient.y * l.offset) / determinant,
        (m.gradient.x * l.offset - l.gradient.x * m.offset) / determinant};
}

double last_bit(scene::DepthFormat format) {
    return format == scene::DepthFormat::unorm24   ? 1.0 / 16777215.0
           : format == scene::DepthFormat::unorm16 ? 1.0 / 65535.0
                                                   : 0.0;
}

} // namespace

double depth_tolerance(const ExactTriangle& triangle, const scene::Settings& settings) {
    const double slope = triangle.depth_slope();
    const double size = std::max(settings.width, settings.height);
    return last_bit(settings.depth_format) + 8.0 * 0x1p-24 * (1.0 + size * slope) + slope / 512.0;
}

double Affine::slope() const {
    return std::fabs(gradient.x) + std::fabs(gradient.y);
}

ExactTriangle::ExactTriangle(
    std::span<const glm::vec4> corners, const PixelRect& viewport, std::span<const glm::vec4> planes
) {
    const glm::dvec4 p0{corners[0]};
    const glm::dvec4 p1{corners[1]};
    const glm::dvec4 p2{corners[2]};
    const glm::dmat3 m{
        glm::dvec3{p0.x, p0.y, p0.w}, glm::dvec3{p1.x, p1.y, p1.w}, glm::dvec3{p2.x, p2.y, p2.w}};
    has_area_ = glm::determinant(m) != 0.0;
    if (!has_area_) {
        return;
    }

    // a = M⁻¹ (x_ndc, y_ndc, 1), and NDC is affine in the window
    const glm::dmat3 inverse = glm::inverse(m);
    const glm::dvec2 half{viewport.width() / 2.0, viewport.height() / 2.0};
    const glm::dvec2 center{viewport.x0 + half.x, viewport.y0 + half.y};
    for (int i = 0; i < 3; ++i) {
        Affine a;
        a.gradient = {inverse[0][i] / half.x, -inverse[1][i] / half.y};
        a.offset = inverse[2][i] - glm::dot(a.gradient, center);
        weights_.push_back(a);
    }
    w_ = {p0.w, p1.w, p2.w};
    const Affine z = combined(weights_, {p0.z, p1.z, p2.z});
    depth_ = {0.5 * z.gradient, 0.5 * z.offset + 0.5};

    // Every bound: three edges, near and far (w is 1 here), user planes
    std::vector<Affine> bounds = weights_;
    bounds.push_back({z.gradient, z.offset + 1.0});
    bounds.push_back({-z.gradient, 1.0 - z.offset});
    for (const glm::vec4& plane : planes) {
        const glm::dvec4 h{plane};
        bounds.push_back(combined(weights_, {glm::dot(h, p0), glm::dot(h, p1), glm::dot(h, p2)}));
    }
    for (const Affine& bound : bounds) {
        if (const auto line = in_pixels(bound)) {
            bounds_.push_back(*line);
        } else if (bound.offset < 0.0) {
            has_area_ = false; // wholly outside
        }
    }
}

glm::dvec3 ExactTriangle::linear_weights(const glm::dvec2& p) const {
    return {weights_[0](p) * w_[0], weights_[1](p) * w_[1], weights_[2](p) * w_[2]};
}

glm::dvec3 ExactTriangle::perspective_weights(const glm::dvec2& p) const {
    const glm::dvec3 a{weights_[0](p), weights_[1](p), weights_[2](p)};
    return a / (a.x + a.y + a.z);
}

Range ExactTriangle::near_snap(const glm::dvec2& p, const glm::dvec3& values, bool perspective)
    const {
    constexpr double half_step = 1.0 / 512.0;
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const glm::dvec2& corner : {
             p + glm::dvec2{-half_step, -half_step},
             p + glm::dvec2{-half_step, half_step},
             p + glm::dvec2{half_step, -half_step},
             p + glm::dvec2{half_step, half_step},
         }) {
        if (weights_[0](corner) + weights_[1](corner) + weights_[2](corner) <= 0.0) {
            const auto [low, high] = std::minmax({values.x, values.y, values.z});
            return {low, high};
        }
        const glm::dvec3 weights =
            perspective ? perspective_weights(corner) : linear_weights(corner);
        const double value = glm::dot(weights, values);
        range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

bool ExactTriangle::all_inside(const glm::dvec2& p, double tolerance) const {
    return std::ranges::all_of(bounds_, [&](const Affine& line) { return line(p) >= -tolerance; });
}

bool ExactTriangle::covers(const glm::dvec2& p) const {
    return has_area_ && all_inside(p, 0.0);
}

bool ExactTriangle::edge_within(const glm::dvec2& p, double distance) const {
    constexpr double on_line = 1.0e-9;
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        // The nearest point of an edge is the foot on its line, or one of its ends
        const glm::dvec2 nearest = foot(bounds_[i], p);
        if (glm::distance(nearest, p) <= distance && all_inside(nearest, on_line)) {
            return true;
        }
        for (std::size_t k = 0; k < i; ++k) {
            const auto corner = crossing(bounds_[i], bounds_[k]);
            if (corner && glm::distance(*corner, p) <= distance && all_inside(*corner, on_line)) {
                return true;
            }
        }
    }
    return false;
}

} // namespace hs::tests
