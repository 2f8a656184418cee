// The values of traversals: edge functions at pixels, corners of tiles and samples, and where edges
// meet scanlines.
//
// Traversals that keep running values are explained by what they add where the pixel before has a
// step of its own (incremental, serpentine), and by the closed form, which is the same whole
// number, where it has none.
#include "core/explain/value_list.hpp"
#include "core/raster/conservative.hpp"
#include "core/raster/sample_spans.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace hs::explain {
namespace {

using trace::StepKind;

Whole coefficient(const StepContext& context, unsigned edge, char which) {
    const raster::EdgeFunction& e = context.piece().setup->edges[edge];
    const std::int64_t value = which == 'a' ? e.a : which == 'b' ? e.b : e.c;
    return context.value(
        StepKind::setup, fmt::format("{}.{}", edge_names[edge], which), value, which == 'c' ? 2 : 1
    );
}

/// The pixel a running value came from, and what was added.
struct Neighbor {
    PixelPos pixel;
    char coefficient = 'a';
    bool added = true; ///< false: subtracted
};

/// Empty for the first pixel, which is evaluated, and for traversals that evaluate every one.
std::optional<Neighbor> neighbor_of(const StepContext& context) {
    const scene::TraversalKind traversal = context.call().settings.traversal;
    const bool serpentine = traversal == scene::TraversalKind::serpentine;
    const PixelPos p = context.step.pixel;
    const PixelRect& box = context.piece().setup->bounds;
    if (traversal != scene::TraversalKind::incremental && !serpentine) {
        return std::nullopt;
    }
    const bool leftward = serpentine && (p.y - box.y0) % 2 != 0;
    const int row_begin = leftward ? box.x1 - 1 : box.x0;
    if (p.x != row_begin) {
        return Neighbor{{p.x + (leftward ? 1 : -1), p.y}, 'a', !leftward};
    }
    if (p.y != box.y0) {
        return Neighbor{{p.x, p.y - 1}, 'b'};
    }
    return std::nullopt;
}

/// An edge function where a pixel's edge test has it.
Whole tested_edge(const StepContext& context, unsigned edge) {
    const std::optional<Neighbor> neighbor = neighbor_of(context);
    if (!neighbor) {
        return edge_term(context, edge, context.step.pixel);
    }
    trace::Step before = context.step;
    before.kind = StepKind::edge_test;
    before.pixel = neighbor->pixel;
    const std::string name = edge_names[edge];
    const Whole value = operand(
        fmt::format("{}({}, {})", name, before.pixel.x, before.pixel.y),
        context.piece().setup->edges[edge](before.pixel),
        {trace::step_path(before), name, {}},
        2
    );
    const Whole one_pixel =
        operand("1 px", std::int64_t{subpixel_scale}, {{}, {}, "from pixel to pixel"}, 1);
    const Whole change = coefficient(context, edge, neighbor->coefficient) * one_pixel;
    return neighbor->added ? value + change : value - change;
}

/// Whether a value with its tie rule is inside.
Truth inside(const StepContext& context, unsigned edge, const Whole& value) {
    const bool ties = context.piece().setup->top_left_bias[edge] >= 0;
    return call<bool>(
        ties ? operations::greater_or_equal : operations::greater, value, Whole{std::int64_t{0}}
    );
}

/// "covered": inside all three edges.
void add_covered(ValueList& list, const StepContext& context, const std::vector<Whole>& values) {
    list.add(
        "covered",
        inside(context, 0, values[0]) && inside(context, 1, values[1]) &&
            inside(context, 2, values[2])
    );
}

const Operation absolute{"abs", 0, UnitRule::first, [](std::span<const Number> n) -> Number {
                             return std::abs(std::get<std::int64_t>(n[0]));
                         }};

/// The corner of the pixel's square that lies most inside.
void add_square(ValueList& list, const StepContext& context, const std::vector<Whole>& center) {
    const Whole half = operand(
        "½ px", std::int64_t{subpixel_scale / 2}, {{}, {}, "half a pixel to the square's side"}, 1
    );
    std::vector<Truth> overlaps;
    for (unsigned k = 0; k < 3; ++k) {
        const Whole reach = call<std::int64_t>(absolute, coefficient(context, k, 'a')) +
                            call<std::int64_t>(absolute, coefficient(context, k, 'b'));
        const Whole corner =
            list.add(fmt::format("{} corner", edge_names[k]), center[k] + reach * half);
        overlaps.push_back(call<bool>(operations::greater, corner, Whole{std::int64_t{0}}));
    }
    list.add("covered", overlaps[0] && overlaps[1] && overlaps[2]);
}

// ---- scanlines

const Operation quotient_up{
    "⌈ / ⌉", 0, UnitRule::quotient, [](std::span<const Number> n) -> Number {
        const auto a = std::get<std::int64_t>(n[0]);
        const auto b = std::get<std::int64_t>(n[1]);
        return a / b + (a % b > 0 ? 1 : 0); // b > 0; division is toward zero
    }};

/// What an edge function gains from a pixel's center to one of its samples.
Whole gain_to_sample(const StepContext& context, unsigned edge, int sample) {
    const auto& offset =
        raster::sample_pattern(context.call().settings.samples)[static_cast<std::size_t>(sample)];
    const std::string place = fmt::format("the place of sample {}", sample);
    const Whole dx = operand("dx", std::int64_t{offset.x}, {{}, {}, place}, 1);
    const Whole dy = operand("dy", std::int64_t{offset.y}, {{}, {}, place}, 1);
    return coefficient(context, edge, 'a') * dx + coefficient(context, edge, 'b') * dy;
}

/// The first pixel not left of an edge, on a scanline: −(b·y + c) / a rounded up. Where scanlines
/// run through a sample, the edge function is that at the sample.
Whole add_crossing(ValueList& list, const StepContext& context, unsigned edge, int row) {
    const bool left = context.piece().setup->edges[edge].a > 0;
    const Whole one_pixel =
        operand("1 px", std::int64_t{subpixel_scale}, {{}, {}, "from pixel to pixel"}, 1);
    const Whole y = operand("y", std::int64_t{row} * subpixel_scale, {{}, {}, "the scanline"}, 1);
    Whole c = coefficient(context, edge, 'c');
    if (context.step.sample >= 0) {
        c = c + gain_to_sample(context, edge, context.step.sample);
    }
    const Whole rest = coefficient(context, edge, 'b') * y + c;
    const Whole a = coefficient(context, edge, 'a');
    return list.add(
        fmt::format("{}.x", edge_names[edge]),
        call<std::int64_t>(quotient_up, left ? -rest : rest, (left ? a : -a) * one_pixel)
    );
}

template <typename Table>
void add_crossings(
    ValueList& list, const StepContext& context, const Table& table, bool at_bucket
) {
    for (int i = 0; i < table.count; ++i) {
        const raster::ScanEdge& edge = table.edges[static_cast<unsigned>(i)];
        add_crossing(
            list,
            context,
            static_cast<unsigned>(edge.edge),
            at_bucket ? edge.first_row : context.step.pixel.y
        );
    }
}

/// What cuts the step's spans: the pixels whose centers, or whose sample, the triangle can cover.
PixelRect box_of_spans(const StepContext& context) {
    const raster::TriangleSetup& setup = *context.piece().setup;
    if (context.step.sample < 0) {
        return setup.bounds;
    }
    const int samples = context.call().settings.samples;
    raster::SampledSetup sampled = raster::at_samples(setup, samples);
    sampled.bounds = raster::bounds_of_samples(setup, samples, context.call().drawable());
    return raster::scan_of_sample(sampled, context.step.sample).setup.bounds;
}

void add_span(ValueList& list, const StepContext& context, const raster::Span& span) {
    const PixelRect box = box_of_spans(context);
    const auto side = [&](const char* name, int value) {
        return operand(name, std::int64_t{value}, {{}, {}, "bounding box of the triangle"});
    };
    const Whole left = add_crossing(list, context, static_cast<unsigned>(span.left.edge), span.row);
    const Whole right =
        add_crossing(list, context, static_cast<unsigned>(span.right.edge), span.row);
    list.add("first", call<std::int64_t>(operations::larger, left, side("box left", box.x0)));
    list.add("end", call<std::int64_t>(operations::smaller, right, side("box right", box.x1)));
}

/// Whether every pixel, and every one of its samples, had a step of its own before it became a
/// fragment. Rows of the image ask no edge functions.
bool asks_every_pixel(const scene::Settings& settings) {
    using scene::TraversalKind;
    return !settings.sweeps() && (settings.traversal == TraversalKind::brute_force ||
                                  settings.traversal == TraversalKind::bounding_box ||
                                  settings.traversal == TraversalKind::incremental ||
                                  settings.traversal == TraversalKind::serpentine);
}

} // namespace

