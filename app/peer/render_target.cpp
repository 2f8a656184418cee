#include "render_target.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hs::peer {

namespace {

/// How pixels of an internal format travel between OpenGL and memory without a conversion.
struct Transfer {
    GLenum format;
    GLenum type;
};

Transfer transfer_of(GLenum internal_format) {
    switch (internal_format) {
    case GL_RGBA8: return {GL_RGBA, GL_UNSIGNED_BYTE};
    case GL_RGBA32F: return {GL_RGBA, GL_FLOAT};
    case GL_R32F: return {GL_RED, GL_FLOAT};
    case GL_R32I: return {GL_RED_INTEGER, GL_INT};
    case GL_DEPTH_COMPONENT32F: return {GL_DEPTH_COMPONENT, GL_FLOAT};
    default: return {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT}; // DEPTH_COMPONENT16 and 24
    }
}

int bits_of_unorm_depth(GLenum internal_format) {
    return internal_format == GL_DEPTH_COMPONENT16 ? 16 : 24;
}

bool is_depth(GLenum internal_format) {
    return transfer_of(internal_format).format == GL_DEPTH_COMPONENT;
}

/// The integer that a shader's texel fetch turned into this float. llvmpipe multiplies by the
/// rounded reciprocal of 2^bits - 1. For 24 bits that is off by up to one integer; it keeps all
/// integers apart but the two largest, both of which become 1: the farthest depth is meant then.
std::uint32_t unorm_from_fetched(float fetched, int bits) {
    const double maximum = std::ldexp(1.0, bits) - 1.0;
    if (fetched >= 1.0F) {
        return static_cast<std::uint32_t>(maximum);
    }
    const auto reciprocal = static_cast<float>(1.0 / maximum);
    const auto guess = std::lround(static_cast<double>(fetched) * maximum);
    for (const auto candidate : {guess - 1, guess, guess + 1}) {
        if (static_cast<float>(candidate) * reciprocal == fetched) {
            return static_cast<std::uint32_t>(candidate);
        }
    }
    return static_cast<std::uint32_t>(guess);
}

/// One triangle larger than the viewport.
constexpr const char* whole_target_vertex_shader = R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})";

/// Spreads the samples of each pixel over neighboring columns; TEXEL and SAMPLER say which kind of
/// texture.
std::string spread_fragment_shader(GLenum internal_format) {
    const bool integers = internal_format == GL_R32I;
    return std::string("#version 330 core\n") +
           (integers ? "#define SAMPLER isampler2DMS\n#define TEXEL ivec4\n"
                     : "#define SAMPLER sampler2DMS\n#define TEXEL vec4\n") +
           R"(uniform SAMPLER samples;
uniform int samples_per_pixel;
layout(location = 0) out TEXEL texel;
void main() {
    ivec2 position = ivec2(gl_FragCoord.xy);
    int sample_index = position.x % samples_per_pixel;
    texel = texelFetch(samples, ivec2(position.x / samples_per_pixel, position.y), sample_index);
})";
}

} // namespace

