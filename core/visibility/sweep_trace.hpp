// How an algorithm that decides scanline by scanline, or ray by ray, tells its story: one event per
// decision, and the state after it.
#pragma once

#include "core/base/named.hpp"

#include <glm/vec3.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace hs::visibility {

/// A decision. What the numbers mean is said beside each kind; `polygon` and `other` are indices
/// into the polygons (ray casting: triangles) the algorithm was given.
enum class SweepEventKind : std::uint8_t {
    // Scanlines
    edge_out,     ///< `edge` of `polygon` has ended above the scanline and is active no longer
    edge_in,      ///< `edge` of `polygon` begins: it is taken from its bucket, at `x`
    active_edges, ///< all active edges are moved to the scanline and sorted by x
    cross,        ///< `edge` at `x`: its `polygon` is entered (verdict) or left
    compare,      ///< at `x`, is `polygon` (depth `value`) in front of `other` (`other_value`)?
    false_edge,   ///< at `x`, inside both, `polygon` comes through `other`
    span,         ///< `polygon` (−1: the background) is visible from `x` to `x_end`

    // A scanline's line of depths
    clear, ///< the line is cleared
    enter, ///< `polygon` covers pixels `x` … `x_end` − 1
    depth, ///< pixel `x`: is `polygon` (depth `value`) nearer than `other` (`other_value`), which
           ///< the line holds (−1: nobody)?

    // Rays
    cast, ///< the ray sets out
    meet, ///< does it hit `polygon` between the near and the far plane? It meets the plane at t =
          ///< `value`, where the vertices have `weights`
    keep  ///< is the hit of `polygon` (t = `value`) nearer than that of `other` (`other_value`)?
};

inline constexpr std::size_t sweep_event_kind_count = 13;

/// One step of a sweep.
struct SweepEvent {
    SweepEventKind kind = SweepEventKind::active_edges;
    bool verdict = false; ///< the question's answer, where the kind asks one
    std::int32_t edge = -1;
    std::int32_t polygon = -1;
    std::int32_t other = -1;
    double x = 0.0;
    double x_end = 0.0;
    double value = 0.0;
    double other_value = 0.0;
    glm::dvec3 weights{0.0};
};

/// Takes a story; never steers. `State` is the algorithm's own (active edges and flags, a line of
/// depths, a ray), as it is after the event.
template <typename Sink, typename State>
concept SweepSink = requires(Sink sink, const SweepEvent& event, const State& state) {
    { sink.sweep_step(event, state) } -> std::same_as<void>;
};

/// Listens to nothing.
struct SilentSweep {
    template <typename State>
    void sweep_step(const SweepEvent&, const State&) {}
};

} // namespace hs::visibility

namespace hs {
template <>
std::span<const Named<visibility::SweepEventKind>> names<visibility::SweepEventKind>();
} // namespace hs
