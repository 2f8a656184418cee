#include "core/scene/file/scene_reader.hpp"

#include <glm/geometric.hpp>

namespace hs::scene::file {

namespace {

void read_depth_limits(TableReader& table, Projection& projection, bool from_eye) {
    table.read("near", projection.near);
    table.read("far", projection.far);
    if (from_eye && !(projection.near > 0.0F)) {
        table.complain("near of projection must be greater than 0");
    }
    if (!(projection.far > projection.near)) {
        table.complain("far of projection must be greater than near");
    }
}

void read_frustum_limits(TableReader& table, Projection& projection) {
    table.read("left", projection.left);
    table.read("right", projection.right);
    table.read("bottom", projection.bottom);
    table.read("top", projection.top);
    if (projection.left == projection.right || projection.bottom == projection.top) {
        table.complain(
            "the frustum must have a width and a height: left and right, bottom and top differ"
        );
    }
}

void read_kind(TableReader& table, Projection& projection) {
    switch (projection.kind) {
    case ProjectionKind::perspective:
        if (table.read("fov_y", projection.fov_y) &&
            !(projection.fov_y > 0.0F && projection.fov_y < 180.0F)) {
            table.must_be("fov_y", "an angle between 0 and 180 degrees");
        }
        read_depth_limits(table, projection, true);
        return;
    case ProjectionKind::orthographic:
        if (table.read("height", projection.height) && !(projection.height > 0.0F)) {
            table.must_be("height", "greater than 0");
        }
        read_depth_limits(table, projection, false);
        return;
    case ProjectionKind::frustum:
        read_frustum_limits(table, projection);
        read_depth_limits(table, projection, true);
        return;
    case ProjectionKind::identity: return;
    }
    HS_CHECK(false, "every projection kind is handled");
}

void read_projection(Complaints& complaints, const toml::table& toml, Projection& projection) {
    TableReader table{complaints, toml, "projection"};
    if (table.has("kind") && !table.read_choice("kind", projection.kind)) {
        return; // which keys belong here is unknown
    }
    table.find("kind");
    read_kind(table, projection);
    table.finish();
}

void check_line_of_sight(TableReader& table, const Camera& camera) {
    const glm::dvec3 sight = glm::dvec3{camera.target} - glm::dvec3{camera.eye};
    const glm::dvec3 up{camera.up};
    constexpr double smallest_angle = 1e-6; // radians: below it float leaves no digits of "right"
    if (glm::length(sight) == 0.0) {
        table.complain(
            "eye and target of the camera are the same point: there is nothing to look at"
        );
    } else if (!(glm::length(glm::cross(sight, up)) >
                 smallest_angle * glm::length(sight) * glm::length(up))) {
        table.complain("up of the camera is parallel to the line of sight: tilt it");
    }
}

} // namespace

void read_camera(SceneReader& reader, const toml::table& toml) {
    Camera& camera = reader.scene.camera;
    TableReader table{reader.complaints, toml, "camera"};
    table.read("eye", camera.eye);
    table.read("target", camera.target);
    table.read("up", camera.up);
    table.read_choice("forward", camera.forward);
    if (const toml::table* projection = table.read_table("projection")) {
        read_projection(reader.complaints, *projection, camera.projection);
    }
    table.finish();
    if (camera.projection.kind != ProjectionKind::identity) {
        check_line_of_sight(table, camera);
    }
}

} // namespace hs::scene::file
