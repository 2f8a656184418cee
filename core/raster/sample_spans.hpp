// Scan conversion with several samples a pixel: every sample has its own scanlines, which run
// through it in every row of pixels, and its own edges and spans. None is asked.
//
// A sample off the center is covered where the center is covered by the triangle moved the other
// way, so each is the edge walk, or the edge table, of a moved triangle. Cost: theirs, but for the
// edge values, which are moved along the row once for all samples.
#pragma once

#include "core/raster/edge_table.hpp"
#include "core/raster/edge_walk.hpp"
#include "core/raster/sample_coverage.hpp"

#include <array>

namespace hs::raster {

/// The triangle as one sample of every pixel sees it.
struct SampleScan {
    TriangleSetup setup;
    RowRange rows; ///< that its scanlines cross; empty if the triangle has none of these samples
    ScanPlace place;

    [[nodiscard]] bool crosses(int row) const { return rows.first <= row && row < rows.end; }
};

[[nodiscard]] inline SampleScan scan_of_sample(const SampledSetup& setup, int sample) {
    const auto s = static_cast<std::size_t>(sample);
    SampleScan scan;
    scan.setup = static_cast<const TriangleSetup&>(setup);
    scan.place = {sample, sample_pattern(setup.samples.count)[s]};
    for (FixedPosition& vertex : scan.setup.vertices) {
        vertex.x -= scan.place.offset.x;
        vertex.y -= scan.place.offset.y;
    }
    for (unsigned k = 0; k < 3; ++k) {
        scan.setup.edges[k].c += setup.samples.steps[s][k];
    }
    scan.setup.bounds = bounds_of_samples(scan.setup, 1, setup.bounds);
    scan.rows = scan.setup.bounds.empty() ? RowRange{} : rows_of_triangle(scan.setup);
    return scan;
}

using SampleScans = std::array<SampleScan, max_samples>;

[[nodiscard]] inline SampleScans scans_of_samples(const SampledSetup& setup) {
    SampleScans scans;
    for (int s = 0; s < setup.samples.count; ++s) {
        scans[static_cast<unsigned>(s)] = scan_of_sample(setup, s);
    }
    return scans;
}

/// Fills the spans that the samples have in one row: a pixel's samples are those whose spans it
/// lies in.
template <TraversalTrace Trace, typename Emit>
void fill_sample_spans(
    const SampledSetup& setup,
    const EdgeSteps& steps,
    const std::array<Span, max_samples>& spans,
    Trace& trace,
    Emit&& emit
) {
    int first = setup.bounds.x1;
    int end = setup.bounds.x0;
    int row = 0;
    for (const Span& span : spans) {
        if (span.width() > 0) {
            first = std::min(first, span.first);
            end = std::max(end, span.end);
            row = span.row;
        }
    }
    if (first >= end) {
        return;
    }
    EdgeValues center = setup.evaluate({first, row});
    trace.cost({.evaluations = 3});
    for (int x = first; x < end; ++x) {
        trace.cost({.pixels = 1});
        unsigned mask = 0;
        for (unsigned s = 0; s < max_samples; ++s) {
            mask |= spans[s].first <= x && x < spans[s].end ? 1U << s : 0U;
        }
        if (mask != 0) {
            emit(PixelPos{x, row}, center, static_cast<CoverageMask>(mask));
        }
        move(center, steps.right);
        trace.cost(cost_of_moving);
    }
}

/// Goes down the rows of pixels. `span_on(sample, row)` is asked for every scanline, in order. Unit
/// k is row y0 + k of the bounds; one that no scanline crosses does not begin.
template <TraversalTrace Trace, typename SpanOn, typename Emit>
void visit_sample_rows(
    const SampledSetup& setup,
    const SampleScans& scans,
    UnitRange units,
    Trace& trace,
    SpanOn&& span_on,
    Emit&& emit
) {
    const EdgeSteps steps = edge_steps(setup);
    const int last = std::min(units.last, setup.bounds.height());
    for (int unit = units.first; unit < last; ++unit) {
        const int row = setup.bounds.y0 + unit;
        const auto crosses = [row](const SampleScan& scan) { return scan.crosses(row); };
        if (std::ranges::none_of(scans, crosses)) {
            continue;
        }
        trace.unit(unit);
        std::array<Span, max_samples> spans{};
        for (unsigned s = 0; s < max_samples; ++s) {
            if (scans[s].crosses(row)) {
                spans[s] = span_on(s, row);
                spans[s].place = scans[s].place;
                trace.span_found(spans[s]);
            }
        }
        fill_sample_spans(setup, steps, spans, trace, emit);
    }
}

template <TraversalTrace Trace, typename Emit>
void traverse_edge_walk(
    const SampledSetup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    struct Sides {
        ScanEdge left;
        ScanEdge right;
    };
    const SampleScans scans = scans_of_samples(setup);
    std::array<Sides, max_samples> sides{};
    const int above = setup.bounds.y0 + units.first - 1; // to resume, stand on the scanline above
    for (unsigned s = 0; s < max_samples; ++s) {
        if (units.first > 0 && scans[s].crosses(above)) {
            const TriangleSetup& moved = scans[s].setup;
            sides[s].left = scan_edge(moved, edge_on_side(moved, true, above), above);
            sides[s].right = scan_edge(moved, edge_on_side(moved, false, above), above);
        }
    }
    const auto span_on = [&](unsigned s, int row) {
        const TriangleSetup& moved = scans[s].setup;
        follow_side(moved, true, row, sides[s].left, trace);
        follow_side(moved, false, row, sides[s].right, trace);
        return span_between(sides[s].left, sides[s].right, row, moved.bounds);
    };
    visit_sample_rows(setup, scans, units, trace, span_on, emit);
}

template <TraversalTrace Trace, typename Emit>
void traverse_edge_table(
    const SampledSetup& setup,
    const PixelRect& /*image*/,
    UnitRange units,
    Trace& trace,
    Emit&& emit
) {
    // Sort the edges into buckets, for every sample that has some
    const SampleScans scans = scans_of_samples(setup);
    std::array<EdgeTable, max_samples> tables{};
    std::array<ActiveEdges, max_samples> active{};
    for (unsigned s = 0; s < max_samples; ++s) {
        if (scans[s].rows.first >= scans[s].rows.end) {
            continue;
        }
        tables[s] = edge_table(scans[s].setup);
        tables[s].place = scans[s].place;
        for (int i = 0; i < tables[s].count; ++i) {
            trace.cost(cost_of_scan_edge);
        }
        trace.edges_bucketed(tables[s]);
        if (units.first > 0) {
            active[s] = active_edges_at(scans[s].setup, setup.bounds.y0 + units.first - 1);
        }
    }

    // Go down: update the active edges of every sample, fill between them
    const auto span_on = [&](unsigned s, int row) {
        trace.cost(update_active_edges(active[s], tables[s], row));
        trace.edges_activated(active[s]);
        return span_between(active[s].edges[0], active[s].edges[1], row, scans[s].setup.bounds);
    };
    visit_sample_rows(setup, scans, units, trace, span_on, emit);
}

} // namespace hs::raster
