// The values of outcodes and clipping, and the vertices that come out of it with their origins.
#include "core/explain/value_list.hpp"
#include "core/math/interpolate.hpp"
#include "core/pipeline/draw.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

using trace::StepKind;

/// A step of the same triangle before there were pieces; parts of split triangles are pieces from
/// the beginning.
trace::Step before_pieces(const StepContext& context, StepKind kind) {
    trace::Step step = context.step;
    step.kind = kind;
    if (step.part) {
        const std::uint32_t draw = context.recording.draw_of_step(step.id);
        const pipeline::DrawOrder& order = context.recording.order;
        const auto part = static_cast<std::size_t>(order.draws[draw].part);
        step.piece = order.parts[part].first_piece;
    }
    return step;
}

const pipeline::TrianglePart* part_of(const StepContext& context) {
    const pipeline::DrawOrder& order = context.recording.order;
    const std::int32_t part = order.draws[context.recording.draw_of_step(context.step.id)].part;
    return part < 0 ? nullptr : &order.parts[static_cast<std::size_t>(part)];
}

// ---- vertices as they enter clipping

trace::Step vertex_step(const StepContext& context, std::uint32_t vertex, StepKind kind) {
    return {.kind = kind, .object = context.step.object, .vertex = vertex};
}

/// Who gave a vertex one of its varyings.
Origin varying_origin(const StepContext& context, std::uint32_t vertex, const std::string& name) {
    const bool color = name.starts_with("color.");
    if (color && context.call().settings.shading == scene::Shading::flat) {
        return {trace::step_path(before_pieces(context, StepKind::outcodes)), "flat " + name, {}};
    }
    if (color && context.call().settings.shading == scene::Shading::gouraud) {
        return {trace::step_path(vertex_step(context, vertex, StepKind::vertex_light)), name, {}};
    }
    if (color) {
        const std::string path = trace::step_path(vertex_step(context, vertex, StepKind::vertex_world));
        return {path, "surface" + name.substr(name.find('.')), {}};
    }
    if (name.starts_with("uv.")) {
        return {{}, {}, fmt::format("uv of vertex {} of object {}", vertex, context.step.object)};
    }
    return {trace::step_path(vertex_step(context, vertex, StepKind::vertex_eye)), name, {}};
}

/// A corner of the whole triangle; with flat interpolation its varyings are the last vertex's.
TermVertex whole_corner(
    const StepContext& context, const geometry::ClipPolygon& assembled, int corner
) {
    const pipeline::DrawCall& call = context.call();
    const scene::TriangleIndices& indices = context.detail.triangle->vertices;
    const bool flat = call.settings.interpolation == scene::InterpolationKind::flat;
    const std::string who = fmt::format("v{}.", corner);
    const std::string path =
        trace::step_path(vertex_step(context, indices[corner], StepKind::vertex_clip));
    const auto position = math::to_vec4(assembled[corner].position);
    TermVertex vertex;
    for (int k = 0; k < 4; ++k) {
        const std::string name = fmt::format("clip.{}", axis_names[static_cast<unsigned>(k)]);
        vertex.position.push_back(operand(who + name, position[k], {path, name, {}}));
    }
    for (int i = 0; i < call.vertex.layout.count; ++i) {
        const std::string name = varying_name(call.vertex.layout, i);
        vertex.varyings.push_back(operand(
            who + name,
            assembled[corner].varyings[i],
            varying_origin(context, indices[flat ? 2 : corner], name)
        ));
    }
    return vertex;
}

/// A corner of a part: the triangle's three vertices by its weights.
TermVertex add_part_corner(
    ValueList& list,
    const StepContext& context,
    const std::array<TermVertex, 3>& whole,
    const glm::dvec3& weights,
    int corner
) {
    const auto mixed = [&](const std::string& name, const auto& value_of) {
        const auto term = [&](unsigned k) {
            const Wide weight = operand(
                fmt::format("weight {}", k), weights[static_cast<int>(k)], {{}, {}, "the split"}
            );
            return weight * to_double(value_of(whole[k]));
        };
        return list.add(
            fmt::format("part v{}.{}", corner, name), to_float((term(0) + term(1)) + term(2))
        );
    };
    TermVertex vertex;
    for (unsigned k = 0; k < 4; ++k) {
        vertex.position.push_back(
            mixed(fmt::format("clip.{}", axis_names[k]), [k](const TermVertex& v) {
                return v.position[k];
            })
        );
    }
    const math::VaryingLayout& layout = context.call().vertex.layout;
    for (int i = 0; i < layout.count; ++i) {
        vertex.varyings.push_back(mixed(varying_name(layout, i), [i](const TermVertex& v) {
            return v.varyings[static_cast<std::size_t>(i)];
        }));
    }
    return vertex;
}

