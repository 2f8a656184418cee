// Written step paths to flat numbers.
//
// A path is a list of parts; each is words and a number. Parts may come in any order; what is
// missing on the fine side means "after the last child".
#include "core/trace/outline.hpp"
#include "core/trace/path_parts.hpp"
#include "core/trace/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace hs::trace {
namespace {

Diagnostic no_step(std::string message) {
    return {.message = std::move(message)};
}

Result<StepId> find_vertex_step(const Recording& recording, const PathParts& parts) {
    if (!parts.object) {
        return recording.first_order_step - 1;
    }
    const ObjectRange& object = recording.objects[*parts.object];
    const auto steps = static_cast<StepId>(object.steps_per_vertex);
    if (object.vertex_count == 0) {
        return no_step(fmt::format("object {} has no vertices", *parts.object));
    }
    if (parts.vertex && *parts.vertex >= object.vertex_count) {
        return no_step(fmt::format(
            "object {} has no vertex {}; its vertices are 0 to {}",
            *parts.object,
            *parts.vertex,
            object.vertex_count - 1
        ));
    }
    const std::uint32_t vertex = parts.vertex.value_or(object.vertex_count - 1);
    StepId offset = steps - 1;
    if (parts.operation) {
        const auto kind = static_cast<StepId>(*parts.operation);
        offset = kind - static_cast<StepId>(StepKind::vertex_world);
        if (offset >= steps) {
            return no_step(fmt::format(
                "a vertex of object {} has no step '{}'", *parts.object, name_of(*parts.operation)
            ));
        }
    }
    return object.first_vertex_step + StepId{vertex} * steps + offset;
}

/// "resolve / pixel 31,17"; without a pixel, the last.
Result<StepId> find_resolve_step(const Recording& recording, const PathParts& parts) {
    if (!recording.samples.active()) {
        return no_step("nothing is resolved in a frame with one sample a pixel");
    }
    if (!parts.visit) {
        return recording.end_step - 1;
    }
    const PixelPos p = *parts.visit;
    if (!recording.settings().image().contains(p)) {
        return no_step(fmt::format(
            "the image has no pixel {},{}; it is {} x {} pixels",
            p.x,
            p.y,
            recording.width(),
            recording.height()
        ));
    }
    const auto row = static_cast<StepId>(p.y) * static_cast<StepId>(recording.width());
    return recording.first_resolve_step + row + static_cast<StepId>(p.x);
}

Result<StepId> find_order_step(const Recording& recording, const PathParts& parts) {
    if (parts.ordering && !parts.decision && recording.settings().sweeps()) {
        return recording.first_resolve_step - 1;
    }
    if (recording.first_order_step == recording.first_triangle_step) {
        return no_step(fmt::format(
            "visibility \"{}\" orders nothing; triangles are drawn in file order",
            name_of(recording.settings().visibility)
        ));
    }
    if (!parts.decision) {
        return recording.first_triangle_step - 1;
    }
    const std::string_view words = name_of(*parts.decision);
    const auto found = recording.decisions.find(*parts.decision, *parts.ordinal);
    if (found) {
        return recording.first_order_step + *found;
    }
    const OrderCounts all = recording.decisions.counts_before(recording.decisions.size());
    const std::uint64_t count = all[static_cast<std::size_t>(*parts.decision)];
    if (count == 0) {
        return no_step(fmt::format("the ordering has no step '{}'", words));
    }
    return no_step(fmt::format(
        "the ordering has no {} {}; its steps of that name are 0 to {}",
        words,
        *parts.ordinal,
        count - 1
    ));
}

/// Whether a step of a row of the image is, or belongs to, what the path names.
bool matches_in_row(const Step& step, const PathParts& parts) {
    const bool decision = step.kind == StepKind::sweep;
    const bool of_triangle = decision ? step.of_polygon : step.in_triangle();
    const bool of_pixel = decision ? step.sweeps_pixel() : step.has_pixel();
    const auto same = [](const auto& wanted, const auto& found) {
        return !wanted || *wanted == found;
    };
    if ((parts.object || parts.triangle) &&
        !(of_triangle && same(parts.object, step.object) && same(parts.triangle, step.triangle))) {
        return false;
    }
    if (parts.piece && step.piece != static_cast<int>(*parts.piece)) {
        return false;
    }
    if (!same(parts.scanline, step.pixel.y) || (parts.visit && !of_pixel) ||
        !same(parts.visit, step.pixel)) {
        return false;
    }
    if (parts.fragment && (!step.in_fragment() || step.pixel != *parts.fragment)) {
        return false;
    }
    if (parts.sweep) {
        return decision && step.sweep == *parts.sweep && same(parts.ordinal, step.ordinal);
    }
    return !parts.operation || step.kind == *parts.operation;
}

/// Whether a step of the wanted triangle is, or belongs to, what the path names.
bool matches(const Step& step, const PathParts& parts) {
    if (parts.piece && (!step.has_piece() || step.piece != static_cast<int>(*parts.piece))) {
        return false;
    }
    if (parts.plane && (step.kind != StepKind::clip_plane || step.plane != *parts.plane)) {
        return false;
    }
    if (parts.tile && (step.kind != StepKind::tile_test || step.pixel != *parts.tile ||
                       step.tile_size != parts.tile_size.value_or(step.tile_size))) {
        return false;
    }
    if (parts.scanline &&
        (!(step.of_scanline() || step.has_pixel()) || step.pixel.y != *parts.scanline)) {
        return false;
    }
    if (parts.visit && (!step.has_pixel() || step.pixel != *parts.visit)) {
        return false;
    }
    // A visit without operation is the edge test itself; a fragment is everything after it
    const bool test = step.kind == StepKind::edge_test || step.kind == StepKind::sample_test ||
                      step.kind == StepKind::plane_test || step.kind == StepKind::line_step;
    if (parts.visit && !parts.operation && !test) {
        return false;
    }
    if (parts.fragment && (!step.in_fragment() || step.pixel != *parts.fragment)) {
        return false;
    }
    if (parts.sample && step.sample != *parts.sample) {
        return false;
    }
    if (parts.operation == StepKind::clip_plane) {
        return step.kind == StepKind::clip_plane || step.kind == StepKind::outcodes;
    }
    return !parts.operation || step.kind == *parts.operation;
}

std::string describe_missing(
    const Recording& recording, const PathParts& parts, std::uint32_t object, std::uint32_t triangle
) {
    const std::string path = primitive_path(recording, object, triangle);
    if (parts.fragment || parts.visit) {
        const PixelPos p = parts.fragment ? *parts.fragment : *parts.visit;
        return fmt::format(
            "{} has no such step at pixel {},{}; ask 'pixel {},{}' for its edge test",
            path,
            p.x,
            p.y,
            p.x,
            p.y
        );
    }
    return path + " has no such step";
}

/// The last step of a draw that matches, searched stretch by stretch from its end.
std::optional<StepId>
find_draw_step(const Recording& recording, const PathParts& parts, std::uint32_t draw) {
    const bool row = recording.order.draws[draw].row >= 0;
    const StepId first = recording.draw_steps[draw];
    const StepId last = last_step_of_draw(recording, draw);
    for (std::size_t entry = index_entry_of_step(recording, last);; --entry) {
        const Outline window = outline(recording, entry);
        const auto step =
            std::find_if(window.steps.rbegin(), window.steps.rend(), [&](const Step& candidate) {
                return candidate.id >= first && candidate.id <= last &&
                       (row ? matches_in_row(candidate, parts) : matches(candidate, parts));
            });
        if (step != window.steps.rend()) {
            return step->id;
        }
        if (window.first_step <= first) {
            return std::nullopt;
        }
    }
}

/// The last step of the triangle that matches.
Result<StepId> find_triangle_step(const Recording& recording, const PathParts& parts) {
    const ObjectRange& object = recording.objects[*parts.object];
    const std::uint32_t frame_triangle = object.first_triangle + *parts.triangle;
    const bool whole = !parts.piece && !parts.plane && !parts.tile && !parts.scanline &&
                       !parts.visit && !parts.fragment && !parts.sample && !parts.operation;
    if (whole) {
        return last_step_of_triangle(recording, frame_triangle);
    }
    const std::vector<std::uint32_t> draws = recording.draws_of_triangle(frame_triangle);
    for (auto draw = draws.rbegin(); draw != draws.rend(); ++draw) {
        if (const std::optional<StepId> found = find_draw_step(recording, parts, *draw)) {
            return *found;
        }
    }
    return no_step(describe_missing(recording, parts, *parts.object, *parts.triangle));
}

/// What a mesh has of a kind, and where its first one stands among the primitives.
struct KindRange {
    std::string_view name;
    std::size_t first;
    std::size_t count;
};

/// A written line or point to its place among the primitives, behind the triangles.
std::optional<Diagnostic> number_primitive(PathParts& parts, const scene::Mesh& mesh) {
    const KindRange lines{"line", mesh.triangles.size(), mesh.lines.size()};
    const KindRange points{"point", lines.first + lines.count, mesh.points.size()};
    const KindRange triangles{"triangle", 0, mesh.triangles.size()};
    const KindRange& kind = parts.line ? lines : parts.point ? points : triangles;
    const std::optional<std::uint32_t> written = parts.line    ? parts.line
                                                 : parts.point ? parts.point
                                                               : parts.triangle;
    if (!written) {
        return std::nullopt;
    }
    if (kind.count == 0) {
        return no_step(fmt::format("object {} has no {}s", *parts.object, kind.name));
    }
    if (*written >= kind.count) {
        return no_step(fmt::format(
            "object {} has no {} {}; its {}s are 0 to {}",
            *parts.object,
            kind.name,
            *written,
            kind.name,
            kind.count - 1
        ));
    }
    parts.triangle = static_cast<std::uint32_t>(kind.first) + *written;
    return std::nullopt;
}

/// Which row of the image a path names, if it does.
std::optional<int> named_row(const PathParts& parts) {
    if (parts.scanline) {
        return parts.scanline;
    }
    const std::optional<PixelPos>& pixel = parts.visit ? parts.visit : parts.fragment;
    return pixel ? std::optional{pixel->y} : std::nullopt;
}

/// "scanline 12 / edge 3", "pixel 31,17 / object 0 / triangle 2 / meeting".
Result<StepId> find_row_step(const Recording& recording, PathParts parts) {
    const std::uint32_t rows = recording.first_row_draw();
    const int first = recording.order.draws[rows].row;
    const int last = recording.order.draws.back().row;
    const int row = *named_row(parts);
    if (row < first || row > last) {
        return no_step(
            fmt::format("there is no scanline {}; those drawn are {} to {}", row, first, last)
        );
    }
    if (parts.triangle && !parts.object && recording.objects.size() == 1) {
        parts.object = 0;
    }
    if (const auto found = find_draw_step(recording, parts, recording.draw_of_row(row))) {
        return *found;
    }
    return no_step(fmt::format(
        "scanline {} has no such step; what was decided there is told by 'scanline {}' and the "
        "steps before it",
        row,
        row
    ));
}

Result<StepId> find_parts(const Recording& recording, PathParts parts) {
    if (parts.ordering || parts.decision || parts.operation == StepKind::order) {
        return find_order_step(recording, parts);
    }
    if (parts.operation == StepKind::resolve) {
        return find_resolve_step(recording, parts);
    }
    const auto objects = static_cast<std::uint32_t>(recording.objects.size());
    const bool names_pixels =
        parts.visit || parts.fragment || parts.sample || parts.tile || parts.scanline;
    const bool names_primitive = parts.triangle || parts.line || parts.point;
    const bool names_inside = parts.vertex || names_primitive || names_pixels;
    if (!parts.object && names_inside && objects == 1) {
        parts.object = 0;
    }
    if (parts.object && *parts.object >= objects) {
        return no_step(fmt::format(
            "there is no object {}; the scene's objects are 0 to {}", *parts.object, objects - 1
        ));
    }
    const bool vertex_operation = parts.operation && *parts.operation >= StepKind::vertex_world &&
                                  *parts.operation <= StepKind::vertex_light;
    if (parts.vertex_stage || parts.vertex || vertex_operation) {
        if (parts.vertex && !parts.object) {
            return no_step("say which object the vertex belongs to, as in 'object 0 / vertex 5'");
        }
        return find_vertex_step(recording, parts);
    }
    if (!parts.object) {
        return no_step("say which object, as in 'object 0 / triangle 12'");
    }
    const ObjectRange& object = recording.objects[*parts.object];
    if (object.triangle_count == 0) {
        return no_step(fmt::format("object {} has no triangles", *parts.object));
    }
    const scene::Mesh& mesh = *recording.frame->calls()[*parts.object].vertex.mesh;
    if (std::optional<Diagnostic> complaint = number_primitive(parts, mesh)) {
        return *complaint;
    }
    if (!parts.triangle) {
        if (names_pixels || parts.operation || parts.plane) {
            return no_step("say which triangle, as in 'object 0 / triangle 12 / setup'");
        }
        parts.triangle = object.triangle_count - 1;
    }
    return find_triangle_step(recording, parts);
}

/// Rows of the image first: they are of all triangles.
Result<StepId> find_named(const Recording& recording, const PathParts& parts) {
    if (recording.settings().sweeps() && named_row(parts)) {
        return find_row_step(recording, parts);
    }
    const bool ordered = parts.decision && !recording.settings().sweeps();
    if (parts.sweep && !ordered && !parts.operation) {
        return no_step(fmt::format(
            "say which scanline or pixel, as in 'scanline 12 / {}'; only visibility \"scanline\", "
            "\"scanline-z\" and \"ray-cast\" have such steps",
            name_of(*parts.sweep)
        ));
    }
    return find_parts(recording, parts);
}

} // namespace

Result<StepId> find_step(const Recording& recording, std::string_view path) {
    const std::string_view text = trimmed(path);
    if (text == "start") {
        return StepId{0};
    }
    if (text == "end") {
        return recording.end_step;
    }
    if (text.starts_with('#')) {
        const auto number = parse_step_number(text.substr(1));
        if (!number || *number > recording.end_step) {
            return no_step(
                fmt::format("there is no step '{}'; steps are #0 to #{}", text, recording.end_step)
            );
        }
        return *number;
    }

    PathParts parts;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t slash = std::min(text.find('/', from), text.size());
        const std::string_view part = trimmed(text.substr(from, slash - from));
        if (!parse_part(part, parts)) {
            return no_step(fmt::format(
                "'{}' in the step path '{}' is not understood; write words and numbers as in "
                "'object 0 / triangle 12 / fragment 31,17 / depth test'",
                part,
                text
            ));
        }
        from = slash + 1;
    }
    return find_named(recording, parts);
}

} // namespace hs::trace
