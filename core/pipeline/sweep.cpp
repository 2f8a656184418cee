#include "core/pipeline/sweep.hpp"

#include "core/pipeline/run_sweep.hpp"
#include "core/pipeline/world_polygons.hpp"

#include <glm/matrix.hpp>

#include <algorithm>

namespace hs::pipeline {
namespace {

/// Collects what would be rasterized. Has no pixels.
class PieceList {
public:
    explicit PieceList(Sweep& sweep) : sweep_(sweep) {}

    void begin(const DrawCall& call, std::uint32_t triangle) {
        const scene::TriangleIndices& t = call.triangles()[triangle];
        const unsigned crossed =
            call.vertices[t.a].outcode | call.vertices[t.b].outcode | call.vertices[t.c].outcode;
        name_ = {
            .object = call.object,
            .triangle = triangle,
            .piece = 0,
            .clipped = call.settings.clip_enabled && crossed != 0};
        reversed_ = call.settings.depth_convention == scene::DepthConvention::reversed;
    }
    void take(const Piece& piece, const PieceSetup& setup) {
        constexpr double to_center =
            0.5; // snapped coordinates count from the center of pixel (0, 0)
        visibility::WindowPolygon polygon;
        polygon.triangle = static_cast<std::uint32_t>(polygons_.size());
        for (const geometry::WindowVertex& vertex : piece.window) {
            const auto depth = static_cast<double>(vertex.window.depth);
            polygon.corners.push_back(
                {.position =
                     {static_cast<double>(vertex.fixed.x) / subpixel_scale + to_center,
                      static_cast<double>(vertex.fixed.y) / subpixel_scale + to_center,
                      reversed_ ? 1.0 - depth : depth},
                 .weights = {}}
            );
        }
        polygons_.push_back(std::move(polygon));
        name_.piece = piece.number;
        sweep_.polygons.push_back(name_);
        sweep_.setups.push_back(setup);
    }
    [[nodiscard]] std::vector<visibility::WindowPolygon> take_polygons() {
        return std::move(polygons_);
    }

