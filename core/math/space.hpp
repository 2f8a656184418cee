// One type per coordinate space, and transforms that say from where to where. Forgetting a matrix
// or the perspective divide does not compile.
//
// Spaces, in the order a vertex meets them: object › world › eye › clip › NDC › window.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace hs::math {

struct ObjectSpace {}; ///< as modeled, before any matrix
struct WorldSpace {};  ///< where the scene stands
struct EyeSpace {};    ///< the eye at the origin, looking along -z (OpenGL)
struct ClipSpace {};   ///< homogeneous; inside the view volume iff -w <= x, y, z <= w (OpenGL)

/// A homogeneous point of one space.
template <typename Space>
struct Position {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
    float w = 1.0F;
    friend bool operator==(const Position&, const Position&) = default;
};

using ObjectPosition = Position<ObjectSpace>;
using WorldPosition = Position<WorldSpace>;
using EyePosition = Position<EyeSpace>;
using ClipPosition = Position<ClipSpace>;

/// Normalized device coordinates: x right, y up, each in [-1, 1] inside the view volume.
struct NdcPosition {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
    friend bool operator==(const NdcPosition&, const NdcPosition&) = default;
};

/// Window coordinates: pixels from the top-left corner of the image, y down; depth in [0, 1] inside
/// the view volume.
struct WindowPosition {
    float x = 0.0F;
    float y = 0.0F;
    float depth = 0.0F;
    friend bool operator==(const WindowPosition&, const WindowPosition&) = default;
};

template <typename Space>
[[nodiscard]] glm::vec4 to_vec4(const Position<Space>& p) {
    return {p.x, p.y, p.z, p.w};
}
template <typename Space>
[[nodiscard]] Position<Space> to_position(const glm::vec4& v) {
    return {v.x, v.y, v.z, v.w};
}

/// One row of a matrix times a vector: the arithmetic of every transform, in the order it is
/// executed. Templated on the scalar so that the same code can compute a number or write down its
/// formula.
template <typename T> // NOLINTNEXTLINE(readability-function-size): a row and a vector
[[nodiscard]] T row_times_vector(T m0, T m1, T m2, T m3, T x, T y, T z, T w) {
    return ((m0 * x + m1 * y) + m2 * z) + m3 * w;
}

/// A 4×4 matrix from one space to another. Column vectors: transforms apply right to left.
template <typename From, typename To>
struct Transform {
    glm::mat4 matrix{1.0F}; ///< glm stores columns: matrix[column][row]

    [[nodiscard]] Position<To> operator()(const Position<From>& p) const {
        const auto row = [&](int r) {
            return row_times_vector(
                matrix[0][r], matrix[1][r], matrix[2][r], matrix[3][r], p.x, p.y, p.z, p.w
            );
        };
        return {row(0), row(1), row(2), row(3)};
    }
};

/// The transform "first inner, then outer".
template <typename A, typename B, typename C>
[[nodiscard]] Transform<A, C> compose(const Transform<B, C>& outer, const Transform<A, B>& inner) {
    return {outer.matrix * inner.matrix};
}

} // namespace hs::math
