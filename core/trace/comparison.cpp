#include "core/trace/comparison.hpp"

#include "core/framebuffer/framebuffer.hpp"
#include "core/pipeline/draw.hpp"

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

TraversalCost
cost_of(const scene::Scene& scene, scene::TraversalKind kind, std::optional<TriangleNumber> only) {
    auto variant = std::make_shared<scene::Scene>(scene);
    variant->settings.traversal = kind;
    pipeline::Frame frame(variant);
    framebuffer::Framebuffer target(variant->settings);
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

} // namespace hs::trace
