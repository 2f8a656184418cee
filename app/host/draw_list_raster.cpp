#include "app/host/draw_list_raster.hpp"

#include "core/pipeline/draw.hpp"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hs::host {
namespace {

constexpr std::uint32_t alpha_bits = 0xFF000000U;

/// The framebuffer with its origin moved to a clip rectangle's corner, so that the pipeline's image
/// *is* that rectangle and nothing outside it is visited.
class ClippedTarget {
public:
    ClippedTarget(framebuffer::Framebuffer& whole, PixelPos origin)
        : whole_(&whole), origin_(origin) {}

    [[nodiscard]] float depth(PixelPos p) const { return whole_->depth(moved(p)); }
    [[nodiscard]] glm::vec4 color(PixelPos p) const { return whole_->color(moved(p)); }
    [[nodiscard]] bool closed(PixelPos) const { return false; }
    void close(PixelPos) {}
    void set_depth(PixelPos p, float depth) { whole_->set_depth(moved(p), depth); }
    void set_color(PixelPos p, const glm::vec4& color) { whole_->set_color(moved(p), color); }

private:
    [[nodiscard]] PixelPos moved(PixelPos p) const { return {p.x + origin_.x, p.y + origin_.y}; }

    framebuffer::Framebuffer* whole_;
    PixelPos origin_;
};

/// One ImDrawCmd with the lists it indexes.
struct Command {
    const ImDrawList* list = nullptr;
    const ImDrawCmd* cmd = nullptr;
    ImVec2 display_pos;
    PixelRect clip; ///< in framebuffer pixels

    [[nodiscard]] unsigned index(unsigned i) const {
        return cmd->VtxOffset + list->IdxBuffer[static_cast<int>(cmd->IdxOffset + i)];
    }
    [[nodiscard]] const ImDrawVert& vertex(unsigned i) const {
        return list->VtxBuffer[static_cast<int>(i)];
    }
};

PixelRect clip_pixels(const ImDrawCmd& cmd, ImVec2 origin, const PixelRect& image) {
    return intersect(
        {static_cast<int>(std::floor(cmd.ClipRect.x - origin.x + 0.5F)),
         static_cast<int>(std::floor(cmd.ClipRect.y - origin.y + 0.5F)),
         static_cast<int>(std::floor(cmd.ClipRect.z - origin.x + 0.5F)),
         static_cast<int>(std::floor(cmd.ClipRect.w - origin.y + 0.5F))},
        image
    );
}

/// State of a draw: blend over, no depth, nearest texture times vertex color, linear interpolation
/// because w = 1 everywhere.
pipeline::DrawCall
make_call(const Command& command, int width, int height, const scene::Mesh& mesh) {
    pipeline::DrawCall call;
    call.settings.width = command.clip.width();
    call.settings.height = command.clip.height();
    call.settings.visibility = scene::Visibility::none;
    call.settings.interpolation = scene::InterpolationKind::linear;
    call.settings.blend_enabled = true;
    call.vertex.mesh = &mesh;
    call.vertex.layout = {.uv = 4, .count = 6};
    call.vertex.shading.layout = call.vertex.layout;
    call.vertex.shading.texture = static_cast<const scene::Texture*>(command.cmd->GetTexID());
    call.volume = geometry::clip_volume(call.settings, glm::mat4{1.0F});
    const int left = -command.clip.x0;
    const int top = -command.clip.y0;
    call.viewport = geometry::make_viewport(
        {left, top, left + width, top + height}, call.settings.depth_convention
    );
    return call;
}

/// Display coordinates to clip space: the identity camera's.
math::ClipPosition clip_position(const Command& command, ImVec2 p, int width, int height) {
    return {
        2.0F * (p.x - command.display_pos.x) / static_cast<float>(width) - 1.0F,
        1.0F - 2.0F * (p.y - command.display_pos.y) / static_cast<float>(height),
        0.0F,
        1.0F};
}

geometry::ClipVertex clip_vertex(const ImDrawVert& v, math::ClipPosition position) {
    geometry::ClipVertex vertex{position, {}};
    vertex.varyings.set(0, framebuffer::unpack(v.col));
    vertex.varyings.set(4, glm::vec2{v.uv.x, v.uv.y});
    return vertex;
}

/// The triangles that change a pixel, with indices from `first` on. Fully transparent ones, which
/// soften the edges of text and lines, blend to what was there.
std::vector<scene::TriangleIndices> visible_triangles(const Command& command, unsigned first) {
    std::vector<scene::TriangleIndices> triangles;
    triangles.reserve(command.cmd->ElemCount / 3);
    for (unsigned i = 0; i + 2 < command.cmd->ElemCount; i += 3) {
        const unsigned a = command.index(i);
        const unsigned b = command.index(i + 1);
        const unsigned c = command.index(i + 2);
        const ImU32 colors = command.vertex(a).col | command.vertex(b).col | command.vertex(c).col;
        if ((colors & alpha_bits) != 0) {
            triangles.push_back({a - first, b - first, c - first});
        }
    }
    return triangles;
}

/// Whether a triangle reads one texel only, and that texel is white: ImGui's plain shapes.
bool is_plain(const std::array<const ImDrawVert*, 3>& corners, const scene::Texture& texture) {
    const ImVec2 uv = corners[0]->uv;
    for (const ImDrawVert* corner : corners) {
        if (corner->uv.x != uv.x || corner->uv.y != uv.y) {
            return false;
        }
    }
    return shading::sample_nearest(texture, {uv.x, uv.y}) == glm::vec4{1.0F};
}

void draw_command(const Command& command, framebuffer::Framebuffer& framebuffer) {
    if (command.clip.empty() || command.cmd->ElemCount == 0) {
        return;
    }
    unsigned first = command.index(0);
    unsigned last = first;
    for (unsigned i = 1; i < command.cmd->ElemCount; ++i) {
        first = std::min(first, command.index(i));
        last = std::max(last, command.index(i));
    }
    scene::Mesh mesh;
    mesh.triangles = visible_triangles(command, first);

    // Vertex stage: display coordinates are clip coordinates after one scale and offset
    const int width = framebuffer.width();
    const int height = framebuffer.height();
    pipeline::DrawCall call = make_call(command, width, height, mesh);
    call.resize_vertices(last - first + 1);
    for (unsigned i = first; i <= last; ++i) {
        const ImDrawVert& vertex = command.vertex(i);
        call.place_vertex(
            i - first, clip_vertex(vertex, clip_position(command, vertex.pos, width, height))
        );
    }

    // Everything after it
    ClippedTarget target{framebuffer, {command.clip.x0, command.clip.y0}};
    pipeline::NullTrace trace;
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    const scene::Texture* const texture = call.vertex.shading.texture;
    for (std::uint32_t i = 0; i < count; ++i) {
        // Spare plain shapes the texture and opaque ones the blending: the same bits come out
        const scene::TriangleIndices& t = mesh.triangles[i];
        const std::array corners{
            &command.vertex(first + t.a),
            &command.vertex(first + t.b),
            &command.vertex(first + t.c)};
        const bool plain = is_plain(corners, *texture);
        const ImU32 colors = corners[0]->col & corners[1]->col & corners[2]->col;
        call.vertex.shading.texture = plain ? nullptr : texture;
        call.settings.blend_enabled = !plain || (colors & alpha_bits) != alpha_bits;
        pipeline::draw_triangle(call, i, {}, target, trace);
    }
}

/// Calls `visit` for every command of the data.
template <typename Visit>
void for_each_command(const ImDrawData& data, const PixelRect& image, Visit&& visit) {
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList* list = data.CmdLists[i];
        for (const ImDrawCmd& cmd : list->CmdBuffer) {
            visit(Command{list, &cmd, data.DisplayPos, clip_pixels(cmd, data.DisplayPos, image)});
        }
    }
}

