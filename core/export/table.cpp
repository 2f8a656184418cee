// The tables of a recording. What is kept is read; what is derived (world, eye, NDC and window
// coordinates, the depth stored before a test) is computed as it is asked for.
#include "core/export/table.hpp"

#include "core/trace/detail.hpp"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <memory>
#include <utility>

namespace hs::exporting {
namespace {

using trace::Recording;
using Shared = std::shared_ptr<const Recording>;

template <typename T>
constexpr ColumnType type_of() {
    if constexpr (std::is_same_v<T, float>) {
        return ColumnType::float32;
    } else if constexpr (std::is_same_v<T, std::uint8_t>) {
        return ColumnType::uint8;
    } else if constexpr (std::is_same_v<T, std::uint16_t>) {
        return ColumnType::uint16;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return ColumnType::uint32;
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
        return ColumnType::uint64;
    } else {
        static_assert(std::is_same_v<T, std::int64_t>);
        return ColumnType::int64;
    }
}

/// A column of N numbers of type T per row; `get(row)` returns them as an array.
template <typename T, std::size_t N, typename Get>
Column column(std::string name, Get get) {
    return {
        .name = std::move(name),
        .type = type_of<T>(),
        .components = N,
        .meanings = {},
        .read = [get = std::move(get)](std::size_t row, void* out) {
            const std::array<T, N> values = get(row);
            std::memcpy(out, values.data(), sizeof values);
        }};
}

/// The names of an enumeration, for readers and manifests.
template <typename Enum>
Column named_column(Column column) {
    for (const Named<Enum>& row : names<Enum>()) {
        column.meanings.emplace_back(row.name);
    }
    return column;
}

/// Where a row of the frame-wide vertex table comes from.
struct VertexRow {
    std::uint32_t object;
    std::uint32_t vertex;
};

VertexRow vertex_row(const Recording& recording, std::size_t row) {
    std::uint32_t object = 0;
    while (row >= recording.objects[object].first_vertex + recording.objects[object].vertex_count) {
        ++object;
    }
    return {object, static_cast<std::uint32_t>(row) - recording.objects[object].first_vertex};
}

template <typename Space>
std::array<float, 4> as_array(const math::Position<Space>& p) {
    return {p.x, p.y, p.z, p.w};
}

/// A column of one stage of the vertex's way; `pick` takes it from the vertex's work.
template <typename Pick>
Column space_column(const Shared& recording, std::string name, Pick pick) {
    return column<float, 4>(std::move(name), [recording, pick](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        return as_array(
            pick(pipeline::run_vertex(recording->frame->calls()[at.object].vertex, at.vertex))
        );
    });
}

/// NDC or window coordinates; not a number where w <= 0 or the vertex has no place.
template <typename Pick>
Column place_column(const Shared& recording, std::string name, Pick pick) {
    return column<float, 3>(std::move(name), [recording, pick](std::size_t row) {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        const VertexRow at = vertex_row(*recording, row);
        const pipeline::ShadedVertex& vertex =
            recording->frame->calls()[at.object].vertices[at.vertex];
        const bool placed =
            vertex.clip.w > 0.0F && vertex.window.status == geometry::WindowStatus::placed;
        return placed ? pick(vertex.window) : std::array<float, 3>{nan, nan, nan};
    });
}

Table vertex_table(const Shared& recording) {
    Table table{.name = "vertex", .rows = 0, .columns = {}};
    for (const trace::ObjectRange& object : recording->objects) {
        table.rows += object.vertex_count;
    }
    table.columns.push_back(column<std::uint32_t, 1>(
        "vertex.object_index",
        [recording](std::size_t row) { return std::array{vertex_row(*recording, row).object}; }
    ));
    using pipeline::VertexWork;
    table.columns.push_back(space_column(recording, "vertex.object", [](const VertexWork& w) {
        return w.object;
    }));
    table.columns.push_back(space_column(recording, "vertex.world", [](const VertexWork& w) {
        return w.world;
    }));
    table.columns.push_back(space_column(recording, "vertex.eye", [](const VertexWork& w) {
        return w.eye;
    }));
    table.columns.push_back(space_column(recording, "vertex.clip", [](const VertexWork& w) {
        return w.clip;
    }));
    using geometry::WindowVertex;
    table.columns.push_back(place_column(recording, "vertex.ndc", [](const WindowVertex& v) {
        return std::array{v.ndc.x, v.ndc.y, v.ndc.z};
    }));
    table.columns.push_back(place_column(recording, "vertex.window", [](const WindowVertex& v) {
        return std::array{v.window.x, v.window.y, v.window.depth};
    }));
    table.columns.push_back(column<float, 4>("vertex.color", [recording](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        const float* varyings = recording->frame->calls()[at.object].varyings_of(at.vertex);
        return std::array{varyings[0], varyings[1], varyings[2], varyings[3]};
    }));
    return table;
}

/// Where a row of the triangle table comes from.
VertexRow triangle_row(const Recording& recording, std::size_t row) {
    const std::uint32_t object = recording.object_of_triangle(static_cast<std::uint32_t>(row));
    return {object, static_cast<std::uint32_t>(row) - recording.objects[object].first_triangle};
}

Table triangle_table(const Shared& recording) {
    Table table{.name = "triangle", .rows = recording->triangles.size(), .columns = {}};
    table.columns.push_back(column<std::uint32_t, 1>(
        "triangle.object_index",
        [recording](std::size_t row) { return std::array{triangle_row(*recording, row).object}; }
    ));
    table.columns.push_back(column<std::uint32_t, 1>("triangle.face", [recording](std::size_t row) {
        const VertexRow at = triangle_row(*recording, row);
        return std::array{
            recording->frame->calls()[at.object].vertex.mesh->triangle_polygon[at.vertex]};
    }));
    table.columns
        .push_back(column<std::uint32_t, 3>("triangle.vertices", [recording](std::size_t row) {
            const VertexRow at = triangle_row(*recording, row);
            const auto& t = recording->frame->calls()[at.object].triangles()[at.vertex];
            const std::uint32_t first = recording->objects[at.object].first_vertex;
            return std::array{first + t.a, first + t.b, first + t.c};
        }));
    table.columns.push_back(named_column<geometry::TriangleVerdict>(column<std::uint8_t, 1>(
        "triangle.verdict",
        [recording](std::size_t row) {
            return std::array{static_cast<std::uint8_t>(recording->triangles[row].verdict)};
        }
    )));
    table.columns.push_back(column<std::uint8_t, 1>(
        "triangle.clip_planes",
        [recording](std::size_t row) { return std::array{recording->triangles[row].crossed}; }
    ));
    table.columns.push_back(column<std::uint64_t, 1>(
        "triangle.first_step",
        [recording](std::size_t row) { return std::array{recording->triangles[row].first_step}; }
    ));
    return table;
}

glm::vec4 color_after(const Recording& recording, std::size_t fragment) {
    return recording.float_color() ? recording.color32f[fragment]
                                   : framebuffer::unpack(recording.fragments[fragment].color);
}

Table fragment_table(const Shared& recording) {
    Table table{.name = "fragment", .rows = recording->fragments.size(), .columns = {}};
    table.columns
        .push_back(column<std::uint32_t, 1>("fragment.triangle", [recording](std::size_t row) {
            return std::array{recording->run_of_fragment(static_cast<std::uint32_t>(row)).triangle};
        }));
    table.columns
        .push_back(column<std::uint16_t, 2>("fragment.pixel", [recording](std::size_t row) {
            return std::array{recording->fragments[row].x, recording->fragments[row].y};
        }));
    table.columns.push_back(column<float, 1>("fragment.depth", [recording](std::size_t row) {
        return std::array{recording->fragments[row].depth};
    }));
    table.columns.push_back(column<float, 1>("fragment.stored_depth", [recording](std::size_t row) {
        return std::array{trace::pixel_before(*recording, static_cast<std::uint32_t>(row)).depth};
    }));
    table.columns.push_back(column<float, 4>("fragment.color", [recording](std::size_t row) {
        const glm::vec4 color = color_after(*recording, row);
        return std::array{color.r, color.g, color.b, color.a};
    }));
    table.columns.push_back(named_column<fragment::FragmentFate>(column<std::uint8_t, 1>(
        "fragment.fate",
        [recording](std::size_t row) {
            return std::array{static_cast<std::uint8_t>(recording->fragments[row].fate)};
        }
    )));
    return table;
}

Table run_table(const Shared& recording) {
    Table table{.name = "run", .rows = recording->runs.size(), .columns = {}};
    table.columns.push_back(column<std::uint32_t, 1>("run.triangle", [recording](std::size_t row) {
        return std::array{recording->runs[row].triangle};
    }));
    table.columns.push_back(column<std::uint16_t, 1>("run.piece", [recording](std::size_t row) {
        return std::array{recording->runs[row].piece};
    }));
    table.columns.push_back(column<std::uint16_t, 1>("run.pass", [](std::size_t) {
        return std::array{std::uint16_t{0}}; // one pass over the scene
    }));
    table.columns
        .push_back(column<std::uint64_t, 1>("run.first_fragment", [recording](std::size_t row) {
            return std::array{std::uint64_t{recording->runs[row].first_fragment}};
        }));
    return table;
}

Table counter_table(const Shared& recording) {
    Table table{.name = "counters", .rows = 1, .columns = {}};
    const auto add = [&table](std::string name, std::uint64_t value) {
        table.columns.push_back(column<std::uint64_t, 1>(
            "counters." + std::move(name), [value](std::size_t) { return std::array{value}; }
        ));
    };
    const trace::Counters& c = recording->counters;
    add("vertices", c.vertices);
    add("triangles", c.triangles);
    add("triangles_clipped", c.clipped);
    add("pieces", c.pieces);
    add("pieces_mapped", c.pieces_mapped);
    add("pieces_faced", c.pieces_faced);
    add("pieces_set_up", c.pieces_set_up);
    add("pixels_visited", c.pixels_visited);
    add("fragments", c.fragments);
    add("fragments_shaded", c.fragments_shaded);
    add("fragments_tested", c.fragments_tested);
    add("fragments_written", c.fates[0]);
    add("fragments_scissor_failed", c.fates[1]);
    add("fragments_depth_failed", c.fates[2]);
    add("steps", recording->end_step + 1);
    return table;
}

/// The pieces of clipped triangles, gathered once: they are few.
struct Pieces {
    struct Piece {
        std::uint32_t triangle;
        std::array<std::uint32_t, 3> vertices; ///< into `clip`
    };
    std::vector<Piece> pieces;
    std::vector<std::array<float, 4>> clip;
};

std::shared_ptr<const Pieces> gather_pieces(const Recording& recording) {
    auto result = std::make_shared<Pieces>();
    for (std::uint32_t t = 0; t < recording.triangles.size(); ++t) {
        if (recording.triangles[t].crossed == 0) {
            continue;
        }
        const VertexRow at = triangle_row(recording, t);
        const trace::TriangleDetail detail =
            trace::triangle_detail(recording, at.object, at.vertex);
        if (detail.passes.empty() || detail.passes.back().after.count < 3) {
            continue;
        }
        const geometry::ClipPolygon& polygon = detail.passes.back().after;
        const auto first = static_cast<std::uint32_t>(result->clip.size());
        for (int i = 0; i < polygon.count; ++i) {
            result->clip.push_back(as_array(polygon[i].position));
        }
        for (std::uint32_t i = 0; i + 2 < static_cast<std::uint32_t>(polygon.count); ++i) {
            result->pieces.push_back({t, {first, first + i + 1, first + i + 2}});
        }
    }
    return result;
}

Table piece_table(const Shared& recording) {
    const auto pieces = gather_pieces(*recording);
    Table table{.name = "piece", .rows = pieces->pieces.size(), .columns = {}};
    table.columns.push_back(column<std::uint32_t, 1>("piece.triangle", [pieces](std::size_t row) {
        return std::array{pieces->pieces[row].triangle};
    }));
    table.columns.push_back(column<std::uint32_t, 3>("piece.vertices", [pieces](std::size_t row) {
        return pieces->pieces[row].vertices;
    }));
    return table;
}

Table piece_vertex_table(const Shared& recording) {
    const auto pieces = gather_pieces(*recording);
    Table table{.name = "piece_vertex", .rows = pieces->clip.size(), .columns = {}};
    table.columns.push_back(column<float, 4>("piece_vertex.clip", [pieces](std::size_t row) {
        return pieces->clip[row];
    }));
    return table;
}

} // namespace

std::size_t size_of(ColumnType type) {
    switch (type) {
    case ColumnType::uint8: return 1;
    case ColumnType::uint16: return 2;
    case ColumnType::float32:
    case ColumnType::uint32: return 4;
    case ColumnType::uint64:
    case ColumnType::int64: return 8;
    }
    HS_CHECK(false, "every column type has a size");
    return 0;
}

Result<Table> make_table(const Shared& recording, std::string_view name) {
    struct Known {
        std::string_view name;
        Table (*make)(const Shared&);
    };
    static constexpr std::array<Known, 7> known{{
        {"vertices", vertex_table},
        {"triangles", triangle_table},
        {"fragments", fragment_table},
        {"runs", run_table},
        {"counters", counter_table},
        {"pieces", piece_table},
        {"piece-vertices", piece_vertex_table},
    }};
    for (const Known& table : known) {
        if (table.name == name) {
            return table.make(recording);
        }
    }
    return Diagnostic{
        .message = fmt::format(
            "'{}' is not a table; known are vertices, triangles, fragments, runs, counters, pieces "
            "and piece-vertices",
            name
        )};
}

} // namespace hs::exporting
