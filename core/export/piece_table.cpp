// The polygons that clipping and splitting made: their vertices in clip space, each with its
// weights among the triangle's three vertices.
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

/// Clips the triangle, or a part of it, again. In place of its varyings it carries weights, so that
/// they are interpolated as everything else is.
geometry::ClipPolygon weighted_polygon(
    const pipeline::DrawCall& call, const pipeline::DrawOrder& order, const pipeline::Draw& draw
) {
    const scene::TriangleIndices& indices = call.triangles()[draw.triangle];
    pipeline::TrianglePart part{.weights = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    geometry::ClipPolygon polygon = pipeline::assemble(call, indices);
    if (draw.part >= 0) {
        part = order.parts[static_cast<std::size_t>(draw.part)];
        polygon = pipeline::assemble(call, indices, part).polygon;
    }
    unsigned crossed = 0;
    for (unsigned corner = 0; corner < 3; ++corner) {
        geometry::ClipVertex& vertex = polygon.vertices[corner];
        crossed |=
            call.settings.clip_enabled ? geometry::outcode(call.volume, vertex.position) : 0U;
        vertex.varyings = {};
        for (int k = 0; k < 3; ++k) {
            vertex.varyings[k] = static_cast<float>(part.weights[corner][k]);
        }
    }
    pipeline::NullTrace nothing;
    return geometry::clip_polygon(
        polygon, call.volume, static_cast<geometry::Outcode>(crossed), nothing
    );
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
        const bool clips = call.settings.clip_enabled && !call.settings.draws_unclipped() &&
                           call.settings.visibility != scene::Visibility::ray_cast;
        const bool clipped =
            clips && record.crossed != 0 && record.verdict != geometry::TriangleVerdict::outside;
        for (const std::uint32_t index : recording.draws_of_triangle(t)) {
            const pipeline::Draw& draw = recording.order.draws[index];
            if (draw.triangle >= call.triangles().size()) {
                continue; // of a line there are no pieces
            }
            if (clipped || draw.part >= 0) {
                add_fan(*all, t, weighted_polygon(call, recording.order, draw));
            }
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
