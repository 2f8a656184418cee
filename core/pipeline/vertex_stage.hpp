// The vertex stage: one vertex at a time from object space to clip space, lit on the way if the
// shading is per vertex.
#pragma once

#include "core/geometry/clip_polygon.hpp"
#include "core/geometry/clip_volume.hpp"
#include "core/geometry/viewport.hpp"
#include "core/math/space.hpp"
#include "core/math/varyings.hpp"
#include "core/scene/camera.hpp"
#include "core/scene/scene.hpp"
#include "core/shading/shade.hpp"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <optional>

namespace hs::pipeline {

using ModelTransform = math::Transform<math::ObjectSpace, math::WorldSpace>;

/// The matrices a vertex meets, in order.
struct Transforms {
    ModelTransform model;
    scene::ViewTransform view;
    scene::ProjectionTransform projection;
    glm::mat3 normal{1.0F}; ///< object to eye, inverse transpose: keeps normals perpendicular under
                            ///< non-uniform scale
};

/// Everything the vertex stage needs that is the same for all vertices of an object.
struct VertexInputs {
    const scene::Mesh* mesh = nullptr; ///< never null in use
    Transforms transforms;
    math::VaryingLayout layout;
    glm::vec4 diffuse{1.0F};
    shading::ShadingInputs shading;
};

/// One vertex in every space up to clip.
struct VertexWork {
    math::ObjectPosition object;
    math::WorldPosition world;
    math::EyePosition eye;
    math::ClipPosition clip;
    math::Varyings varyings;
    std::optional<shading::LightingTerms> terms; ///< Gouraud only
};

/// What is lit at a vertex.
shading::SurfacePoint
vertex_surface(const VertexInputs& in, std::uint32_t vertex, const math::EyePosition& eye);

/// Runs the stage for one vertex of the mesh. A pure function.
VertexWork run_vertex(const VertexInputs& in, std::uint32_t vertex);

/// The vertex after the stage, ready for primitive assembly: with its outcode and its place in the
/// window, so that triangles sharing it share that work. One cache line; varyings are kept beside
/// it, as many floats as the draw uses.
struct ShadedVertex {
    math::ClipPosition clip;
    geometry::WindowVertex window;
    geometry::Outcode outcode = 0;
};

/// How many steps the stage takes for a vertex: one per matrix, one for per-vertex lighting.
[[nodiscard]] inline int steps_per_vertex(scene::Shading shading) {
    return shading == scene::Shading::gouraud ? 4 : 3;
}

} // namespace hs::pipeline
