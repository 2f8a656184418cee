// Every triangle with its verdict, in file order.
#include "core/export/column.hpp"

namespace hs::exporting {
namespace {

/// Where a row of the frame-wide table comes from.
struct TriangleRow {
    std::uint32_t object;
    std::uint32_t triangle;
    const scene::Mesh& mesh;
};

TriangleRow triangle_row(const trace::Recording& recording, std::size_t row) {
    const auto number = static_cast<std::uint32_t>(row);
    const std::uint32_t object = recording.object_of_triangle(number);
    return {
        object,
        number - recording.objects[object].first_triangle,
        *recording.frame->calls()[object].vertex.mesh};
}

} // namespace

Table triangle_table(const SharedRecording& recording) {
    Table table{.name = "triangles", .rows = recording->triangles.size(), .columns = {}};
    table.columns.push_back(column<std::uint32_t>(
        "triangle.object_index",
        [recording](std::size_t row) { return triangle_row(*recording, row).object; }
    ));
    table.columns.push_back(column<std::uint32_t>("triangle.face", [recording](std::size_t row) {
        const TriangleRow at = triangle_row(*recording, row);
        const scene::Primitive primitive = at.mesh.primitive(at.triangle);
        const bool triangle = primitive.kind == scene::PrimitiveKind::triangle;
        return triangle ? at.mesh.triangle_polygon[at.triangle] : primitive.number;
    }));
    table.columns
        .push_back(column<std::uint32_t, 3>("triangle.vertices", [recording](std::size_t row) {
            const TriangleRow at = triangle_row(*recording, row);
            const scene::TriangleIndices corners = at.mesh.primitive(at.triangle).vertices;
            const std::uint32_t first = recording->objects[at.object].first_vertex;
            return std::array{first + corners.a, first + corners.b, first + corners.c};
        }));
    table.columns.push_back(named_column<scene::PrimitiveKind>(
        "triangle.primitive",
        [recording](std::size_t row) {
            const TriangleRow at = triangle_row(*recording, row);
            return at.mesh.primitive(at.triangle).kind;
        }
    ));
    table.columns.push_back(named_column<geometry::TriangleVerdict>(
        "triangle.verdict",
        [recording](std::size_t row) { return recording->triangles[row].verdict; }
    ));
    table.columns.push_back(column<std::uint8_t>(
        "triangle.clip_planes",
        [recording](std::size_t row) { return recording->triangles[row].crossed; }
    ));
    table.columns.push_back(column<std::uint64_t>(
        "triangle.first_step",
        [recording](std::size_t row) { return recording->triangles[row].first_step; }
    ));
    return table;
}

} // namespace hs::exporting
