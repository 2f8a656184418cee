#include "app/viewer/space_lines.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hs::viewer {
namespace {

constexpr std::size_t most_edges = 15000;
constexpr float nearest = 0.05F; ///< lines are cut this far before the outside camera

glm::vec3 divided(const glm::vec4& v) {
    return glm::vec3{v.x, v.y, v.z} / v.w;
}

std::optional<glm::vec3> with_place(const glm::vec4& v) {
    if (!(v.w > 0.0F)) {
        return std::nullopt;
    }
    const glm::vec3 p = divided(v);
    constexpr float largest = 1.0e6F;
    const bool finite =
        std::fabs(p.x) < largest && std::fabs(p.y) < largest && std::fabs(p.z) < largest;
    return finite ? std::optional{p} : std::nullopt;
}

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

} // namespace

std::optional<glm::vec3> vertex_in_space(
    const trace::Recording& recording, Space space, std::uint32_t object, std::uint32_t vertex
) {
    const pipeline::DrawCall& call = recording.frame->calls()[object];
    const glm::vec4& position = call.vertex.mesh->positions[vertex];
    const pipeline::Transforms& t = call.vertex.transforms;
    const math::ClipPosition& clip = call.vertices[vertex].clip;
    switch (space) {
    case Space::object: return with_place(position);
    case Space::world: return with_place(t.model.matrix * position);
    case Space::eye: return with_place(t.view.matrix * (t.model.matrix * position));
    case Space::clip: return glm::vec3{clip.x, clip.y, -clip.w};
    case Space::ndc: return with_place(math::to_vec4(clip));
    }
    HS_CHECK(false, "every space is handled");
    return std::nullopt;
}

