#include "core/trace/quad_detail.hpp"

#include "core/pipeline/draw.hpp"
#include "core/raster/sample_coverage.hpp"

namespace hs::trace {
namespace {

/// What pieces are fanned from, and the number of the first.
struct Fan {
    geometry::ClipPolygon polygon;
    int first_piece = 0;
};

/// The triangle, or the part of it that the step draws, after clipping.
Fan fan_of(const Recording& recording, const TriangleDetail& triangle, const Step& step) {
    const pipeline::DrawCall& call = recording.frame->calls()[step.object];
    const pipeline::Draw& draw = recording.order.draws[recording.draw_of_step(step.id)];
    Fan fan;
    if (draw.part < 0) {
        fan.polygon = pipeline::assemble(call, triangle.vertices);
    } else {
        const auto index = static_cast<std::size_t>(draw.part);
        const pipeline::TrianglePart& part = recording.order.parts[index];
        fan.polygon = pipeline::assemble(call, triangle.vertices, part).polygon;
        fan.first_piece = part.first_piece;
    }
    if (!triangle.passes.empty()) {
        fan.polygon = triangle.passes.back().after;
    }
    return fan;
}

/// What is interpolated over a piece. The polygon owns the varyings.
raster::Interpolator interpolator_of(
    const pipeline::DrawCall& call,
    const geometry::ClipPolygon& polygon,
    const PieceDetail& piece,
    int number
) {
    pipeline::Piece fan{.window = piece.window};
    const std::array<int, 3> corners{0, number + 1, number + 2};
    for (unsigned k = 0; k < 3; ++k) {
        fan.varyings[k] = polygon[corners[k]].varyings.values.data();
    }
    return raster::Interpolator(pipeline::interpolants_of(call, fan));
}

/// Whether a piece makes a fragment of a pixel.
class Covers {
public:
    Covers(const pipeline::DrawCall& call, const raster::TriangleSetup& setup)
        : setup_(setup),
          region_(intersect(setup.bounds, call.drawable())),
          samples_(raster::sample_steps(setup, call.settings.samples)) {}

    [[nodiscard]] bool operator()(PixelPos pixel) const {
        return region_.contains(pixel) &&
               raster::covered_samples(setup_, samples_, setup_.evaluate(pixel)) != 0;
    }
    [[nodiscard]] const PixelRect& region() const { return region_; }

private:
    const raster::TriangleSetup& setup_;
    PixelRect region_;
    raster::SampleSteps samples_;
};

const PieceDetail* piece_of(const TriangleDetail& triangle, const Step& step) {
    const auto number = static_cast<std::size_t>(step.piece);
    const bool exists = step.has_piece() && number < triangle.pieces.size();
    return exists && triangle.pieces[number].setup ? &triangle.pieces[number] : nullptr;
}

} // namespace

std::optional<QuadDetail>
quad_detail(const Recording& recording, const TriangleDetail& triangle, const Step& step) {
    const PieceDetail* piece = piece_of(triangle, step);
    if (piece == nullptr || !step.has_pixel() || recording.in_row(step.id)) {
        return std::nullopt;
    }
    const pipeline::DrawCall& call = recording.frame->calls()[step.object];
    const Fan fan = fan_of(recording, triangle, step);
    QuadDetail detail;
    detail.layout = call.vertex.layout;
    detail.quad = raster::make_quad(
        *piece->setup,
        interpolator_of(call, fan.polygon, *piece, step.piece - fan.first_piece),
        step.pixel,
        Covers(call, *piece->setup)
    );
    detail.coarse = raster::coarse_derivatives(detail.quad);
    detail.fine = raster::fine_derivatives(detail.quad, step.pixel);
    return detail;
}

HelperPixels helper_pixels(
    const Recording& recording,
    const TriangleDetail& triangle,
    const Step& step,
    std::size_t most_pixels
) {
    HelperPixels result;
    const PieceDetail* piece = piece_of(triangle, step);
    if (piece == nullptr || recording.in_row(step.id)) {
        return result;
    }
    const Covers covers(recording.frame->calls()[step.object], *piece->setup);
    const PixelRect& region = covers.region();
    const auto area =
        static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height());
    if (area > most_pixels) {
        result.whole = false;
        return result;
    }
    const PixelPos first = raster::quad_origin({region.x0, region.y0});
    for (int y = first.y; y < region.y1; y += 2) {
        for (int x = first.x; x < region.x1; x += 2) {
            std::vector<PixelPos> uncovered;
            for (const PixelPos p : {PixelPos{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) {
                if (!covers(p)) {
                    uncovered.push_back(p);
                }
            }
            if (uncovered.size() < 4) {
                result.covered += 4 - uncovered.size();
                result.helpers.insert(result.helpers.end(), uncovered.begin(), uncovered.end());
            }
        }
    }
    return result;
}

} // namespace hs::trace