/// The polygon that enters clipping; names what only parts compute in `outcodes`, the list of the
/// step of that kind.
std::vector<TermVertex> assembled(ValueList& outcodes, const StepContext& context) {
    const pipeline::DrawCall& call = context.call();
    const geometry::ClipPolygon polygon =
        pipeline::assemble(call, context.detail.triangle->vertices);
    std::array<TermVertex, 3> whole;
    for (int corner = 0; corner < 3; ++corner) {
        whole[static_cast<unsigned>(corner)] = whole_corner(context, polygon, corner);
    }
    std::vector<TermVertex> result{whole.begin(), whole.end()};
    if (const pipeline::TrianglePart* part = part_of(context)) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto k = static_cast<unsigned>(corner);
            result[k] = add_part_corner(outcodes, context, whole, part->weights[k], corner);
        }
    }
    if (context.step.primitive != scene::PrimitiveKind::triangle) {
        result.pop_back(); // a segment
    }
    return result;
}

// ---- one plane

/// A plane's coefficients in clip space, and the distance of a vertex to it.
class PlaneTerms {
public:
    PlaneTerms(const StepContext& context, geometry::ClipPlane plane) {
        const math::HalfSpace& h = context.call().volume.planes[static_cast<std::size_t>(plane)];
        const std::string name{name_of(plane)};
        const Origin origin{{}, {}, "clip plane " + name};
        coefficients_ = {
            operand(name + ".a", h.a, origin),
            operand(name + ".b", h.b, origin),
            operand(name + ".c", h.c, origin),
            operand(name + ".d", h.d, origin)};
    }

    [[nodiscard]] Real distance(const TermVertex& v) const {
        const auto product = [&](unsigned k) { return coefficients_[k] * v.position[k]; };
        return ((product(0) + product(1)) + product(2)) + product(3);
    }

private:
    std::vector<Real> coefficients_;
};

/// Where the edge from `in` to `out` meets the plane: values "cut 0.t", "cut 0.x", …
TermVertex add_cut(
    ValueList& list,
    const StepContext& context,
    const std::string& name,
    std::pair<const TermVertex&, const Real&> in,
    std::pair<const TermVertex&, const Real&> out
) {
    const Real t = list.add(name + ".t", in.second / (in.second - out.second));
    TermVertex made;
    for (unsigned k = 0; k < 4; ++k) {
        made.position.push_back(list.add(
            fmt::format("{}.{}", name, axis_names[k]),
            math::interpolate(in.first.position[k], out.first.position[k], t)
        ));
    }
    const math::VaryingLayout& layout = context.call().vertex.layout;
    for (int i = 0; i < layout.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        made.varyings.push_back(list.add(
            fmt::format("{}.{}", name, varying_name(layout, i)),
            math::interpolate(in.first.varyings[k], out.first.varyings[k], t)
        ));
    }
    return made;
}

/// Sutherland and Hodgman's step, as geometry/clip_polygon.hpp takes it; on two vertices as
/// clip_segment.hpp does.
std::vector<TermVertex> add_pass(
    ValueList& list,
    const StepContext& context,
    geometry::ClipPlane plane,
    const std::vector<TermVertex>& before
) {
    const PlaneTerms terms(context, plane);
    std::vector<Real> d;
    for (std::size_t i = 0; i < before.size(); ++i) {
        d.push_back(list.add(fmt::format("d{}", i), terms.distance(before[i])));
    }
    int cuts = 0;
    std::vector<TermVertex> kept;
    const auto cut = [&](std::size_t in, std::size_t out) {
        kept.push_back(add_cut(
            list, context, fmt::format("cut {}", cuts++), {before[in], d[in]}, {before[out], d[out]}
        ));
    };
    const bool segment = before.size() == 2;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::size_t previous = i == 0 ? before.size() - 1 : i - 1;
        const bool here = math::inside(d[i].value());
        const bool there = math::inside(d[previous].value());
        if (here && !there && !segment) {
            cut(i, previous);
        }
        if (here) {
            kept.push_back(before[i]);
        } else if (there) {
            cut(previous, i);
        }
    }
    return kept;
}

