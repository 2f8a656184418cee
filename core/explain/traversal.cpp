#include "core/explain/traversal.hpp"

#include "core/explain/numbers.hpp"
#include "core/explain/registers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdlib>
#include <span>

namespace hs::explain {
namespace {

using trace::StepKind;

constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};

const char* name_of_edge(const raster::ScanEdge& edge) {
    return edge_names[static_cast<unsigned>(edge.edge)];
}

/// In window coordinates: pixel centers lie at halves.
std::string crossing(const raster::ScanEdge& edge, const raster::ScanPlace& place) {
    const double offset = static_cast<double>(place.offset.x) / subpixel_scale;
    return number(static_cast<float>(edge.position() + 0.5 + offset));
}

/// "Scanline 3", "Scanline 3 through sample 2"
std::string scanline_name(int row, const raster::ScanPlace& place) {
    return place.sample < 0 ? fmt::format("Scanline {}", row)
                            : fmt::format("Scanline {} through sample {}", row, place.sample);
}

template <typename Table>
std::span<const raster::ScanEdge> edges_of(const Table& table) {
    return std::span{table.edges}.first(static_cast<std::size_t>(table.count));
}

// ---- sentences

/// How many corners of a tile lie outside an edge by what is asked there: their centers, or all
/// their samples; and how many do not lie inside by all of it.
struct CornersOutside {
    int wholly = 0;
    int partly = 0;
};

CornersOutside
corners_outside(const raster::TileTest& tile, const raster::TriangleSetup& setup, unsigned k) {
    CornersOutside count;
    for (const raster::EdgeValues& corner : tile.corners) {
        const std::int64_t value = corner[k] + setup.top_left_bias[k];
        count.wholly += value + tile.reach.in[k] < 0 ? 1 : 0;
        count.partly += value + tile.reach.out[k] < 0 ? 1 : 0;
    }
    return count;
}

/// The edges that some corners lie outside of; only those all of them do, if `all`.
std::string
edges_outside(const raster::TileTest& tile, const raster::TriangleSetup& setup, bool all) {
    std::vector<std::string_view> found;
    for (unsigned k = 0; k < 3; ++k) {
        const CornersOutside outside = corners_outside(tile, setup, k);
        if (all ? outside.wholly == 4 : outside.partly > 0) {
            found.emplace_back(edge_names[k]);
        }
    }
    return fmt::format("{}", fmt::join(found, " and "));
}

/// Whether a tile's corners are asked at samples.
bool asks_samples(const raster::TileTest& tile) {
    return tile.reach.in != tile.reach.out;
}

std::string tile_sentence(
    const std::string& who, const raster::TileTest& tile, const raster::TriangleSetup& setup
) {
    const std::string tile_name =
        fmt::format("Tile {} of {} × {} pixels", pixel(tile.origin), tile.size, tile.size);
    const bool samples = asks_samples(tile);
    switch (tile.verdict) {
    case raster::TileVerdict::rejected:
        return fmt::format(
            "{} is rejected: all {}four corners lie outside {} of {}.",
            tile_name,
            samples ? "samples of all " : "",
            edges_outside(tile, setup, true),
            who
        );
    case raster::TileVerdict::accepted:
        return fmt::format(
            "{} is accepted: all {}four corners lie inside {}, so do the {} pixels between.",
            tile_name,
            samples ? "samples of all " : "",
            who,
            tile.pixels.width() * tile.pixels.height()
        );
    case raster::TileVerdict::partial:
        return fmt::format(
            "{} is partial: {} corners disagree about {} of {}.",
            tile_name,
            samples ? "the samples of its" : "its",
            edges_outside(tile, setup, false),
            who
        );
    }
    HS_CHECK(false, "every verdict has a sentence");
    return "";
}

std::string bucket_sentence(const std::string& who, const raster::EdgeTable& table) {
    std::vector<std::string> buckets;
    for (const raster::ScanEdge& edge : edges_of(table)) {
        buckets.push_back(fmt::format("{} at scanline {}", name_of_edge(edge), edge.first_row));
    }
    const std::string through =
        table.place.sample < 0 ? "" : fmt::format(" through sample {}", table.place.sample);
    if (buckets.empty()) {
        return fmt::format("No edge of {} crosses a scanline{}.", who, through);
    }
    return fmt::format(
        "The edges of {} go into buckets{}: {}.",
        who,
        through.empty() ? "" : " for scanlines" + through,
        fmt::join(buckets, ", ")
    );
}

std::string active_sentence(const std::string& who, const raster::ActiveEdges& active) {
    std::vector<std::string> edges;
    for (const raster::ScanEdge& edge : edges_of(active)) {
        edges.push_back(
            fmt::format("{} at x = {}", name_of_edge(edge), crossing(edge, active.place))
        );
    }
    return fmt::format(
        "{} of {}: {} edges enter, {} leave; active are {}.",
        scanline_name(active.row, active.place),
        who,
        active.entered,
        active.left,
        fmt::join(edges, " and ")
    );
}

std::string span_sentence(const std::string& who, const raster::Span& span) {
    const std::string between = fmt::format(
        "{} of {} runs from {} at x = {} to {} at x = {}",
        scanline_name(span.row, span.place),
        who,
        name_of_edge(span.left),
        crossing(span.left, span.place),
        name_of_edge(span.right),
        crossing(span.right, span.place)
    );
    const int sample = span.place.sample;
    if (span.width() == 0) {
        return sample < 0 ? between + ": no pixel center lies between."
                          : fmt::format("{}: no sample {} lies between.", between, sample);
    }
    const std::string what = sample < 0 ? "" : fmt::format("sample {} of ", sample);
    return fmt::format("{}: it covers {}pixels {} to {}.", between, what, span.first, span.end - 1);
}

// ---- formulas

std::vector<Formula>
tile_formulas(const raster::TileTest& tile, const raster::TriangleSetup& setup) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const CornersOutside outside = corners_outside(tile, setup, k);
        std::string corners;
        for (const raster::EdgeValues& corner : tile.corners) {
            corners +=
                fmt::format("{}{} px²", corners.empty() ? "" : "\n", square_pixels(corner[k]));
        }
        const char* const below = setup.edges[k].owns_ties() ? "<" : "≤";
        const std::string rule =
            !asks_samples(tile)
                ? fmt::format("outside iff E {} 0", below)
                : fmt::format(
                      "all samples outside iff E + {} px² {} 0, some iff E {} {} px² {} 0",
                      square_pixels(tile.reach.in[k]),
                      below,
                      tile.reach.out[k] < 0 ? "−" : "+",
                      square_pixels(std::abs(tile.reach.out[k])),
                      below
                  );
        list.push_back(
            {fmt::format("{} at the four corners", edge_names[k]),
             rule,
             corners,
             outside.wholly == 4   ? "all outside: reject"
             : outside.partly == 0 ? "all inside"
                                   : fmt::format("{} of 4 outside", outside.partly)}
        );
    }
    return list;
}

