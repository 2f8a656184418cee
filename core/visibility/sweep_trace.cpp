#include "core/visibility/sweep_trace.hpp"

namespace hs {

template <>
std::span<const Named<visibility::SweepEventKind>> names<visibility::SweepEventKind>() {
    using visibility::SweepEventKind;
    static constexpr std::array<Named<SweepEventKind>, visibility::sweep_event_kind_count> table{{
        {SweepEventKind::edge_out, "edge out", "an edge that has ended leaves the active edges"},
        {SweepEventKind::edge_in, "edge in", "an edge that begins joins the active edges"},
        {SweepEventKind::active_edges,
         "active edges",
         "the active edges are moved to the scanline and sorted by x"},
        {SweepEventKind::cross, "edge", "at an edge its polygon is entered or left"},
        {SweepEventKind::compare,
         "comparison",
         "the depths of two polygons are compared, both of which the scanline is inside"},
        {SweepEventKind::false_edge, "false edge", "a polygon comes through the visible one"},
        {SweepEventKind::span, "span", "what is visible from one edge to the next is decided"},
        {SweepEventKind::clear, "clear", "the line of depths is cleared for the next scanline"},
        {SweepEventKind::enter, "enter", "the pixels of a polygon on the scanline are found"},
        {SweepEventKind::depth, "depth", "a polygon's depth is compared with the line's"},
        {SweepEventKind::cast, "ray", "a ray sets out through a pixel's center"},
        {SweepEventKind::meet, "meeting", "the ray is held against a triangle"},
        {SweepEventKind::keep, "nearest", "a hit is compared with the nearest so far"},
    }};
    return table;
}

} // namespace hs