/// ImGui writes a glyph as one quad of six indices over four vertices, corners 0 and 2 opposite.
bool is_cut_quad(const Command& command, unsigned i) {
    constexpr float tolerance = 1.0F;
    const ImDrawVert& min = command.vertex(command.index(i));
    const ImDrawVert& max = command.vertex(command.index(i + 2));
    const ImVec4& clip = command.cmd->ClipRect;
    const float middle = 0.5F * (min.pos.y + max.pos.y);
    if (middle < clip.y || middle > clip.w || (min.col & alpha_bits) == 0) {
        return false; // scrolled away
    }
    const bool crosses_left = min.pos.x < clip.x - tolerance && max.pos.x > clip.x;
    const bool crosses_right = max.pos.x > clip.z + tolerance && min.pos.x < clip.z;
    return crosses_left || crosses_right;
}

} // namespace

void draw(const ImDrawData& data, framebuffer::Framebuffer& framebuffer) {
    const PixelRect image{0, 0, framebuffer.width(), framebuffer.height()};
    for_each_command(data, image, [&](const Command& command) {
        draw_command(command, framebuffer);
    });
}

std::vector<CutGlyph> cut_glyphs(const ImDrawData& data, ImTextureID font_texture) {
    const PixelRect image{
        0, 0, static_cast<int>(data.DisplaySize.x), static_cast<int>(data.DisplaySize.y)};
    std::vector<CutGlyph> cuts;
    for_each_command(data, image, [&](const Command& command) {
        if (command.cmd->GetTexID() != font_texture) {
            return;
        }
        for (unsigned i = 0; i + 5 < command.cmd->ElemCount;) {
            const ImDrawVert& a = command.vertex(command.index(i));
            const ImDrawVert& c = command.vertex(command.index(i + 2));
            const bool textured = a.uv.x < c.uv.x && a.uv.y < c.uv.y; // plain shapes use one texel
            const bool quad = textured && command.index(i) == command.index(i + 3) &&
                              command.index(i + 2) == command.index(i + 4);
            if (quad && is_cut_quad(command, i)) {
                cuts.push_back({a.pos.x, a.pos.y});
            }
            i += quad ? 6 : 3;
        }
    });
    return cuts;
}

} // namespace hs::host
