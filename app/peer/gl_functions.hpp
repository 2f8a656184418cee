// The OpenGL entry points the peer uses, found at run time in libOSMesa. Nothing here is linked: a
// machine without the library still runs everything else. Building needs the header
// <GL/glcorearb.h> only (Debian: libgl-dev), not OSMesa's own.
#pragma once

#include <GL/glcorearb.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace hs::peer {

/// The functions of libOSMesa itself; the others come from get_proc_address. The declarations
/// repeat <GL/osmesa.h>, which cannot stand beside the core-profile header.
struct OsMesa {
    using Context = void*;
    using Procedure = void (*)();

    Context (*create_context)(const int* attributes, Context shared) = nullptr;
    void (*destroy_context)(Context) = nullptr;
    unsigned char (*make_current
    )(Context, void* buffer, GLenum type, int width, int height) = nullptr;
    Context (*current_context)() = nullptr;
    Procedure (*get_proc_address)(const char* name) = nullptr;

    /// Why the library cannot be used, as a sentence; empty when it can.
    std::string why_not;
};

/// Loads libOSMesa on the first call and keeps it until the program ends (llvmpipe's threads run
/// inside it). Asks for llvmpipe with two threads unless GALLIUM_DRIVER or LP_NUM_THREADS already
/// say otherwise; as it may set these, the first call must not run beside threads that read the
/// environment.
[[nodiscard]] const OsMesa& load_osmesa();

/// OpenGL 3.3 core, as far as the peer needs it. Valid on the thread whose context is current.
class Gl {
public:
    explicit Gl(const OsMesa& library) : get_proc_address_(library.get_proc_address) {}

    /// Names of functions the library does not have; empty in every Mesa since version 12.
    [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }

    void disable_each(std::initializer_list<GLenum> states) const {
        for (const GLenum state : states) {
            disable(state);
        }
    }

private:
    /// An entry point that takes the type of the member it initializes, so that each is written
    /// once.
    struct Entry {
        OsMesa::Procedure procedure;

        template <typename Function>
        operator Function() const { // NOLINT(google-explicit-constructor): see above
            return reinterpret_cast<Function>(procedure);
        }
    };

    Entry find(const char* name);

    decltype(OsMesa::get_proc_address) get_proc_address_;
    std::vector<std::string> missing_;

public:
    PFNGLFINISHPROC finish = find("glFinish");
    PFNGLGETERRORPROC get_error = find("glGetError");
    PFNGLGETINTEGERVPROC get_integers = find("glGetIntegerv");
    PFNGLGETSTRINGPROC get_string = find("glGetString");
    PFNGLPIXELSTOREIPROC pixel_store = find("glPixelStorei");

    PFNGLENABLEPROC enable = find("glEnable");
    PFNGLDISABLEPROC disable = find("glDisable");
    PFNGLENABLEIPROC enable_indexed = find("glEnablei");
    PFNGLBLENDFUNCSEPARATEPROC blend_function = find("glBlendFuncSeparate");
    PFNGLCULLFACEPROC cull_face = find("glCullFace");
    PFNGLFRONTFACEPROC front_face = find("glFrontFace");
    PFNGLDEPTHFUNCPROC depth_function = find("glDepthFunc");
    PFNGLDEPTHMASKPROC depth_mask = find("glDepthMask");
    PFNGLSCISSORPROC scissor = find("glScissor");
    PFNGLVIEWPORTPROC viewport = find("glViewport");
    PFNGLVIEWPORTINDEXEDFPROC viewport_fractional = find("glViewportIndexedf");

    PFNGLGENTEXTURESPROC generate_textures = find("glGenTextures");
    PFNGLDELETETEXTURESPROC delete_textures = find("glDeleteTextures");
    PFNGLACTIVETEXTUREPROC active_texture = find("glActiveTexture");
    PFNGLBINDTEXTUREPROC bind_texture = find("glBindTexture");
    PFNGLTEXIMAGE2DPROC texture_image = find("glTexImage2D");
    PFNGLTEXIMAGE2DMULTISAMPLEPROC texture_image_multisample = find("glTexImage2DMultisample");
    PFNGLTEXPARAMETERIPROC texture_parameter = find("glTexParameteri");

    PFNGLGENFRAMEBUFFERSPROC generate_framebuffers = find("glGenFramebuffers");
    PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = find("glDeleteFramebuffers");
    PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = find("glBindFramebuffer");
    PFNGLFRAMEBUFFERTEXTURE2DPROC framebuffer_texture = find("glFramebufferTexture2D");
    PFNGLCHECKFRAMEBUFFERSTATUSPROC framebuffer_status = find("glCheckFramebufferStatus");
    PFNGLBLITFRAMEBUFFERPROC blit_framebuffer = find("glBlitFramebuffer");
    PFNGLDRAWBUFFERSPROC draw_buffers = find("glDrawBuffers");
    PFNGLREADBUFFERPROC read_buffer = find("glReadBuffer");
    PFNGLREADPIXELSPROC read_pixels = find("glReadPixels");
    PFNGLCLEARBUFFERFVPROC clear_floats = find("glClearBufferfv");
    PFNGLCLEARBUFFERIVPROC clear_integers = find("glClearBufferiv");

    PFNGLGENVERTEXARRAYSPROC generate_vertex_arrays = find("glGenVertexArrays");
    PFNGLDELETEVERTEXARRAYSPROC delete_vertex_arrays = find("glDeleteVertexArrays");
    PFNGLBINDVERTEXARRAYPROC bind_vertex_array = find("glBindVertexArray");
    PFNGLGENBUFFERSPROC generate_buffers = find("glGenBuffers");
    PFNGLDELETEBUFFERSPROC delete_buffers = find("glDeleteBuffers");
    PFNGLBINDBUFFERPROC bind_buffer = find("glBindBuffer");
    PFNGLBUFFERDATAPROC buffer_data = find("glBufferData");
    PFNGLENABLEVERTEXATTRIBARRAYPROC enable_attribute = find("glEnableVertexAttribArray");
    PFNGLVERTEXATTRIBPOINTERPROC attribute_pointer = find("glVertexAttribPointer");
    PFNGLDRAWARRAYSPROC draw_arrays = find("glDrawArrays");
    PFNGLDRAWELEMENTSPROC draw_elements = find("glDrawElements");

    PFNGLCREATESHADERPROC create_shader = find("glCreateShader");
    PFNGLDELETESHADERPROC delete_shader = find("glDeleteShader");
    PFNGLSHADERSOURCEPROC shader_source = find("glShaderSource");
    PFNGLCOMPILESHADERPROC compile_shader = find("glCompileShader");
    PFNGLCREATEPROGRAMPROC create_program = find("glCreateProgram");
    PFNGLATTACHSHADERPROC attach_shader = find("glAttachShader");
    PFNGLLINKPROGRAMPROC link_program = find("glLinkProgram");
    PFNGLGETPROGRAMIVPROC get_program = find("glGetProgramiv");
    PFNGLUSEPROGRAMPROC use_program = find("glUseProgram");
    PFNGLGETUNIFORMLOCATIONPROC uniform_location = find("glGetUniformLocation");
    PFNGLUNIFORM1IPROC uniform_int = find("glUniform1i");
    PFNGLUNIFORM3FPROC uniform_vec3 = find("glUniform3f");
    PFNGLUNIFORMMATRIX4FVPROC uniform_mat4 = find("glUniformMatrix4fv");
};

} // namespace hs::peer
