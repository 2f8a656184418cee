// Pictures the viewer shows: whoever hosts it keeps them where it draws from.
#pragma once

#include "core/base/pixel.hpp"
#include "core/framebuffer/color.hpp"

#include <imgui.h>

#include <span>

namespace hs::viewer {

class Textures {
public:
    Textures() = default;
    Textures(const Textures&) = delete;
    Textures& operator=(const Textures&) = delete;
    Textures(Textures&&) = delete;
    Textures& operator=(Textures&&) = delete;
    virtual ~Textures() = default;

    /// A texture of undefined content, magnified without smoothing.
    virtual ImTextureID create(int width, int height) = 0;
    /// Replaces the pixels of `rect` by those of `image`, which has the texture's size.
    virtual void update(
        ImTextureID texture, const PixelRect& rect, std::span<const framebuffer::Rgba8> image
    ) = 0;
    virtual void destroy(ImTextureID texture) = 0;
};

} // namespace hs::viewer
