#include "core/scene/shapes.hpp"

#include "core/base/spelling.hpp"
#include "core/scene/shapes/families.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace hs::scene {

namespace {

constexpr int max_triangles = 20'000'000;

struct Shape {
    std::string_view kind;
    int default_triangles;
    Mesh (*make)(int triangles);
};

constexpr Shape all_shapes[] = {
    {"plane", 2, shapes::plane},
    {"cube", 12, shapes::cube},
    {"sphere", 960, shapes::sphere},
    {"torus", 1024, shapes::torus},
    {"torus-knot", 4096, shapes::torus_knot},
    {"teapot", 6320, shapes::teapot},
};

Diagnostic unknown_shape(std::string_view kind) {
    std::vector<std::string_view> kinds;
    for (const Shape& shape : all_shapes) {
        kinds.push_back(shape.kind);
    }
    return {
        "",
        0,
        0,
        fmt::format(
            "there is no shape \"{}\": choose one of {}{}",
            kind,
            fmt::join(kinds, ", "),
            did_you_mean(kind, kinds)
        )};
}

} // namespace

Result<Mesh> make_shape(std::string_view kind, const ShapeOptions& options) {
    const Shape* shape = std::ranges::find(all_shapes, kind, &Shape::kind);
    if (shape == std::end(all_shapes)) {
        return unknown_shape(kind);
    }
    if (options.triangles < 0 || options.triangles > max_triangles) {
        return Diagnostic{
            "",
            0,
            0,
            fmt::format(
                "a shape can have 1 to {} triangles, not {}", max_triangles, options.triangles
            )};
    }
    const bool chosen = options.triangles > 0;
    Mesh mesh = shape->make(chosen ? options.triangles : shape->default_triangles);
    mesh.name = shape->kind;
    finish_mesh(mesh);
    return mesh;
}

} // namespace hs::scene
