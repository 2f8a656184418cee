#include "osmesa.hpp"

#include "complaints.hpp"
#include "context_state.hpp"
#include "drawing_state.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

namespace hs::peer {

namespace {

GLenum to_gl(DepthFormat format) {
    switch (format) {
    case DepthFormat::unorm16: return GL_DEPTH_COMPONENT16;
    case DepthFormat::unorm24: return GL_DEPTH_COMPONENT24;
    case DepthFormat::float32: return GL_DEPTH_COMPONENT32F;
    }
    return 0; // unreachable
}

GLenum to_gl(ColorFormat format) {
    return format == ColorFormat::rgba8 ? GL_RGBA8 : GL_RGBA32F;
}

// Programs

constexpr const char* vertex_shader = R"(
layout(location = 0) in vec4 clip_position;
layout(location = 1) in vec4 vertex_color;
layout(location = 2) in vec2 vertex_uv;
COLOR_QUALIFIER out vec4 color;
UV_QUALIFIER out vec2 uv;
flat out int triangle;
void main() {
    gl_Position = clip_position;
    color = vertex_color;
    uv = vertex_uv;
    triangle = gl_VertexID / 3;
})";

constexpr const char* fragment_shader = R"(
COLOR_QUALIFIER in vec4 color;
UV_QUALIFIER in vec2 uv;
flat in int triangle;
uniform sampler2D picture;
layout(location = 0) out vec4 fragment_color;
layout(location = 1) out int fragment_triangle;
void main() {
    fragment_color = color;
    if (TEXTURED) {
        fragment_color *= texture(picture, uv);
    }
    fragment_triangle = triangle;
})";

const char* qualifier_of(Interpolation interpolation) {
    switch (interpolation) {
    case Interpolation::smooth: return "smooth";
    case Interpolation::noperspective: return "noperspective";
    case Interpolation::flat: return "flat";
    }
    return ""; // unreachable
}

/// What the two shaders above leave open. Texture coordinates are interpolated even where colors
/// are flat.
std::string shader_prefix(Interpolation interpolation, bool textured) {
    const bool flat = interpolation == Interpolation::flat;
    std::string prefix = "#version 330 core\n";
    prefix += std::string("#define COLOR_QUALIFIER ") + qualifier_of(interpolation) + "\n";
    prefix += std::string("#define UV_QUALIFIER ") +
              qualifier_of(flat ? Interpolation::smooth : interpolation) + "\n";
    prefix += std::string("#define TEXTURED ") + (textured ? "true" : "false") + "\n";
    return prefix;
}

GLuint drawing_program(Session& session, const DrawOptions& options) {
    const std::string prefix = shader_prefix(options.interpolation, options.texture.has_value());
    return session.program(prefix + vertex_shader, prefix + fragment_shader);
}

/// Each triangle adds its own power of two, built from its exponent bits so that no rounding is
/// involved.
constexpr const char* coverage_vertex_source = R"(#version 330 core
layout(location = 0) in vec4 clip_position;
flat out float weight;
void main() {
    gl_Position = clip_position;
    weight = uintBitsToFloat(uint(127 + gl_VertexID / CORNERS) << 23);
})";

/// The shader above for primitives of so many corners.
std::string coverage_vertex_shader(Primitive primitive) {
    constexpr std::string_view word = "CORNERS";
    std::string source = coverage_vertex_source;
    source.replace(source.find(word), word.size(), std::to_string(static_cast<int>(primitive)));
    return source;
}

constexpr const char* coverage_fragment_shader = R"(#version 330 core
flat in float weight;
layout(location = 0) out float sum;
void main() {
    sum = weight;
})";

// Geometry

/// The position that makes Mesa draw the mirrored scene. A quarter of the position in a viewport of
/// four times the size is the same picture, exactly: both are powers of two.
glm::vec4 mirrored(const glm::vec4& clip, bool wide_viewport) {
    const float scale = wide_viewport ? 0.25F : 1.0F;
    return {clip.x * scale, -clip.y * scale, clip.z, clip.w};
}