/// The polygon after all planes, or before `stop`.
std::vector<TermVertex>
clipped(const StepContext& context, std::optional<geometry::ClipPlane> stop = std::nullopt) {
    ValueList outcodes(trace::step_path(before_pieces(context, StepKind::outcodes)));
    std::vector<TermVertex> polygon = assembled(outcodes, context);
    for (const trace::ClipPass& pass : context.detail.triangle->passes) {
        if (pass.plane == stop) {
            break;
        }
        trace::Step step = before_pieces(context, StepKind::clip_plane);
        step.plane = pass.plane;
        ValueList values(trace::step_path(step));
        polygon = add_pass(values, context, pass.plane, polygon);
    }
    return polygon;
}

// ---- flat shading

/// The color that all three vertices get, lit with the triangle's own normal at the last of them.
void add_flat_color(ValueList& list, const StepContext& context) {
    const pipeline::DrawCall& call = context.call();
    const scene::TriangleIndices& indices = context.detail.triangle->vertices;
    std::vector<Triple> eyes;
    for (int corner = 0; corner < 3; ++corner) {
        const std::string path =
            trace::step_path(vertex_step(context, indices[corner], StepKind::vertex_eye));
        const auto& eye = context.detail.triangle->corners[static_cast<unsigned>(corner)].work.eye;
        const auto part = [&](const char* axis, float value) {
            const std::string name = fmt::format("eye.{}", axis);
            return operand(fmt::format("v{}.{}", corner, name), value, {path, name, {}});
        };
        eyes.push_back({part("x", eye.x), part("y", eye.y), part("z", eye.z)});
    }
    const auto edge = [&](std::size_t to) -> Triple {
        return {eyes[to][0] - eyes[0][0], eyes[to][1] - eyes[0][1], eyes[to][2] - eyes[0][2]};
    };
    const Triple u = edge(1);
    const Triple v = edge(2);
    const Real side = operand(
        "facing",
        call.settings.front_face == scene::Winding::ccw ? 1.0F : -1.0F,
        {{}, {}, "settings.front_face"}
    );
    const Triple normal{
        list.add("normal.x", (u[1] * v[2] - v[1] * u[2]) * side),
        list.add("normal.y", (u[2] * v[0] - v[2] * u[0]) * side),
        list.add("normal.z", (u[0] * v[1] - v[0] * u[1]) * side)};
    const geometry::ClipVertex last = call.clip_vertex(indices.c);
    const std::string path =
        trace::step_path(vertex_step(context, indices.c, StepKind::vertex_world));
    const auto surface = [&](unsigned k) {
        const std::string name = fmt::format("surface.{}", channel_names[k]);
        return operand(name, last.varyings[static_cast<int>(k)], {path, name, {}});
    };
    add_lighting(
        list, call, {eyes[2], normal, {surface(0), surface(1), surface(2)}}, "flat color."
    );
    list.add("flat color.a", surface(3));
}

} // namespace

std::string varying_name(const math::VaryingLayout& layout, int index) {
    const auto part = [index](int first, const std::array<const char*, 4>& parts) {
        return parts[static_cast<unsigned>(index - first)];
    };
    if (layout.eye_position >= 0 && index >= layout.eye_position) {
        return fmt::format("eye.{}", part(layout.eye_position, axis_names));
    }
    if (layout.normal >= 0 && index >= layout.normal) {
        return fmt::format("eye normal.{}", part(layout.normal, axis_names));
    }
    if (layout.uv >= 0 && index >= layout.uv) {
        return index == layout.uv ? "uv.u" : "uv.v";
    }
    return fmt::format("color.{}", part(0, channel_names));
}

std::array<TermVertex, 3> corners_of_piece(const StepContext& context) {
    const std::vector<TermVertex> polygon = clipped(context);
    if (polygon.size() == 2) {
        return {polygon[0], polygon[1], polygon[1]};
    }
    const int first = before_pieces(context, StepKind::outcodes).piece;
    const auto k = static_cast<std::size_t>(context.step.part ? context.step.piece - first
                                                              : context.step.piece);
    return {polygon[0], polygon[k + 1], polygon[k + 2]};
}

void add_outcode_values(ValueList& list, const StepContext& context) {
    const std::vector<TermVertex> corners = assembled(list, context);
    const geometry::ClipVolume& volume = context.call().volume;
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        for (int k = 0; k < volume.count; ++k) {
            const auto plane = static_cast<geometry::ClipPlane>(k);
            list.add(
                fmt::format("v{}.{}", corner, name_of(plane)),
                PlaneTerms(context, plane).distance(corners[corner])
            );
        }
    }
    if (context.call().settings.shading == scene::Shading::flat) {
        add_flat_color(list, context);
    }
}

void add_clip_values(ValueList& list, const StepContext& context) {
    add_pass(list, context, context.step.plane, clipped(context, context.step.plane));
}

} // namespace hs::explain