Whole edge_term(const StepContext& context, unsigned edge, PixelPos pixel) {
    return coefficient(context, edge, 'a') * pixel_coordinate("x", pixel.x) +
           coefficient(context, edge, 'b') * pixel_coordinate("y", pixel.y) +
           coefficient(context, edge, 'c');
}

Whole sample_edge_term(const StepContext& context, unsigned edge, PixelPos pixel, int sample) {
    return edge_term(context, edge, pixel) + gain_to_sample(context, edge, sample);
}

Whole add_edge_value(ValueList& list, const StepContext& context, unsigned edge) {
    const scene::Settings& settings = context.call().settings;
    const PixelPos pixel = context.step.pixel;
    const int sample = context.step.sample;
    const std::string name = edge_names[edge];
    const bool asked = asks_every_pixel(settings);
    if (sample >= 0) {
        return asked ? context.value(
                           StepKind::sample_test,
                           name,
                           context.detail.samples[static_cast<std::size_t>(sample)].edges[edge],
                           2
                       )
                     : list.add(name, sample_edge_term(context, edge, pixel, sample));
    }
    return asked && settings.samples == 1
               ? context.value(StepKind::edge_test, name, context.detail.fragment->edges[edge], 2)
               : list.add(name, edge_term(context, edge, pixel));
}

