#include "core/export/table.hpp"

#include "core/export/column.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace hs::exporting {
namespace {

using trace::Player;

Table vertices_at(const Player& player) {
    return vertex_table(player.shared_recording());
}
Table triangles_at(const Player& player) {
    return triangle_table(player.shared_recording());
}
Table fragments_at(const Player& player) {
    return fragment_table(player.shared_recording(), player.fragments_done());
}
Table runs_at(const Player& player) {
    return run_table(player.shared_recording(), player.fragments_done());
}
Table order_at(const Player& player) {
    const trace::Recording& recording = player.recording();
    const trace::StepId done =
        std::clamp(player.step() + 1, recording.first_order_step, recording.first_triangle_step);
    return order_table(player.shared_recording(), done - recording.first_order_step);
}
Table spans_at(const Player& player) {
    return span_table(player.shared_recording());
}
Table rays_at(const Player& player) {
    return ray_table(player.shared_recording());
}
Table counters_at(const Player& player) {
    return counter_table(player.counters());
}
Table steps_at(const Player& player) {
    return step_table(player.shared_recording(), player.step());
}
Table pieces_at(const Player& player) {
    return piece_tables(player.shared_recording()).pieces;
}
Table piece_vertices_at(const Player& player) {
    return piece_tables(player.shared_recording()).vertices;
}

constexpr std::array<TableName, 14> known{{
    {"vertices", "every vertex in every space, with its varyings"},
    {"triangles", "every triangle with its verdict"},
    {"fragments", "every fragment up to the step, with its fate"},
    {"samples", "what every sample of every pixel holds, where a pixel has several"},
    {"counters", "how often everything has happened up to the step"},
    {"runs", "stretches of one triangle's fragments, up to the step"},
    {"pieces", "triangles made by clipping"},
    {"piece-vertices", "their vertices, with weights among the original three"},
    {"order", "every decision of the ordering algorithm, up to the step"},
    {"spans", "what every scanline of the frame shows, from left to right"},
    {"rays", "what every ray of the frame hits first"},
    {"sweep", "every decision of the scanline or the ray the step stands in, up to the step"},
    {"steps", "where every step up to this one stands"},
    {"traversals", "what every traversal would spend on the step's triangle, or on the frame"},
}};

/// In the order of the names.
constexpr std::array<Table (*)(const Player&), known.size()> makers{
    vertices_at,
    triangles_at,
    fragments_at,
    sample_table,
    counters_at,
    runs_at,
    pieces_at,
    piece_vertices_at,
    order_at,
    spans_at,
    rays_at,
    sweep_table,
    steps_at,
    traversal_table};

} // namespace

std::size_t size_of(ColumnType type) {
    switch (type) {
    case ColumnType::uint8: return 1;
    case ColumnType::uint16: return 2;
    case ColumnType::float32:
    case ColumnType::int32:
    case ColumnType::uint32: return 4;
    case ColumnType::uint64:
    case ColumnType::float64: return 8;
    }
    HS_CHECK(false, "every column type has a size");
    return 0;
}

std::string component_name(std::string_view column, std::size_t components, std::size_t component) {
    if (components == 1) {
        return std::string{column};
    }
    const bool numbered = column.ends_with("vertices") || column.ends_with("weights") ||
                          column.ends_with("barycentric");
    const std::string_view letters = numbered                    ? "0123"
                                     : column.ends_with("color") ? "rgba"
                                     : column.ends_with("uv")    ? "uv"
                                                                 : "xyzw";
    return fmt::format("{}.{}", column, letters[component]);
}

std::span<const TableName> table_names() {
    return known;
}

Result<Table> make_table(const Player& player, std::string_view name) {
    std::vector<std::string_view> all;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i].name == name) {
            return makers[i](player);
        }
        all.push_back(known[i].name);
    }
    return Diagnostic{
        .message = fmt::format("'{}' is not a table; known are {}", name, fmt::join(all, ", "))};
}

Table counter_table(const trace::Counters& counters) {
    Table table{.name = "counters", .rows = 1, .columns = {}};
    const auto add = [&table](const std::string& name, std::uint64_t value) {
        table.columns.push_back(column<std::uint64_t>("counters." + name, [value](std::size_t) {
            return value;
        }));
    };
    add("vertices", counters.vertices);
    for (const Named<visibility::OrderEventKind>& kind : names<visibility::OrderEventKind>()) {
        std::string name = fmt::format("order_{}", kind.name);
        std::ranges::replace(name, ' ', '_');
        add(name, counters.decisions[static_cast<std::size_t>(kind.value)]);
    }
    for (const Named<visibility::SweepEventKind>& kind : names<visibility::SweepEventKind>()) {
        std::string name = fmt::format("sweep_{}", kind.name);
        std::ranges::replace(name, ' ', '_');
        add(name, counters.sweeps[static_cast<std::size_t>(kind.value)]);
    }
    add("triangles", counters.triangles);
    add("triangles_clipped", counters.clipped);
    add("pieces", counters.pieces);
    add("pieces_mapped", counters.pieces_mapped);
    add("pieces_faced", counters.pieces_faced);
    add("pieces_set_up", counters.pieces_set_up);
    add("pixels_visited", counters.traversal.pixels);
    add("tiles_visited", counters.traversal.tiles);
    add("edge_evaluations", counters.traversal.evaluations);
    add("multiplications", counters.traversal.multiplications());
    add("additions", counters.traversal.additions());
    add("divisions", counters.traversal.divisions);
    add("fragments", counters.fragments);
    add("fragments_shaded", counters.fragments_shaded);
    add("fragments_tested", counters.fragments_tested);
    for (const Named<fragment::FragmentFate>& fate : names<fragment::FragmentFate>()) {
        std::string name = fmt::format("fragments_{}", fate.name);
        std::ranges::replace(name, ' ', '_');
        add(name, counters.fates[static_cast<std::size_t>(fate.value)]);
    }
    return table;
}

std::vector<Table> trace_tables(const SharedRecording& recording) {
    const auto fragments = static_cast<std::uint32_t>(recording->fragments.size());
    PieceTables pieces = piece_tables(recording);
    std::vector<Table> tables;
    tables.push_back(vertex_table(recording));
    tables.push_back(triangle_table(recording));
    if (recording->settings().orders_triangles()) {
        tables.push_back(order_table(recording, recording->decisions.size()));
    }
    if (recording->settings().visibility == scene::Visibility::ray_cast) {
        tables.push_back(ray_table(recording));
    } else if (recording->settings().sweeps()) {
        tables.push_back(span_table(recording));
    }
    tables.push_back(std::move(pieces.pieces));
    tables.push_back(std::move(pieces.vertices));
    tables.push_back(run_table(recording, fragments));
    tables.push_back(fragment_table(recording, fragments));
    return tables;
}

} // namespace hs::exporting
