#pragma once

#include "session.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hs::peer {

/// What to say where RenderTarget::complete is false.
inline constexpr const char* unsupported_target =
    "the driver does not support this kind of framebuffer";

/// What a framebuffer object consists of. Formats are OpenGL's sized internal formats, 0 for none.
struct TargetShape {
    int width = 0;
    int height = 0;
    /// 0 for a plain target, or samples per pixel.
    int samples = 0;
    std::array<GLenum, 2> colors = {0, 0};
    GLenum depth = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads a defaulted comparison
    auto operator<=>(const TargetShape&) const = default;
};

/// A framebuffer object with textures as attachments. The peer draws the mirrored scene, so row 0
/// of OpenGL's y-up window is the top row of our y-down picture, and everything read here comes top
/// row first.
class RenderTarget {
public:
    /// The session must be current here and in every other function of this class.
    RenderTarget(std::shared_ptr<Session> session, const TargetShape& shape);
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;
    RenderTarget(RenderTarget&&) = delete;
    RenderTarget& operator=(RenderTarget&&) = delete;
    ~RenderTarget();

    /// False if the driver does not support this combination of formats, size and samples.
    [[nodiscard]] bool complete() const { return complete_; }

    /// Makes this the target of drawing and clearing.
    void bind() const;

    /// Number of texels that the functions below read: width × height × max(1, samples).
    [[nodiscard]] std::size_t texel_count() const;

    /// Writes color attachment 0 or 1 to `texels`, in its own format; the samples of a pixel side
    /// by side.
    void read_color(std::size_t attachment, void* texels) const;

    /// The stored depths in the same order: the unorm integer, or the bits of the float.
    [[nodiscard]] std::vector<std::uint32_t> read_depth() const;

    /// Color attachment 0, which must be RGBA8, with the samples of each pixel averaged by OpenGL.
    [[nodiscard]] std::vector<std::uint8_t> read_resolved() const;

private:
    [[nodiscard]] GLuint attach(GLenum attachment, GLenum format) const;
    void read(GLenum attachment, GLenum format, void* texels) const;
    void read_samples(GLuint texture, GLenum format, void* texels) const;

    std::shared_ptr<Session> session_;
    TargetShape shape_;
    GLuint framebuffer_ = 0;
    std::array<GLuint, 2> color_textures_ = {0, 0};
    GLuint depth_texture_ = 0;
    bool complete_ = false;
};

} // namespace hs::peer
