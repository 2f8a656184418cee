#include "core/explain/order.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hs::explain {
namespace {

using visibility::NewellTest;
using visibility::OrderEvent;
using visibility::OrderEventKind;
using visibility::Side;

std::string depth(double value) {
    return number(static_cast<float>(value));
}

std::string whole_number(double value) {
    return whole(static_cast<std::int64_t>(value));
}

/// "1 polygon", "2 polygons".
std::string polygons(double count) {
    return fmt::format("{} polygon{}", whole_number(count), count == 1.0 ? "" : "s");
}

std::string capital(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

/// Who a decision is about, and what algorithm makes it.
struct Subject {
    const OrderEvent& event;
    std::string polygon;
    std::string other;
    const scene::Settings& settings;
};

std::string key_name(const scene::Settings& settings) {
    return fmt::format("{} depth", name_of(settings.painters_key));
}

// ---- sorted lists

std::string compare_sentence(const Subject& of) {
    const auto [value, other] =
        compared(static_cast<float>(of.event.value), static_cast<float>(of.event.other_value));
    return fmt::format(
        "{} {} of {} is {}farther than {} of {}: {} goes first.",
        capital(key_name(of.settings)),
        value,
        of.polygon,
        of.event.verdict ? "" : "not ",
        other,
        of.other,
        of.event.verdict ? of.polygon : of.other
    );
}

std::string move_sentence(const Subject& of) {
    if (of.other.empty()) {
        return fmt::format("{} goes to place {}.", capital(of.polygon), of.event.place);
    }
    return fmt::format(
        "{} goes to the head of the list, before {}, and is marked.", capital(of.polygon), of.other
    );
}

std::string iteration_sentence(const Subject& of) {
    if (of.settings.visibility == scene::Visibility::painters) {
        return fmt::format(
            "Pass {} merges sorted runs of {} in pairs.", of.event.place, polygons(of.event.value)
        );
    }
    return fmt::format(
        "Iteration {} begins: nothing undrawn lies behind {}.",
        of.event.place - 1, // counted from 0, as in paths
        polygons(of.event.value)
    );
}

// ---- front lists

std::string nearer_sentence(const Subject& of) {
    const auto [value, other] =
        compared(static_cast<float>(of.event.value), static_cast<float>(of.event.other_value));
    if (of.event.value == of.event.other_value) {
        return fmt::format(
            "{} and {} are equally deep where they overlap, {}: neither is in front.",
            capital(of.polygon),
            of.other,
            value
        );
    }
    return fmt::format(
        "Where they overlap, {} has depth {} and {} has depth {}: {} is in front.",
        of.polygon,
        value,
        of.other,
        other,
        of.event.verdict ? of.polygon : of.other
    );
}

// ---- Newell, Newell and Sancha

/// What a test found out about P and Q.
std::string finding(NewellTest test, bool passed) {
    switch (test) {
    case NewellTest::depth_extents:
        return passed ? "no point of Q is farther than a point of P" : "they overlap in depth";
    case NewellTest::x_extents:
        return passed ? "their extents in x do not overlap" : "their extents in x overlap";
    case NewellTest::y_extents:
        return passed ? "their extents in y do not overlap" : "their extents in y overlap";
    case NewellTest::behind_plane:
        return passed ? "P is wholly behind the plane of Q"
                      : "P is not wholly behind the plane of Q";
    case NewellTest::in_front_of_plane:
        return passed ? "Q is wholly in front of the plane of P"
                      : "Q is not wholly in front of the plane of P";
    case NewellTest::projections:
        return passed ? "their projections do not overlap" : "their projections overlap";
    }
    HS_CHECK(false, "every test finds something out");
    return "";
}

std::string newell_sentence(const Subject& of) {
    const auto test = static_cast<NewellTest>(of.event.place);
    const bool exchanged = of.event.kind == OrderEventKind::exchanged_test;
    const bool last =
        test == NewellTest::projections || (exchanged && test == NewellTest::in_front_of_plane);
    const char* const then = of.event.verdict ? "P may go first"
                             : !last          ? "on to the next test"
                             : exchanged      ? "one must be cut"
                                              : "P may hide Q, so they exchange roles";
    return fmt::format(
        "Test {}{} for P = {}, Q = {}: {}; {}.",
        of.event.place,
        exchanged ? ", roles exchanged," : "",
        of.polygon,
        of.other,
        finding(test, of.event.verdict),
        then
    );
}

// ---- trees

std::string side_phrase(Side side) {
    switch (side) {
    case Side::on: return "in";
    case Side::front: return "in front of";
    case Side::back: return "behind";
    case Side::spanning: return "on both sides of";
    }
    HS_CHECK(false, "every side is handled");
    return "";
}

std::string split_sentence(const Subject& of) {
    const std::string by = of.event.other >= 0 ? fmt::format("the plane of {}", of.other)
                                               : fmt::format("a wall of cell {}", of.event.node);
    return fmt::format(
        "{} is cut by {}: area {} in front, area {} behind.",
        capital(of.polygon),
        by,
        depth(of.event.value),
        depth(of.event.other_value)
    );
}

std::string node_sentence(const Subject& of) {
    const std::string place =
        of.event.place < 0
            ? std::string{"the root"}
            : fmt::format(
                  "node {}, {} node {}", of.event.node, side_phrase(of.event.side), of.event.place
              );
    return fmt::format(
        "{} becomes the splitter of {}, for {}.",
        capital(of.polygon),
        place,
        polygons(of.event.value)
    );
}

std::string eye_sentence(const Subject& of) {
    return fmt::format(
        "The walk comes to node {}: the eye is {} its plane, signed distance {}.",
        of.event.node,
        of.event.verdict ? "in front of" : "behind",
        depth(of.event.value)
    );
}

std::string tree_sentence(const Subject& of) {
    const OrderEvent& event = of.event;
    if (event.kind == OrderEventKind::candidate) {
        return fmt::format(
            "The plane of {} would cut {} of {} polygons{}.",
            of.polygon,
            whole_number(event.value),
            whole_number(event.other_value),
            event.verdict ? ": the fewest so far" : ""
        );
    }
    if (event.kind == OrderEventKind::classify) {
        return fmt::format(
            "{} lies {} the plane of node {}.",
            capital(of.polygon),
            side_phrase(event.side),
            event.node
        );
    }
    if (event.kind == OrderEventKind::visit_side) {
        return fmt::format(
            "The walk goes on {} the plane of node {}.", side_phrase(event.side), event.node
        );
    }
    return fmt::format(
        "{} cell {}: it holds {} and {}.",
        event.kind == OrderEventKind::make_cell ? "The octree gets" : "The walk comes to",
        event.node,
        polygons(event.value),
        event.kind == OrderEventKind::make_cell ? (event.verdict ? "is divided" : "stays a leaf")
                                                : (event.verdict ? "is a leaf" : "has children")
    );
}

// NOLINTNEXTLINE(readability-function-size): one line for every kind of decision
std::string sentence_of(const Subject& of) {
    const OrderEvent& event = of.event;
    switch (event.kind) {
    case OrderEventKind::compare: return compare_sentence(of);
    case OrderEventKind::move: return move_sentence(of);
    case OrderEventKind::emit:
        return fmt::format(
            "{} is number {} in the order of drawing.", capital(of.polygon), event.place
        );
    case OrderEventKind::overlap:
        return fmt::format(
            "The projections of {} and {} {}.",
            of.polygon,
            of.other,
            event.verdict ? "overlap: their depths decide which is in front"
                          : "do not overlap: neither hides the other"
        );
    case OrderEventKind::nearer: return nearer_sentence(of);
    case OrderEventKind::list_in_front:
        return fmt::format(
            "{} enters the front list of {} and has {} behind it so far.",
            capital(of.other),
            of.polygon,
            polygons(event.value)
        );
    case OrderEventKind::iteration: return iteration_sentence(of);
    case OrderEventKind::count_down:
        return fmt::format(
            "{} is drawn, which leaves {} behind {}.",
            capital(of.other),
            polygons(event.value),
            of.polygon
        );
    case OrderEventKind::stuck:
        return fmt::format(
            "{} can never be drawn: it {}.",
            capital(of.polygon),
            event.verdict ? "is part of a cycle" : "lies in front of a cycle"
        );
    case OrderEventKind::take_farthest:
        return fmt::format(
            "{} becomes P: its farthest depth {} is the greatest left.",
            capital(of.polygon),
            depth(event.value)
        );
    case OrderEventKind::test:
    case OrderEventKind::exchanged_test: return newell_sentence(of);
    case OrderEventKind::draw_anyway:
        return fmt::format(
            "No plane cuts this cycle: {} is drawn before {} anyway.", of.polygon, of.other
        );
    case OrderEventKind::split: return split_sentence(of);
    case OrderEventKind::make_node: return node_sentence(of);
    case OrderEventKind::enter_node: return eye_sentence(of);
    case OrderEventKind::candidate:
    case OrderEventKind::classify:
    case OrderEventKind::visit_side:
    case OrderEventKind::make_cell:
    case OrderEventKind::enter_cell: return tree_sentence(of);
    case OrderEventKind::in_front:
        return fmt::format(
            "The planes {} that {} is in front of {}.",
            event.verdict ? "show" : "do not show",
            of.polygon,
            of.other
        );
    case OrderEventKind::undecided:
        return fmt::format(
            "No polygon of leaf {} is in front of all others: {} is taken by its center.",
            event.node,
            of.polygon
        );
    }
    HS_CHECK(false, "every decision has a sentence");
    return "";
}

/// Whether a polygon had been cut by the time of a decision. Those that never are, are most.
bool is_split_at(const trace::Recording& recording, std::int32_t polygon, std::uint32_t event) {
    if (!recording.order.polygons[static_cast<std::size_t>(polygon)].split) {
        return false;
    }
    for (std::uint32_t i = 0; i <= event; ++i) {
        const OrderEvent& earlier = recording.decisions[i];
        const bool involved = earlier.polygon == polygon || earlier.place == polygon;
        if (earlier.kind == OrderEventKind::split && involved) {
            return true;
        }
    }
    return false;
}

/// The polygon as it was at the decision: later ones may cut it. Nothing for −1.
std::string name_at(const trace::Recording& recording, std::int32_t polygon, std::uint32_t event) {
    if (polygon < 0) {
        return "";
    }
    pipeline::OrderedPolygon then = recording.order.polygons[static_cast<std::size_t>(polygon)];
    then.split = is_split_at(recording, polygon, event);
    return polygon_name(recording, then);
}

/// By which numbers a polygon is known.
struct Numbers {
    std::optional<std::uint32_t> object{}; ///< where there is more than one
    std::uint32_t own = 0;                 ///< of the face or the triangle in its object
    bool face = false;
    bool alone = false; ///< the object has nothing else
};

Numbers numbers_of(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon) {
    const std::uint32_t object = recording.object_of_triangle(polygon.triangle);
    const trace::ObjectRange& range = recording.objects[object];
    Numbers numbers;
    numbers.own = polygon.triangle - range.first_triangle;
    numbers.face = polygon.triangle_count > 1;
    numbers.alone = polygon.triangle_count == range.triangle_count;
    if (numbers.face) {
        const scene::Mesh& mesh = *recording.frame->calls()[object].vertex.mesh;
        numbers.own = mesh.triangle_polygon[numbers.own];
    }
    if (recording.objects.size() > 1) {
        numbers.object = object;
    }
    return numbers;
}

// ---- formulas

Formula key_formula(
    const std::string& who, const visibility::WindowPolygon& polygon, scene::PaintersKey key
) {
    std::vector<std::string> depths;
    for (const auto& corner : polygon.corners) {
        depths.push_back(depth(corner.position.z));
    }
    const bool average = key == scene::PaintersKey::centroid;
    const char* const symbol = key == scene::PaintersKey::farthest  ? "z = max(z0, z1, …)"
                               : key == scene::PaintersKey::nearest ? "z = min(z0, z1, …)"
                                                                    : "z = (z0 + z1 + …) / n";
    const char* const function = key == scene::PaintersKey::farthest ? "max" : "min";
    return {
        fmt::format("key of {}", who),
        symbol,
        average ? fmt::format("({}) / {}", fmt::join(depths, " + "), depths.size())
                : fmt::format("{}({})", function, fmt::join(depths, ", ")),
        depth(visibility::painters_key(polygon, key))};
}

} // namespace

std::string
polygon_name(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon) {
    const Numbers of = numbers_of(recording, polygon);
    std::string name = fmt::format("{} {}", of.face ? "polygon" : "triangle", of.own);
    if (of.object && of.alone) {
        const std::string& given = recording.scene().objects[*of.object].name;
        name = given.empty() ? fmt::format("object {}", *of.object) : fmt::format("\"{}\"", given);
    } else if (of.object) {
        name += fmt::format(" of object {}", *of.object);
    }
    return polygon.split ? fmt::format("part {} of {}", polygon.part, name) : name;
}

std::string
polygon_label(const trace::Recording& recording, const pipeline::OrderedPolygon& polygon) {
    const Numbers of = numbers_of(recording, polygon);
    std::string label = fmt::format("{}", of.own);
    if (of.object && of.alone) {
        constexpr std::size_t short_enough = 4;
        const std::string& given = recording.scene().objects[*of.object].name;
        const bool fits = !given.empty() && given.size() <= short_enough;
        label = fits ? given : fmt::format("{}", *of.object);
    } else if (of.object) {
        label = fmt::format("{}.{}", *of.object, of.own);
    }
    return polygon.split ? fmt::format("{}/{}", label, polygon.part) : label;
}

std::string order_sentence(const trace::Recording& recording, std::uint32_t event) {
    const OrderEvent& decision = recording.decisions[event];
    return sentence_of(
        {.event = decision,
         .polygon = name_at(recording, decision.polygon, event),
         .other = name_at(recording, decision.other, event),
         .settings = recording.settings()}
    );
}

std::vector<Formula>
order_formulas(const trace::Recording& recording, const trace::OrderDetail& detail) {
    std::vector<Formula> list;
    const scene::Settings& settings = recording.settings();
    if (settings.visibility != scene::Visibility::painters) {
        return list;
    }
    for (const std::int32_t index : {detail.decision.polygon, detail.decision.other}) {
        if (index >= 0) {
            const auto& polygon = detail.window_polygons()[static_cast<std::size_t>(index)];
            list.push_back(key_formula(
                polygon_name(recording, *detail.polygon(index)), polygon, settings.painters_key
            ));
        }
    }
    return list;
}

} // namespace hs::explain
