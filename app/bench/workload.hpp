// What is drawn while we measure: a mesh that fills the image, Gouraud shading, z-buffer, back
// faces culled.
#pragma once

#include "core/scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace hs::bench {

struct ImageSize {
    std::string name; ///< "512", "1080p"
    int width = 0;
    int height = 0;
};
inline const ImageSize square_512{"512", 512, 512};
inline const ImageSize full_hd{"1080p", 1920, 1080};

/// A mesh and where it stands: fitted into the unit sphere.
struct Subject {
    std::string name; ///< "bunny", "knot870k"
    std::shared_ptr<const scene::Mesh> mesh;
};

/// A torus knot of about so many triangles; generated, so it never fails.
Subject knot(const std::string& name, int triangles);

/// A mesh file, fitted into the unit sphere. Without a mesh: the file is missing or damaged.
Subject mesh_file(const std::string& name, const std::filesystem::path& file);

/// The light of every workload, in world space: what the peer is told, too.
struct Light {
    glm::vec3 to_light{0.26726124F, 0.53452248F, 0.80178373F}; ///< (1, 2, 3), unit length
    float ambient = 0.25F;
    glm::vec3 color{0.8F, 0.5F, 0.4F};
};

std::shared_ptr<scene::Scene> scene_of(const Subject& subject, const ImageSize& size);

/// So many sheets of two triangles, each over the whole image, the nearest last: as many fragments
/// per pixel.
std::shared_ptr<const scene::Scene> sheets(int count, const ImageSize& size);

/// Object space to clip space in one matrix, as a graphics library wants it. Precondition: the
/// scene's objects stand where they were modeled.
glm::mat4 clip_from_object(const scene::Scene& scene);

} // namespace hs::bench
