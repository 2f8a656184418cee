// Every vertex in every space. Clip coordinates are kept by the recording; earlier spaces are
// computed again as they are asked for.
#include "core/export/column.hpp"

#include <algorithm>
#include <limits>

namespace hs::exporting {
namespace {

using trace::Recording;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Where a row of the frame-wide table comes from.
struct VertexRow {
    std::uint32_t object;
    std::uint32_t vertex;
};

VertexRow vertex_row(const Recording& recording, std::size_t row) {
    const auto after = std::upper_bound(
        recording.objects.begin(),
        recording.objects.end(),
        row,
        [](std::size_t r, const trace::ObjectRange& object) { return r < object.first_vertex; }
    );
    const trace::ObjectRange& object = *(after - 1);
    return {
        static_cast<std::uint32_t>(&object - recording.objects.data()),
        static_cast<std::uint32_t>(row) - object.first_vertex};
}

/// A column of one space on the vertex's way; `pick` takes it from the vertex's work.
template <typename Pick>
Column space_column(const SharedRecording& recording, std::string name, Pick pick) {
    return column<float, 4>(std::move(name), [recording, pick](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        const pipeline::DrawCall& call = recording->frame->calls()[at.object];
        return as_array(pick(pipeline::run_vertex(call.vertex, at.vertex)));
    });
}

/// NDC or window coordinates; not a number where w <= 0 or dividing by it overflows.
template <typename Pick>
Column place_column(const SharedRecording& recording, std::string name, Pick pick) {
    return column<float, 3>(std::move(name), [recording, pick](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        const pipeline::DrawCall& call = recording->frame->calls()[at.object];
        const math::ClipPosition& clip = call.vertices[at.vertex].clip;
        const geometry::WindowVertex place = geometry::to_window(clip, call.viewport);
        if (!(clip.w > 0.0F) || place.status == geometry::WindowStatus::at_eye) {
            return std::array{not_a_number, not_a_number, not_a_number};
        }
        return pick(place);
    });
}

/// A varying; not a number for objects whose shading has no use for it. `start` finds its place.
template <std::size_t N, typename Start>
Column varying_column(const SharedRecording& recording, std::string name, Start start) {
    return column<float, N>(std::move(name), [recording, start](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        const pipeline::DrawCall& call = recording->frame->calls()[at.object];
        std::array<float, N> values{};
        values.fill(not_a_number);
        const int first = start(call.vertex.layout);
        if (first >= 0) {
            std::copy_n(call.varyings_of(at.vertex) + first, N, values.begin());
        }
        return values;
    });
}

void add_spaces(Table& table, const SharedRecording& recording) {
    using geometry::WindowVertex;
    using pipeline::VertexWork;
    std::vector<Column>& columns = table.columns;
    columns.push_back(space_column(recording, "vertex.object", [](const VertexWork& w) {
        return w.object;
    }));
    columns.push_back(space_column(recording, "vertex.world", [](const VertexWork& w) {
        return w.world;
    }));
    columns.push_back(space_column(recording, "vertex.eye", [](const VertexWork& w) {
        return w.eye;
    }));
    columns.push_back(column<float, 4>("vertex.clip", [recording](std::size_t row) {
        const VertexRow at = vertex_row(*recording, row);
        return as_array(recording->frame->calls()[at.object].vertices[at.vertex].clip);
    }));
    columns.push_back(place_column(recording, "vertex.ndc", [](const WindowVertex& v) {
        return std::array{v.ndc.x, v.ndc.y, v.ndc.z};
    }));
    columns.push_back(place_column(recording, "vertex.window", [](const WindowVertex& v) {
        return std::array{v.window.x, v.window.y, v.window.depth};
    }));
}

void add_varyings(Table& table, const SharedRecording& recording) {
    using math::VaryingLayout;
    const auto used = [&recording](int VaryingLayout::*start) {
        const auto& calls = recording->frame->calls();
        return std::any_of(calls.begin(), calls.end(), [start](const pipeline::DrawCall& call) {
            return call.vertex.layout.*start >= 0;
        });
    };
    table.columns.push_back(varying_column<4>(recording, "vertex.color", [](const VaryingLayout&) {
        return 0;
    }));
    if (used(&VaryingLayout::uv)) {
        table.columns.push_back(varying_column<2>(recording, "vertex.uv", [](const auto& layout) {
            return layout.uv;
        }));
    }
    if (used(&VaryingLayout::normal)) {
        table.columns.push_back(varying_column<3>(
            recording, "vertex.eye_normal", [](const auto& layout) { return layout.normal; }
        ));
    }
}

} // namespace

Table vertex_table(const SharedRecording& recording) {
    Table table{.name = "vertices", .rows = 0, .columns = {}};
    for (const trace::ObjectRange& object : recording->objects) {
        table.rows += object.vertex_count;
    }
    table.columns.push_back(column<std::uint32_t>(
        "vertex.object_index",
        [recording](std::size_t row) { return vertex_row(*recording, row).object; }
    ));
    add_spaces(table, recording);
    add_varyings(table, recording);
    return table;
}

} // namespace hs::exporting
