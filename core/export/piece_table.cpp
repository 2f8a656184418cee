// The polygons clipping made: their vertices in clip space, each with its weights among the
// triangle's three vertices.
#include "core/export/column.hpp"
#include "core/pipeline/draw.hpp"

namespace hs::exporting {
namespace {

struct Piece {
    std::uint32_t triangle; ///< over the whole frame
    std::array<std::uint32_t, 3> vertices;
};

struct PieceVertex {
    std::array<float, 4> clip;
    std::array<float, 3> weights;
};

/// All of a frame, gathered once: few triangles cross a plane.
struct Pieces {
    std::vector<Piece> pieces;
    std::vector<PieceVertex> vertices;
};

/// Clips the triangle again. In place of its varyings it carries weights, so that they are
/// interpolated as everything else is.
geometry::ClipPolygon weighted_polygon(
    const pipeline::DrawCall& call, std::uint32_t triangle, geometry::Outcode crossed
) {
    geometry::ClipPolygon polygon = pipeline::assemble(call, call.triangles()[triangle]);
    for (unsigned corner = 0; corner < 3; ++corner) {
        polygon.vertices[corner].varyings = {};
        polygon.vertices[corner].varyings[static_cast<int>(corner)] = 1.0F;
    }
    pipeline::NullTrace nothing;
    return geometry::clip_polygon(polygon, call.volume, crossed, nothing);
}

void add_fan(Pieces& all, std::uint32_t triangle, const geometry::ClipPolygon& polygon) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (int i = 0; i < polygon.count; ++i) {
        const math::Varyings& weights = polygon[i].varyings;
        all.vertices.push_back({as_array(polygon[i].position), {weights[0], weights[1], weights[2]}}
        );
    }
    for (std::uint32_t i = 1; i + 1 < static_cast<std::uint32_t>(polygon.count); ++i) {
        all.pieces.push_back({triangle, {first, first + i, first + i + 1}});
    }
}

std::shared_ptr<const Pieces> gather(const trace::Recording& recording) {
    auto all = std::make_shared<Pieces>();
    for (std::uint32_t t = 0; t < recording.triangles.size(); ++t) {
        const trace::TriangleRecord& record = recording.triangles[t];
        const std::uint32_t object = recording.object_of_triangle(t);
        const pipeline::DrawCall& call = recording.frame->calls()[object];
        const bool clips = call.settings.clip_enabled &&
                           call.settings.traversal != scene::TraversalKind::homogeneous;
        const bool clipped =
            clips && record.crossed != 0 && record.verdict != geometry::TriangleVerdict::outside;
        if (clipped) {
            const std::uint32_t own = t - recording.objects[object].first_triangle;
            add_fan(*all, t, weighted_polygon(call, own, record.crossed));
        }
    }
    return all;
}

} // namespace

PieceTables piece_tables(const SharedRecording& recording) {
    const std::shared_ptr<const Pieces> all = gather(*recording);
    PieceTables tables{
        .pieces = {.name = "pieces", .rows = all->pieces.size(), .columns = {}},
        .vertices = {.name = "piece-vertices", .rows = all->vertices.size(), .columns = {}}};
    std::vector<Column>& pieces = tables.pieces.columns;
    pieces.push_back(column<std::uint32_t>("piece.triangle", [all](std::size_t row) {
        return all->pieces[row].triangle;
    }));
    pieces.push_back(column<std::uint32_t, 3>("piece.vertices", [all](std::size_t row) {
        return all->pieces[row].vertices;
    }));
    std::vector<Column>& vertices = tables.vertices.columns;
    vertices.push_back(column<float, 4>("piece_vertex.clip", [all](std::size_t row) {
        return all->vertices[row].clip;
    }));
    vertices.push_back(column<float, 3>("piece_vertex.weights", [all](std::size_t row) {
        return all->vertices[row].weights;
    }));
    return tables;
}

} // namespace hs::exporting
