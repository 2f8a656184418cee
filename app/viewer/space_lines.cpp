#include "app/viewer/space_lines.hpp"

#include "app/viewer/space_planes.hpp"
#include "core/explain/eye_planes.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace hs::viewer {
namespace {

constexpr std::size_t most_edges = 15000;

bool is_of_object(Space space) {
    return space == Space::object;
}

/// Calls `visit(map, triangle)` for every triangle, line and point shown, of large frames for every
/// so many.
template <typename Visit>
std::size_t for_each_triangle(const Document& document, const SpaceView& view, Visit&& visit) {
    const trace::Recording& recording = document.recording();
    const std::uint32_t current = document.player().current().object;
    const auto shown = [&](const pipeline::DrawCall& call) {
        return !is_of_object(view.space) || call.object == current;
    };
    std::size_t edges = 0;
    for (const pipeline::DrawCall& call : recording.frame->calls()) {
        edges += shown(call) ? std::size_t{call.primitive_count()} * 3 : 0;
    }
    const std::size_t stride = edges / most_edges + 1;
    for (const pipeline::DrawCall& call : recording.frame->calls()) {
        if (shown(call)) {
            const SpaceMap map{recording, view, call.object};
            for (std::size_t i = 0; i < call.primitive_count(); i += stride) {
                visit(call, map, call.primitive(static_cast<std::uint32_t>(i)).vertices);
            }
        }
    }
    return edges;
}

bool shows_planes(const Document& document) {
    const trace::Player& player = document.player();
    return player.current().kind >= trace::StepKind::setup && player.current().in_triangle() &&
           explain::planes_through_eye(player.recording(), player.detail(), player.current());
}

} // namespace

/// Collects points and says how they are held in the picture.
class SpaceLines::Bounds {
public:
    void add(const glm::vec3& p) { points_.push_back(p); }
    void add(const std::optional<glm::vec3>& p) {
        if (p) {
            points_.push_back(*p);
        }
    }
    [[nodiscard]] Framing framing() const {
        if (points_.empty()) {
            return {};
        }
        Framing framing{
            glm::vec3{std::numeric_limits<float>::max()},
            glm::vec3{std::numeric_limits<float>::lowest()},
            1.0e-6F};
        for (const glm::vec3& p : points_) {
            framing.low = glm::min(framing.low, p);
            framing.high = glm::max(framing.high, p);
        }
        const glm::vec3 middle = framing.middle();
        for (const glm::vec3& p : points_) {
            framing.radius = std::max(framing.radius, glm::length(p - middle));
        }
        return framing;
    }

private:
    std::vector<glm::vec3> points_;
};

/// What is the same in all spaces.
void SpaceLines::meet(const Document& document) {
    volume_ = view_volume(document.recording());
    if (!volume_) {
        return;
    }
    // How far from the eye do visible vertices lie?
    const float forward = scene::forward_sign(document.scene().camera);
    float farthest = std::numeric_limits<float>::lowest();
    for_each_triangle(
        document,
        SpaceView{},
        [&](const pipeline::DrawCall& call, const SpaceMap&, const scene::TriangleIndices& t) {
            const pipeline::Transforms& transforms = call.vertex.transforms;
            for (const std::uint32_t vertex : {t.a, t.b, t.c}) {
                if (call.vertices[vertex].outcode == 0) {
                    const glm::vec4& position = call.vertex.mesh->positions[vertex];
                    const glm::vec4 eye =
                        transforms.view.matrix * (transforms.model.matrix * position);
                    farthest = std::max(farthest, forward * eye.z);
                }
            }
        }
    );
    constexpr float behind = 1.2F;
    constexpr float distant = 1.6F; // a far plane nearer than that is worth showing
    const float length = (farthest - volume_->near_distance) * behind;
    const float whole = volume_->far_distance - volume_->near_distance;
    const bool cut = length > 0.0F && length * distant < whole;
    interest_ = cut ? volume_->near_distance + length : volume_->far_distance;
}

/// Every edge of small meshes, of large ones the edges of every so many triangles.
void SpaceLines::collect(const Document& document, const SpaceView& view) {
    lines_.clear();
    all_edges_ = for_each_triangle(
        document,
        view,
        [&](const pipeline::DrawCall&, const SpaceMap& map, const scene::TriangleIndices& t) {
            const std::array corners{map.of_vertex(t.a), map.of_vertex(t.b), map.of_vertex(t.c)};
            for (unsigned k = 0; k < 3; ++k) {
                const auto& a = corners[k];
                const auto& b = corners[(k + 1) % 3];
                if (a && b) {
                    lines_.push_back({*a, *b});
                }
            }
        }
    );
}

