// Counts of the frame, of an object or of a triangle, and what the finished picture holds.
#include "app/lesson/quantity.hpp"
#include "core/trace/history.hpp"
#include "core/trace/player.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace hs::lesson {

namespace {

using trace::Counters;
using trace::Recording;

/// Not owned: the player's interface wants a shared recording, the caller's outlives it.
Counters counters_at(const Recording& recording, trace::StepId step) {
    trace::Player player(std::shared_ptr<const Recording>(std::shared_ptr<void>{}, &recording));
    player.seek(step);
    return player.counters();
}

/// How a counter grew over a frame, an object's triangles, or one triangle.
template <typename Count>
Result<Value> count(const Recording& recording, const Subject& subject, Count counter) {
    if (!subject.object && !subject.triangle) {
        return Value{static_cast<double>(counter(recording.counters))};
    }
    const trace::ObjectRange& object = recording.objects[subject.object.value_or(0)];
    if (object.triangle_count == 0) {
        return Value{0.0};
    }
    const std::uint32_t first = object.first_triangle + subject.triangle.value_or(0);
    const std::uint32_t last = subject.triangle ? first : first + object.triangle_count - 1;

    // Stretches of its draws: an order may scatter them
    const auto belongs = [&](std::uint32_t draw) {
        if (recording.order.draws[draw].row >= 0) {
            return false; // of all triangles
        }
        const std::uint32_t triangle = recording.triangle_of_draw(recording.order.draws[draw]);
        return triangle >= first && triangle <= last;
    };
    const auto draws = static_cast<std::uint32_t>(recording.order.draws.size());
    double sum = 0.0;
    for (std::uint32_t draw = 0; draw < draws; ++draw) {
        const bool begins = belongs(draw) && (draw == 0 || !belongs(draw - 1));
        const bool ends = belongs(draw) && (draw + 1 == draws || !belongs(draw + 1));
        if (begins) {
            const trace::StepId before = recording.draw_steps[draw] - 1;
            sum -= static_cast<double>(counter(counters_at(recording, before)));
        }
        if (ends) {
            const trace::StepId after = trace::last_step_of_draw(recording, draw);
            sum += static_cast<double>(counter(counters_at(recording, after)));
        }
    }
    return Value{sum};
}

template <auto member>
Result<Value> counted(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& counters) { return counters.*member; });
}

Result<Value> visits(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& c) { return c.traversal.pixels; });
}

Result<Value> tile_tests(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& c) { return c.traversal.tiles; });
}

Result<Value> multiplications(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& c) {
        return c.traversal.multiplications();
    });
}

Result<Value> additions(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& c) { return c.traversal.additions(); });
}

template <fragment::FragmentFate fate>
Result<Value> fated(const Recording& recording, const Subject& subject) {
    return count(recording, subject, [](const Counters& counters) {
        return counters.fates[static_cast<std::size_t>(fate)];
    });
}

/// Ordering comes before the first triangle: the frame's, whatever the subject is.
template <visibility::OrderEventKind kind>
Result<Value> decided(const Recording& recording, const Subject& /*subject*/) {
    return Value{static_cast<double>(recording.counters.decisions[static_cast<std::size_t>(kind)])};
}

Result<Value> depth_sort_tests(const Recording& recording, const Subject& /*subject*/) {
    const auto of = [&](visibility::OrderEventKind kind) {
        return recording.counters.decisions[static_cast<std::size_t>(kind)];
    };
    using enum visibility::OrderEventKind;
    return Value{static_cast<double>(of(test) + of(exchanged_test))};
}

Result<Value> place_in_order(const Recording& recording, const Subject& subject) {
    const trace::ObjectRange& object = recording.objects[subject.object.value_or(0)];
    const std::uint32_t triangle = object.first_triangle + *subject.triangle;
    const std::vector<pipeline::Draw>& draws = recording.order.draws;
    const auto first = std::ranges::find_if(draws, [&](const pipeline::Draw& draw) {
        return recording.triangle_of_draw(draw) == triangle;
    });
    return first == draws.end() ? Value{0.0}
                                : Value{static_cast<double>(first - draws.begin()) + 1.0};
}

Result<Value> decisions(const Recording& recording, const Subject& /*subject*/) {
    return Value{static_cast<double>(recording.decisions.size())};
}

