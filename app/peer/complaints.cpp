#include "complaints.hpp"

#include <algorithm>

namespace hs::peer {

namespace {

std::string complain_about_texture(const Texture& texture) {
    if (texture.levels.empty()) {
        return "a texture needs a level 0";
    }
    int width = texture.levels.front().width;
    int height = texture.levels.front().height;
    for (const Texture::Level& level : texture.levels) {
        if (level.width < 1 || level.height < 1 || level.width != width || level.height != height) {
            return "each texture level must be half as wide and high as the one before";
        }
        if (level.rgba8.size() !=
            4 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height)) {
            return "a texture level must have four bytes per texel";
        }
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
    return {};
}

} // namespace

std::string complain_about_size(int width, int height, int samples, bool wide_viewport) {
    const int limit = wide_viewport ? 4096 : 16384;
    if (width < 1 || height < 1 || width > limit || height > limit) {
        return "width and height must lie in 1 … " + std::to_string(limit);
    }
    if (samples != 0 && samples != 4) {
        return "samples must be 0 or 4";
    }
    return {};
}

std::string
complain_about_indices(std::size_t vertex_count, std::span<const glm::uvec3> triangles) {
    const bool all_exist = std::ranges::all_of(triangles, [&](const glm::uvec3& triangle) {
        return std::max({triangle.x, triangle.y, triangle.z}) < vertex_count;
    });
    return all_exist ? "" : "a triangle names a vertex that does not exist";
}

std::string complain_about_options(const DrawOptions& options) {
    if (options.scissor && (options.scissor->width < 0 || options.scissor->height < 0)) {
        return "a scissor rectangle cannot have a negative size";
    }
    if (options.scissor && options.samples > 0) {
        return "no scissor together with samples: llvmpipe moves its edges by half a pixel";
    }
    if (options.texture) {
        if (std::string complaint = complain_about_texture(*options.texture); !complaint.empty()) {
            return complaint;
        }
    }
    return complain_about_size(
        options.width, options.height, options.samples, options.wide_viewport
    );
}

} // namespace hs::peer