RenderTarget::RenderTarget(std::shared_ptr<Session> session, const TargetShape& shape)
    : session_(std::move(session)), shape_(shape) {
    const Gl& gl = session_->gl();
    gl.generate_framebuffers(1, &framebuffer_);
    gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);

    std::array<GLenum, 2> draw_buffers = {GL_NONE, GL_NONE};
    for (std::size_t i = 0; i < shape_.colors.size(); ++i) {
        if (shape_.colors[i] != 0) {
            draw_buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
            color_textures_[i] = attach(draw_buffers[i], shape_.colors[i]);
        }
    }
    if (shape_.depth != 0) {
        depth_texture_ = attach(GL_DEPTH_ATTACHMENT, shape_.depth);
    }
    gl.draw_buffers(static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
    complete_ = gl.framebuffer_status(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

RenderTarget::~RenderTarget() {
    session_->make_current();
    const Gl& gl = session_->gl();
    gl.delete_framebuffers(1, &framebuffer_);
    gl.delete_textures(static_cast<GLsizei>(color_textures_.size()), color_textures_.data());
    gl.delete_textures(1, &depth_texture_);
}

GLuint RenderTarget::attach(GLenum attachment, GLenum format) const {
    const Gl& gl = session_->gl();
    const GLenum kind = shape_.samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    GLuint texture = 0;
    gl.generate_textures(1, &texture);
    gl.bind_texture(kind, texture);
    if (shape_.samples > 0) {
        gl.texture_image_multisample(
            kind, shape_.samples, format, shape_.width, shape_.height, GL_TRUE
        );
    } else {
        const Transfer transfer = transfer_of(format);
        gl.texture_image(
            kind,
            0,
            static_cast<GLint>(format),
            shape_.width,
            shape_.height,
            0,
            transfer.format,
            transfer.type,
            nullptr
        );
    }
    gl.framebuffer_texture(GL_FRAMEBUFFER, attachment, kind, texture, 0);
    return texture;
}

void RenderTarget::bind() const {
    session_->gl().bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
}

std::size_t RenderTarget::texel_count() const {
    return static_cast<std::size_t>(shape_.width) * static_cast<std::size_t>(shape_.height) *
           static_cast<std::size_t>(std::max(1, shape_.samples));
}

void RenderTarget::read_color(std::size_t attachment, void* texels) const {
    if (shape_.samples > 0) {
        read_samples(color_textures_[attachment], shape_.colors[attachment], texels);
    } else {
        read(
            GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment),
            shape_.colors[attachment],
            texels
        );
    }
}

void RenderTarget::read(GLenum attachment, GLenum format, void* texels) const {
    const Gl& gl = session_->gl();
    const Transfer transfer = transfer_of(format);
    bind();
    if (attachment != GL_DEPTH_ATTACHMENT) { // depth is found by its transfer format
        gl.read_buffer(attachment);
    }
    gl.read_pixels(0, 0, shape_.width, shape_.height, transfer.format, transfer.type, texels);
}

void RenderTarget::read_samples(GLuint texture, GLenum format, void* texels) const {
    const Gl& gl = session_->gl();
    // OpenGL has no direct way to read single samples: copy them to a plain target, one column
    // each. Depth travels as a 32-bit float; 24 bits of unorm survive that.
    const GLenum plain_format = is_depth(format) ? GL_R32F : format;
    const RenderTarget plain(
        session_,
        {.width = shape_.width * shape_.samples,
         .height = shape_.height,
         .colors = {plain_format, 0}}
    );
    plain.bind();
    gl.viewport(0, 0, shape_.width * shape_.samples, shape_.height);
    gl.disable_each({GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_MULTISAMPLE});
    const GLuint program =
        session_->program(whole_target_vertex_shader, spread_fragment_shader(format));
    gl.use_program(program);
    gl.uniform_int(gl.uniform_location(program, "samples"), 0);
    gl.uniform_int(gl.uniform_location(program, "samples_per_pixel"), shape_.samples);
    gl.active_texture(GL_TEXTURE0);
    gl.bind_texture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    gl.draw_arrays(GL_TRIANGLES, 0, 3);
    plain.read(GL_COLOR_ATTACHMENT0, plain_format, texels);
}

std::vector<std::uint32_t> RenderTarget::read_depth() const {
    std::vector<std::uint32_t> depths(texel_count());
    const bool is_float = shape_.depth == GL_DEPTH_COMPONENT32F;
    const int bits = bits_of_unorm_depth(shape_.depth);
    if (shape_.samples > 0) {
        read_samples(depth_texture_, shape_.depth, depths.data());
    } else {
        read(GL_DEPTH_ATTACHMENT, shape_.depth, depths.data());
    }
    if (is_float) {
        return depths;
    }
    for (std::uint32_t& depth : depths) {
        // A shader fetched the samples as floats; a plain read widens the integer to 32 bits.
        depth = shape_.samples > 0 ? unorm_from_fetched(std::bit_cast<float>(depth), bits)
                                   : depth >> (32 - bits);
    }
    return depths;
}

std::vector<std::uint8_t> RenderTarget::read_resolved() const {
    const Gl& gl = session_->gl();
    const RenderTarget plain(
        session_, {.width = shape_.width, .height = shape_.height, .colors = {GL_RGBA8, 0}}
    );
    gl.bind_framebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl.read_buffer(GL_COLOR_ATTACHMENT0);
    gl.bind_framebuffer(GL_DRAW_FRAMEBUFFER, plain.framebuffer_);
    gl.disable(GL_SCISSOR_TEST); // it would cut the copy as well
    gl.blit_framebuffer(
        0,
        0,
        shape_.width,
        shape_.height,
        0,
        0,
        shape_.width,
        shape_.height,
        GL_COLOR_BUFFER_BIT,
        GL_NEAREST
    );
    std::vector<std::uint8_t> pixels(plain.texel_count() * 4);
    plain.read_color(0, pixels.data());
    return pixels;
}

} // namespace hs::peer
