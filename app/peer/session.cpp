#include "session.hpp"

namespace hs::peer {

namespace {

/// An OpenGL 3.3 core context: old enough for softpipe; llvmpipe answers with 4.5.
OsMesa::Context create_context(const OsMesa& library) {
    // Values of <GL/osmesa.h>; see OsMesa for why it is not included.
    constexpr int format = 0x22;
    constexpr int profile = 0x33;
    constexpr int core_profile = 0x34;
    constexpr int major_version = 0x36;
    constexpr int minor_version = 0x37;
    const int attributes[] = {
        format, GL_RGBA, profile, core_profile, major_version, 3, minor_version, 3, 0};
    return library.create_context(attributes, nullptr);
}

GLuint compile(const Gl& gl, GLenum stage, const std::string& source) {
    const GLuint shader = gl.create_shader(stage);
    const char* text = source.c_str();
    gl.shader_source(shader, 1, &text, nullptr);
    gl.compile_shader(shader);
    return shader;
}

GLuint link(const Gl& gl, const std::string& vertex, const std::string& fragment) {
    const GLuint program = gl.create_program();
    for (const GLuint shader :
         {compile(gl, GL_VERTEX_SHADER, vertex), compile(gl, GL_FRAGMENT_SHADER, fragment)}) {
        gl.attach_shader(program, shader);
        gl.delete_shader(shader); // lives on as long as the program
    }
    gl.link_program(program);

    // A shader that did not compile cannot link, so one question answers for all three.
    GLint linked = GL_FALSE;
    gl.get_program(program, GL_LINK_STATUS, &linked);
    return linked == GL_TRUE ? program : 0;
}

} // namespace

std::shared_ptr<Session> Session::create(std::string& why_not) {
    const OsMesa& library = load_osmesa();
    why_not = library.why_not;
    if (!why_not.empty()) {
        return nullptr;
    }
    const OsMesa::Context context = create_context(library);
    if (context == nullptr) {
        why_not = "libOSMesa cannot create an OpenGL 3.3 core context";
        return nullptr;
    }

    std::shared_ptr<Session> session(new Session(library, context));
    if (!session->gl_.missing().empty()) {
        why_not = "libOSMesa has no function " + session->gl_.missing().front();
        return nullptr;
    }
    session->make_current();
    // Rows of 16-bit depth or of single bytes follow each other without padding.
    session->gl_.pixel_store(GL_PACK_ALIGNMENT, 1);
    session->gl_.pixel_store(GL_UNPACK_ALIGNMENT, 1);
    return session;
}

Session::Session(const OsMesa& library, OsMesa::Context context)
    : library_(library), context_(context), gl_(library) {}

Session::~Session() {
    if (library_.current_context() == context_) {
        library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
    library_.destroy_context(context_);
}

void Session::make_current() {
    if (library_.current_context() == context_) {
        return; // OSMesa would flush and look at its window buffer again
    }
    library_.make_current(context_, window_buffer_, GL_UNSIGNED_BYTE, 1, 1);
}

GLuint Session::program(const std::string& vertex, const std::string& fragment) {
    const auto [entry, is_new] = programs_.try_emplace(vertex + fragment, 0U);
    if (is_new) {
        entry->second = link(gl_, vertex, fragment);
    }
    return entry->second;
}

std::string Session::take_error() const {
    std::string sentence;
    // OpenGL keeps one flag per kind of error; reading until none is left empties them all.
    while (const GLenum error = gl_.get_error()) {
        sentence = "OpenGL reports error " + std::to_string(error);
    }
    return sentence;
}

} // namespace hs::peer