Result<Value> vertices(const Recording& recording, const Subject& subject) {
    return subject.object
               ? Value{static_cast<double>(recording.objects[*subject.object].vertex_count)}
               : Value{static_cast<double>(recording.counters.vertices)};
}

Result<Value> image_width(const Recording& recording, const Subject& /*subject*/) {
    return Value{static_cast<double>(recording.width())};
}

Result<Value> image_height(const Recording& recording, const Subject& /*subject*/) {
    return Value{static_cast<double>(recording.height())};
}

const trace::PixelRecord& pixel(const Recording& recording, const Subject& subject) {
    return recording.final_pixels[*subject.pixel];
}

Result<Value> pixel_depth(const Recording& recording, const Subject& subject) {
    return Value{static_cast<double>(pixel(recording, subject).depth)};
}

template <int channel>
Result<Value> pixel_color(const Recording& recording, const Subject& subject) {
    const glm::vec4 color = trace::pixel_history(recording, *subject.pixel, 1).final_color;
    return Value{static_cast<double>(color[channel])};
}

Result<Value> pixel_fragments(const Recording& recording, const Subject& subject) {
    return Value{static_cast<double>(pixel(recording, subject).complexity)};
}

Result<Value> pixel_triangle(const Recording& recording, const Subject& subject) {
    const std::uint32_t owner = pixel(recording, subject).triangle;
    return Value{owner == trace::no_triangle ? -1.0 : static_cast<double>(owner)};
}

} // namespace

std::span<const Quantity> frame_quantities() {
    using enum fragment::FragmentFate;
    constexpr QuantityOf frame = QuantityOf::frame;
    constexpr QuantityOf picture = QuantityOf::pixel;
    static constexpr std::array<Quantity, 27> rows{{
        {"image width", frame, "pixels from left to right", image_width},
        {"image height", frame, "pixels from top to bottom", image_height},
        {"vertices", frame, "vertices that went through the vertex stage", vertices},
        {"triangles", frame, "triangles that entered clipping", counted<&Counters::triangles>},
        {"visits", frame, "pixels the traversal visits", visits},
        {"tile tests", frame, "tiles held against the edges by their corners", tile_tests},
        {"multiplications",
         frame,
         "those of the traversal, by docs/command-line.md",
         multiplications},
        {"additions", frame, "those of the traversal, by docs/command-line.md", additions},
        {"fragments", frame, "pixels found covered", counted<&Counters::fragments>},
        {"fragments written", frame, "fragments that changed their pixel", fated<written>},
        {"fragments failed", frame, "fragments that failed the depth test", fated<depth_failed>},
        {"decisions", frame, "those of the ordering algorithm, of every kind", decisions},
        {"comparisons",
         frame,
         "keys of two polygons compared by the ordering algorithm",
         decided<visibility::OrderEventKind::compare>},
        {"splits",
         frame,
         "polygons cut by the ordering algorithm",
         decided<visibility::OrderEventKind::split>},
        {"pairs",
         frame,
         "front lists: pairs of polygons asked whether they overlap",
         decided<visibility::OrderEventKind::overlap>},
        {"iterations",
         frame,
         "front lists: rounds in which polygons with nothing behind them are drawn",
         decided<visibility::OrderEventKind::iteration>},
        {"stuck polygons",
         frame,
         "front lists: polygons that no round can draw",
         decided<visibility::OrderEventKind::stuck>},
        {"depth sort tests",
         frame,
         "depth sort: tests of pairs, exchanged ones included",
         depth_sort_tests},
        {"nodes", frame, "BSP tree: planes", decided<visibility::OrderEventKind::make_node>},
        {"place",
         QuantityOf::triangle,
         "of a triangle in the order of drawing, from 1; of its first part, if it is cut",
         place_in_order},
        {"pixel depth", picture, "the depth stored when the frame is finished", pixel_depth},
        {"pixel color.r", picture, "red of the finished picture", pixel_color<0>},
        {"pixel color.g", picture, "green of the finished picture", pixel_color<1>},
        {"pixel color.b", picture, "blue of the finished picture", pixel_color<2>},
        {"pixel color.a", picture, "alpha of the finished picture", pixel_color<3>},
        {"pixel fragments", picture, "fragments that reached the pixel", pixel_fragments},
        {"pixel triangle", picture, "the triangle seen there, −1 for none", pixel_triangle},
    }};
    return rows;
}

} // namespace hs::lesson
