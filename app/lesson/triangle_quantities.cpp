// A triangle in the window: its area, its verdict, its three edge functions.
#include "app/lesson/quantity.hpp"
#include "core/trace/detail.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace hs::lesson {

namespace {

using trace::PieceDetail;
using trace::Recording;
using trace::TriangleDetail;

/// Edge values and doubled areas are in 1/65536 pixel².
constexpr double pixel_square = 65536.0;

TriangleDetail detail(const Recording& recording, const Subject& subject) {
    return trace::triangle_detail(recording, *subject.object, *subject.triangle);
}

Diagnostic complain(const Subject& subject, std::string_view what) {
    return {
        "",
        0,
        0,
        fmt::format("triangle {} of object {} {}", *subject.triangle, *subject.object, what)};
}

/// Of the piece written, or the only one.
Result<PieceDetail> find_piece(const Recording& recording, const Subject& subject) {
    const TriangleDetail triangle = detail(recording, subject);
    const std::uint32_t piece = subject.piece.value_or(0);
    if (piece >= triangle.pieces.size()) {
        return complain(subject, "did not reach the window");
    }
    return triangle.pieces[piece];
}

Result<raster::TriangleSetup> find_setup(const Recording& recording, const Subject& subject) {
    const Result<PieceDetail> piece = find_piece(recording, subject);
    if (!piece) {
        return piece.diagnostics();
    }
    if (!piece->setup) {
        return complain(subject, "was not set up");
    }
    return *piece->setup;
}

Result<Value> verdict(const Recording& recording, const Subject& subject) {
    return Value{std::string{name_of(detail(recording, subject).verdict)}};
}

Result<Value> pieces(const Recording& recording, const Subject& subject) {
    return Value{static_cast<double>(detail(recording, subject).pieces.size())};
}

template <int scale>
Result<Value> signed_area(const Recording& recording, const Subject& subject) {
    const Result<PieceDetail> piece = find_piece(recording, subject);
    if (!piece) {
        return piece.diagnostics();
    }
    return Value{static_cast<double>(piece->signed_doubled_area) / pixel_square * scale / 2};
}

Result<Value> facing(const Recording& recording, const Subject& subject) {
    const Result<PieceDetail> piece = find_piece(recording, subject);
    if (!piece) {
        return piece.diagnostics();
    }
    if (piece->signed_doubled_area == 0) {
        return Value{std::string{"edge-on"}};
    }
    const scene::Settings& settings = recording.frame->calls()[*subject.object].settings;
    const bool front = geometry::is_front(piece->signed_doubled_area, settings.front_face);
    return Value{std::string{front ? "front" : "back"}};
}

/// Coefficients per pixel: a and b count in 1/256 pixel, c in 1/65536 pixel².
template <int edge, char coefficient>
Result<Value> edge_coefficient(const Recording& recording, const Subject& subject) {
    const Result<raster::TriangleSetup> setup = find_setup(recording, subject);
    if (!setup) {
        return setup.diagnostics();
    }
    const raster::EdgeFunction& e = setup->edges[edge];
    if constexpr (coefficient == 'c') {
        return Value{static_cast<double>(e.c) / pixel_square};
    } else {
        return Value{static_cast<double>(coefficient == 'a' ? e.a : e.b) / subpixel_scale};
    }
}

template <int edge>
Result<Value> edge_owns(const Recording& recording, const Subject& subject) {
    const Result<raster::TriangleSetup> setup = find_setup(recording, subject);
    return setup ? Result<Value>{Value{setup->edges[edge].owns_ties()}} : setup.diagnostics();
}

template <int edge>
Result<Value> edge_value(const Recording& recording, const Subject& subject) {
    const Result<raster::TriangleSetup> setup = find_setup(recording, subject);
    if (!setup) {
        return setup.diagnostics();
    }
    return Value{static_cast<double>(setup->evaluate(*subject.pixel)[edge]) / pixel_square};
}

/// The pixels of a piece whose edge values satisfy a rule.
template <typename Rule>
void add_pixels(const raster::TriangleSetup& setup, Rule covers, std::vector<PixelPos>& pixels) {
    for (int y = setup.bounds.y0; y < setup.bounds.y1; ++y) {
        for (int x = setup.bounds.x0; x < setup.bounds.x1; ++x) {
            if (covers(setup, setup.evaluate({x, y}))) {
                pixels.push_back({x, y});
            }
        }
    }
}

/// The same of all pieces.
template <typename Rule>
Result<Value> select_pixels(const Recording& recording, const Subject& subject, Rule covers) {
    std::vector<PixelPos> pixels;
    for (const PieceDetail& piece : detail(recording, subject).pieces) {
        if (piece.setup) {
            add_pixels(*piece.setup, covers, pixels);
        }
    }
    return Value{make_pixel_set(std::move(pixels))};
}

Result<Value> covered_pixels(const Recording& recording, const Subject& subject) {
    return select_pixels(
        recording,
        subject,
        [](const raster::TriangleSetup& setup, const raster::EdgeValues& e) {
            return setup.covers(e);
        }
    );
}

/// What "all three ≥ 0" would cover.
Result<Value> touched_pixels(const Recording& recording, const Subject& subject) {
    return select_pixels(
        recording,
        subject,
        [](const raster::TriangleSetup& /*setup*/, const raster::EdgeValues& e) {
            return e[0] >= 0 && e[1] >= 0 && e[2] >= 0;
        }
    );
}

/// What "all three > 0" would cover.
Result<Value> inner_pixels(const Recording& recording, const Subject& subject) {
    return select_pixels(
        recording,
        subject,
        [](const raster::TriangleSetup& /*setup*/, const raster::EdgeValues& e) {
            return e[0] > 0 && e[1] > 0 && e[2] > 0;
        }
    );
}

Result<Value> box_pixels(const Recording& recording, const Subject& subject) {
    return select_pixels(
        recording,
        subject,
        [](const raster::TriangleSetup& /*setup*/, const raster::EdgeValues& /*e*/) { return true; }
    );
}

Result<Value> covered(const Recording& recording, const Subject& subject) {
    for (const PieceDetail& piece : detail(recording, subject).pieces) {
        if (piece.setup && piece.setup->bounds.contains(*subject.pixel) &&
            piece.setup->covers(piece.setup->evaluate(*subject.pixel))) {
            return Value{true};
        }
    }
    return Value{false};
}

constexpr QuantityOf of = QuantityOf::triangle;
constexpr QuantityOf at = QuantityOf::triangle_pixel;

constexpr std::array<Quantity, 25> rows{{
    {"verdict", of, "what became of the triangle", verdict},
    {"facing", of, "front or back", facing},
    {"pieces", of, "triangles it was divided into by clipping", pieces},
    {"signed area", of, "in pixel², positive when counterclockwise as seen", signed_area<1>},
    {"signed doubled area", of, "twice that, what the edge functions add up to", signed_area<2>},
    {"E01.a", of, "what edge function 01 changes by per pixel in x", edge_coefficient<0, 'a'>},
    {"E01.b", of, "what edge function 01 changes by per pixel in y", edge_coefficient<0, 'b'>},
    {"E01.c", of, "edge function 01 at the center of pixel 0,0", edge_coefficient<0, 'c'>},
    {"E12.a", of, "what edge function 12 changes by per pixel in x", edge_coefficient<1, 'a'>},
    {"E12.b", of, "what edge function 12 changes by per pixel in y", edge_coefficient<1, 'b'>},
    {"E12.c", of, "edge function 12 at the center of pixel 0,0", edge_coefficient<1, 'c'>},
    {"E20.a", of, "what edge function 20 changes by per pixel in x", edge_coefficient<2, 'a'>},
    {"E20.b", of, "what edge function 20 changes by per pixel in y", edge_coefficient<2, 'b'>},
    {"E20.c", of, "edge function 20 at the center of pixel 0,0", edge_coefficient<2, 'c'>},
    {"E01.owns ties", of, "whether the edge is a top or a left edge", edge_owns<0>},
    {"E12.owns ties", of, "whether the edge is a top or a left edge", edge_owns<1>},
    {"E20.owns ties", of, "whether the edge is a top or a left edge", edge_owns<2>},
    {"covered pixels", of, "the pixels it covers", covered_pixels},
    {"touched pixels", of, "pixels with no negative edge value, ties on any edge", touched_pixels},
    {"inner pixels", of, "pixels with three positive edge values, no ties", inner_pixels},
    {"box pixels", of, "pixels of its bounding box", box_pixels},
    {"E01", at, "edge function 01 at the pixel's center, in pixel²", edge_value<0>},
    {"E12", at, "edge function 12 at the pixel's center, in pixel²", edge_value<1>},
    {"E20", at, "edge function 20 at the pixel's center, in pixel²", edge_value<2>},
    {"covered", at, "whether the triangle covers the pixel", covered},
}};

} // namespace

std::span<const Quantity> triangle_quantities() {
    return rows;
}

} // namespace hs::lesson
