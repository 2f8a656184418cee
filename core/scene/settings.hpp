// Everything that can be chosen about a frame. One row per key in the table of settings.cpp serves
// scene files, `--set`, lessons, the viewer's panel and the glossary alike.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/base/named.hpp"
#include "core/base/pixel.hpp"

#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hs::scene {

enum class Visibility : std::uint8_t {
    none,
    z_buffer,
    painters,
    front_lists,
    newell_sancha,
    bsp,
    octree,
    scanline,
    scanline_z,
    ray_cast
};
/// The one depth that stands for a polygon in the painter's algorithm.
enum class PaintersKey : std::uint8_t {
    farthest,
    nearest,
    centroid
};
/// Which polygon of a list divides it in a BSP tree.
enum class BspSplitter : std::uint8_t {
    first,
    random,
    fewest_splits
};
/// In which direction a BSP tree is walked.
enum class BspOrder : std::uint8_t {
    back_to_front,
    front_to_back
};
enum class TraversalKind : std::uint8_t {
    brute_force,
    bounding_box,
    incremental,
    serpentine,
    hierarchical,
    edge_walk,
    edge_table,
    homogeneous
};
enum class CullFace : std::uint8_t {
    none,
    back,
    front
};
enum class Winding : std::uint8_t {
    ccw,
    cw
};
enum class Shading : std::uint8_t {
    unlit,
    flat,
    gouraud,
    phong
};
enum class InterpolationKind : std::uint8_t {
    perspective,
    linear,
    flat
};
enum class CompareOp : std::uint8_t {
    never,
    less,
    lequal,
    equal,
    gequal,
    greater,
    notequal,
    always,
};
enum class DepthFormat : std::uint8_t {
    float32,
    unorm24,
    unorm16
};
enum class DepthConvention : std::uint8_t {
    opengl,
    direct3d,
    reversed
};
enum class DepthOrder : std::uint8_t {
    late,
    early
};
enum class LineAlgorithm : std::uint8_t {
    bresenham,
    dda
};
enum class ColorFormat : std::uint8_t {
    rgba8,
    rgba32f
};
enum class Sampling : std::uint8_t {
    multisample,
    supersample,
    conservative
};

/// A classic mistake, seeded on purpose.
enum class Fault : std::uint8_t {
    none,
    ties_to_all,
    ties_to_none,
    ties_to_bottom_right,
    half_up_rounding,
    floor_snapping,
    increment_before_test,
    affine_interpolation,
    no_divide,
    viewport_without_parentheses,
    near_plane_forgotten,
    reversed_winding,
    inverted_depth_test,
    normals_like_points,
    camera_not_inverted,
};

/// One frame's settings, or one object's after its overrides. Defaults are those of docs and scene
/// files.
struct Settings {
    int width = 64;  ///< pixels, 1 … 8192
    int height = 64; ///< pixels, 1 … 8192
    glm::vec4 background{0.0F, 0.0F, 0.0F, 1.0F};
    Visibility visibility = Visibility::z_buffer;
    PaintersKey painters_key = PaintersKey::farthest;
    BspSplitter bsp_splitter = BspSplitter::first;
    std::uint64_t bsp_seed = 0; ///< of the random splitter
    BspOrder bsp_order = BspOrder::back_to_front;
    double order_limit = 5.0e6; ///< decisions; an ordering that would take more is refused
    TraversalKind traversal = TraversalKind::bounding_box;
    LineAlgorithm line_algorithm = LineAlgorithm::bresenham;
    int tile_size = 8; ///< of the hierarchical traversal: a power of two, 2 … 64
    int samples = 1;   ///< points a pixel is asked at: 1, 2, 4 or 8
    Sampling sampling = Sampling::multisample;
    bool clip_enabled = true;
    float guard_band = 1.0F; ///< triangles are clipped at the sides of so many view volumes, 1 … 64
    std::vector<glm::vec4>
        clip_planes; ///< user planes in eye space, inside where ax + by + cz + d >= 0; at most 2
    CullFace cull = CullFace::none;
    Winding front_face = Winding::ccw; ///< as seen on screen with y up
    Shading shading = Shading::unlit;
    InterpolationKind interpolation = InterpolationKind::perspective;
    std::optional<CompareOp> depth_test_choice; ///< empty: the convention's default
    bool depth_write = true;
    DepthFormat depth_format = DepthFormat::float32;
    std::optional<float> depth_clear_choice; ///< empty: the far value of the convention
    DepthConvention depth_convention = DepthConvention::opengl;
    DepthOrder depth_order = DepthOrder::late;
    ColorFormat color_format = ColorFormat::rgba8;
    std::optional<PixelRect> viewport_choice; ///< empty: the whole image
    std::optional<PixelRect> scissor;         ///< empty: no scissor test
    bool blend_enabled =
        false; ///< source alpha over destination: src·a + dst·(1 − a); alpha: a + dst_a·(1 − a)
    Fault fault = Fault::none;

