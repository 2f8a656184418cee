#include "timed_mesh.hpp"

#include "complaints.hpp"
#include "context_state.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace hs::peer {

namespace {

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_object;
uniform vec3 to_light;
uniform vec3 lit_color;
uniform vec3 ambient_color;
smooth out vec3 color;
void main() {
    gl_Position = clip_from_object * vec4(position, 1.0);
    color = ambient_color + lit_color * max(0.0, dot(normal, to_light));
})";

constexpr const char* fragment_shader = R"(#version 330 core
smooth in vec3 color;
layout(location = 0) out vec4 fragment_color;
void main() {
    fragment_color = vec4(color, 1.0);
})";

std::string complain_about(const MeshView& mesh, int width, int height) {
    if (mesh.positions.size() != mesh.normals.size()) {
        return "a mesh needs as many normals as positions";
    }
    std::string complaint = complain_about_indices(mesh.positions.size(), mesh.triangles);
    return complaint.empty() ? complain_about_size(width, height, 0, false) : complaint;
}

/// The matrix that makes Mesa draw the mirrored scene.
glm::mat4 mirrored(glm::mat4 clip_from_object) {
    for (int column = 0; column < 4; ++column) {
        clip_from_object[column].y = -clip_from_object[column].y;
    }
    return clip_from_object;
}

} // namespace

struct TimedMesh::State {
    State(std::shared_ptr<Session> the_session, const MeshView& mesh, int width, int height);
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;
    ~State();

    void set_state(const FrameSettings& settings) const;
    void set_uniforms(const FrameSettings& settings) const;

    std::shared_ptr<Session> session;
    int width;
    int height;
    RenderTarget target;
    GLuint program;
    GLuint vertex_array = 0;
    /// positions, normals, indices
    std::array<GLuint, 3> buffers = {0, 0, 0};
    GLsizei index_count;
};

TimedMesh::State::State(
    std::shared_ptr<Session> the_session, const MeshView& mesh, int the_width, int the_height
)
    : session(std::move(the_session)),
      width(the_width),
      height(the_height),
      target(
          session,
          {.width = width, .height = height, .colors = {GL_RGBA8, 0}, .depth = GL_DEPTH_COMPONENT24}
      ),
      program(session->program(vertex_shader, fragment_shader)),
      index_count(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    const Gl& gl = session->gl();
    gl.generate_vertex_arrays(1, &vertex_array);
    gl.bind_vertex_array(vertex_array);
    gl.generate_buffers(static_cast<GLsizei>(buffers.size()), buffers.data());

    const auto upload = [&](GLenum kind, GLuint buffer, const auto& values) {
        gl.bind_buffer(kind, buffer);
        gl.buffer_data(
            kind, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STATIC_DRAW
        );
    };
    upload(GL_ARRAY_BUFFER, buffers[0], mesh.positions);
    gl.enable_attribute(0);
    gl.attribute_pointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    upload(GL_ARRAY_BUFFER, buffers[1], mesh.normals);
    gl.enable_attribute(1);
    gl.attribute_pointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    upload(GL_ELEMENT_ARRAY_BUFFER, buffers[2], mesh.triangles);
}

TimedMesh::State::~State() {
    session->make_current();
    const Gl& gl = session->gl();
    gl.delete_buffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    gl.delete_vertex_arrays(1, &vertex_array);
}

void TimedMesh::State::set_state(const FrameSettings& settings) const {
    const Gl& gl = session->gl();
    target.bind();
    gl.disable_each({GL_BLEND, GL_DITHER, GL_MULTISAMPLE, GL_SCISSOR_TEST});
    gl.enable(GL_DEPTH_TEST);
    gl.depth_function(GL_LESS);
    gl.depth_mask(GL_TRUE);
    gl.enable(GL_CULL_FACE);
    gl.cull_face(GL_BACK);
    // Swapped: what we see counterclockwise is clockwise in the mirrored scene.
    gl.front_face(settings.front == Winding::ccw ? GL_CW : GL_CCW);
    gl.viewport(0, 0, width, height);
    gl.bind_vertex_array(vertex_array);
}

void TimedMesh::State::set_uniforms(const FrameSettings& settings) const {
    const Gl& gl = session->gl();
    gl.use_program(program);
    const auto set_vec3 = [&](const char* name, const glm::vec3& value) {
        gl.uniform_vec3(gl.uniform_location(program, name), value.x, value.y, value.z);
    };
    set_vec3("to_light", settings.to_light);
    set_vec3("ambient_color", settings.color * settings.ambient);
    set_vec3("lit_color", settings.color * (1.0F - settings.ambient));
    const glm::mat4 matrix = mirrored(settings.clip_from_object);
    gl.uniform_mat4(gl.uniform_location(program, "clip_from_object"), 1, GL_FALSE, &matrix[0].x);
}

TimedMesh::TimedMesh(std::unique_ptr<State> state) : state_(std::move(state)) {}
TimedMesh::TimedMesh(TimedMesh&&) noexcept = default;
TimedMesh& TimedMesh::operator=(TimedMesh&&) noexcept = default;
TimedMesh::~TimedMesh() = default;

std::optional<TimedMesh> TimedMesh::create(
    const Context& context, const MeshView& mesh, int width, int height, std::string* why_not
) {
    std::string complaint = complain_about(mesh, width, height);
    std::unique_ptr<State> state;
    if (complaint.empty()) {
        const std::shared_ptr<Session>& session = context.state_->session;
        session->make_current();
        state = std::make_unique<State>(session, mesh, width, height);
        complaint = state->target.complete() ? session->take_error() : unsupported_target;
    }
    if (why_not != nullptr) {
        *why_not = complaint;
    }
    if (!complaint.empty()) {
        return std::nullopt;
    }
    return TimedMesh(std::move(state));
}

double TimedMesh::draw_frame(const FrameSettings& settings) {
    using Clock = std::chrono::steady_clock;
    constexpr std::array black = {0.0F, 0.0F, 0.0F, 0.0F};
    constexpr float farthest = 1.0F;
    state_->session->make_current();
    const Gl& gl = state_->session->gl();
    state_->set_state(settings);
    state_->set_uniforms(settings);
    gl.finish(); // nothing left over from before

    const Clock::time_point start = Clock::now();
    gl.clear_floats(GL_COLOR, 0, black.data());
    gl.clear_floats(GL_DEPTH, 0, &farthest);
    gl.draw_elements(GL_TRIANGLES, state_->index_count, GL_UNSIGNED_INT, nullptr);
    gl.finish();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Image TimedMesh::image() const {
    state_->session->make_current();
    Image image{.width = state_->width, .height = state_->height};
    image.rgba8.resize(4 * state_->target.texel_count());
    state_->target.read_color(0, image.rgba8.data());
    image.depth_raw = state_->target.read_depth();
    image.depth.resize(image.depth_raw.size());
    std::ranges::transform(image.depth_raw, image.depth.begin(), [](std::uint32_t raw) {
        return static_cast<float>(static_cast<double>(raw) / 16777215.0);
    });
    image.error = state_->session->take_error();
    return image;
}

} // namespace hs::peer
