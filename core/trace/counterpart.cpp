#include "core/trace/counterpart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace hs::trace {
namespace {

std::optional<StepId> find(const Recording& other, const std::string& path) {
    const Result<StepId> found = find_step(other, path);
    return found ? std::optional{*found} : std::nullopt;
}

std::string triangle_path(const Step& step) {
    return fmt::format("object {} / {}", step.object, primitive_name(step));
}

/// The fragment of the same triangle at the same pixel; where several pieces made one, the first.
std::optional<std::uint32_t> find_fragment(const Recording& other, const Step& step) {
    const std::uint32_t triangle = other.objects[step.object].first_triangle + step.triangle;
    std::optional<std::uint32_t> found;
    std::uint32_t fragment = other.final_pixels[step.pixel].last_fragment;
    while (fragment != no_fragment) {
        if (other.run_of_fragment(fragment).triangle == triangle) {
            found = fragment;
        }
        fragment = other.fragments[fragment].previous;
    }
    return found;
}

/// The step of a kind within a fragment that ends with `last`; `last` where it has none.
Counterpart in_fragment(const Recording& other, StepId last, StepKind kind) {
    const Step end = describe_step(other, last);
    for (StepId id = last;; --id) {
        const Step step = describe_step(other, id);
        if (!step.in_fragment() || step.fragment != end.fragment) {
            return {last, Match::same_pixel};
        }
        if (step.kind == kind) {
            return {id, Match::same_step};
        }
    }
}

/// What is asked of a pixel, a tile or a scanline where the other recording does not ask the same.
Counterpart in_unit(const Recording& other, const Step& step, Counterpart done) {
    if (const auto fragment = step.has_pixel() ? find_fragment(other, step) : std::nullopt) {
        const StepId last = last_step_of_fragment(other, *fragment);
        return {in_fragment(other, last, StepKind::interpolate).step, Match::same_pixel};
    }
    const std::string triangle = triangle_path(step);
    const PixelPos p = step.pixel;
    if (const auto visit = find(other, fmt::format("{} / pixel {},{}", triangle, p.x, p.y));
        visit && !step.of_scanline()) {
        return {*visit, Match::same_pixel};
    }
    if (const auto row = find(other, fmt::format("{} / scanline {}", triangle, p.y));
        row && step.kind != StepKind::tile_test) {
        return {*row, Match::same_scanline};
    }
    return done;
}

Counterpart of_triangle(const Recording& other, const Step& step) {
    if (const auto fragment = step.in_fragment() ? find_fragment(other, step) : std::nullopt) {
        return in_fragment(other, last_step_of_fragment(other, *fragment), step.kind);
    }
    if (const auto same = find(other, step_path(step))) {
        return {*same, Match::same_step};
    }
    const std::uint32_t triangle = other.objects[step.object].first_triangle + step.triangle;
    const Counterpart done{last_step_of_triangle(other, triangle), Match::same_part};
    if (step.in_unit()) {
        return in_unit(other, step, done);
    }
    if (step.kind == StepKind::clip_plane) {
        return {other.triangles[triangle].first_step, Match::same_part}; // outcodes: nothing is cut
    }
    const auto other_piece =
        find(other, fmt::format("{} / {}", triangle_path(step), name_of(step.kind)));
    return {other_piece.value_or(done.step), Match::same_part};
}

/// A decision of a scanline or ray: where the other is done with the pixel, else with everything.
Counterpart of_sweep(const Recording& other, const Step& step) {
    if (const auto same = find(other, step_path(step))) {
        return {*same, Match::same_step};
    }
    if (step.sweeps_pixel()) {
        const std::uint32_t fragment = other.final_pixels[step.pixel].last_fragment;
        if (fragment != no_fragment) {
            return {last_step_of_fragment(other, fragment), Match::same_pixel};
        }
    }
    return {other.end_step, Match::same_part};
}

} // namespace

Counterpart counterpart(const Recording& other, const Step& step) {
    if (step.in_triangle()) {
        return of_triangle(other, step);
    }
    if (step.kind == StepKind::sweep) {
        return of_sweep(other, step);
    }
    if (const auto same = find(other, step_path(step))) {
        return {*same, Match::same_step};
    }
    const std::string vertex =
        fmt::format("vertex stage / object {} / vertex {}", step.object, step.vertex);
    return {find(other, vertex).value_or(other.end_step), Match::same_part};
}

Counterpart
counterpart_by_count(const Recording& other, const Recording& recording, const Step& step) {
    if (!step.in_triangle()) {
        return counterpart(other, step);
    }
    const std::uint32_t triangle = recording.objects[step.object].first_triangle + step.triangle;
    const StepId done = step.id - recording.triangles[triangle].first_step;
    const StepId there = other.triangles[triangle].first_step + done;
    return {std::min(there, last_step_of_triangle(other, triangle)), Match::same_count};
}

Difference difference(const Recording& a, const Recording& b) {
    HS_CHECK(a.width() == b.width() && a.height() == b.height(), "the pictures have one size");
    Difference result;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const PixelPos pixel{x, y};
            if (a.final_pixels.color(pixel) != b.final_pixels.color(pixel)) {
                result.color.push_back(pixel);
            }
            const bool equal = a.final_pixels[pixel].depth == b.final_pixels[pixel].depth;
            result.depths += equal ? 0U : 1U;
        }
    }
    return result;
}

} // namespace hs::trace

namespace hs {

template <>
std::span<const Named<trace::Match>> names<trace::Match>() {
    using trace::Match;
    static constexpr std::array<Named<Match>, 5> table{{
        {Match::same_step, "same step", "both stand on the same step"},
        {Match::same_pixel,
         "same pixel",
         "the other has no such step, and stands on the same triangle at the same pixel"},
        {Match::same_scanline,
         "same scanline",
         "the other does not ask this pixel, and stands where it is done with the scanline"},
        {Match::same_part,
         "same part",
         "the other has no such step, and stands where it is done with this triangle or vertex"},
        {Match::same_count,
         "same count",
         "both stand as many steps into the triangle; who is done first waits"},
    }};
    return table;
}

} // namespace hs
