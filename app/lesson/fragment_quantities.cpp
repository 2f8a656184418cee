// A fragment: its weights, its depth, its color, its fate.
#include "app/lesson/quantity.hpp"
#include "core/trace/detail.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace hs::lesson {

namespace {

using trace::FragmentDetail;
using trace::Recording;

/// Walks the fragments that reached the pixel, last first, to the triangle's.
Result<FragmentDetail> find_fragment(const Recording& recording, const Subject& subject) {
    const std::uint32_t triangle =
        recording.objects[*subject.object].first_triangle + *subject.triangle;
    std::uint32_t fragment = recording.final_pixels[*subject.pixel].last_fragment;
    while (fragment != trace::no_fragment) {
        if (recording.run_of_fragment(fragment).triangle == triangle) {
            return trace::fragment_detail(recording, fragment);
        }
        fragment = recording.fragments[fragment].previous;
    }
    return Diagnostic{
        "",
        0,
        0,
        fmt::format(
            "triangle {} of object {} has no fragment at pixel {},{}",
            *subject.triangle,
            *subject.object,
            subject.pixel->x,
            subject.pixel->y
        )};
}

Diagnostic did_not_reach(const Subject& subject, std::string_view stage) {
    return {
        "",
        0,
        0,
        fmt::format(
            "the fragment at pixel {},{} did not reach {}",
            subject.pixel->x,
            subject.pixel->y,
            stage
        )};
}

template <typename Read>
Result<Value> of_fragment(const Recording& recording, const Subject& subject, Read read) {
    const Result<FragmentDetail> fragment = find_fragment(recording, subject);
    return fragment ? read(*fragment) : Result<Value>{fragment.diagnostics()};
}

template <int corner>
Result<Value> barycentric(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [](const FragmentDetail& f) -> Result<Value> {
        return Value{static_cast<double>(f.fragment.barycentric[corner])};
    });
}

template <int corner>
Result<Value> barycentric_clip(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [](const FragmentDetail& f) -> Result<Value> {
        return Value{static_cast<double>(f.fragment.barycentric_clip[corner])};
    });
}

Result<Value> depth(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [](const FragmentDetail& f) -> Result<Value> {
        return Value{static_cast<double>(f.fragment.depth)};
    });
}

template <int channel>
Result<Value> color(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [&](const FragmentDetail& f) -> Result<Value> {
        if (!f.shaded) {
            return did_not_reach(subject, "shading");
        }
        return Value{static_cast<double>(f.shaded->color[channel])};
    });
}

Result<Value> stored_depth(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [&](const FragmentDetail& f) -> Result<Value> {
        if (!f.depth_test) {
            return did_not_reach(subject, "the depth test");
        }
        return Value{static_cast<double>(f.depth_test->stored)};
    });
}

Result<Value> passes_depth_test(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [&](const FragmentDetail& f) -> Result<Value> {
        if (!f.depth_test) {
            return did_not_reach(subject, "the depth test");
        }
        return Value{f.depth_test->passed};
    });
}

Result<Value> fate(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [](const FragmentDetail& f) -> Result<Value> {
        return Value{std::string{name_of(f.fate)}};
    });
}

/// 1/w is linear in the window: the weights of the window interpolate it.
Result<Value> fragment_inv_w(const Recording& recording, const Subject& subject) {
    return of_fragment(recording, subject, [&](const FragmentDetail& f) -> Result<Value> {
        const trace::TriangleDetail triangle =
            trace::triangle_detail(recording, *subject.object, *subject.triangle);
        if (triangle.pieces.size() != 1) {
            return Diagnostic{
                "", 0, 0, "1/w at a pixel is known for triangles that are not clipped"};
        }
        const auto& v = triangle.pieces[0].window;
        const auto& lambda = f.fragment.barycentric;
        return Value{static_cast<double>(
            math::interpolate(v[0].inv_w, v[1].inv_w, v[2].inv_w, lambda[1], lambda[2])
        )};
    });
}

constexpr QuantityOf of = QuantityOf::fragment;

constexpr std::array<Quantity, 15> rows{{
    {"λ0", of, "weight of the triangle's first vertex, in the window", barycentric<0>},
    {"λ1", of, "weight of the triangle's second vertex, in the window", barycentric<1>},
    {"λ2", of, "weight of the triangle's third vertex, in the window", barycentric<2>},
    {"1/w", of, "the interpolated 1/w", fragment_inv_w},
    {"b0", of, "weight of the first vertex, corrected for perspective", barycentric_clip<0>},
    {"b1", of, "weight of the second vertex, corrected for perspective", barycentric_clip<1>},
    {"b2", of, "weight of the third vertex, corrected for perspective", barycentric_clip<2>},
    {"depth", of, "the fragment's depth", depth},
    {"color.r", of, "red of the fragment", color<0>},
    {"color.g", of, "green of the fragment", color<1>},
    {"color.b", of, "blue of the fragment", color<2>},
    {"color.a", of, "alpha of the fragment", color<3>},
    {"stored depth", of, "the depth buffer's value before the test", stored_depth},
    {"passes depth test", of, "whether the fragment passes the depth test", passes_depth_test},
    {"fate", of, "what became of the fragment", fate},
}};

} // namespace

std::span<const Quantity> fragment_quantities() {
    return rows;
}

} // namespace hs::lesson
