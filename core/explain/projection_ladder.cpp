#include "core/explain/projection_ladder.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace hs::explain {
namespace {

using scene::ProjectionKind;

bool has_eye(ProjectionKind kind) {
    return kind == ProjectionKind::perspective || kind == ProjectionKind::frustum;
}

ProjectionRung apply(ProjectionRung rung, const glm::mat4& matrix, const glm::vec3& eye_point) {
    rung.matrix = matrix;
    rung.clip = matrix * glm::vec4{eye_point, 1.0F};
    if (rung.clip.w != 0.0F) {
        rung.divided = glm::vec3{rung.clip} / rung.clip.w;
    }
    return rung;
}

/// w = d, so that dividing by w divides by the distance.
glm::mat4 dividing_by_distance(float forward) {
    glm::mat4 m{1.0F};
    m[2][2] = 0.0F;
    m[2][3] = forward;
    m[3][3] = 0.0F;
    return m;
}

/// "z_ndc runs from −1 at the near plane to 1 at the far plane."
std::string_view full_remap(scene::DepthConvention convention, bool perspective) {
    switch (convention) {
    case scene::DepthConvention::opengl:
        return perspective ? "z_ndc = A + B/d runs from −1 (near) to 1 (far): order is kept, steps "
                             "are not"
                           : "z_ndc = A·d + B runs from −1 (near) to 1 (far), in equal steps";
    case scene::DepthConvention::direct3d:
        return perspective ? "z_ndc = A + B/d runs from 0 (near) to 1 (far): order is kept, steps "
                             "are not"
                           : "z_ndc = A·d + B runs from 0 (near) to 1 (far), in equal steps";
    case scene::DepthConvention::reversed:
        return perspective ? "z_ndc = A + B/d runs from 1 (near) to 0 (far): order is turned "
                             "around, steps are not equal"
                           : "z_ndc = A·d + B runs from 1 (near) to 0 (far), in equal steps";
    }
    HS_CHECK(false, "every depth convention is handled");
    return "";
}

std::string written(float v) {
    return number(v);
}

/// The depth row: what follows from the convention's ends of z_ndc.
std::string depth_numerator(scene::DepthConvention convention, bool offset) {
    switch (convention) {
    case scene::DepthConvention::opengl: return offset ? "−2·f·n" : "f + n";
    case scene::DepthConvention::direct3d: return offset ? "−f·n" : "f";
    case scene::DepthConvention::reversed: return offset ? "f·n" : "−n";
    }
    HS_CHECK(false, "every depth convention is handled");
    return "";
}

MatrixEntry entry(
    const glm::mat4& m,
    int row,
    int column,
    std::string symbolic,
    std::string with_numbers,
    std::string meaning
) {
    return {
        row,
        column,
        std::move(symbolic),
        std::move(with_numbers),
        m[column][row],
        std::move(meaning)};
}

void add_perspective_entries(
    std::vector<MatrixEntry>& list,
    const glm::mat4& m,
    const FrustumLimits& v,
    scene::DepthConvention convention,
    float forward
) {
    const std::string n = written(v.near);
    const std::string f = written(v.far);
    const std::string width = fmt::format("({} − {})", written(v.right), written(v.left));
    const std::string height = fmt::format("({} − {})", written(v.top), written(v.bottom));
    const char* const sign = forward < 0.0F ? "" : "−";
    const auto off_axis = [&](int row, float low, float high, const char* symbols) {
        if (m[2][row] != 0.0F) {
            list.push_back(entry(
                m,
                row,
                2,
                fmt::format("{}{}", sign, symbols),
                fmt::format(
                    "{}({} + {}) / ({} − {})",
                    sign,
                    written(high),
                    written(low),
                    written(high),
                    written(low)
                ),
                "off axis: shifts the image's middle to x = 0, y = 0"
            ));
        }
    };
    list.push_back(entry(
        m,
        0,
        0,
        "2n / (r − l)",
        fmt::format("2·{} / {}", n, width),
        "half the image's width at the near plane becomes 1"
    ));
    off_axis(0, v.left, v.right, "(r + l) / (r − l)");
    list.push_back(entry(
        m, 1, 1, "2n / (t − b)", fmt::format("2·{} / {}", n, height), "the same for its height"
    ));
    off_axis(1, v.bottom, v.top, "(t + b) / (t − b)");
    const char* const minus = forward < 0.0F ? "−" : "";
    list.push_back(entry(
        m,
        2,
        2,
        fmt::format("{}({}) / (f − n)", minus, depth_numerator(convention, false)),
        fmt::format("n = {}, f = {}", n, f),
        "A: what z_ndc tends to far away"
    ));
    list.push_back(entry(
        m,
        2,
        3,
        fmt::format("{} / (f − n)", depth_numerator(convention, true)),
        fmt::format("n = {}, f = {}", n, f),
        "B: what is divided by the distance"
    ));
    list.push_back(entry(
        m, 3, 2, forward < 0.0F ? "−1" : "1", "", "w becomes the distance, so the divide shrinks"
    ));
}

void add_parallel_entries(
    std::vector<MatrixEntry>& list, const glm::mat4& m, const FrustumLimits& v
) {
    list.push_back(entry(
        m,
        0,
        0,
        "2 / (r − l)",
        fmt::format("2 / ({} − {})", written(v.right), written(v.left)),
        "the image's width becomes 2, at every distance"
    ));
    list.push_back(entry(
        m,
        1,
        1,
        "2 / (t − b)",
        fmt::format("2 / ({} − {})", written(v.top), written(v.bottom)),
        "the same for its height"
    ));
    const std::string numbers = fmt::format("n = {}, f = {}", written(v.near), written(v.far));
    list.push_back(entry(m, 2, 2, "Δz_ndc / (f − n)", numbers, "depth in equal steps"));
    list.push_back(
        entry(m, 2, 3, "so that the near plane meets its end", numbers, "where depth starts")
    );
    list.push_back(entry(m, 3, 3, "1", "", "w stays 1: nothing is divided"));
}

} // namespace

