// Varyings: what the vertex stage hands to the rasterizer to be interpolated over a triangle.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace hs::math {

/// Which varyings a draw uses and where they start in `Varyings::values`. Position in the array is
/// fixed by need: color is always there, the others only where the shading asks for them, so that
/// nothing unused is interpolated.
struct VaryingLayout {
    int uv = -1;           ///< 2 floats, or -1: not used
    int normal = -1;       ///< 3 floats, eye space, or -1
    int eye_position = -1; ///< 3 floats, or -1
    int count = 4;         ///< floats in use; color is 0…3
};

inline constexpr int max_varyings = 12;

/// Up to 12 floats; only the first `VaryingLayout::count` are meaningful, the rest stay 0.
struct Varyings {
    std::array<float, max_varyings> values{};

    [[nodiscard]] float operator[](int i) const { return values[static_cast<unsigned>(i)]; }
    [[nodiscard]] float& operator[](int i) { return values[static_cast<unsigned>(i)]; }
    [[nodiscard]] glm::vec4 color() const { return {values[0], values[1], values[2], values[3]}; }
    [[nodiscard]] glm::vec2 vec2_at(int i) const { return {(*this)[i], (*this)[i + 1]}; }
    [[nodiscard]] glm::vec3 vec3_at(int i) const {
        return {(*this)[i], (*this)[i + 1], (*this)[i + 2]};
    }
    void set(int i, const glm::vec2& v) {
        (*this)[i] = v.x;
        (*this)[i + 1] = v.y;
    }
    void set(int i, const glm::vec3& v) {
        set(i, glm::vec2{v.x, v.y});
        (*this)[i + 2] = v.z;
    }
    void set(int i, const glm::vec4& v) {
        set(i, glm::vec3{v.x, v.y, v.z});
        (*this)[i + 3] = v.w;
    }
    friend bool operator==(const Varyings&, const Varyings&) = default;
};

} // namespace hs::math