/// The meshes, the eye, and the view volume as far as it is of interest.
Framing SpaceLines::framing_of(const Document& document, const SpaceView& view) const {
    Bounds bounds;
    for_each_triangle(
        document,
        view,
        [&](const pipeline::DrawCall&, const SpaceMap& map, const scene::TriangleIndices& t) {
            bounds.add(map.of_vertex(t.a));
            bounds.add(map.of_vertex(t.b));
            bounds.add(map.of_vertex(t.c));
        }
    );
    if (volume_ && view.space == Space::world) {
        add_volume(bounds, SpaceMap{document.recording(), view, 0}, 0.0F);
    }
    return bounds.framing();
}

/// The eye withdraws while the divide sets in, and the far plane comes into the picture.
void SpaceLines::add_volume(Bounds& bounds, const SpaceMap& map, float divided) const {
    const float all = divided * divided * divided * divided;
    const float end = interest_ + (volume_->far_distance - interest_) * all;
    glm::vec3 image{0.0F};
    for (const float distance : {end, volume_->near_distance}) {
        for (const glm::vec3& corner : volume_->section(distance)) {
            bounds.add(map.of_eye(corner));
        }
        image = map.of_eye(volume_->section(distance)[0]).value_or(image);
    }
    const auto eye = volume_->has_eye ? map.of_eye(glm::vec3{0.0F}) : std::nullopt;
    if (eye) {
        const float left = (1.0F - divided) * (1.0F - divided);
        bounds.add(image + (*eye - image) * left);
    }
}

/// On the way to NDC the view volume is what counts, wherever meshes reach beyond it.
Framing SpaceLines::framing_on_the_way(const Document& document, const SpaceView& view) const {
    if (!volume_) {
        return framing_of(document, view);
    }
    Bounds bounds;
    const SpaceMap map{document.recording(), view, 0};
    add_volume(bounds, map, std::clamp(view.morph - 1.0F, 0.0F, 1.0F));
    return bounds.framing();
}

/// The planes through the eye are what counts while they are shown.
std::optional<Framing>
SpaceLines::framing_of_planes(const Document& document, const SpaceView& view) const {
    const trace::Player& player = document.player();
    const auto planes =
        explain::planes_through_eye(player.recording(), player.detail(), player.current());
    if (!planes) {
        return std::nullopt;
    }
    Bounds bounds;
    const SpaceMap map{player.recording(), view, player.current().object};
    const auto eye = map.of_eye(glm::vec3{0.0F});
    if (!eye) {
        return std::nullopt; // after the divide
    }
    bounds.add(*eye);
    for (const explain::PlaneThroughEye& plane : planes->planes) {
        bounds.add(map.of_eye(plane.edge[0] * planes_reach));
    }
    return bounds.framing();
}

void SpaceLines::update(const Document& document, const SpaceView& view) {
    const trace::Step& step = document.player().current();
    const Subject subject{
        document.revision(),
        is_on_the_way(view.space) ? Space::eye : view.space,
        is_on_the_way(view.space) ? view.morph : 0.0F,
        is_of_object(view.space) ? step.object : 0,
        shows_planes(document) ? document.current_triangle() : std::nullopt};
    if (subject_ != subject) {
        if (!subject_ || subject_->document != subject.document) {
            meet(document);
        }
        subject_ = subject;
        collect(document, view);
        framing_ = is_on_the_way(view.space) ? framing_on_the_way(document, view)
                                             : framing_of(document, view);
        framing_ = framing_of_planes(document, view).value_or(framing_);
        view_.reset();
    }
    const auto same = [](const SpaceView& a, const SpaceView& b) {
        return a.yaw == b.yaw && a.pitch == b.pitch && a.distance == b.distance &&
               a.side == b.side && a.area.x == b.area.x && a.area.y == b.area.y &&
               a.area.width == b.area.width && a.area.height == b.area.height;
    };
    if (view_ && same(*view_, view)) {
        return;
    }
    view_ = view;
    camera_ = OrbitCamera(view, framing_);
    projected_.clear();
    for (const auto& line : lines_) {
        if (const auto seen = camera_.project(line[0], line[1])) {
            projected_.push_back(*seen);
        }
    }
}

} // namespace hs::viewer
