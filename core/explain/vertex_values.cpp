// The values of the vertex stage: three matrices one after the other, and per-vertex lighting.
#include "core/explain/value_list.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

using trace::StepKind;

std::string who(const trace::Step& step) {
    return fmt::format("vertex {} of object {}", step.vertex, step.object);
}

/// Matrix times vector; values "world.x" … "world.w".
template <typename From, typename To>
void add_transform(
    ValueList& list,
    const std::string& space,
    char letter,
    const math::Transform<From, To>& transform,
    const std::array<Real, 4>& from,
    const std::string& given
) {
    for (int r = 0; r < 4; ++r) {
        const auto entry = [&](int column) {
            return operand(
                fmt::format("{}{}{}", letter, r, column),
                transform.matrix[column][r],
                {{}, {}, given}
            );
        };
        list.add(
            fmt::format("{}.{}", space, axis_names[static_cast<unsigned>(r)]),
            math::row_times_vector(
                entry(0), entry(1), entry(2), entry(3), from[0], from[1], from[2], from[3]
            )
        );
    }
}

/// A position that an earlier step of the vertex computed, or that was modeled.
template <typename Space>
std::array<Real, 4> position_terms(
    const StepContext& context,
    const std::string& space,
    const math::Position<Space>& p,
    std::optional<StepKind> made_by
) {
    const auto part = [&](const char* axis, float value) {
        const std::string name = space + "." + axis;
        return made_by ? context.value(*made_by, name, value)
                       : operand(name, value, {{}, {}, who(context.step)});
    };
    return {part("x", p.x), part("y", p.y), part("z", p.z), part("w", p.w)};
}

/// Vertex color times material, without lights.
void add_surface(ValueList& list, const StepContext& context) {
    const pipeline::VertexInputs& in = context.call().vertex;
    const bool colored = !in.mesh->colors.empty();
    for (int k = 0; k < 4; ++k) {
        const char* const channel = channel_names[static_cast<unsigned>(k)];
        const Real color =
            colored ? operand(
                          fmt::format("vertex color.{}", channel),
                          in.mesh->colors[context.step.vertex][k],
                          {{}, {}, "color of " + who(context.step)}
                      )
                    : Real{1.0F};
        const Real diffuse = operand(
            fmt::format("material.{}", channel), in.diffuse[k], {{}, {}, "material.diffuse"}
        );
        list.add(fmt::format("surface.{}", channel), color * diffuse);
    }
}

/// Object to eye, by the inverse transpose.
void add_normal(ValueList& list, const StepContext& context) {
    const pipeline::VertexInputs& in = context.call().vertex;
    if (in.mesh->normals.empty()) {
        return;
    }
    const glm::vec3& normal = in.mesh->normals[context.step.vertex];
    for (int r = 0; r < 3; ++r) {
        const auto product = [&](int column) {
            const Real entry = operand(
                fmt::format("N{}{}", r, column),
                in.transforms.normal[column][r],
                {{}, {}, "inverse transpose of view times model"}
            );
            return entry * operand(
                               fmt::format("normal.{}", axis_names[static_cast<unsigned>(column)]),
                               normal[column],
                               {{}, {}, "normal of " + who(context.step)}
                           );
        };
        list.add(
            fmt::format("eye normal.{}", axis_names[static_cast<unsigned>(r)]),
            (product(0) + product(1)) + product(2)
        );
    }
}

void add_vertex_light(ValueList& list, const StepContext& context) {
    const pipeline::DrawCall& call = context.call();
    const shading::SurfacePoint point =
        pipeline::vertex_surface(call.vertex, context.step.vertex, context.detail.vertex->work.eye);
    const auto triple = [&](StepKind kind,
                            const std::string& name,
                            const std::array<const char*, 4>& parts,
                            const glm::vec3& v) -> Triple {
        const auto part = [&](unsigned k, float value) {
            return context.value(kind, name + "." + parts[k], value);
        };
        return {part(0, v.x), part(1, v.y), part(2, v.z)};
    };
    add_lighting(
        list,
        call,
        {triple(StepKind::vertex_eye, "eye", axis_names, point.position),
         triple(StepKind::vertex_eye, "eye normal", axis_names, point.normal),
         triple(StepKind::vertex_world, "surface", channel_names, glm::vec3{point.color})},
        "color."
    );
    list.add("color.a", context.value(StepKind::vertex_world, "surface.a", point.color.a));
}

} // namespace

void add_vertex_values(ValueList& list, const StepContext& context) {
    const trace::VertexDetail& vertex = *context.detail.vertex;
    const pipeline::Transforms& t = vertex.transforms;
    const pipeline::VertexWork& work = vertex.work;
    if (context.step.kind == StepKind::vertex_world) {
        const auto object = position_terms(context, "object", work.object, std::nullopt);
        const std::string given = fmt::format("object.{}.transform", context.step.object);
        add_transform(list, "world", 'M', t.model, object, given);
        add_surface(list, context);
    } else if (context.step.kind == StepKind::vertex_eye) {
        const auto world = position_terms(context, "world", work.world, StepKind::vertex_world);
        add_transform(list, "eye", 'V', t.view, world, "camera: eye, target, up");
        add_normal(list, context);
    } else if (context.step.kind == StepKind::vertex_clip) {
        const auto eye = position_terms(context, "eye", work.eye, StepKind::vertex_eye);
        add_transform(list, "clip", 'P', t.projection, eye, "camera.projection");
    } else {
        add_vertex_light(list, context);
    }
}

} // namespace hs::explain