    /// Triangles are drawn in an order that a stage of its own finds, not in file order.
    [[nodiscard]] bool orders_triangles() const {
        return visibility >= Visibility::painters && visibility <= Visibility::octree;
    }
    /// That stage may cut triangles in parts.
    [[nodiscard]] bool splits_triangles() const {
        return visibility >= Visibility::newell_sancha && visibility <= Visibility::octree;
    }
    /// What is nearest is decided for all triangles at once, row by row of the image; no triangle
    /// is traversed.
    [[nodiscard]] bool sweeps() const { return visibility >= Visibility::scanline; }
    /// Triangles reach the planes through the eye as they are.
    [[nodiscard]] bool draws_unclipped() const {
        return traversal == TraversalKind::homogeneous && !sweeps();
    }
    /// Triangles come front to back, so that a written pixel is closed to all that follow.
    [[nodiscard]] bool closes_pixels() const {
        return visibility == Visibility::octree ||
               (visibility == Visibility::bsp && bsp_order == BspOrder::front_to_back);
    }
    [[nodiscard]] CompareOp depth_test() const {
        const bool reversed = depth_convention == DepthConvention::reversed;
        return depth_test_choice.value_or(reversed ? CompareOp::greater : CompareOp::less);
    }
    [[nodiscard]] float depth_clear() const {
        return depth_clear_choice.value_or(
            depth_convention == DepthConvention::reversed ? 0.0F : 1.0F
        );
    }
    [[nodiscard]] PixelRect image() const { return {0, 0, width, height}; }
    [[nodiscard]] PixelRect viewport() const { return viewport_choice.value_or(image()); }
    friend bool operator==(const Settings&, const Settings&) = default;
};

/// A value as scene files and the command line write it, free of any parser's types.
struct SettingValue {
    using List = std::vector<SettingValue>;
    std::variant<bool, std::int64_t, double, std::string, List> value;
    friend bool operator==(const SettingValue&, const SettingValue&) = default;
};

/// How a panel edits a setting.
enum class SettingType : std::uint8_t {
    boolean,
    number,
    choice,
    color,
    list
};

/// One row of the table of settings.
struct SettingInfo {
    std::string_view key; ///< "depth.test"
    SettingType type;
    std::string_view explanation;          ///< one sentence
    std::string_view opengl;               ///< the OpenGL call behind it, "" where there is none
    bool per_object;                       ///< may stand in an object's `settings`
    std::vector<std::string_view> choices; ///< for SettingType::choice
};

/// All settings, in the order of the scene format's documentation.
std::span<const SettingInfo> setting_infos();
const SettingInfo* find_setting(std::string_view key);

/// Assigns one setting. Errors (unknown key, wrong type, out of range, NaN) come back as a sentence
/// without location.
std::optional<std::string>
assign(Settings& settings, std::string_view key, const SettingValue& value);

/// The current value, defaults resolved, as TOML text: `less`-like choices come quoted.
std::string print_setting(const Settings& settings, std::string_view key);
/// The same as a typed value; empty for optional settings that are not set (viewport, scissor when
/// absent).
std::optional<SettingValue> read_setting(const Settings& settings, std::string_view key);

/// A combination that has no meaning (reversed depth with a user-set test is allowed; a viewport
/// outside the image is not), in one sentence that begins with the key to blame, or nothing.
std::optional<std::string> check_combination(const Settings& settings);

/// Applies the compare op to a fragment's depth and the stored one: `compare(less, z, stored)` is z
/// < stored.
[[nodiscard]] inline bool compare(CompareOp op, float fragment, float stored) {
    switch (op) {
    case CompareOp::never: return false;
    case CompareOp::less: return fragment < stored;
    case CompareOp::lequal: return fragment <= stored;
    case CompareOp::equal: return fragment == stored;
    case CompareOp::gequal: return fragment >= stored;
    case CompareOp::greater: return fragment > stored;
    case CompareOp::notequal: return fragment != stored;
    case CompareOp::always: return true;
    }
    HS_CHECK(false, "every compare op is handled");
    return false;
}

} // namespace hs::scene

namespace hs {
template <>
std::span<const Named<scene::Visibility>> names<scene::Visibility>();
template <>
std::span<const Named<scene::PaintersKey>> names<scene::PaintersKey>();
template <>
std::span<const Named<scene::BspSplitter>> names<scene::BspSplitter>();
template <>
std::span<const Named<scene::BspOrder>> names<scene::BspOrder>();
template <>
std::span<const Named<scene::TraversalKind>> names<scene::TraversalKind>();
template <>
std::span<const Named<scene::CullFace>> names<scene::CullFace>();
template <>
std::span<const Named<scene::Winding>> names<scene::Winding>();
template <>
std::span<const Named<scene::Shading>> names<scene::Shading>();
template <>
std::span<const Named<scene::InterpolationKind>> names<scene::InterpolationKind>();
template <>
std::span<const Named<scene::CompareOp>> names<scene::CompareOp>();
template <>
std::span<const Named<scene::DepthFormat>> names<scene::DepthFormat>();
template <>
std::span<const Named<scene::DepthConvention>> names<scene::DepthConvention>();
template <>
std::span<const Named<scene::DepthOrder>> names<scene::DepthOrder>();
template <>
std::span<const Named<scene::LineAlgorithm>> names<scene::LineAlgorithm>();
template <>
std::span<const Named<scene::ColorFormat>> names<scene::ColorFormat>();
template <>
std::span<const Named<scene::Sampling>> names<scene::Sampling>();
template <>
std::span<const Named<scene::Fault>> names<scene::Fault>();
} // namespace hs
