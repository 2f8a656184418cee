// A frame made ready: a scene's objects as draw calls, with all state resolved and all vertices
// shaded.
#pragma once

#include "core/pipeline/vertex_stage.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace hs::pipeline {

/// One object's draw: state, and its vertices after the vertex stage.
struct DrawCall {
    std::uint32_t object = 0;
    scene::Settings settings; ///< the frame's with the object's overrides
    VertexInputs vertex;
    geometry::ClipVolume volume;
    geometry::Viewport viewport;
    std::vector<ShadedVertex> vertices; ///< as many as the mesh has, once the vertex stage has run
    std::vector<float> varyings;        ///< vertices × layout.count

    /// Makes room for vertices, to be placed by `place_vertex`.
    void resize_vertices(std::size_t count) {
        vertices.resize(count);
        varyings.resize(count * static_cast<std::size_t>(vertex.layout.count));
    }
    /// Stores a vertex with its outcode and its place in the window. Precondition: index below the
    /// size.
    void place_vertex(std::size_t index, const geometry::ClipVertex& placed);
    /// The `layout.count` varyings of a vertex.
    [[nodiscard]] const float* varyings_of(std::size_t index) const {
        return varyings.data() + index * static_cast<std::size_t>(vertex.layout.count);
    }
    /// A vertex as clipping takes it.
    [[nodiscard]] geometry::ClipVertex clip_vertex(std::size_t index) const;

    /// The pixels it may reach: the image, within the viewport where the view volume clips.
    [[nodiscard]] PixelRect drawable() const {
        return settings.clip_enabled ? intersect(settings.image(), settings.viewport())
                                     : settings.image();
    }
    [[nodiscard]] const std::vector<scene::TriangleIndices>& triangles() const {
        return vertex.mesh->triangles;
    }
    /// Triangles, lines and points, numbered through.
    [[nodiscard]] std::uint32_t primitive_count() const {
        return static_cast<std::uint32_t>(vertex.mesh->primitive_count());
    }
    [[nodiscard]] scene::Primitive primitive(std::uint32_t index) const {
        return vertex.mesh->primitive(index);
    }
};

/// Not copyable: draw calls point at the lights and at the scene's meshes.
class Frame {
public:
    /// Resolves matrices, lights and per-object settings; runs no stage yet. The scene must be
    /// valid (see scene_file.hpp).
    explicit Frame(std::shared_ptr<const scene::Scene> scene);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    Frame(Frame&&) = delete;
    Frame& operator=(Frame&&) = delete;
    ~Frame() = default;

    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }
    [[nodiscard]] const std::shared_ptr<const scene::Scene>& shared_scene() const { return scene_; }
    [[nodiscard]] const scene::Settings& settings() const { return scene_->settings; }
    [[nodiscard]] const std::vector<DrawCall>& calls() const { return calls_; }
    [[nodiscard]] std::vector<DrawCall>& calls() { return calls_; }

private:
    std::shared_ptr<const scene::Scene> scene_;
    std::vector<shading::EyeLight> lights_;
    std::vector<DrawCall> calls_;
};

} // namespace hs::pipeline