Formula crossing_formula(
    const raster::ScanEdge& edge,
    const raster::TriangleSetup& setup,
    int row,
    const raster::ScanPlace& place
) {
    const raster::EdgeFunction& e = setup.edges[static_cast<unsigned>(edge.edge)];
    return {
        fmt::format(
            "{} on scanline {}: {} edge", name_of_edge(edge), row, edge.left ? "left" : "right"
        ),
        "x = −(b·y + c) / a, one scanline on: x − b/a",
        fmt::format(
            "−({}·{} + {}) / {}\n−b/a = {}",
            e.b,
            row * subpixel_scale + place.offset.y,
            e.c,
            e.a,
            number(static_cast<float>(edge.slope()))
        ),
        fmt::format(
            "x = {}: the first {} {} is {}",
            crossing(edge, place),
            place.sample < 0 ? "pixel" : fmt::format("sample {}", place.sample),
            edge.left ? "inside" : "outside",
            edge.x
        )};
}

} // namespace

std::string traversal_sentence(
    const std::string& who,
    const trace::Step& step,
    const trace::TraversalDetail& detail,
    const raster::TriangleSetup& setup
) {
    if (step.kind == StepKind::tile_test && detail.tile) {
        return tile_sentence(who, *detail.tile, setup);
    }
    if (step.kind == StepKind::edge_table && detail.edge_table) {
        return bucket_sentence(who, *detail.edge_table);
    }
    if (step.kind == StepKind::active_edges && detail.active) {
        return active_sentence(who, *detail.active);
    }
    HS_CHECK(detail.span.has_value(), "a step of a traversal has its detail");
    return span_sentence(who, *detail.span);
}

std::vector<Formula> traversal_formulas(
    const trace::TraversalDetail& detail,
    const trace::Step& step,
    const raster::TriangleSetup& setup
) {
    if (step.kind == StepKind::tile_test && detail.tile) {
        return tile_formulas(*detail.tile, setup);
    }
    std::vector<Formula> list;
    if (step.kind == StepKind::edge_table && detail.edge_table) {
        for (const raster::ScanEdge& edge : edges_of(*detail.edge_table)) {
            list.push_back(crossing_formula(edge, setup, edge.first_row, detail.edge_table->place));
        }
    } else if (step.kind == StepKind::active_edges && detail.active) {
        for (const raster::ScanEdge& edge : edges_of(*detail.active)) {
            list.push_back(crossing_formula(edge, setup, detail.active->row, detail.active->place));
        }
    } else if (step.kind == StepKind::span && detail.span) {
        const raster::Span& span = *detail.span;
        list.push_back(crossing_formula(span.left, setup, span.row, span.place));
        list.push_back(crossing_formula(span.right, setup, span.row, span.place));
    }
    return list;
}

std::vector<Formula> running_edge_formulas(
    const trace::StepDetail& detail, const trace::Step& step, scene::TraversalKind traversal
) {
    const std::optional<Registers> registers = registers_at(detail, step, traversal);
    std::vector<Formula> list;
    if (!registers || registers->move == RegisterMove::evaluated) {
        return list;
    }
    const bool leftward = registers->move == RegisterMove::left;
    const bool along = leftward || registers->move == RegisterMove::right;
    for (unsigned k = 0; k < 3; ++k) {
        const EdgeRegisters& edge = registers->edges[k];
        list.push_back(
            {fmt::format("{} from pixel {}", edge_names[k], pixel(registers->from)),
             fmt::format(
                 "E = E at {} {} {}",
                 pixel(registers->from),
                 leftward ? "−" : "+",
                 along ? "a" : "b"
             ),
             fmt::format(
                 "{} {} {} px²",
                 square_pixels(edge.before),
                 leftward ? "−" : "+",
                 square_pixels(along ? edge.a : edge.b)
             ),
             fmt::format("{} px²", square_pixels(edge.now)),
             {edge_names[k], "covered"}}
        );
    }
    return list;
}

} // namespace hs::explain
