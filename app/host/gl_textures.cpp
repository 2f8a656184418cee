#include "app/host/gl_textures.hpp"

#include <GL/gl.h>

#include <cstdint>

namespace hs::host {
namespace {

GLuint name_of_texture(ImTextureID texture) {
    return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(texture));
}

// Mesa's gl.h stops at OpenGL 1.3 without extensions; these are 1.2 and 1.0.
constexpr GLint clamp_to_edge = 0x812F;

} // namespace

ImTextureID GlTextures::create(int width, int height) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); // pixels stay squares
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, clamp_to_edge);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, clamp_to_edge);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    // ImGui hands a backend's own texture names around as pointers that nobody follows
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name));
}

void GlTextures::update(
    ImTextureID texture, const PixelRect& rect, std::span<const framebuffer::Rgba8> image
) {
    glBindTexture(GL_TEXTURE_2D, name_of_texture(texture));
    GLint width = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, width);
    const auto first = static_cast<std::size_t>(rect.y0) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(rect.x0);
    glTexSubImage2D(
        GL_TEXTURE_2D,
        0,
        rect.x0,
        rect.y0,
        rect.width(),
        rect.height(),
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        &image[first]
    );
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GlTextures::destroy(ImTextureID texture) {
    const GLuint name = name_of_texture(texture);
    glDeleteTextures(1, &name);
}

} // namespace hs::host
