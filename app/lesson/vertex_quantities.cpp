// A vertex in every space it passes through.
#include "app/lesson/quantity.hpp"
#include "core/trace/detail.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace hs::lesson {

namespace {

using pipeline::VertexWork;
using trace::Recording;
using trace::VertexDetail;

VertexDetail detail(const Recording& recording, const Subject& subject) {
    return trace::vertex_detail(recording, *subject.object, *subject.vertex);
}

/// A component of a position the vertex stage computed.
template <auto position, auto component>
Result<Value> in_vertex_stage(const Recording& recording, const Subject& subject) {
    const VertexDetail vertex = detail(recording, subject);
    return Value{static_cast<double>((vertex.work.*position).*component)};
}

/// What only a vertex with a place in the window has.
template <typename Read>
Result<Value> placed(const Recording& recording, const Subject& subject, Read read) {
    const VertexDetail vertex = detail(recording, subject);
    if (vertex.window.status != geometry::WindowStatus::placed) {
        return Diagnostic{
            "",
            0,
            0,
            fmt::format(
                "vertex {} of object {} has no place in the window",
                *subject.vertex,
                *subject.object
            )};
    }
    return Value{static_cast<double>(read(vertex.window))};
}

template <auto component>
Result<Value> in_ndc(const Recording& recording, const Subject& subject) {
    return placed(recording, subject, [](const geometry::WindowVertex& v) {
        return v.ndc.*component;
    });
}

template <auto component>
Result<Value> in_window(const Recording& recording, const Subject& subject) {
    return placed(recording, subject, [](const geometry::WindowVertex& v) {
        return v.window.*component;
    });
}

template <auto component>
Result<Value> snapped(const Recording& recording, const Subject& subject) {
    return placed(recording, subject, [](const geometry::WindowVertex& v) {
        return to_pixels(v.fixed.*component);
    });
}

template <auto component>
Result<Value> fixed(const Recording& recording, const Subject& subject) {
    return placed(recording, subject, [](const geometry::WindowVertex& v) {
        return v.fixed.*component;
    });
}

Result<Value> inv_w(const Recording& recording, const Subject& subject) {
    return placed(recording, subject, [](const geometry::WindowVertex& v) { return v.inv_w; });
}

/// The planes a vertex is outside of, by name; "inside" when there is none.
Result<Value> outcode(const Recording& recording, const Subject& subject) {
    const unsigned code = detail(recording, subject).outcode;
    std::string planes;
    for (unsigned k = 0; k < geometry::max_clip_planes; ++k) {
        if ((code >> k & 1U) != 0) {
            planes += planes.empty() ? "" : ", ";
            planes += name_of(static_cast<geometry::ClipPlane>(k));
        }
    }
    return Value{planes.empty() ? std::string{"inside"} : planes};
}

using math::ClipPosition;
using math::EyePosition;
using math::NdcPosition;
using math::ObjectPosition;
using math::WindowPosition;
using math::WorldPosition;

constexpr QuantityOf of = QuantityOf::vertex;
constexpr auto object = &VertexWork::object;
constexpr auto world = &VertexWork::world;
constexpr auto eye = &VertexWork::eye;
constexpr auto clip = &VertexWork::clip;

// clang-format off
constexpr std::array<Quantity, 28> rows{{
    {"object.x", of, "as modeled", in_vertex_stage<object, &ObjectPosition::x>},
    {"object.y", of, "as modeled", in_vertex_stage<object, &ObjectPosition::y>},
    {"object.z", of, "as modeled", in_vertex_stage<object, &ObjectPosition::z>},
    {"object.w", of, "as modeled; 1 for points", in_vertex_stage<object, &ObjectPosition::w>},
    {"world.x", of, "after the model matrix", in_vertex_stage<world, &WorldPosition::x>},
    {"world.y", of, "after the model matrix", in_vertex_stage<world, &WorldPosition::y>},
    {"world.z", of, "after the model matrix", in_vertex_stage<world, &WorldPosition::z>},
    {"world.w", of, "after the model matrix", in_vertex_stage<world, &WorldPosition::w>},
    {"eye.x", of, "after the view matrix", in_vertex_stage<eye, &EyePosition::x>},
    {"eye.y", of, "after the view matrix", in_vertex_stage<eye, &EyePosition::y>},
    {"eye.z", of, "after the view matrix", in_vertex_stage<eye, &EyePosition::z>},
    {"eye.w", of, "after the view matrix", in_vertex_stage<eye, &EyePosition::w>},
    {"clip.x", of, "after the projection matrix", in_vertex_stage<clip, &ClipPosition::x>},
    {"clip.y", of, "after the projection matrix", in_vertex_stage<clip, &ClipPosition::y>},
    {"clip.z", of, "after the projection matrix", in_vertex_stage<clip, &ClipPosition::z>},
    {"clip.w", of, "what the divide divides by", in_vertex_stage<clip, &ClipPosition::w>},
    {"inv_w", of, "1/w of clip space", inv_w},
    {"outcode", of, "the clip planes it is outside of", outcode},
    {"ndc.x", of, "clip x over w", in_ndc<&NdcPosition::x>},
    {"ndc.y", of, "clip y over w", in_ndc<&NdcPosition::y>},
    {"ndc.z", of, "clip z over w", in_ndc<&NdcPosition::z>},
    {"window.x", of, "pixels from the left edge", in_window<&WindowPosition::x>},
    {"window.y", of, "pixels from the top edge", in_window<&WindowPosition::y>},
    {"window.depth", of, "NDC z mapped to depth", in_window<&WindowPosition::depth>},
    {"snapped.x", of, "window x rounded to 1/256 pixel", snapped<&FixedPosition::x>},
    {"snapped.y", of, "window y rounded to 1/256 pixel", snapped<&FixedPosition::y>},
    {"fixed.x", of, "snapped x in 1/256 pixel from the center of pixel 0", fixed<&FixedPosition::x>},
    {"fixed.y", of, "snapped y in 1/256 pixel from the center of pixel 0", fixed<&FixedPosition::y>},
}};
// clang-format on

} // namespace

std::span<const Quantity> vertex_quantities() {
    return rows;
}

} // namespace hs::lesson