void add_edge_test_values(ValueList& list, const StepContext& context) {
    std::vector<Whole> values;
    for (unsigned k = 0; k < 3; ++k) {
        values.push_back(list.add(edge_names[k], tested_edge(context, k)));
    }
    if (context.call().settings.sampling == scene::Sampling::conservative) {
        add_square(list, context, values);
    } else {
        add_covered(list, context, values);
    }
}

void add_sample_test_values(ValueList& list, const StepContext& context) {
    std::vector<Whole> values;
    for (unsigned k = 0; k < 3; ++k) {
        const Whole center = list.add(
            fmt::format("{} at center", edge_names[k]), edge_term(context, k, context.step.pixel)
        );
        values.push_back(
            list.add(edge_names[k], center + gain_to_sample(context, k, context.step.sample))
        );
    }
    add_covered(list, context, values);
}

void add_tile_values(ValueList& list, const StepContext& context) {
    const PixelRect& pixels = context.detail.traversal->tile->pixels;
    const PixelPos last{pixels.x1 - 1, pixels.y1 - 1};
    const std::array<std::pair<const char*, PixelPos>, 4> corners{
        {{"top left", {pixels.x0, pixels.y0}},
         {"top right", {last.x, pixels.y0}},
         {"bottom left", {pixels.x0, last.y}},
         {"bottom right", last}}};
    for (const auto& [name, pixel] : corners) {
        for (unsigned k = 0; k < 3; ++k) {
            list.add(fmt::format("{} {}", name, edge_names[k]), edge_term(context, k, pixel));
        }
    }
}

void add_scan_values(ValueList& list, const StepContext& context) {
    const trace::TraversalDetail& detail = *context.detail.traversal;
    if (context.step.kind == StepKind::edge_table) {
        add_crossings(list, context, *detail.edge_table, true);
    } else if (context.step.kind == StepKind::active_edges) {
        add_crossings(list, context, *detail.active, false);
    } else {
        add_span(list, context, *detail.span);
    }
}

} // namespace hs::explain
