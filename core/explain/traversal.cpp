#include "core/explain/traversal.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <span>

namespace hs::explain {
namespace {

using trace::StepKind;

constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};

const char* name_of_edge(const raster::ScanEdge& edge) {
    return edge_names[static_cast<unsigned>(edge.edge)];
}

/// In window coordinates: pixel centers lie at halves.
std::string crossing(const raster::ScanEdge& edge) {
    return number(static_cast<float>(edge.position() + 0.5));
}

template <typename Table>
std::span<const raster::ScanEdge> edges_of(const Table& table) {
    return std::span{table.edges}.first(static_cast<std::size_t>(table.count));
}

// ---- sentences

/// The edges that some corners lie outside of; only those all of them do, if `all`.
std::string
edges_outside(const raster::TileTest& tile, const raster::TriangleSetup& setup, bool all) {
    std::vector<std::string_view> found;
    for (unsigned k = 0; k < 3; ++k) {
        int outside = 0;
        for (const raster::EdgeValues& corner : tile.corners) {
            outside += corner[k] + setup.top_left_bias[k] < 0 ? 1 : 0;
        }
        if (all ? outside == 4 : outside > 0) {
            found.emplace_back(edge_names[k]);
        }
    }
    return fmt::format("{}", fmt::join(found, " and "));
}

std::string tile_sentence(
    const std::string& who, const raster::TileTest& tile, const raster::TriangleSetup& setup
) {
    const std::string tile_name =
        fmt::format("Tile {} of {} × {} pixels", pixel(tile.origin), tile.size, tile.size);
    switch (tile.verdict) {
    case raster::TileVerdict::rejected:
        return fmt::format(
            "{} is rejected: all four corners lie outside {} of {}.",
            tile_name,
            edges_outside(tile, setup, true),
            who
        );
    case raster::TileVerdict::accepted:
        return fmt::format(
            "{} is accepted: all four corners lie inside {}, so do the {} pixels between.",
            tile_name,
            who,
            tile.pixels.width() * tile.pixels.height()
        );
    case raster::TileVerdict::partial:
        return fmt::format(
            "{} is partial: its corners disagree about {} of {}.",
            tile_name,
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
    if (buckets.empty()) {
        return fmt::format("No edge of {} crosses a scanline.", who);
    }
    return fmt::format("The edges of {} go into buckets: {}.", who, fmt::join(buckets, ", "));
}

std::string active_sentence(const std::string& who, const raster::ActiveEdges& active) {
    std::vector<std::string> edges;
    for (const raster::ScanEdge& edge : edges_of(active)) {
        edges.push_back(fmt::format("{} at x = {}", name_of_edge(edge), crossing(edge)));
    }
    return fmt::format(
        "Scanline {} of {}: {} edges enter, {} leave; active are {}.",
        active.row,
        who,
        active.entered,
        active.left,
        fmt::join(edges, " and ")
    );
}

std::string span_sentence(const std::string& who, const raster::Span& span) {
    const std::string between = fmt::format(
        "Scanline {} of {} runs from {} at x = {} to {} at x = {}",
        span.row,
        who,
        name_of_edge(span.left),
        crossing(span.left),
        name_of_edge(span.right),
        crossing(span.right)
    );
    if (span.width() == 0) {
        return between + ": no pixel center lies between.";
    }
    return fmt::format("{}: it covers pixels {} to {}.", between, span.first, span.end - 1);
}

// ---- formulas

std::vector<Formula>
tile_formulas(const raster::TileTest& tile, const raster::TriangleSetup& setup) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        int outside = 0;
        std::string corners;
        for (const raster::EdgeValues& corner : tile.corners) {
            outside += corner[k] + setup.top_left_bias[k] < 0 ? 1 : 0;
            corners += fmt::format("{}{}", corners.empty() ? "" : "\n", whole(corner[k]));
        }
        list.push_back(
            {fmt::format("{} at the four corners", edge_names[k]),
             setup.edges[k].owns_ties() ? "outside iff E < 0" : "outside iff E ≤ 0",
             corners,
             outside == 4   ? "all outside: reject"
             : outside == 0 ? "all inside"
                            : fmt::format("{} of 4 outside", outside)}
        );
    }
    return list;
}

Formula
crossing_formula(const raster::ScanEdge& edge, const raster::TriangleSetup& setup, int row) {
    const raster::EdgeFunction& e = setup.edges[static_cast<unsigned>(edge.edge)];
    return {
        fmt::format(
            "{} on scanline {}: {} edge", name_of_edge(edge), row, edge.left ? "left" : "right"
        ),
        "x = −(b·y + c) / a, one scanline on: x − b/a",
        fmt::format(
            "−({}·{} + {}) / {}\n−b/a = {}",
            e.b,
            row * subpixel_scale,
            e.c,
            e.a,
            number(static_cast<float>(edge.slope()))
        ),
        fmt::format(
            "x = {}: the first pixel {} is {}",
            crossing(edge),
            edge.left ? "inside" : "outside",
            edge.x
        )};
}

/// Where a running value came from.
struct Source {
    PixelPos pixel;
    const char* addition; ///< "+ a"
};

std::optional<Source> source_of(PixelPos p, const PixelRect& box, scene::TraversalKind traversal) {
    const bool leftward = traversal == scene::TraversalKind::serpentine && (p.y - box.y0) % 2 != 0;
    const int row_begin = leftward ? box.x1 - 1 : box.x0;
    if (p.x != row_begin) {
        return Source{{p.x + (leftward ? 1 : -1), p.y}, leftward ? "− a" : "+ a"};
    }
    if (p.y != box.y0) {
        return Source{{p.x, p.y - 1}, "+ b"};
    }
    return std::nullopt;
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
            list.push_back(crossing_formula(edge, setup, edge.first_row));
        }
    } else if (step.kind == StepKind::active_edges && detail.active) {
        for (const raster::ScanEdge& edge : edges_of(*detail.active)) {
            list.push_back(crossing_formula(edge, setup, detail.active->row));
        }
    } else if (step.kind == StepKind::span && detail.span) {
        list.push_back(crossing_formula(detail.span->left, setup, detail.span->row));
        list.push_back(crossing_formula(detail.span->right, setup, detail.span->row));
    }
    return list;
}

std::vector<Formula> running_edge_formulas(
    const raster::TriangleSetup& setup,
    const trace::VisitDetail& visit,
    scene::TraversalKind traversal
) {
    const bool running = traversal == scene::TraversalKind::incremental ||
                         traversal == scene::TraversalKind::serpentine;
    const auto source =
        running ? source_of(visit.pixel, setup.bounds, traversal) : std::optional<Source>{};
    std::vector<Formula> list;
    for (unsigned k = 0; source && k < 3; ++k) {
        const std::int64_t before = setup.edges[k](source->pixel);
        list.push_back(
            {fmt::format("{} from pixel {}", edge_names[k], pixel(source->pixel)),
             fmt::format("E = E at {} {}·256", pixel(source->pixel), source->addition),
             fmt::format("{} + {}", whole(before), whole(visit.edges[k] - before)),
             whole(visit.edges[k])}
        );
    }
    return list;
}

} // namespace hs::explain