/// Corners one after another, so that gl_VertexID / 3 is the triangle and no driver has to number
/// primitives.
std::vector<Vertex> unroll(
    std::span<const Vertex> vertices, std::span<const glm::uvec3> triangles, bool wide_viewport
) {
    std::vector<Vertex> corners;
    corners.reserve(3 * triangles.size());
    for (const glm::uvec3& triangle : triangles) {
        for (const unsigned index : {triangle.x, triangle.y, triangle.z}) {
            corners.push_back(vertices[index]);
            corners.back().clip = mirrored(vertices[index].clip, wide_viewport);
        }
    }
    return corners;
}

std::vector<glm::vec4> mirror(std::span<const glm::vec4> corners, bool wide_viewport) {
    std::vector<glm::vec4> result(corners.size());
    std::ranges::transform(corners, result.begin(), [&](const glm::vec4& clip) {
        return mirrored(clip, wide_viewport);
    });
    return result;
}

/// Attribute `location` consists of floats, `offset` bytes into each corner of `stride` bytes.
void set_attribute(
    const Gl& gl, GLuint location, GLint components, std::size_t stride, std::size_t offset
) {
    gl.enable_attribute(location);
    gl.attribute_pointer(
        location,
        components,
        GL_FLOAT,
        GL_FALSE,
        static_cast<GLsizei>(stride),
        // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL wants the offset as a pointer
        reinterpret_cast<const void*>(offset)
    );
}

/// Draws corners that already lie in the mirrored scene, as many per primitive as it has.
template <typename Corner>
void draw_corners(
    const Gl& gl,
    GLuint buffer,
    const std::vector<Corner>& corners,
    Primitive primitive = Primitive::triangles
) {
    gl.bind_buffer(GL_ARRAY_BUFFER, buffer);
    gl.buffer_data(
        GL_ARRAY_BUFFER,
        static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
        corners.data(),
        GL_STREAM_DRAW
    );
    if constexpr (std::is_same_v<Corner, Vertex>) {
        set_attribute(gl, 0, 4, sizeof(Vertex), offsetof(Vertex, clip));
        set_attribute(gl, 1, 4, sizeof(Vertex), offsetof(Vertex, color));
        set_attribute(gl, 2, 2, sizeof(Vertex), offsetof(Vertex, uv));
    } else { // positions alone
        set_attribute(gl, 0, 4, sizeof(Corner), 0);
    }
    const GLenum mode = primitive == Primitive::points  ? GL_POINTS
                        : primitive == Primitive::lines ? GL_LINES
                                                        : GL_TRIANGLES;
    gl.draw_arrays(mode, 0, static_cast<GLsizei>(corners.size()));
}

/// Every triangle adds to what is there.
DrawOptions coverage_state(const CoverageOptions& options) {
    constexpr BlendFactor one = BlendFactor::one;
    return {
        .width = options.width,
        .height = options.height,
        .samples = options.samples,
        .wide_viewport = options.wide_viewport,
        .blend = Blend{.src_rgb = one, .dst_rgb = one, .src_alpha = one, .dst_alpha = one}};
}

// Reading back

float depth_from_raw(std::uint32_t raw, DepthFormat format) {
    if (format == DepthFormat::float32) {
        return std::bit_cast<float>(raw);
    }
    const double maximum = format == DepthFormat::unorm16 ? 65535.0 : 16777215.0;
    return static_cast<float>(static_cast<double>(raw) / maximum);
}

Image read_image(const RenderTarget& target, const DrawOptions& options) {
    Image image{
        .width = options.width, .height = options.height, .samples = std::max(1, options.samples)};
    const std::size_t count = target.texel_count();
    if (options.color_format == ColorFormat::rgba8) {
        image.rgba8.resize(4 * count);
        target.read_color(0, image.rgba8.data());
    } else {
        image.rgba32f.resize(count);
        target.read_color(0, image.rgba32f.data());
    }
    if (options.samples > 0 && options.color_format == ColorFormat::rgba8) {
        image.resolved = target.read_resolved();
    }
    image.triangle.resize(count);
    target.read_color(1, image.triangle.data());

    image.depth_raw = target.read_depth();
    image.depth.resize(count);
    std::ranges::transform(image.depth_raw, image.depth.begin(), [&](std::uint32_t raw) {
        return depth_from_raw(raw, options.depth_format);
    });
    return image;
}

} // namespace

// Context

Context::State::State(std::shared_ptr<Session> the_session) : session(std::move(the_session)) {
    const Gl& gl = session->gl();
    gl.generate_vertex_arrays(1, &vertex_array);
    gl.generate_buffers(1, &vertex_buffer);
    gl.generate_textures(1, &texture);
}

