#include "core/trace/comparison.hpp"

#include "core/pipeline/draw_frame.hpp"

namespace hs::trace {
namespace {

/// Adds up, and hears nothing else.
class CostTrace : public pipeline::NullTrace {
public:
    static constexpr bool ignores_traversal = false; // the traversal is what it asks about

    explicit CostTrace(TraversalCost& total) : total_(total) {}

    void cost(const raster::Cost& cost) { total_.cost += cost; }
    void edge_tests(int pixels) {
        const auto count = static_cast<std::uint64_t>(pixels);
        cost({.pixels = count, .evaluations = count * raster::cost_of_asking.evaluations});
    }
    void interpolated(const raster::Fragment&) { ++total_.fragments; }

private:
    TraversalCost& total_;
};
static_assert(pipeline::TraceSink<CostTrace>);

/// Pixels that nobody reads: what a traversal spends does not depend on them.
struct NoPixels {
    [[nodiscard]] float depth(PixelPos) const { return 1.0F; }
    [[nodiscard]] glm::vec4 color(PixelPos) const { return glm::vec4{0.0F}; }
    [[nodiscard]] bool closed(PixelPos) const { return false; }
    void close(PixelPos) {}
    void set_depth(PixelPos, float) {}
    void set_color(PixelPos, const glm::vec4&) {}
};
static_assert(framebuffer::PixelTarget<NoPixels>);

/// The mesh of one triangle alone, its vertices numbered 0, 1, 2.
scene::Mesh alone(const scene::Mesh& mesh, const scene::TriangleIndices& triangle) {
    scene::Mesh one;
    const auto copy = [&triangle](const auto& from, auto& to) {
        for (int corner = 0; corner < 3 && !from.empty(); ++corner) {
            to.push_back(from[triangle[corner]]);
        }
    };
    copy(mesh.positions, one.positions);
    copy(mesh.normals, one.normals);
    copy(mesh.colors, one.colors);
    copy(mesh.uvs, one.uvs);
    one.triangles = {{0, 1, 2}};
    return one;
}

/// What all traversals can ask, triangle by triangle.
void ask_centers(scene::Settings& settings) {
    if (settings.sweeps()) {
        settings.visibility = scene::Visibility::none;
    }
    settings.samples = 1;
    settings.sampling = scene::Sampling::multisample;
}

TraversalCost
cost_of(const scene::Scene& scene, scene::TraversalKind kind, std::optional<TriangleNumber> only) {
    auto variant = std::make_shared<scene::Scene>(scene);
    variant->settings.traversal = kind;
    ask_centers(variant->settings);
    pipeline::Frame frame(variant);
    NoPixels target;
    TraversalCost total;
    total.traversal = kind;
    CostTrace trace(total);
    for (pipeline::DrawCall& call : frame.calls()) {
        if (only && call.object != only->object) {
            continue;
        }
        pipeline::run_vertex_stage(call, trace);
        const auto count = static_cast<std::uint32_t>(call.triangles().size());
        for (std::uint32_t i = only ? only->triangle : 0; i < (only ? only->triangle + 1 : count);
             ++i) {
            pipeline::draw_triangle(call, i, {}, target, trace);
        }
    }
    return total;
}

} // namespace

std::vector<TraversalCost> compare_traversals(
    const std::shared_ptr<const scene::Scene>& scene, std::optional<TriangleNumber> only
) {
    std::vector<TraversalCost> costs;
    for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
        costs.push_back(cost_of(*scene, kind.value, only));
    }
    return costs;
}

std::vector<TraversalCost>
compare_traversals(const Recording& recording, const TriangleNumber& triangle) {
    const pipeline::DrawCall& call = recording.frame->calls()[triangle.object];
    const scene::TriangleIndices& indices = call.triangles()[triangle.triangle];
    const scene::Mesh mesh = alone(*call.vertex.mesh, indices);
    pipeline::DrawCall one{
        .object = call.object,
        .settings = call.settings,
        .vertex = call.vertex,
        .volume = call.volume,
        .viewport = call.viewport,
        .vertices = {},
        .varyings = {}};
    one.vertex.mesh = &mesh;
    one.resize_vertices(3);
    for (int corner = 0; corner < 3; ++corner) {
        one.place_vertex(static_cast<std::size_t>(corner), call.clip_vertex(indices[corner]));
    }

    std::vector<TraversalCost> costs;
    for (const Named<scene::TraversalKind>& kind : names<scene::TraversalKind>()) {
        one.settings.traversal = kind.value;
        ask_centers(one.settings);
        TraversalCost& total = costs.emplace_back();
        total.traversal = kind.value;
        CostTrace trace(total);
        NoPixels target;
        pipeline::draw_triangle(one, 0, {}, target, trace);
    }
    return costs;
}

} // namespace hs::trace
