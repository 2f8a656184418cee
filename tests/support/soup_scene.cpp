#include "tests/support/soup_scene.hpp"

#include "core/pipeline/draw_frame.hpp"

#include <bit>
#include <cmath>

namespace hs::tests {
namespace {

std::shared_ptr<const scene::Mesh> mesh_of(const Soup& soup) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->polygon_start.push_back(0);
    for (std::uint32_t i = 0; i < soup.size(); ++i) {
        mesh->positions.push_back(soup[i].clip);
        mesh->normals.emplace_back(0.0F, 0.0F, 1.0F);
        mesh->colors.push_back(soup[i].color);
        mesh->uvs.push_back(soup[i].uv);
        mesh->polygon_vertices.push_back(i);
        if (i % 3 == 2) {
            mesh->triangle_polygon.push_back(i / 3);
            mesh->triangles.push_back({i - 2, i - 1, i});
            mesh->polygon_start.push_back(i + 1);
        }
    }
    return mesh;
}

/// Notes which triangle each pixel was written by.
class WriterTrace : public pipeline::NullTrace {
public:
    WriterTrace(const scene::Scene& scene, Drawing& drawing) : drawing_(drawing) {
        int first = 0;
        for (const scene::Object& object : scene.objects) {
            first_.push_back(first);
            first += static_cast<int>(object.mesh->triangles.size());
        }
    }
    void triangle_begin(std::uint32_t object, std::uint32_t triangle) {
        current_ = first_[object] + static_cast<int>(triangle);
    }
    void interpolated(const raster::Fragment& fragment) {
        index_ =
            static_cast<std::size_t>(fragment.pixel.y * drawing_.target.width() + fragment.pixel.x);
        ++drawing_.covered[index_];
    }
    void merged(const pipeline::Merge&) { drawing_.triangle[index_] = current_; }

private:
    Drawing& drawing_;
    std::vector<int> first_;
    int current_ = 0;
    std::size_t index_ = 0;
};

} // namespace

std::shared_ptr<const scene::Scene> soup_scene(
    const Soup& soup, const scene::Settings& settings, std::shared_ptr<const scene::Texture> texture
) {
    auto scene = std::make_shared<scene::Scene>();
    scene->settings = settings;
    scene->camera.projection.kind = scene::ProjectionKind::identity;
    scene::Object object;
    object.mesh = mesh_of(soup);
    if (texture) {
        scene::Material material;
        material.texture = std::move(texture);
        scene->materials.push_back(std::move(material));
        object.material = 0;
    }
    scene->objects.push_back(std::move(object));
    return scene;
}

Drawing drawn(const std::shared_ptr<const scene::Scene>& scene) {
    pipeline::Frame frame(scene);
    const auto pixels = static_cast<std::size_t>(scene->settings.width) *
                        static_cast<std::size_t>(scene->settings.height);
    Drawing drawing{framebuffer::Framebuffer(scene->settings), {}, {}, {}};
    drawing.triangle.assign(pixels, -1);
    drawing.covered.assign(pixels, 0);
    WriterTrace trace(*scene, drawing);
    pipeline::draw_frame(frame, drawing.target, trace);
    for (const pipeline::DrawCall& call : frame.calls()) {
        drawing.clip.emplace_back();
        for (const pipeline::ShadedVertex& vertex : call.vertices) {
            drawing.clip.back().push_back(math::to_vec4(vertex.clip));
        }
    }
    return drawing;
}

std::uint32_t raw_depth(float stored, scene::DepthFormat format) {
    switch (format) {
    case scene::DepthFormat::float32: return std::bit_cast<std::uint32_t>(stored);
    case scene::DepthFormat::unorm24:
        return static_cast<std::uint32_t>(std::lround(static_cast<double>(stored) * 16777215.0));
    case scene::DepthFormat::unorm16:
        return static_cast<std::uint32_t>(std::lround(static_cast<double>(stored) * 65535.0));
    }
    HS_CHECK(false, "every depth format is handled");
    return 0;
}

} // namespace hs::tests