    [[nodiscard]] static float depth(PixelPos) { return 0.0F; }
    [[nodiscard]] static glm::vec4 color(PixelPos) { return glm::vec4{0.0F}; }
    [[nodiscard]] static bool closed(PixelPos) { return false; }
    void close(PixelPos) {}
    void set_depth(PixelPos, float) {}
    void set_color(PixelPos, const glm::vec4&) {}

private:
    Sweep& sweep_;
    std::vector<visibility::WindowPolygon> polygons_;
    PieceName name_;
    bool reversed_ = false;
};
static_assert(PieceTarget<PieceList>);
static_assert(framebuffer::PixelTarget<PieceList>);

void gather_pieces(const Frame& frame, Sweep& sweep) {
    NullTrace nothing;
    PieceList pieces(sweep);
    for (const DrawCall& call : frame.calls()) {
        const auto count = static_cast<std::uint32_t>(call.triangles().size());
        for (std::uint32_t i = 0; i < count; ++i) {
            pieces.begin(call, i);
            draw_triangle(call, i, {}, pieces, nothing);
        }
    }
    const int height = frame.settings().height;
    sweep.scan = visibility::scan_scene(pieces.take_polygons(), 0, height);
}

void gather_triangles(const Frame& frame, Sweep& sweep) {
    const std::vector<visibility::WorldPolygon> polygons = world_polygons(frame);
    std::size_t number = 0;
    for (const DrawCall& call : frame.calls()) {
        const auto count = static_cast<std::uint32_t>(call.triangles().size());
        for (std::uint32_t i = 0; i < count; ++i, ++number) {
            if (seen_side(call, i).verdict != geometry::TriangleVerdict::drawn) {
                continue;
            }
            const auto& corners = polygons[number].corners;
            sweep.triangles.push_back(
                {corners[0].position, corners[1].position, corners[2].position}
            );
            sweep.polygons.push_back({.object = call.object, .triangle = i});
        }
    }
    if (!frame.calls().empty()) {
        const Transforms& t = frame.calls().front().vertex.transforms;
        sweep.clip_to_world =
            glm::inverse(glm::dmat4{t.projection.matrix} * glm::dmat4{t.view.matrix});
    }
}

/// Adds up, and hears nothing else.
struct SweepCount {
    double decisions = 0.0;
    template <typename State>
    void sweep_step(const visibility::SweepEvent&, const State&) {
        ++decisions;
    }
};

double count_row(const Frame& frame, const Sweep& sweep, int row) {
    SweepCount count;
    const int width = frame.settings().width;
    if (frame.settings().visibility == scene::Visibility::scanline) {
        visibility::scan_row(sweep.scan, row, width, count, [](const visibility::ScanSpan&) {});
    } else {
        visibility::scan_row_with_line_buffer(
            sweep.scan, row, width, count, [](const visibility::LineBuffer&) {}
        );
    }
    return count.decisions;
}

} // namespace

std::size_t Sweep::bytes() const {
    std::size_t total = polygons.capacity() * sizeof(PieceName) +
                        setups.capacity() * sizeof(PieceSetup) +
                        triangles.capacity() * sizeof(visibility::RayTriangle);
    if (scan) {
        constexpr std::size_t corners = 3;
        total += scan->polygons.size() *
                 (sizeof(visibility::WindowPolygon) + sizeof(visibility::WindowPlane) +
                  corners * sizeof(visibility::Corner<visibility::WindowSpace>));
        total += scan->table.edges.capacity() * sizeof(visibility::ScanEdge);
        for (const std::vector<std::int32_t>& row : scan->table.crossing) {
            total += row.capacity() * sizeof(std::int32_t);
        }
    }
    return total;
}

std::shared_ptr<const Sweep> make_sweep(const Frame& frame) {
    auto sweep = std::make_shared<Sweep>();
    if (frame.settings().visibility == scene::Visibility::ray_cast) {
        gather_triangles(frame, *sweep);
    } else {
        gather_pieces(frame, *sweep);
    }
    return sweep;
}

visibility::Ray pixel_ray(const Frame& frame, const Sweep& sweep, PixelPos pixel) {
    using scene::DepthConvention;
    const PixelRect viewport = frame.settings().viewport();
    const DepthConvention convention = frame.settings().depth_convention;
    const visibility::NdcDepths depths{
        .near = convention == DepthConvention::opengl     ? -1.0
                : convention == DepthConvention::direct3d ? 0.0
                                                          : 1.0,
        .far = convention == DepthConvention::reversed ? 0.0 : 1.0};
    return visibility::ray_through(
        {pixel.x - viewport.x0 + 0.5, pixel.y - viewport.y0 + 0.5},
        {viewport.width(), viewport.height()},
        sweep.clip_to_world,
        depths
    );
}

raster::Fragment hit_fragment(
    const DrawCall& call, std::uint32_t triangle, PixelPos pixel, const glm::dvec3& weights
) {
    const geometry::ClipPolygon corners = assemble(call, call.triangles()[triangle]);
    raster::Fragment fragment;
    fragment.pixel = pixel;

    // Depth: z / w of the point, mapped like a vertex's
    double z = 0.0;
    double w = 0.0;
    for (int i = 0; i < 3; ++i) {
        z += weights[i] * static_cast<double>(corners[i].position.z);
        w += weights[i] * static_cast<double>(corners[i].position.w);
    }
    fragment.depth =
        std::fma(static_cast<float>(z / w), call.viewport.depth_scale, call.viewport.depth_offset);

    // Weights in space are the ray's; in the window each counts w_i / w times as much
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<unsigned>(i);
        fragment.barycentric_clip[k] = static_cast<float>(weights[i]);
        fragment.barycentric[k] =
            static_cast<float>(weights[i] * static_cast<double>(corners[i].position.w) / w);
    }
    if (call.settings.interpolation != scene::InterpolationKind::perspective) {
        fragment.barycentric_clip = fragment.barycentric;
    }
    for (int i = 0; i < call.vertex.layout.count; ++i) {
        fragment.varyings[i] = math::interpolate(
            corners[0].varyings[i],
            corners[1].varyings[i],
            corners[2].varyings[i],
            fragment.barycentric_clip[1],
            fragment.barycentric_clip[2]
        );
    }
    return fragment;
}

SeenSide seen_side(const DrawCall& call, std::uint32_t triangle) {
    const scene::TriangleIndices& indices = call.triangles()[triangle];
    HomogeneousTriangle corners;
    for (int i = 0; i < 3; ++i) {
        const ShadedVertex& vertex = call.vertices[indices[i]];
        corners.clip[static_cast<unsigned>(i)] = vertex.clip;
        corners.window[static_cast<unsigned>(i)] = vertex.window;
    }
    const double determinant = raster::determinant(homogeneous_vertices(call, corners));
    return {determinant, face_by_determinant(call, determinant)};
}

double estimate_sweep(const Frame& frame) {
    constexpr int rows_asked = 32;
    const PixelRect region = swept_region(frame);
    if (frame.settings().visibility == scene::Visibility::ray_cast) {
        std::size_t triangles = 0;
        for (const DrawCall& call : frame.calls()) {
            triangles += call.triangles().size();
        }
        return visibility::estimate_ray_cast(region.width(), region.height(), triangles);
    }
    const std::shared_ptr<const Sweep> sweep = make_sweep(frame);
    const int stride = region.height() / rows_asked + 1;
    double decisions = 0.0;
    int asked = 0;
    for (int row = region.y0 + stride / 2; row < region.y1; row += stride) {
        decisions += count_row(frame, *sweep, row);
        ++asked;
    }
    return asked == 0 ? 0.0 : decisions * region.height() / asked;
}

} // namespace hs::pipeline