std::optional<std::array<glm::vec3, 8>>
view_volume(const trace::Recording& recording, Space space, std::uint32_t object) {
    if (recording.frame->calls().empty()) {
        return std::nullopt;
    }
    const pipeline::DrawCall& call = recording.frame->calls()[object];
    const pipeline::Transforms& t = call.vertex.transforms;
    glm::mat4 to_clip = t.projection.matrix;
    if (space == Space::world || space == Space::object) {
        to_clip = to_clip * t.view.matrix;
    }
    if (space == Space::object) {
        to_clip = to_clip * t.model.matrix;
    }
    const bool matrix_matters = space != Space::clip && space != Space::ndc;
    const glm::mat4 back = matrix_matters ? glm::inverse(to_clip) : glm::mat4{1.0F};
    const scene::DepthConvention convention = recording.settings().depth_convention;
    const float near_z = convention == scene::DepthConvention::opengl     ? -1.0F
                         : convention == scene::DepthConvention::reversed ? 1.0F
                                                                          : 0.0F;
    const float far_z = convention == scene::DepthConvention::reversed ? 0.0F : 1.0F;
    std::array<glm::vec3, 8> corners{};
    constexpr std::array<std::array<float, 2>, 4> square{
        {{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}};
    for (unsigned i = 0; i < 8; ++i) {
        const auto& [x, y] = square[i % 4];
        const glm::vec4 ndc{x, y, i < 4 ? near_z : far_z, 1.0F};
        if (space == Space::clip) {
            // Where the plane lies in w: eye distance for perspective, 1 for parallel projections
            const glm::vec4 eye = glm::inverse(t.projection.matrix) * ndc;
            const float w = 1.0F / eye.w;
            corners[i] = {x * w, y * w, -w};
            continue;
        }
        const std::optional<glm::vec3> corner = with_place(back * ndc);
        if (!corner) {
            return std::nullopt;
        }
        corners[i] = *corner;
    }
    return corners;
}

// ---- outside camera

OrbitCamera::OrbitCamera(const SpaceView& view, const glm::vec3& center, float radius)
    : center_(center),
      scale_(1.0F / radius),
      sin_yaw_(std::sin(view.yaw)),
      cos_yaw_(std::cos(view.yaw)),
      sin_pitch_(std::sin(view.pitch)),
      cos_pitch_(std::cos(view.pitch)),
      distance_(3.2F * view.distance),
      middle_{view.area.x + view.area.width * 0.5F, view.area.y + view.area.height * 0.5F},
      pixels_(std::min(view.area.width, view.area.height) * 1.35F) {}

glm::vec3 OrbitCamera::turn(const glm::vec3& point) const {
    const glm::vec3 p = (point - center_) * scale_;
    const float x = cos_yaw_ * p.x - sin_yaw_ * p.z;
    const float z = sin_yaw_ * p.x + cos_yaw_ * p.z;
    return {x, cos_pitch_ * p.y - sin_pitch_ * z, distance_ - (sin_pitch_ * p.y + cos_pitch_ * z)};
}

ImVec2 OrbitCamera::to_window(const glm::vec3& turned) const {
    return {middle_.x + pixels_ * turned.x / turned.z, middle_.y - pixels_ * turned.y / turned.z};
}

std::optional<ImVec2> OrbitCamera::project(const glm::vec3& point) const {
    const glm::vec3 turned = turn(point);
    return turned.z > nearest ? std::optional{to_window(turned)} : std::nullopt;
}

std::optional<std::array<ImVec2, 2>>
OrbitCamera::project(const glm::vec3& a, const glm::vec3& b) const {
    glm::vec3 from = turn(a);
    glm::vec3 to = turn(b);
    if (from.z <= nearest && to.z <= nearest) {
        return std::nullopt;
    }
    if (from.z <= nearest) {
        from += (to - from) * ((nearest - from.z) / (to.z - from.z));
    } else if (to.z <= nearest) {
        to += (from - to) * ((nearest - to.z) / (from.z - to.z));
    }
    return std::array{to_window(from), to_window(to)};
}

// ---- lines

/// Every edge of small meshes, of large ones the edges of every so many triangles.
void SpaceLines::collect(const Document& document) {
    lines_.clear();
    const trace::Recording& recording = document.recording();
    const std::vector<pipeline::DrawCall>& calls = recording.frame->calls();
    all_edges_ = 0;
    for (const pipeline::DrawCall& call : calls) {
        const bool shown = subject_->space != Space::object || call.object == subject_->object;
        all_edges_ += shown ? call.triangles().size() * 3 : 0;
    }
    const std::size_t stride = all_edges_ / most_edges + 1;
    for (const pipeline::DrawCall& call : calls) {
        if (subject_->space == Space::object && call.object != subject_->object) {
            continue;
        }
        for (std::size_t i = 0; i < call.triangles().size(); i += stride) {
            const scene::TriangleIndices& triangle = call.triangles()[i];
            for (int k = 0; k < 3; ++k) {
                const auto a =
                    vertex_in_space(recording, subject_->space, call.object, triangle[k]);
                const auto b =
                    vertex_in_space(recording, subject_->space, call.object, triangle[(k + 1) % 3]);
                if (a && b) {
                    lines_.push_back({*a, *b});
                }
            }
        }
    }
}

void SpaceLines::measure(const Document& document) {
    Bounds bounds;
    for (const auto& line : lines_) {
        bounds.add(line[0]);
        bounds.add(line[1]);
    }
    const Space space = subject_->space;
    if (space == Space::ndc || lines_.empty()) {
        bounds.add(glm::vec3{-1.0F});
        bounds.add(glm::vec3{1.0F});
    }
    if (space == Space::eye || space == Space::clip) {
        bounds.add(glm::vec3{0.0F});
    }
    if (space == Space::world) {
        bounds.add(document.scene().camera.eye);
    }
    center_ = (bounds.low + bounds.high) * 0.5F;
    radius_ = std::max(1.0e-6F, glm::length(bounds.high - bounds.low) * 0.5F);
}

void SpaceLines::update(const Document& document, const SpaceView& view) {
    const trace::Step& step = document.player().current();
    const Subject subject{
        document.revision(), view.space, view.space == Space::object ? step.object : 0};
    if (subject_ != subject) {
        subject_ = subject;
        collect(document);
        measure(document);
        view_.reset();
    }
    const auto same = [](const SpaceView& a, const SpaceView& b) {
        return a.yaw == b.yaw && a.pitch == b.pitch && a.distance == b.distance &&
               a.area.x == b.area.x && a.area.y == b.area.y && a.area.width == b.area.width &&
               a.area.height == b.area.height;
    };
    if (view_ && same(*view_, view)) {
        return;
    }
    view_ = view;
    camera_ = OrbitCamera(view, center_, radius_);
    projected_.clear();
    for (const auto& line : lines_) {
        if (const auto seen = camera_.project(line[0], line[1])) {
            projected_.push_back(*seen);
        }
    }
}

} // namespace hs::viewer
