#include "tests/support/random_scene.hpp"

#include "core/scene/triangulate.hpp"

#include <string>

namespace hs::tests {
namespace {

/// An enumerator below `count`.
template <typename Enum>
Enum any(Random& random, std::uint32_t count) {
    return static_cast<Enum>(random.below(count));
}

scene::Settings random_settings(Random& random) {
    scene::Settings s;
    s.width = 1 + static_cast<int>(random.below(24));
    s.height = 1 + static_cast<int>(random.below(24));
    s.background = {0.125F, 0.25F, 0.5F, 1.0F};
    s.visibility = random.one_in(4) ? scene::Visibility::none : scene::Visibility::z_buffer;
    if (random.one_in(3)) {
        s.visibility = static_cast<scene::Visibility>(2 + random.below(8));
    }
    s.painters_key = any<scene::PaintersKey>(random, 3);
    s.bsp_splitter = any<scene::BspSplitter>(random, 3);
    s.bsp_seed = random.below(4);
    s.bsp_order = any<scene::BspOrder>(random, 2);
    s.traversal = any<scene::TraversalKind>(random, 8);
    s.tile_size = 2 << random.below(6);
    s.clip_enabled = !random.one_in(5);
    if (random.one_in(4)) {
        s.guard_band = random.between(1.0F, 3.0F);
    }
    if (random.one_in(4)) {
        s.clip_planes.emplace_back(1.0F, 0.5F, 0.25F, random.between(-1.0F, 3.0F));
    }
    s.cull = any<scene::CullFace>(random, 3);
    s.front_face = any<scene::Winding>(random, 2);
    s.shading = any<scene::Shading>(random, 4);
    s.interpolation = any<scene::InterpolationKind>(random, 3);
    s.depth_convention = any<scene::DepthConvention>(random, 3);
    if (random.one_in(3)) {
        s.depth_test_choice = any<scene::CompareOp>(random, 8);
    }
    s.depth_write = !random.one_in(5);
    s.depth_format = any<scene::DepthFormat>(random, 3);
    s.depth_order = any<scene::DepthOrder>(random, 2);
    s.color_format = any<scene::ColorFormat>(random, 2);
    s.blend_enabled = random.one_in(3);
    if (random.one_in(4)) {
        s.scissor = PixelRect{1, 2, 9, 11};
    }
    return s;
}

glm::vec4 random_position(Random& random, bool clip_space) {
    const auto coordinate = [&random] {
        // Multiples of 1/4 make shared edges, ties and degenerate triangles common
        const float value = random.between(-2.5F, 2.5F);
        return random.one_in(2) ? static_cast<float>(static_cast<int>(value * 4.0F)) / 4.0F : value;
    };
    const float w = clip_space && random.one_in(2) ? random.between(-1.0F, 3.0F) : 1.0F;
    const float far_out = random.one_in(20) ? 1.0e5F : 1.0F;
    return {coordinate() * far_out, coordinate(), coordinate(), w};
}

std::shared_ptr<const scene::Mesh> random_mesh(Random& random, bool clip_space) {
    auto mesh = std::make_shared<scene::Mesh>();
    const std::uint32_t vertices = 3 + random.below(8);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        mesh->positions.push_back(random_position(random, clip_space));
        // Braces: arguments in parentheses are drawn in the order the compiler likes
        // NOLINTNEXTLINE(modernize-use-emplace)
        mesh->colors.push_back(glm::vec4{
            random.between(0.0F, 1.0F),
            random.between(0.0F, 1.0F),
            random.between(0.0F, 1.0F),
            random.between(0.25F, 1.0F)});
    }
    const std::uint32_t triangles = random.below(9);
    mesh->polygon_start.push_back(0);
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
        mesh->polygon_vertices.push_back(random.below(vertices));
        if (i % 3 == 2) {
            mesh->polygon_start.push_back(i + 1);
        }
    }
    scene::finish_mesh(*mesh);
    return mesh;
}

/// Takes back what is refused: cutting triangles that are drawn whole, dividing a world in which
/// vertices have no place.
void make_meaningful(scene::Scene& scene) {
    using scene::Visibility;
    scene::Settings& s = scene.settings;
    if (s.splits_triangles() && s.traversal == scene::TraversalKind::homogeneous) {
        s.traversal = scene::TraversalKind::bounding_box;
    }
    if (s.sweeps()) {
        s.blend_enabled = false;
    }
    if (s.visibility == Visibility::ray_cast) {
        s.clip_enabled = true;
        s.clip_planes.clear();
    }
    const bool in_world = s.visibility == Visibility::bsp || s.visibility == Visibility::octree ||
                          s.visibility == Visibility::ray_cast;
    for (const scene::Object& object : scene.objects) {
        for (const glm::vec4& position : object.mesh->positions) {
            if (in_world && position.w != 1.0F) {
                s.visibility = s.sweeps() ? Visibility::scanline : Visibility::newell_sancha;
            }
        }
    }
}

} // namespace

std::shared_ptr<const scene::Scene> random_scene(std::uint64_t seed) {
    Random random(seed);
    auto made = std::make_shared<scene::Scene>();
    made->name = "random scene " + std::to_string(seed);
    made->settings = random_settings(random);
    const bool identity = random.one_in(3);
    made->camera.projection.kind =
        identity ? scene::ProjectionKind::identity : scene::ProjectionKind::perspective;
    made->camera.projection.near = 0.5F;
    made->lights.push_back({.to_light = {1.0F, 2.0F, 3.0F}});
    made->lights.push_back({.kind = scene::LightKind::ambient, .color = {0.25F, 0.25F, 0.25F}});
    made->materials.push_back({.name = "shiny", .specular = {0.5F, 0.5F, 0.5F}});
    const std::uint32_t objects = 1 + random.below(3);
    for (std::uint32_t i = 0; i < objects; ++i) {
        scene::Object object;
        object.name = std::to_string(i);
        object.mesh = random_mesh(random, identity);
        if (random.one_in(2)) {
            object.material = 0;
        }
        if (random.one_in(3)) {
            object.overrides.emplace_back("depth.test", scene::SettingValue{std::string{"lequal"}});
            object.overrides.emplace_back("depth.write", scene::SettingValue{false});
        }
        made->objects.push_back(std::move(object));
    }
    make_meaningful(*made);
    return made;
}

std::shared_ptr<const scene::Scene> sampled_scene(std::uint64_t seed) {
    auto made = std::make_shared<scene::Scene>(*random_scene(seed));
    Random random(~seed);
    scene::Settings& s = made->settings;
    if (s.sweeps()) {
        s.visibility = scene::Visibility::z_buffer; // which ask pixel centers only
    }
    s.sampling = any<scene::Sampling>(random, 3);
    switch (s.sampling) {
    case scene::Sampling::multisample: s.samples = 2 << random.below(3); break;
    case scene::Sampling::supersample: s.samples = 4; break;
    case scene::Sampling::conservative:
        // Bounding box, incremental, serpentine, hierarchical
        s.traversal = static_cast<scene::TraversalKind>(1 + random.below(4));
        return made;
    }
    s.traversal = any<scene::TraversalKind>(random, 7); // all but homogeneous
    return made;
}

} // namespace hs::tests
