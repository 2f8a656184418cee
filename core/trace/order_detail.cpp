#include "core/trace/order_detail.hpp"

#include "core/pipeline/order.hpp"
#include "core/trace/recording.hpp"

#include <utility>

namespace hs::trace {
namespace {

/// Copies the state at one decision and goes on: a sink never steers.
class StateAt {
public:
    explicit StateAt(std::uint32_t event) : wanted_(event) {}

    template <typename State>
    void order_step(const visibility::OrderEvent& event, const State& state) {
        if (event_++ == wanted_) {
            detail_.decision = event;
            keep(state);
        }
    }
    [[nodiscard]] bool found() const { return event_ > wanted_; }
    [[nodiscard]] OrderDetail& detail() { return detail_; }

private:
    template <typename State>
    void keep(const State& state) {
        detail_.state = state;
    }
    void keep(const visibility::BspTree& tree) { detail_.state = BspMoment{tree, {}}; }
    void keep(const visibility::BspWalk& walk) { detail_.state = BspMoment{{}, walk}; }
    void keep(const visibility::Octree& tree) { detail_.state = OctreeMoment{tree, {}}; }
    void keep(const visibility::OctreeWalk& walk) { detail_.state = OctreeMoment{{}, walk}; }

    std::uint32_t wanted_;
    std::uint32_t event_ = 0;
    OrderDetail detail_;
};
static_assert(pipeline::AnyOrderSink<StateAt>);

/// A walk's state goes with the tree, which is complete by then.
void run_tree(const pipeline::Frame& frame, StateAt& sink) {
    visibility::BspTree tree = pipeline::build_tree(frame, sink);
    if (!sink.found()) {
        static_cast<void>(pipeline::walk_tree(frame, tree, sink));
        std::get<BspMoment>(sink.detail().state).tree = std::move(tree);
    }
}

void run_cells(const pipeline::Frame& frame, StateAt& sink) {
    visibility::Octree tree = pipeline::build_cells(frame, sink);
    if (!sink.found()) {
        static_cast<void>(pipeline::walk_cells(frame, tree, sink));
        std::get<OctreeMoment>(sink.detail().state).tree = std::move(tree);
    }
}

/// What holds the polygons of a state.
template <typename Space>
struct PolygonsOf {
    using List = std::span<const visibility::Polygon<Space>>;

    template <typename Other>
    List operator()(const Other&) const {
        return {};
    }
};
struct WindowPolygonsOf : PolygonsOf<visibility::WindowSpace> {
    using PolygonsOf::operator();
    List operator()(const visibility::PaintersSort& sort) const { return sort.polygons; }
    List operator()(const visibility::FrontLists& lists) const { return lists.polygons; }
    List operator()(const visibility::DepthSort& sort) const { return sort.set.polygons; }
};
struct WorldPolygonsOf : PolygonsOf<math::WorldSpace> {
    using PolygonsOf::operator();
    List operator()(const BspMoment& moment) const { return moment.tree.set.polygons; }
    List operator()(const OctreeMoment& moment) const { return moment.tree.set.polygons; }
};

} // namespace

std::span<const visibility::WindowPolygon> OrderDetail::window_polygons() const {
    return std::visit(WindowPolygonsOf{}, state);
}

std::span<const visibility::WorldPolygon> OrderDetail::world_polygons() const {
    return std::visit(WorldPolygonsOf{}, state);
}

std::optional<pipeline::OrderedPolygon> OrderDetail::polygon(std::int32_t number) const {
    if (number < 0) {
        return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(number);
    const auto window = window_polygons();
    return window.empty() ? pipeline::ordered_polygon(world_polygons()[index])
                          : pipeline::ordered_polygon(window[index]);
}

OrderDetail order_detail(const Recording& recording, std::uint32_t event) {
    HS_CHECK(event < recording.decisions.size(), "a decision of this recording");
    StateAt sink(event);
    const pipeline::Frame& frame = *recording.frame;
    if (recording.settings().visibility == scene::Visibility::bsp) {
        run_tree(frame, sink);
    } else if (recording.settings().visibility == scene::Visibility::octree) {
        run_cells(frame, sink);
    } else {
        static_cast<void>(pipeline::order_in_window(frame, sink));
    }
    return std::move(sink.detail());
}

} // namespace hs::trace
