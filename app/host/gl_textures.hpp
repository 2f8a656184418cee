// The viewer's pictures as OpenGL textures.
#pragma once

#include "app/viewer/textures.hpp"

namespace hs::host {

/// Needs a current OpenGL context.
class GlTextures : public viewer::Textures {
public:
    ImTextureID create(int width, int height) override;
    void update(
        ImTextureID texture, const PixelRect& rect, std::span<const framebuffer::Rgba8> image
    ) override;
    void destroy(ImTextureID texture) override;
};

} // namespace hs::host