Context::State::~State() {
    session->make_current();
    const Gl& gl = session->gl();
    gl.delete_vertex_arrays(1, &vertex_array);
    gl.delete_buffers(1, &vertex_buffer);
    gl.delete_textures(1, &texture);
}

const RenderTarget& Context::State::target(const TargetShape& shape) {
    constexpr std::size_t most_targets = 8; // tests of random sizes must not fill the memory
    if (targets.size() >= most_targets && !targets.contains(shape)) {
        targets.clear();
    }
    std::unique_ptr<RenderTarget>& target = targets[shape];
    if (!target) {
        target = std::make_unique<RenderTarget>(session, shape);
    }
    return *target;
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

std::optional<Context> Context::create(std::string* why_not) {
    std::string reason;
    std::shared_ptr<Session> session = Session::create(reason);
    if (why_not != nullptr) {
        *why_not = reason;
    }
    if (!session) {
        return std::nullopt;
    }
    return Context(std::make_unique<State>(std::move(session)));
}

Image Context::draw(
    std::span<const Vertex> vertices,
    std::span<const glm::uvec3> triangles,
    const DrawOptions& options
) {
    std::string complaint = complain_about_options(options);
    if (complaint.empty()) {
        complaint = complain_about_indices(vertices.size(), triangles);
    }
    if (!complaint.empty()) {
        return {.error = std::move(complaint)};
    }
    state_->session->make_current();
    const RenderTarget& target = state_->target(
        {.width = options.width,
         .height = options.height,
         .samples = options.samples,
         .colors = {to_gl(options.color_format), GL_R32I},
         .depth = to_gl(options.depth_format)}
    );
    if (!target.complete()) {
        return {.error = unsupported_target};
    }

    const Gl& gl = state_->session->gl();
    target.bind();
    clear(gl, options);
    set_fixed_functions(gl, options);
    if (options.texture) {
        set_texture(gl, state_->texture, *options.texture);
    }
    gl.use_program(drawing_program(*state_->session, options));
    gl.bind_vertex_array(state_->vertex_array);
    draw_corners(gl, state_->vertex_buffer, unroll(vertices, triangles, options.wide_viewport));

    Image image = read_image(target, options);
    image.error = state_->session->take_error();
    return image;
}

Coverage Context::coverage(std::span<const glm::vec4> corners, const CoverageOptions& options) {
    const auto each = static_cast<std::size_t>(options.primitive);
    if (corners.size() % each != 0 || corners.size() > each * coverage_batch_size) {
        return {.error = "coverage takes all corners of at most 24 primitives"};
    }
    if (std::string complaint = complain_about_size(
            options.width, options.height, options.samples, options.wide_viewport
        );
        !complaint.empty()) {
        return {.error = std::move(complaint)};
    }
    state_->session->make_current();
    const RenderTarget& target = state_->target(
        {.width = options.width,
         .height = options.height,
         .samples = options.samples,
         .colors = {GL_R32F, 0}}
    );
    if (!target.complete()) {
        return {.error = unsupported_target};
    }

    // Sum one power of two per triangle: a float holds 24 of them exactly.
    const Gl& gl = state_->session->gl();
    target.bind();
    set_fixed_functions(gl, coverage_state(options));
    gl.clear_floats(GL_COLOR, 0, std::array{0.0F, 0.0F, 0.0F, 0.0F}.data());
    gl.use_program(state_->session->program(
        coverage_vertex_shader(options.primitive), coverage_fragment_shader
    ));
    gl.bind_vertex_array(state_->vertex_array);
    draw_corners(
        gl, state_->vertex_buffer, mirror(corners, options.wide_viewport), options.primitive
    );

    state_->coverage_bits.resize(target.texel_count());
    target.read_color(0, state_->coverage_bits.data());
    for (std::uint32_t& sum : state_->coverage_bits) {
        sum = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::bit_cast<float>(sum)));
    }
    return {.bits = state_->coverage_bits, .error = state_->session->take_error()};
}

std::string Context::renderer() const {
    state_->session->make_current();
    const GLubyte* name = state_->session->gl().get_string(GL_RENDERER);
    return reinterpret_cast<const char*>(name);
}

} // namespace hs::peer
