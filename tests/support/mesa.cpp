#include "tests/support/mesa.hpp"

#include "core/framebuffer/color.hpp"
#include "tests/support/catch.hpp"

#include <string>

namespace hs::tests {
namespace {

peer::CompareOp to_peer(scene::CompareOp op) {
    switch (op) {
    case scene::CompareOp::never: return peer::CompareOp::never;
    case scene::CompareOp::less: return peer::CompareOp::less;
    case scene::CompareOp::lequal: return peer::CompareOp::less_equal;
    case scene::CompareOp::equal: return peer::CompareOp::equal;
    case scene::CompareOp::gequal: return peer::CompareOp::greater_equal;
    case scene::CompareOp::greater: return peer::CompareOp::greater;
    case scene::CompareOp::notequal: return peer::CompareOp::not_equal;
    case scene::CompareOp::always: return peer::CompareOp::always;
    }
    HS_CHECK(false, "every compare op is handled");
    return peer::CompareOp::always;
}

peer::DepthFormat to_peer(scene::DepthFormat format) {
    switch (format) {
    case scene::DepthFormat::float32: return peer::DepthFormat::float32;
    case scene::DepthFormat::unorm24: return peer::DepthFormat::unorm24;
    case scene::DepthFormat::unorm16: return peer::DepthFormat::unorm16;
    }
    HS_CHECK(false, "every depth format is handled");
    return peer::DepthFormat::float32;
}

peer::Interpolation to_peer(scene::InterpolationKind kind) {
    switch (kind) {
    case scene::InterpolationKind::perspective: return peer::Interpolation::smooth;
    case scene::InterpolationKind::linear: return peer::Interpolation::noperspective;
    case scene::InterpolationKind::flat: return peer::Interpolation::flat;
    }
    HS_CHECK(false, "every interpolation is handled");
    return peer::Interpolation::smooth;
}

peer::CullFace to_peer(scene::CullFace cull) {
    return cull == scene::CullFace::none   ? peer::CullFace::none
           : cull == scene::CullFace::back ? peer::CullFace::back
                                           : peer::CullFace::front;
}

peer::DrawOptions options_for(const scene::Settings& settings, Sides sides) {
    peer::DrawOptions options{
        .width = settings.width,
        .height = settings.height,
        .samples = settings.samples > 1 ? settings.samples : 0,
        .color_format = settings.color_format == scene::ColorFormat::rgba8
                            ? peer::ColorFormat::rgba8
                            : peer::ColorFormat::rgba32f,
        .clear = settings.background,
        .interpolation = to_peer(settings.interpolation),
        .depth_test = settings.visibility == scene::Visibility::z_buffer,
        .depth_write = settings.depth_write,
        .depth_compare = to_peer(settings.depth_test()),
        .depth_format = to_peer(settings.depth_format),
        .depth_clear = settings.depth_clear(),
        .cull = to_peer(settings.cull),
        .front =
            settings.front_face == scene::Winding::ccw ? peer::Winding::ccw : peer::Winding::cw,
        .wide_viewport = sides == Sides::do_not_clip};
    if (settings.blend_enabled) {
        options.blend = peer::Blend{};
    }
    if (settings.scissor) {
        const PixelRect& s = *settings.scissor;
        options.scissor = peer::Scissor{s.x0, s.y0, s.width(), s.height()};
    }
    return options;
}

std::vector<std::uint8_t> bytes_of(const scene::Texture& texture) {
    std::vector<std::uint8_t> bytes;
    for (const glm::vec4& texel : texture.texels) {
        for (int channel = 0; channel < 4; ++channel) {
            bytes.push_back(static_cast<std::uint8_t>(framebuffer::to_unorm8(texel[channel])));
        }
    }
    return bytes;
}

} // namespace

peer::Context* mesa() {
    static std::string why_not;
    static std::optional<peer::Context> context = peer::Context::create(&why_not);
    if (!context) {
        WARN("not compared with Mesa: " << why_not);
        return nullptr;
    }
    return &*context;
}

peer::Image drawn_by(
    peer::Context& mesa,
    const Soup& soup,
    const scene::Settings& settings,
    Sides sides,
    const scene::Texture* texture
) {
    std::vector<peer::Vertex> vertices;
    std::vector<glm::uvec3> triangles;
    for (unsigned i = 0; i < soup.size(); ++i) {
        vertices.push_back({.clip = soup[i].clip, .color = soup[i].color, .uv = soup[i].uv});
        if (i % 3 == 2) {
            triangles.emplace_back(i - 2, i - 1, i);
        }
    }
    peer::DrawOptions options = options_for(settings, sides);
    std::vector<std::uint8_t> texels;
    if (texture != nullptr) {
        texels = bytes_of(*texture);
        options.texture = peer::Texture{.levels = {{texture->width, texture->height, texels}}};
    }
    peer::Image image = mesa.draw(vertices, triangles, options);
    INFO(image.error);
    REQUIRE(image.error.empty());
    return image;
}

} // namespace hs::tests
