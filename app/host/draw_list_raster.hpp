// ImGui's draw lists, drawn by our own pipeline: the window's content without a display.
#pragma once

#include "core/framebuffer/framebuffer.hpp"
#include "core/scene/texture.hpp"

#include <imgui.h>

#include <string>
#include <vector>

namespace hs::host {

/// Draws every command into the framebuffer. Texture ids are pointers to `scene::Texture`.
/// Precondition: the framebuffer is rgba8 and as large as the data's display.
void draw(const ImDrawData& data, framebuffer::Framebuffer& framebuffer);

/// Where a glyph is cut by the left or right edge of its clip rectangle: text that does not fit.
struct CutGlyph {
    float x = 0.0F;
    float y = 0.0F;
};
std::vector<CutGlyph> cut_glyphs(const ImDrawData& data, ImTextureID font_texture);

} // namespace hs::host
