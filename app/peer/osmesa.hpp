// OpenGL as Mesa's llvmpipe implements it, as the oracle of our tests.
//
// libOSMesa is opened at run time. Where it is missing, Context::create says so and nothing else
// happens. GALLIUM_DRIVER (llvmpipe) and LP_NUM_THREADS (2) are set before loading unless the
// environment has them; the driver cannot change afterwards. GALLIUM_DRIVER=softpipe serves for
// formulas, never for coverage.
//
// All positions are in OUR convention: y down in the picture, top row first, facing as seen in that
// picture. Mesa is fed the vertically mirrored scene (clip y negated, front face swapped), whose
// bottom-first rows are our top-first rows; then its left-and-bottom rule is our top-left rule,
// ties included.
//
// Mesa's window transform is fused (one rounding per coordinate) where the processor has FMA. On
// one without, expect about one covered pixel in a million to differ from ours, unless the window
// positions are exact in float anyway.
//
// A context belongs to the thread that uses it. Do not draw with a window's OpenGL on that same
// thread: both may share Mesa's dispatch table.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hs::peer {

struct Vertex {
    glm::vec4 clip = {0.0F, 0.0F, 0.0F, 1.0F};
    glm::vec4 color = {1.0F, 1.0F, 1.0F, 1.0F};
    glm::vec2 uv = {0.0F, 0.0F};
};

// The enumerators below follow the order of OpenGL's constants where those are consecutive.

enum class CompareOp {
    never,
    less,
    equal,
    less_equal,
    greater,
    not_equal,
    greater_equal,
    always
};
enum class DepthFormat {
    unorm16,
    unorm24,
    float32
};
enum class ColorFormat {
    rgba8,
    rgba32f
};
enum class Interpolation {
    smooth,
    noperspective,
    flat
};
enum class CullFace {
    none,
    back,
    front
};
enum class Winding {
    ccw,
    cw
};
enum class Wrap {
    repeat,
    mirrored_repeat,
    clamp_to_edge
};
enum class Filter {
    nearest,
    bilinear,
    trilinear
};

enum class BlendFactor {
    zero,
    one,
    src_color,
    one_minus_src_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
    dst_color,
    one_minus_dst_color,
};

/// src × src factor + dst × dst factor, by default "over" with a destination alpha that
/// accumulates.
struct Blend {
    BlendFactor src_rgb = BlendFactor::src_alpha;
    BlendFactor dst_rgb = BlendFactor::one_minus_src_alpha;
    BlendFactor src_alpha = BlendFactor::one;
    BlendFactor dst_alpha = BlendFactor::one_minus_src_alpha;
};

/// In pixels from the top-left corner.
struct Scissor {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// A picture that multiplies the color. Level 0 first, each next one half as wide and high, rounded
/// down, at least 1; trilinear filtering wants them all. The first row given lies at v = 0.
struct Texture {
    struct Level {
        int width = 0;
        int height = 0;
        std::span<const std::uint8_t> rgba8 = {};
    };
    std::vector<Level> levels = {};
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::nearest;
};

struct DrawOptions {
    /// In pixels, 1 … 16384; with wide_viewport 1 … 4096.
    int width = 256;
    int height = 256;
    /// 0, or 4 samples per pixel.
    int samples = 0;

    ColorFormat color_format = ColorFormat::rgba8;
    glm::vec4 clear = {0.0F, 0.0F, 0.0F, 0.0F};
    /// Noperspective only without clipping at the sides (wide_viewport): Mesa's clipper may answer
    /// NaN. Flat is the color of the last vertex.
    Interpolation interpolation = Interpolation::smooth;

    bool depth_test = false;
    /// Without a depth test OpenGL does not write depth either.
    bool depth_write = true;
    CompareOp depth_compare = CompareOp::less;
    DepthFormat depth_format = DepthFormat::unorm24;
    /// In [0, 1].
    float depth_clear = 1.0F;

    CullFace cull = CullFace::none;
    Winding front = Winding::ccw;

    /// Draws the same picture through a viewport four times as wide and high, so that no triangle
    /// within that area is clipped at the sides. Near and far planes still clip.
    bool wide_viewport = false;

    std::optional<Blend> blend = {};
    /// Not together with samples: llvmpipe moves the rectangle's edges by half a pixel then.
    std::optional<Scissor> scissor = {};
    std::optional<Texture> texture = {};
};

/// What was drawn, top row first. With 4 samples, each array holds the four of a pixel side by
/// side, in the order of the positions in our y-down pixel: (.375,.125) (.875,.375) (.125,.625)
/// (.625,.875).
struct Image {
    int width = 0;
    int height = 0;
    /// Values per pixel in every array but `resolved`: 1, or the samples.
    int samples = 1;

    /// One of the two, as color_format asks; four bytes per value in the first.
    std::vector<std::uint8_t> rgba8 = {};
    std::vector<glm::vec4> rgba32f = {};
    /// The samples of a pixel averaged; only for 4 samples of rgba8.
    std::vector<std::uint8_t> resolved = {};

    /// As stored: the integer in 0 … 2^bits − 1, or the bits of the float. With samples, the two
    /// largest integers of unorm24 cannot be told apart and read as the largest.
    std::vector<std::uint32_t> depth_raw = {};
    /// The same as a number in [0, 1].
    std::vector<float> depth = {};
    /// The triangle (its position in the list) that was written last; −1 for background.
    std::vector<int> triangle = {};

    /// Why there is no picture; empty when there is one.
    std::string error = {};
};

/// How many triangles one call of Context::coverage can tell apart.
inline constexpr std::size_t coverage_batch_size = 24;

enum class Primitive {
    points = 1,
    lines = 2,
    triangles = 3
};

struct CoverageOptions {
    Primitive primitive = Primitive::triangles; ///< what the corners make, by so many
    /// As in DrawOptions.
    int width = 256;
    int height = 256;
    int samples = 0;
    bool wide_viewport = true;
};

struct Coverage {
    /// Bit k of a word says that triangle k covers that pixel or sample; ordered as the arrays of
    /// Image. Valid until the next call of Context::coverage.
    std::span<const std::uint32_t> bits = {};
    /// Why there are none; empty when there are.
    std::string error = {};
};

class Context {
public:
    /// Empty when Mesa cannot be used; the reason, a sentence, goes to `why_not` unless that is
    /// null.
    [[nodiscard]] static std::optional<Context> create(std::string* why_not = nullptr);

    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    /// One picture of all triangles in order, in a freshly cleared framebuffer. Vertex positions
    /// are clip coordinates with y up and −w ≤ z ≤ w. Any option out of range or index beyond the
    /// vertices gives an image with an error.
    [[nodiscard]] Image draw(
        std::span<const Vertex> vertices,
        std::span<const glm::uvec3> triangles,
        const DrawOptions& options
    );

    /// Which pixels each of up to 24 triangles (lines, points) covers, all in one pass: `corners`
    /// are three (two, one) clip positions for each. Neither culls nor tests depth. For checking
    /// triangles by the ten thousand.
    [[nodiscard]] Coverage
    coverage(std::span<const glm::vec4> corners, const CoverageOptions& options);

    /// What OpenGL calls the renderer, for example "llvmpipe (LLVM 15.0.6, 256 bits)".
    [[nodiscard]] std::string renderer() const;

private:
    friend class TimedMesh;
    struct State;

    explicit Context(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

} // namespace hs::peer