std::vector<ProjectionRung> projection_ladder(
    const scene::Camera& camera,
    float aspect,
    scene::DepthConvention convention,
    const glm::vec3& eye_point
) {
    const ProjectionKind kind = camera.projection.kind;
    const glm::mat4 executed = scene::projection_transform(camera, aspect, convention).matrix;
    const float forward = scene::forward_sign(camera);
    std::vector<ProjectionRung> ladder;
    if (has_eye(kind)) {
        // x/d and y/d, and a third number that is d/d
        glm::mat4 drop = dividing_by_distance(forward);
        drop[2][2] = forward;
        ladder.push_back(apply(
            {.title = "drop to a plane",
             .idea = "divide everything by the distance: the point slides along its line of sight "
                     "to the plane at distance 1",
             .survives = "nothing: the third number is d/d = 1 for every point"},
            drop,
            eye_point
        ));
        glm::mat4 keep = dividing_by_distance(forward);
        keep[3][2] = 1.0F;
        ladder.push_back(apply(
            {.title = "keep 1/d",
             .idea = "put 1 into the third number before the divide",
             .survives = "1/d: order is kept (larger is nearer), but from ∞ to 0, not in a range"},
            keep,
            eye_point
        ));
    } else if (kind == ProjectionKind::orthographic) {
        glm::mat4 drop{1.0F};
        drop[2][2] = 0.0F;
        ladder.push_back(apply(
            {.title = "z := 0",
             .idea = "the point slides along z, parallel to all others",
             .survives = "nothing: the third number is 0 for every point"},
            drop,
            eye_point
        ));
    }
    const bool none = kind == ProjectionKind::identity;
    ladder.push_back(apply(
        {.title = none ? "no camera" : "map near and far",
         .idea = none ? "positions are clip coordinates already"
                      : "scale x and y so that the image's edges are at ±1, and depth so that near "
                        "and far are the ends of its range",
         .survives = none ? "z, as it is" : full_remap(convention, has_eye(kind))},
        executed,
        eye_point
    ));
    return ladder;
}

FrustumLimits frustum_limits(const scene::Projection& p, float aspect) {
    FrustumLimits v{p.left, p.right, p.bottom, p.top, p.near, p.far};
    if (p.kind == ProjectionKind::frustum) {
        return v;
    }
    const float half_angle = p.fov_y * (std::numbers::pi_v<float> / 360.0F);
    v.top = p.kind == ProjectionKind::perspective    ? p.near * std::tan(half_angle)
            : p.kind == ProjectionKind::orthographic ? p.height * 0.5F
                                                     : 1.0F;
    v.bottom = -v.top;
    v.right = p.kind == ProjectionKind::identity ? 1.0F : v.top * aspect;
    v.left = -v.right;
    return v;
}

std::vector<MatrixEntry>
matrix_entries(const scene::Camera& camera, float aspect, scene::DepthConvention convention) {
    const glm::mat4 m = scene::projection_transform(camera, aspect, convention).matrix;
    const FrustumLimits limits = frustum_limits(camera.projection, aspect);
    std::vector<MatrixEntry> list;
    if (has_eye(camera.projection.kind)) {
        add_perspective_entries(list, m, limits, convention, scene::forward_sign(camera));
    } else if (camera.projection.kind == ProjectionKind::orthographic) {
        add_parallel_entries(list, m, limits);
    }
    return list;
}

std::optional<std::array<ConventionDepth, 3>>
depth_in_conventions(const scene::Camera& camera, float aspect, const glm::vec3& eye_point) {
    constexpr std::array conventions{
        scene::DepthConvention::opengl,
        scene::DepthConvention::direct3d,
        scene::DepthConvention::reversed};
    std::array<ConventionDepth, 3> list;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const glm::mat4 m = scene::projection_transform(camera, aspect, conventions[i]).matrix;
        const glm::vec4 clip = m * glm::vec4{eye_point, 1.0F};
        if (clip.w == 0.0F) {
            return std::nullopt;
        }
        const float z_ndc = clip.z / clip.w;
        const bool opengl = conventions[i] == scene::DepthConvention::opengl;
        list[i] = {
            .convention = conventions[i],
            .a = m[2][2],
            .b = m[3][2],
            .z_clip = clip.z,
            .z_ndc = z_ndc,
            .depth = opengl ? (z_ndc + 1.0F) * 0.5F : z_ndc};
    }
    return list;
}

std::optional<ByHand>
project_by_hand(const scene::Camera& camera, int width, int height, const glm::vec3& eye_point) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const FrustumLimits v = frustum_limits(camera.projection, aspect);
    ByHand path;
    path.distance = scene::forward_sign(camera) * eye_point.z;
    path.on_plane = {eye_point.x, eye_point.y};
    if (has_eye(camera.projection.kind)) {
        if (!(path.distance > 0.0F)) {
            return std::nullopt;
        }
        path.on_plane *= v.near / path.distance; // similar triangles
    }
    path.ndc = {
        2.0F * (path.on_plane.x - v.left) / (v.right - v.left) - 1.0F,
        2.0F * (path.on_plane.y - v.bottom) / (v.top - v.bottom) - 1.0F};
    path.raster = {
        (path.ndc.x + 1.0F) * 0.5F * static_cast<float>(width),
        (1.0F - path.ndc.y) * 0.5F * static_cast<float>(height)};
    return path;
}

} // namespace hs::explain
