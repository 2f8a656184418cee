#include "core/explain/sweep.hpp"

#include "core/explain/numbers.hpp"
#include "core/explain/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace hs::explain {
namespace {

using visibility::ScanEdge;
using visibility::ScanState;
using visibility::SweepEvent;
using visibility::SweepEventKind;

std::string decimal(double value) {
    return number(static_cast<float>(value));
}

std::pair<std::string, std::string> decimals(double left, double right) {
    return compared(static_cast<float>(left), static_cast<float>(right));
}

std::string capital(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

/// Who a decision is about.
struct Subject {
    const trace::SweepDetail& detail;
    const SweepEvent& event;
    std::string polygon; ///< "the background" for −1
    std::string other;
    std::string edge;
};

Subject subject_of(const trace::Recording& recording, const trace::SweepDetail& detail) {
    const SweepEvent& event = detail.last();
    const auto name = [&recording](std::int32_t polygon) {
        return polygon < 0 ? std::string{"the background"} : swept_name(recording, polygon);
    };
    Subject of{detail, event, name(event.polygon), name(event.other), {}};
    if (event.edge >= 0) {
        of.edge = edge_label(recording, *detail.scan->scene, event.edge);
    }
    return of;
}

// ---- sentences: scanlines

std::string active_sentence(const trace::Recording& recording, const Subject& of) {
    const ScanState& state = *of.detail.scan;
    if (state.active.empty()) {
        return fmt::format("No edge crosses scanline {}.", state.row);
    }
    std::vector<std::string> labels;
    for (const visibility::ActiveScanEdge& active : state.active) {
        labels.push_back(edge_label(recording, *state.scene, active.edge));
    }
    return fmt::format(
        "Scanline {} crosses {} active edge{}, from left to right: {}.",
        state.row,
        labels.size(),
        labels.size() == 1 ? "" : "s",
        fmt::join(labels, ", ")
    );
}

std::string cross_sentence(const trace::Recording& recording, const Subject& of) {
    std::vector<std::string> inside;
    for (const std::int32_t polygon : of.detail.scan->inside) {
        inside.push_back(swept_name(recording, polygon));
    }
    return fmt::format(
        "At x = {} edge {} is crossed: {} is {} and its flag goes {}; inside {} now.",
        decimal(of.event.x),
        of.edge,
        of.polygon,
        of.event.verdict ? "entered" : "left",
        of.event.verdict ? "up" : "down",
        inside.empty() ? std::string{"nothing"} : fmt::format("{}", fmt::join(inside, ", "))
    );
}

std::string compare_sentence(const Subject& of) {
    const auto [own, other] = decimals(of.event.value, of.event.other_value);
    if (of.event.value == of.event.other_value) {
        return fmt::format(
            "At x = {} {} and {} are equally deep, {}: {} is nearer where the stretch ends, or "
            "first in the file.",
            decimal(of.event.x),
            of.polygon,
            of.other,
            own,
            of.event.verdict ? of.polygon : of.other
        );
    }
    return fmt::format(
        "At x = {} depth {} of {} is {}nearer than {} of {}.",
        decimal(of.event.x),
        own,
        of.polygon,
        of.event.verdict ? "" : "not ",
        other,
        of.other
    );
}

std::string span_sentence(const Subject& of) {
    const int first = visibility::first_pixel(of.event.x);
    const int end = visibility::first_pixel(of.event.x_end);
    const std::string pixels = end == first       ? std::string{"no pixel center lies there"}
                               : end == first + 1 ? fmt::format("pixel {}", first)
                                                  : fmt::format("pixels {} to {}", first, end - 1);
    return fmt::format(
        "From x = {} to {} {} is visible: {}.",
        decimal(of.event.x),
        decimal(of.event.x_end),
        of.polygon,
        pixels
    );
}

// ---- sentences: a line of depths

std::string depth_sentence(const Subject& of) {
    const std::string where =
        fmt::format("Pixel {}:", pixel({static_cast<int>(of.event.x), of.detail.row}));
    if (of.event.other < 0) {
        return fmt::format(
            "{} the line holds nothing yet and keeps {}, depth {}.",
            where,
            of.polygon,
            decimal(of.event.value)
        );
    }
    const auto [own, other] = decimals(of.event.value, of.event.other_value);
    return fmt::format(
        "{} depth {} of {} is {}nearer than {} of {}, which {}.",
        where,
        own,
        of.polygon,
        of.event.verdict ? "" : "not ",
        other,
        of.other,
        of.event.verdict ? "it replaces" : "stays"
    );
}

// ---- sentences: rays

std::string meet_sentence(const Subject& of) {
    const glm::dvec3& w = of.event.weights;
    if (w == glm::dvec3{0.0}) {
        return fmt::format("The ray runs along the plane of {} and misses it.", of.polygon);
    }
    const bool inside = w.x >= 0.0 && w.y >= 0.0 && w.z >= 0.0;
    if (!inside) {
        return fmt::format(
            "The ray misses {}: where it meets its plane, at t = {}, a weight is negative.",
            of.polygon,
            decimal(of.event.value)
        );
    }
    if (!of.event.verdict) {
        return fmt::format(
            "The ray meets {} at t = {}, {}: no hit.",
            of.polygon,
            decimal(of.event.value),
            of.event.value < 0.0 ? "before the near plane" : "beyond the far plane"
        );
    }
    return fmt::format("The ray hits {} at t = {}.", of.polygon, decimal(of.event.value));
}

std::string keep_sentence(const Subject& of) {
    if (of.event.other < 0) {
        return fmt::format("{} is the first hit, and kept.", capital(of.polygon));
    }
    const auto [own, other] = decimals(of.event.value, of.event.other_value);
    return fmt::format(
        "The hit of {} at t = {} is {}nearer than that of {} at {}: {} is kept.",
        of.polygon,
        own,
        of.event.verdict ? "" : "not ",
        of.other,
        other,
        of.event.verdict ? of.polygon : of.other
    );
}

// ---- formulas

/// x = x0 + (y − y0) · Δx / Δy
Formula crossing_formula(const std::string& edge, const ScanEdge& of, int row) {
    return {
        fmt::format("x of edge {}", edge),
        "x = x0 + (y − y0) (x1 − x0) / (y1 − y0)",
        fmt::format(
            "{} + ({} − {}) ({} − {}) / ({} − {})",
            decimal(of.top.x),
            decimal(visibility::scanline(row)),
            decimal(of.top.y),
            decimal(of.bottom.x),
            decimal(of.top.x),
            decimal(of.bottom.y),
            decimal(of.top.y)
        ),
        decimal(visibility::crossing(of, row))};
}

/// z = −(a x + b y + d) / c, the plane divided by −c.
Formula
depth_formula(const std::string& who, const visibility::WindowPlane& plane, double x, double y) {
    const double c = plane.normal.z;
    return {
        fmt::format("depth of {}", who),
        "z = −(a x + b y + d) / c",
        fmt::format(
            "({}) · {} + ({}) · {} + ({})",
            decimal(-plane.normal.x / c),
            decimal(x),
            decimal(-plane.normal.y / c),
            decimal(y),
            decimal(-plane.offset / c)
        ),
        decimal(-(plane.normal.x * x + plane.normal.y * y + plane.offset) / c)};
}

std::vector<Formula> depth_formulas(const trace::Recording& recording, const Subject& of) {
    std::vector<Formula> list;
    const ScanState& state = *of.detail.scan;
    const bool at_pixel = of.event.kind == SweepEventKind::depth;
    const double x = at_pixel ? of.event.x + 0.5 : of.event.x;
    for (const std::int32_t polygon : {of.event.polygon, of.event.other}) {
        if (polygon >= 0) {
            list.push_back(depth_formula(
                swept_name(recording, polygon),
                state.scene->planes[static_cast<std::size_t>(polygon)],
                x,
                visibility::scanline(of.detail.row)
            ));
        }
    }
    return list;
}

std::string point_text(const glm::dvec3& p) {
    return point(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
}

std::vector<Formula> ray_formulas(const trace::Recording& recording, const Subject& of) {
    const visibility::Ray& ray = of.detail.ray->ray;
    std::vector<Formula> list{
        {"ray",
         "p(t) = o + t d, t from 0 to 1",
         "",
         fmt::format("{} + t {}", point_text(ray.origin), point_text(ray.direction))}};
    if (of.event.kind != SweepEventKind::meet) {
        return list;
    }
    const visibility::RayTriangle& triangle =
        recording.order.sweep->triangles[static_cast<std::size_t>(of.event.polygon)];
    const glm::dvec3 volumes = visibility::ray_volumes(ray, triangle);
    list.push_back(
        {"volumes",
         "V0 = d · (b × c), V1 = d · (c × a), V2 = d · (a × b)",
         "a, b, c: the vertices, seen from o",
         point_text(volumes)}
    );
    list.push_back(
        {"weights",
         "λi = Vi / (V0 + V1 + V2)",
         fmt::format("V0 + V1 + V2 = {}", decimal(volumes.x + volumes.y + volumes.z)),
         point_text(of.event.weights)}
    );
    list.push_back(
        {"t",
         "t = (λ0 a + λ1 b + λ2 c) · d / (d · d)",
         fmt::format("p = {}", point_text(ray.origin + of.event.value * ray.direction)),
         decimal(of.event.value)}
    );
    return list;
}

} // namespace

std::string swept_name(const trace::Recording& recording, std::int32_t polygon) {
    const pipeline::PieceName& piece = recording.order.sweep->polygon(polygon);
    const std::string name = polygon_name(
        recording, {.triangle = recording.objects[piece.object].first_triangle + piece.triangle}
    );
    return piece.clipped ? fmt::format("piece {} of {}", piece.piece, name) : name;
}

std::string swept_label(const trace::Recording& recording, std::int32_t polygon) {
    const pipeline::PieceName& piece = recording.order.sweep->polygon(polygon);
    const std::string label = polygon_label(
        recording, {.triangle = recording.objects[piece.object].first_triangle + piece.triangle}
    );
    return piece.clipped ? fmt::format("{}/{}", label, piece.piece) : label;
}

std::string edge_label(
    const trace::Recording& recording, const visibility::ScanScene& scene, std::int32_t edge
) {
    constexpr std::int32_t corners = 3;
    constexpr std::size_t alphabet = 26;
    const ScanEdge& of = scene.table.edge(edge);
    if (scene.polygons.size() * corners <= alphabet) {
        const auto letter = [&of](std::int32_t corner) {
            return static_cast<char>('A' + corners * of.polygon + corner);
        };
        return {letter(of.from), letter(of.to)};
    }
    return fmt::format("{}:{}{}", swept_label(recording, of.polygon), of.from, of.to);
}

// NOLINTNEXTLINE(readability-function-size): one line for every kind of decision
std::string sweep_sentence(const trace::Recording& recording, const trace::SweepDetail& detail) {
    const Subject of = subject_of(recording, detail);
    const SweepEvent& event = of.event;
    switch (event.kind) {
    case SweepEventKind::edge_out:
        return fmt::format(
            "Edge {} of {} has ended and leaves the active edges.", of.edge, of.polygon
        );
    case SweepEventKind::edge_in:
        return fmt::format(
            "Edge {} of {} begins: it crosses scanline {} at x = {} and joins the active edges.",
            of.edge,
            of.polygon,
            detail.row,
            decimal(event.x)
        );
    case SweepEventKind::active_edges: return active_sentence(recording, of);
    case SweepEventKind::cross: return cross_sentence(recording, of);
    case SweepEventKind::compare: return compare_sentence(of);
    case SweepEventKind::false_edge:
        return fmt::format(
            "At x = {} {} comes through {}: a false edge.", decimal(event.x), of.polygon, of.other
        );
    case SweepEventKind::span: return span_sentence(of);
    case SweepEventKind::clear:
        return fmt::format("The line of depths is cleared for scanline {}.", detail.row);
    case SweepEventKind::enter:
        return event.x < event.x_end ? fmt::format(
                                           "{} covers pixels {} to {} of scanline {}.",
                                           capital(of.polygon),
                                           static_cast<int>(event.x),
                                           static_cast<int>(event.x_end) - 1,
                                           detail.row
                                       )
                                     : fmt::format(
                                           "{} covers no pixel center of scanline {}.",
                                           capital(of.polygon),
                                           detail.row
                                       );
    case SweepEventKind::depth: return depth_sentence(of);
    case SweepEventKind::cast:
        return fmt::format("A ray sets out through the center of pixel {}.", pixel(detail.pixel));
    case SweepEventKind::meet: return meet_sentence(of);
    case SweepEventKind::keep: return keep_sentence(of);
    }
    HS_CHECK(false, "every decision has a sentence");
    return "";
}

std::vector<Formula>
sweep_formulas(const trace::Recording& recording, const trace::SweepDetail& detail) {
    const Subject of = subject_of(recording, detail);
    switch (of.event.kind) {
    case SweepEventKind::edge_in:
    case SweepEventKind::cross:
        return {
            crossing_formula(of.edge, detail.scan->scene->table.edge(of.event.edge), detail.row)};
    case SweepEventKind::compare:
    case SweepEventKind::false_edge:
    case SweepEventKind::span:
    case SweepEventKind::depth: return depth_formulas(recording, of);
    case SweepEventKind::cast:
    case SweepEventKind::meet:
    case SweepEventKind::keep: return ray_formulas(recording, of);
    case SweepEventKind::edge_out:
    case SweepEventKind::active_edges:
    case SweepEventKind::clear:
    case SweepEventKind::enter: return {};
    }
    HS_CHECK(false, "every decision is handled");
    return {};
}

} // namespace hs::explain
