// The teapot: 32 bicubic Bézier patches by Martin Newell, University of Utah, 1975; public domain.
//
// Only what symmetry does not give is listed: a quarter of rim, body, lid and bottom (the bottom
// was added by Crow 1987), half of handle and spout. z is up in the data, y in the result.
#include "core/base/check.hpp"
#include "core/scene/shapes/families.hpp"
#include "core/scene/shapes/grid.hpp"
#include "core/scene/triangulate.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace hs::scene::shapes {

namespace {

// clang-format off
constexpr float control_points[][3] = {
    {0.2F, 0, 2.7F}, {0.2F, -0.112F, 2.7F}, {0.112F, -0.2F, 2.7F}, {0, -0.2F, 2.7F}, // 0
    {1.3375F, 0, 2.53125F}, {1.3375F, -0.749F, 2.53125F}, {0.749F, -1.3375F, 2.53125F}, {0, -1.3375F, 2.53125F}, // 4
    {1.4375F, 0, 2.53125F}, {1.4375F, -0.805F, 2.53125F}, {0.805F, -1.4375F, 2.53125F}, {0, -1.4375F, 2.53125F}, // 8
    {1.5F, 0, 2.4F}, {1.5F, -0.84F, 2.4F}, {0.84F, -1.5F, 2.4F}, {0, -1.5F, 2.4F}, // 12
    {1.75F, 0, 1.875F}, {1.75F, -0.98F, 1.875F}, {0.98F, -1.75F, 1.875F}, {0, -1.75F, 1.875F}, // 16
    {2, 0, 1.35F}, {2, -1.12F, 1.35F}, {1.12F, -2, 1.35F}, {0, -2, 1.35F}, // 20
    {2, 0, 0.9F}, {2, -1.12F, 0.9F}, {1.12F, -2, 0.9F}, {0, -2, 0.9F}, // 24
    {-2, 0, 0.9F}, // 28
    {2, 0, 0.45F}, {2, -1.12F, 0.45F}, {1.12F, -2, 0.45F}, {0, -2, 0.45F}, // 29
    {1.5F, 0, 0.225F}, {1.5F, -0.84F, 0.225F}, {0.84F, -1.5F, 0.225F}, {0, -1.5F, 0.225F}, // 33
    {1.5F, 0, 0.15F}, {1.5F, -0.84F, 0.15F}, {0.84F, -1.5F, 0.15F}, {0, -1.5F, 0.15F}, // 37
    {-1.6F, 0, 2.025F}, {-1.6F, -0.3F, 2.025F}, {-1.5F, -0.3F, 2.25F}, {-1.5F, 0, 2.25F}, // 41
    {-2.3F, 0, 2.025F}, {-2.3F, -0.3F, 2.025F}, {-2.5F, -0.3F, 2.25F}, {-2.5F, 0, 2.25F}, // 45
    {-2.7F, 0, 2.025F}, {-2.7F, -0.3F, 2.025F}, {-3, -0.3F, 2.25F}, {-3, 0, 2.25F}, // 49
    {-2.7F, 0, 1.8F}, {-2.7F, -0.3F, 1.8F}, {-3, -0.3F, 1.8F}, {-3, 0, 1.8F}, // 53
    {-2.7F, 0, 1.575F}, {-2.7F, -0.3F, 1.575F}, {-3, -0.3F, 1.35F}, {-3, 0, 1.35F}, // 57
    {-2.5F, 0, 1.125F}, {-2.5F, -0.3F, 1.125F}, {-2.65F, -0.3F, 0.9375F}, {-2.65F, 0, 0.9375F}, // 61
    {-2, -0.3F, 0.9F}, {-1.9F, -0.3F, 0.6F}, {-1.9F, 0, 0.6F}, // 65
    {1.7F, 0, 1.425F}, {1.7F, -0.66F, 1.425F}, {1.7F, -0.66F, 0.6F}, {1.7F, 0, 0.6F}, // 68
    {2.6F, 0, 1.425F}, {2.6F, -0.66F, 1.425F}, {3.1F, -0.66F, 0.825F}, {3.1F, 0, 0.825F}, // 72
    {2.3F, 0, 2.1F}, {2.3F, -0.25F, 2.1F}, {2.4F, -0.25F, 2.025F}, {2.4F, 0, 2.025F}, // 76
    {2.7F, 0, 2.4F}, {2.7F, -0.25F, 2.4F}, {3.3F, -0.25F, 2.4F}, {3.3F, 0, 2.4F}, // 80
    {2.8F, 0, 2.475F}, {2.8F, -0.25F, 2.475F}, {3.525F, -0.25F, 2.49375F}, {3.525F, 0, 2.49375F}, // 84
    {2.9F, 0, 2.475F}, {2.9F, -0.15F, 2.475F}, {3.45F, -0.15F, 2.5125F}, {3.45F, 0, 2.5125F}, // 88
    {2.8F, 0, 2.4F}, {2.8F, -0.15F, 2.4F}, {3.2F, -0.15F, 2.4F}, {3.2F, 0, 2.4F}, // 92
    {0, 0, 3.15F}, {0.8F, 0, 3.15F}, {0.8F, -0.45F, 3.15F}, {0.45F, -0.8F, 3.15F}, {0, -0.8F, 3.15F}, // 96
    {0, 0, 2.85F}, // 101
    {1.4F, 0, 2.4F}, {1.4F, -0.784F, 2.4F}, {0.784F, -1.4F, 2.4F}, {0, -1.4F, 2.4F}, // 102
    {0.4F, 0, 2.55F}, {0.4F, -0.224F, 2.55F}, {0.224F, -0.4F, 2.55F}, {0, -0.4F, 2.55F}, // 106
    {1.3F, 0, 2.55F}, {1.3F, -0.728F, 2.55F}, {0.728F, -1.3F, 2.55F}, {0, -1.3F, 2.55F}, // 110
    {1.3F, 0, 2.4F}, {1.3F, -0.728F, 2.4F}, {0.728F, -1.3F, 2.4F}, {0, -1.3F, 2.4F}, // 114
    {0, 0, 0}, {1.425F, -0.798F, 0}, {1.5F, 0, 0.075F}, {1.425F, 0, 0}, // 118
    {0.798F, -1.425F, 0}, {0, -1.5F, 0.075F}, {0, -1.425F, 0}, // 122
    {1.5F, -0.84F, 0.075F}, {0.84F, -1.5F, 0.075F}, // 125
};

/// Four rows of four control points; repeated in how many mirror images, so that there are 32 patches.
struct PatchFamily {
    std::array<int, 16> points;
    bool mirror_x; ///< four images (mirrored in x and y) instead of two (mirrored in y)
};

constexpr PatchFamily families[] = {
    {{102, 103, 104, 105, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, true},                  // rim
    {{12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27}, true},                // body
    {{24, 25, 26, 27, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40}, true},
    {{96, 96, 96, 96, 97, 98, 99, 100, 101, 101, 101, 101, 0, 1, 2, 3}, true},               // lid
    {{0, 1, 2, 3, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117}, true},
    {{118, 118, 118, 118, 124, 122, 119, 121, 123, 126, 125, 120, 40, 39, 38, 37}, true},    // bottom
    {{41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56}, false},               // handle
    {{53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 28, 65, 66, 67}, false},
    {{68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83}, false},               // spout
    {{80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95}, false},
};
// clang-format on

using Patch = std::array<glm::vec3, 16>;

/// The image of a family under mirroring; columns change their order with every mirror, so that the
/// outside stays outside.
Patch make_patch(const PatchFamily& family, bool mirror_x, bool mirror_y) {
    Patch patch{};
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const std::size_t column = mirror_x == mirror_y ? 3 - i % 4 : i % 4;
        const auto& p = control_points[family.points[i - i % 4 + column]];
        patch[i] = {mirror_x ? -p[0] : p[0], p[2], mirror_y ? p[1] : -p[1]};
    }
    return patch;
}

/// What the four control points of a curve weigh.
struct Weights {
    std::array<float, 4> each{};
    float sum = 1.0F; ///< 1 for a point, 0 for a derivative
};

/// Bernstein polynomials at t = i / n. Written symmetrically in i and n − i, so that two patches
/// that walk along their common border in opposite directions compute the very same points.
Weights bernstein(int i, int n) {
    const float t = static_cast<float>(i) / static_cast<float>(n);
    const float s = static_cast<float>(n - i) / static_cast<float>(n);
    return {{s * s * s, 3.0F * (s * s * t), 3.0F * (t * t * s), t * t * t}, 1.0F};
}

Weights bernstein_derivative(int i, int n) {
    const float t = static_cast<float>(i) / static_cast<float>(n);
    const float s = 1.0F - t;
    return {
        {-3.0F * s * s, 3.0F * s * (s - 2.0F * t), 3.0F * t * (2.0F * s - t), 3.0F * t * t}, 0.0F};
}

/// Relative to the middle of the end points: where all four coincide, at a pole, the result is
/// exactly that point.
glm::vec3 combine(const Weights& w, const std::array<glm::vec3, 4>& p) {
    const glm::vec3 middle = 0.5F * (p[0] + p[3]);
    return w.sum * middle + ((w.each[0] * (p[0] - middle) + w.each[3] * (p[3] - middle)) +
                             (w.each[1] * (p[1] - middle) + w.each[2] * (p[2] - middle)));
}

glm::vec3 evaluate(const Patch& patch, const Weights& across, const Weights& down) {
    std::array<glm::vec3, 4> rows{};
    for (std::size_t r = 0; r < 4; ++r) {
        const std::size_t first = 4 * r;
        rows[r] =
            combine(across, {patch[first], patch[first + 1], patch[first + 2], patch[first + 3]});
    }
    return combine(down, rows);
}

/// Column 0 … n across the patch, row 0 at its last line of control points: rows count upward.
SurfacePoint patch_point(const Patch& patch, int n, int column, int row) {
    const int down = n - row;
    const glm::vec3 position = evaluate(patch, bernstein(column, n), bernstein(down, n));
    // A pole has no derivative across: its normal is that of a point close by.
    constexpr int fine = 1024;
    const auto normal_at = [&](int i, int j, int steps) {
        const glm::vec3 right =
            evaluate(patch, bernstein_derivative(i, steps), bernstein(j, steps));
        const glm::vec3 below =
            evaluate(patch, bernstein(i, steps), bernstein_derivative(j, steps));
        return glm::cross(below, right);
    };
    glm::vec3 normal = normal_at(column, down, n);
    if (glm::length(normal) < 1e-6F) {
        normal = normal_at(column * fine, down == 0 ? 1 : n * fine - 1, n * fine);
    }
    return {position, glm::normalize(normal)};
}

/// Vertices of neighboring patches at the same place are one vertex of the teapot: normals and
/// silhouettes may ask.
void weld(Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::uint32_t> first;
    for (const glm::vec4& p : mesh.positions) {
        const auto number = static_cast<std::uint32_t>(first.size());
        mesh.file_vertex.push_back(first.try_emplace({p.x, p.y, p.z}, number).first->second);
    }
}

} // namespace

Mesh teapot(int triangles) {
    // 32 patches of 2n² triangles; 8 of them meet a pole, where n triangles have no area.
    const double root = (8.0 + std::sqrt(64.0 + 256.0 * triangles)) / 128.0;
    const int n = std::max(2, static_cast<int>(std::lround(root)));
    Mesh mesh;
    for (const PatchFamily& family : families) {
        for (int image = 0; image < (family.mirror_x ? 4 : 2); ++image) {
            const Patch patch = make_patch(family, image >= 2, image % 2 == 1);
            add_sheet(mesh, {n, n}, false, [&](int column, int row) {
                return patch_point(patch, n, column, row);
            });
        }
    }
    weld(mesh);
    fit_to_unit_sphere(mesh);
    return mesh;
}

} // namespace hs::scene::shapes
