#include "core/trace/order_detail.hpp"

#include "core/pipeline/order.hpp"
#include "core/trace/recording.hpp"

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
            detail_.state = state;
        }
    }
    [[nodiscard]] OrderDetail& detail() { return detail_; }

private:
    std::uint32_t wanted_;
    std::uint32_t event_ = 0;
    OrderDetail detail_;
};
static_assert(pipeline::AnyOrderSink<StateAt>);

} // namespace

std::span<const visibility::WindowPolygon> OrderDetail::window_polygons() const {
    if (const auto* const sort = std::get_if<visibility::PaintersSort>(&state)) {
        return sort->polygons;
    }
    return {};
}

std::optional<pipeline::OrderedPolygon> OrderDetail::polygon(std::int32_t number) const {
    if (number < 0) {
        return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(number);
    return pipeline::ordered_polygon(window_polygons()[index]);
}

OrderDetail order_detail(const Recording& recording, std::uint32_t event) {
    HS_CHECK(event < recording.decisions.size(), "a decision of this recording");
    StateAt sink(event);
    static_cast<void>(pipeline::order_triangles(*recording.frame, sink));
    return std::move(sink.detail());
}

} // namespace hs::trace
