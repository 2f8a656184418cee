#include "drawing_state.hpp"

namespace hs::peer {

namespace {

GLenum to_gl(CompareOp op) {
    return GL_NEVER + static_cast<GLenum>(op);
}

GLenum to_gl(BlendFactor factor) {
    const auto index = static_cast<GLenum>(factor);
    return index < 2 ? index : GL_SRC_COLOR + (index - 2);
}

GLint to_gl(Wrap wrap) {
    switch (wrap) {
    case Wrap::repeat: return GL_REPEAT;
    case Wrap::mirrored_repeat: return GL_MIRRORED_REPEAT;
    case Wrap::clamp_to_edge: return GL_CLAMP_TO_EDGE;
    }
    return 0; // unreachable
}

void set_enabled(const Gl& gl, GLenum state, bool enabled) {
    enabled ? gl.enable(state) : gl.disable(state);
}

void set_viewport(const Gl& gl, int width, int height, bool wide_viewport) {
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    if (wide_viewport) {
        // The center stays at (w/2, h/2). Fractional, because 1.5 w is not an integer for odd
        // sizes.
        gl.viewport_fractional(0, -1.5F * w, -1.5F * h, 4.0F * w, 4.0F * h);
    } else {
        gl.viewport_fractional(0, 0.0F, 0.0F, w, h);
    }
}

void set_fragment_tests(const Gl& gl, const DrawOptions& options) {
    set_enabled(gl, GL_DEPTH_TEST, options.depth_test);
    gl.depth_mask(options.depth_write ? GL_TRUE : GL_FALSE);
    gl.depth_function(to_gl(options.depth_compare));

    set_enabled(gl, GL_SCISSOR_TEST, options.scissor.has_value());
    if (options.scissor) { // the mirrored scene makes our top edge OpenGL's bottom edge
        const Scissor& scissor = *options.scissor;
        gl.scissor(scissor.x, scissor.y, scissor.width, scissor.height);
    }
}

void set_culling(const Gl& gl, const DrawOptions& options) {
    set_enabled(gl, GL_CULL_FACE, options.cull != CullFace::none);
    gl.cull_face(options.cull == CullFace::front ? GL_FRONT : GL_BACK);
    // Swapped: what we see counterclockwise is clockwise in the mirrored scene.
    gl.front_face(options.front == Winding::ccw ? GL_CW : GL_CCW);
}

void set_blending(const Gl& gl, const std::optional<Blend>& blend) {
    gl.disable(GL_BLEND);
    if (blend) {
        gl.enable_indexed(GL_BLEND, 0); // colors only: ids cannot blend
        gl.blend_function(
            to_gl(blend->src_rgb),
            to_gl(blend->dst_rgb),
            to_gl(blend->src_alpha),
            to_gl(blend->dst_alpha)
        );
    }
}

} // namespace

void clear(const Gl& gl, const DrawOptions& options) {
    constexpr GLint no_triangle[] = {-1, 0, 0, 0};
    gl.disable(GL_SCISSOR_TEST);
    gl.depth_mask(GL_TRUE);
    gl.clear_floats(GL_COLOR, 0, &options.clear.x);
    gl.clear_integers(GL_COLOR, 1, no_triangle);
    gl.clear_floats(GL_DEPTH, 0, &options.depth_clear);
}

void set_fixed_functions(const Gl& gl, const DrawOptions& options) {
    gl.disable(GL_DITHER);
    set_enabled(gl, GL_MULTISAMPLE, options.samples > 0);
    set_viewport(gl, options.width, options.height, options.wide_viewport);
    set_fragment_tests(gl, options);
    set_culling(gl, options);
    set_blending(gl, options.blend);
}

void set_texture(const Gl& gl, GLuint name, const Texture& texture) {
    gl.active_texture(GL_TEXTURE0);
    gl.bind_texture(GL_TEXTURE_2D, name);
    for (std::size_t i = 0; i < texture.levels.size(); ++i) {
        const Texture::Level& level = texture.levels[i];
        gl.texture_image(
            GL_TEXTURE_2D,
            static_cast<GLint>(i),
            GL_RGBA8,
            level.width,
            level.height,
            0,
            GL_RGBA,
            GL_UNSIGNED_BYTE,
            level.rgba8.data()
        );
    }
    const bool nearest = texture.filter == Filter::nearest;
    const bool trilinear = texture.filter == Filter::trilinear;
    const auto set = [&](GLenum parameter, GLint value) {
        gl.texture_parameter(GL_TEXTURE_2D, parameter, value);
    };
    set(GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(texture.levels.size()) - 1);
    set(GL_TEXTURE_WRAP_S, to_gl(texture.wrap));
    set(GL_TEXTURE_WRAP_T, to_gl(texture.wrap));
    set(GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    set(GL_TEXTURE_MIN_FILTER,
        trilinear ? GL_LINEAR_MIPMAP_LINEAR
        : nearest ? GL_NEAREST
                  : GL_LINEAR);
}

} // namespace hs::peer
