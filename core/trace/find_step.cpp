// Written step paths to flat numbers.
//
// A path is a list of parts; each is words and a number. Parts may come in any order; what is
// missing on the fine side means "after the last child".
#include "core/trace/outline.hpp"
#include "core/trace/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace hs::trace {
namespace {

/// The parts of a path, as far as they were written.
struct PathParts {
    std::optional<std::uint32_t> object;
    std::optional<std::uint32_t> vertex;
    std::optional<std::uint32_t> triangle;
    std::optional<std::uint32_t> line;
    std::optional<std::uint32_t> point;
    std::optional<std::uint32_t> piece;
    std::optional<geometry::ClipPlane> plane;
    std::optional<PixelPos> tile;
    std::optional<int> tile_size;
    std::optional<int> scanline;
    std::optional<PixelPos> visit;
    std::optional<PixelPos> fragment;
    std::optional<int> sample;
    std::optional<StepKind> operation;
    std::optional<visibility::OrderEventKind> decision;
    std::optional<std::uint64_t> ordinal; ///< among decisions of its kind
    bool vertex_stage = false;
    bool ordering = false;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return number;
}

std::optional<PixelPos> parse_pixel(std::string_view text) {
    const auto comma = text.find(',');
    if (comma == std::string_view::npos) {
        return std::nullopt;
    }
    const auto x = parse_number<int>(trimmed(text.substr(0, comma)));
    const auto y = parse_number<int>(trimmed(text.substr(comma + 1)));
    return x && y ? std::optional{PixelPos{*x, *y}} : std::nullopt;
}

std::optional<StepKind> parse_operation(std::string_view text) {
    return parse_name<StepKind>(text);
}

/// "triangle 12 piece 1" to triangle and piece.
bool parse_triangle(std::string_view rest, PathParts& parts) {
    const auto piece = rest.find("piece");
    parts.triangle = parse_number<std::uint32_t>(trimmed(rest.substr(0, piece)));
    if (piece != std::string_view::npos) {
        parts.piece = parse_number<std::uint32_t>(trimmed(rest.substr(piece + 5)));
    }
    return parts.triangle && (parts.piece || piece == std::string_view::npos);
}

/// "tile 8,0 size 4" to tile and size; without a size, the smallest tile there.
bool parse_tile(std::string_view rest, PathParts& parts) {
    const auto size = rest.find("size");
    parts.tile = parse_pixel(trimmed(rest.substr(0, size)));
    if (size != std::string_view::npos) {
        parts.tile_size = parse_number<int>(trimmed(rest.substr(size + 4)));
    }
    return parts.tile && (parts.tile_size || size == std::string_view::npos);
}

/// "comparison 17": the words of a decision and how many came before it.
bool parse_decision(std::string_view part, PathParts& parts) {
    const std::size_t space = part.rfind(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    const auto kind = parse_name<visibility::OrderEventKind>(trimmed(part.substr(0, space)));
    const auto ordinal = parse_number<std::uint64_t>(part.substr(space + 1));
    if (!kind || !ordinal) {
        return false;
    }
    parts.decision = kind;
    parts.ordinal = ordinal;
    return true;
}

/// Reads one part into `parts`; false when it is not understood.
bool parse_part(std::string_view part, PathParts& parts) {
    if (part == "vertex stage") {
        parts.vertex_stage = true;
        return true;
    }
    if (part == "visibility") {
        parts.ordering = true;
        return true;
    }
    if (parse_decision(part, parts)) {
        return true;
    }
    if (const auto operation = parse_operation(part)) {
        parts.operation = operation;
        return true;
    }
    const auto space = part.find(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    const std::string_view word = part.substr(0, space);
    const std::string_view rest = trimmed(part.substr(space));
    if (word == "triangle") {
        return parse_triangle(rest, parts);
    }
    if (word == "tile") {
        return parse_tile(rest, parts);
    }
    if (word == "scanline") {
        return (parts.scanline = parse_number<int>(rest)).has_value();
    }
    if (word == "sample") {
        return (parts.sample = parse_number<int>(rest)).has_value();
    }
    if (word == "plane") {
        return (parts.plane = parse_name<geometry::ClipPlane>(rest)).has_value();
    }
    if (word == "pixel") {
        return (parts.visit = parse_pixel(rest)).has_value();
    }
    if (word == "fragment") {
        return (parts.fragment = parse_pixel(rest)).has_value();
    }
    std::optional<std::uint32_t>* number = word == "object"   ? &parts.object
                                           : word == "vertex" ? &parts.vertex
                                           : word == "line"   ? &parts.line
                                           : word == "point"  ? &parts.point
                                           : word == "piece"  ? &parts.piece
                                                              : nullptr;
    return number != nullptr && (*number = parse_number<std::uint32_t>(rest)).has_value();
}

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
    const StepId first = recording.draw_steps[draw];
    const StepId last = last_step_of_draw(recording, draw);
    for (std::size_t entry = index_entry_of_step(recording, last);; --entry) {
        const Outline window = outline(recording, entry);
        const auto step =
            std::find_if(window.steps.rbegin(), window.steps.rend(), [&](const Step& candidate) {
                return candidate.id >= first && candidate.id <= last && matches(candidate, parts);
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
        const auto number = parse_number<StepId>(text.substr(1));
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
    return find_parts(recording, parts);
}

} // namespace hs::trace
