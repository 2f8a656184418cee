#include "core/explain/why_not.hpp"

#include "core/explain/clip_story.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/samples.hpp"
#include "core/explain/sentence.hpp"
#include "core/pipeline/homogeneous.hpp"
#include "core/trace/last_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hs {

template <>
std::span<const Named<explain::PixelRole>> names<explain::PixelRole>() {
    using explain::PixelRole;
    static constexpr std::array<Named<PixelRole>, 17> table{{
        {PixelRole::shows, "shows", "the pixel shows its color"},
        {PixelRole::overwritten, "overwritten", "it colored the pixel, and another came after it"},
        {PixelRole::depth_failed, "depth failed", "its fragment failed the depth test"},
        {PixelRole::scissor_failed, "scissor failed", "the pixel lies outside the scissor"},
        {PixelRole::pixel_closed, "pixel closed", "a nearer triangle had closed the pixel"},
        {PixelRole::not_drawn_yet, "not drawn yet", "the playhead stands before it"},
        {PixelRole::stuck, "stuck", "the ordering found no moment to draw it"},
        {PixelRole::outside, "outside", "nothing of it lies in the view volume"},
        {PixelRole::cut_away, "cut away", "clipping removed the part that covers the pixel"},
        {PixelRole::behind_the_eye, "behind the eye", "a vertex with w = 0 has no place"},
        {PixelRole::too_large, "too large", "a vertex lies beyond exact arithmetic"},
        {PixelRole::back_facing, "back-facing", "it shows its back, which is culled"},
        {PixelRole::front_facing, "front-facing", "it shows its front, which is culled"},
        {PixelRole::degenerate, "degenerate", "its snapped vertices enclose no area"},
        {PixelRole::beyond_viewport, "beyond viewport", "the pixel lies outside the viewport"},
        {PixelRole::hidden, "hidden", "a scanline or ray found another nearer"},
        {PixelRole::not_covered, "not covered", "the pixel lies outside one of its edges"},
    }};
    return table;
}

} // namespace hs

namespace hs::explain {
namespace {

using geometry::TriangleVerdict;
using trace::Left;

constexpr std::array edge_names{"E01", "E12", "E20"};

std::string real(double value) {
    return number(static_cast<float>(value));
}

// ---- who and where

/// "triangle 12", "line 2 of object 1".
std::string who(const trace::Recording& recording, std::uint32_t triangle) {
    const std::uint32_t object = recording.object_of_triangle(triangle);
    const std::string path = trace::primitive_path(
        recording, object, triangle - recording.objects[object].first_triangle
    );
    const std::string own = path.substr(path.find(" / ") + 3);
    return recording.objects.size() > 1 ? fmt::format("{} of object {}", own, object) : own;
}

/// One triangle and one pixel.
struct Case {
    const trace::Player& player;
    PixelPos pixel;
    std::uint32_t triangle = 0; ///< over the whole frame

    [[nodiscard]] const trace::Recording& recording() const { return player.recording(); }
    [[nodiscard]] std::uint32_t object() const { return recording().object_of_triangle(triangle); }
    [[nodiscard]] std::uint32_t own() const {
        return triangle - recording().objects[object()].first_triangle;
    }
    [[nodiscard]] const pipeline::DrawCall& call() const {
        return recording().frame->calls()[object()];
    }
    [[nodiscard]] std::string name() const { return who(recording(), triangle); }
    [[nodiscard]] bool is_triangle() const {
        return call().primitive(own()).kind == scene::PrimitiveKind::triangle;
    }
    /// The first of the triangle's steps that exists; its last one if none does.
    [[nodiscard]] trace::StepId step(std::initializer_list<std::string_view> names) const {
        const std::string path = trace::primitive_path(recording(), object(), own());
        for (const std::string_view each : names) {
            if (const auto found =
                    trace::find_step(recording(), fmt::format("{} / {}", path, each))) {
                return *found;
            }
        }
        return trace::last_step_of_triangle(recording(), triangle);
    }
    [[nodiscard]] std::string asked() const { return fmt::format("pixel {},{}", pixel.x, pixel.y); }
    [[nodiscard]] TriangleAtPixel
    verdict(PixelRole role, std::string sentence, trace::StepId step) const {
        return {triangle, role, std::move(sentence), step};
    }
};

// ---- fragments

/// Its fragments among those that reached the pixel up to `last`, the last one first.
std::vector<std::uint32_t> fragments_up_to(const Case& of, std::uint32_t last) {
    std::vector<std::uint32_t> list;
    const trace::Recording& recording = of.recording();
    for (std::uint32_t i = last; i != trace::no_fragment; i = recording.fragments[i].previous) {
        if (recording.run_of_fragment(i).triangle == of.triangle) {
            list.push_back(i);
        }
    }
    return list;
}

/// Its fragments at the pixel up to the playhead.
std::vector<std::uint32_t> fragments_of(const Case& of) {
    return fragments_up_to(of, of.player.pixel(of.pixel).last_fragment);
}

/// The samples whose color is the triangle's; with one sample a pixel, bit 0.
raster::CoverageMask samples_shown(const Case& of) {
    const trace::Recording& recording = of.recording();
    const std::uint32_t last = of.player.pixel(of.pixel).last_fragment;
    const int count = recording.settings().samples;
    unsigned mask = 0;
    for (int s = 0; s < count; ++s) {
        const std::uint32_t writer =
            trace::last_writer(recording, last, count > 1 ? s : -1, Left::color);
        const bool own = writer != trace::no_fragment &&
                         recording.run_of_fragment(writer).triangle == of.triangle;
        mask |= own ? 1U << static_cast<unsigned>(s) : 0U;
    }
    return static_cast<raster::CoverageMask>(mask);
}

TriangleAtPixel shown(const Case& of, std::uint32_t fragment, raster::CoverageMask samples) {
    const trace::FragmentRecord& record = of.recording().fragments[fragment];
    const std::string depth = number(record.depth);
    return of.verdict(
        PixelRole::shows,
        of.recording().settings().samples > 1
            ? fmt::format(
                  "Of {} the pixel shows the color in samples {}.", of.name(), sample_list(samples)
              )
            : fmt::format(
                  "The pixel shows {}: its fragment at depth {} was the last one written.",
                  of.name(),
                  depth
              ),
        trace::last_step_of_fragment(of.recording(), fragment)
    );
}

/// Written once, and no longer to be seen.
TriangleAtPixel overwritten(const Case& of, std::uint32_t fragment) {
    const trace::Recording& recording = of.recording();
    std::uint32_t next = trace::no_fragment;
    for (std::uint32_t i = of.player.pixel(of.pixel).last_fragment; i != fragment;
         i = recording.fragments[i].previous) {
        if (recording.fragments[i].written()) {
            next = i;
        }
    }
    HS_CHECK(next != trace::no_fragment, "who overwrote it came later");
    const std::uint32_t by = recording.run_of_fragment(next).triangle;
    const bool blended =
        recording.frame->calls()[recording.object_of_triangle(by)].settings.blend_enabled;
    return of.verdict(
        PixelRole::overwritten,
        fmt::format(
            "{} colored the pixel at depth {}; then {} {}.",
            of.name(),
            number(recording.fragments[fragment].depth),
            who(recording, by),
            blended
                ? "was blended over it"
                : fmt::format("overwrote it at depth {}", number(recording.fragments[next].depth))
        ),
        trace::last_step_of_fragment(recording, fragment)
    );
}

/// Who put something there before a fragment came: "triangle 3", "the cleared buffer".
std::string earlier(const Case& of, std::uint32_t fragment, int sample, Left what) {
    const std::uint32_t writer = trace::last_writer(
        of.recording(), of.recording().fragments[fragment].previous, sample, what
    );
    return writer == trace::no_fragment
               ? std::string{"the cleared buffer"}
               : who(of.recording(), of.recording().run_of_fragment(writer).triangle);
}

TriangleAtPixel depth_failed(const Case& of, std::uint32_t fragment) {
    const trace::StepId id = trace::last_step_of_fragment(of.recording(), fragment);
    const trace::StepDetail detail =
        trace::step_detail(of.recording(), trace::describe_step(of.recording(), id));
    const pipeline::DepthTest& test = *detail.fragment->depth_test;
    const auto [depth, stored] = compared(test.depth, test.stored);
    const std::string_view sign = symbol(test.op);
    return of.verdict(
        PixelRole::depth_failed,
        sign.empty() ? fmt::format("{} failed the depth test: it never passes.", of.name())
                     : fmt::format(
                           "{} failed the depth test against {}: {} {} {} is false.",
                           of.name(),
                           earlier(of, fragment, test.sample, Left::depth),
                           depth,
                           sign,
                           stored
                       ),
        id
    );
}

/// It reached the pixel, and was never written.
TriangleAtPixel failed(const Case& of, std::uint32_t fragment) {
    const trace::StepId id = trace::last_step_of_fragment(of.recording(), fragment);
    if (of.recording().fragments[fragment].fate == fragment::FragmentFate::depth_failed) {
        return depth_failed(of, fragment);
    }
    if (of.recording().fragments[fragment].fate == fragment::FragmentFate::pixel_closed) {
        return of.verdict(
            PixelRole::pixel_closed,
            fmt::format(
                "{} came too late: {} is nearer and had closed the pixel.",
                of.name(),
                earlier(of, fragment, -1, Left::color)
            ),
            id
        );
    }
    const PixelRect& rect = *of.call().settings.scissor;
    return of.verdict(
        PixelRole::scissor_failed,
        fmt::format(
            "{} failed the scissor test: pixel {} lies outside {} … {} in x, {} … {} in y.",
            of.name(),
            pixel(of.pixel),
            rect.x0,
            rect.x1 - 1,
            rect.y0,
            rect.y1 - 1
        ),
        id
    );
}

// ---- the projection, as if nothing were clipped

/// Weights over w where the ray through a pixel's center meets the triangle.
struct RayHit {
    std::array<double, 3> rho{};
    double inv_w = 0.0;
};

/// Empty where it passes the triangle by, or meets it behind the eye. Borders belong to it.
std::optional<RayHit> ray_hit(const Case& of) {
    const scene::TriangleIndices indices = of.call().primitive(of.own()).vertices;
    pipeline::HomogeneousTriangle triangle;
    for (int corner = 0; corner < 3; ++corner) {
        triangle.clip[static_cast<unsigned>(corner)] = of.call().vertices[indices[corner]].clip;
    }
    const auto vertices = pipeline::homogeneous_vertices(of.call(), triangle);
    const double determinant = raster::determinant(vertices);
    if (determinant == 0.0 || !std::isfinite(determinant)) {
        return std::nullopt;
    }
    const raster::HomogeneousSetup planes = raster::set_up_planes(vertices, {});
    RayHit hit;
    for (unsigned k = 0; k < 3; ++k) {
        hit.rho[(k + 2) % 3] = planes.edges[k].rho(of.pixel);
    }
    hit.inv_w = (hit.rho[0] + hit.rho[1]) + hit.rho[2];
    const bool inside = std::ranges::all_of(hit.rho, [](double rho) { return rho >= 0.0; });
    return inside && hit.inv_w > 0.0 ? std::optional{hit} : std::nullopt;
}

/// A plane that the triangle crosses, and how far outside of it the ray meets the triangle.
struct Beyond {
    geometry::ClipPlane plane = geometry::ClipPlane::near;
    double distance = 0.0; ///< < 0
};

/// The plane it is farthest outside of; empty where the ray meets it inside of all.
std::optional<Beyond> beyond_plane(const Case& of, const RayHit& hit) {
    const geometry::ClipVolume& volume = of.call().volume;
    const scene::TriangleIndices indices = of.call().primitive(of.own()).vertices;
    const unsigned crossed = of.recording().triangles[of.triangle].crossed;
    std::optional<Beyond> found;
    for (int k = 0; of.call().settings.clip_enabled && k < volume.count; ++k) {
        if ((crossed >> static_cast<unsigned>(k) & 1U) == 0) {
            continue;
        }
        double sum = 0.0;
        for (int corner = 0; corner < 3; ++corner) {
            sum += hit.rho[static_cast<unsigned>(corner)] *
                   static_cast<double>(math::signed_distance(
                       volume.planes[static_cast<unsigned>(k)],
                       math::to_vec4(of.call().vertices[indices[corner]].clip)
                   ));
        }
        const double distance = sum / hit.inv_w;
        if (distance < 0.0 && (!found || distance < found->distance)) {
            found = Beyond{static_cast<geometry::ClipPlane>(k), distance};
        }
    }
    return found;
}

// ---- removed before there were fragments

TriangleAtPixel outside(const Case& of, const trace::TriangleDetail& detail) {
    const geometry::Outcode all = static_cast<geometry::Outcode>(
        detail.outcodes[0] & detail.outcodes[1] & detail.outcodes[2]
    );
    std::string reason = "clipping leaves nothing of it";
    for (unsigned k = 0; k < geometry::max_clip_planes; ++k) {
        if ((static_cast<unsigned>(all) >> k & 1U) == 0) {
            continue;
        }
        std::vector<std::string> distances;
        for (const trace::VertexDetail& corner : detail.corners) {
            distances.push_back(number(
                math::signed_distance(of.call().volume.planes[k], math::to_vec4(corner.work.clip))
            ));
        }
        reason = fmt::format(
            "all its vertices lie outside plane {}, at distances {}",
            name_of(static_cast<geometry::ClipPlane>(k)),
            fmt::join(distances, ", ")
        );
        break;
    }
    return of.verdict(
        PixelRole::outside,
        fmt::format("{} was clipped: {}.", of.name(), reason),
        of.recording().triangles[of.triangle].first_step
    );
}

TriangleAtPixel
culled(const Case& of, const trace::TriangleDetail& detail, TriangleVerdict verdict) {
    const bool back = verdict == TriangleVerdict::back_facing;
    const auto piece = std::ranges::find(detail.pieces, verdict, &trace::PieceDetail::facing);
    HS_CHECK(piece != detail.pieces.end(), "a culled triangle has a culled piece");
    const std::string number_of =
        piece->determinant
            ? fmt::format("its determinant is {}", real(*piece->determinant))
            : fmt::format(
                  "twice its signed area is {} px²", square_pixels(piece->signed_doubled_area)
              );
    const bool ccw =
        piece->determinant ? *piece->determinant < 0.0 : piece->signed_doubled_area > 0;
    return of.verdict(
        back ? PixelRole::back_facing : PixelRole::front_facing,
        fmt::format(
            "{} was culled: {}, {}clockwise, so it shows its {}.",
            of.name(),
            number_of,
            ccw ? "counter" : "",
            back ? "back" : "front"
        ),
        of.step({"facing"})
    );
}

TriangleAtPixel cut_away(const Case& of, geometry::ClipPlane plane, double distance) {
    return of.verdict(
        PixelRole::cut_away,
        fmt::format(
            "{} was clipped: where it would cover the pixel it lies {} outside plane {}.",
            of.name(),
            real(-distance),
            name_of(plane)
        ),
        of.step({of.asked(), fmt::format("clip / plane {}", name_of(plane)), "outcodes"})
    );
}

/// The edge a piece's pixel is farthest outside of.
struct Miss {
    unsigned edge = 0;
    std::int64_t value = 0;  ///< E
    std::int64_t margin = 0; ///< E with its bias, < 0: outside
};

Miss miss_of(const raster::TriangleSetup& setup, PixelPos pixel) {
    const raster::EdgeValues values = setup.evaluate(pixel);
    Miss worst{0, values[0], values[0] + setup.top_left_bias[0]};
    for (unsigned k = 1; k < 3; ++k) {
        if (values[k] + setup.top_left_bias[k] < worst.margin) {
            worst = {k, values[k], values[k] + setup.top_left_bias[k]};
        }
    }
    return worst;
}

std::string miss_sentence(const Case& of, const Miss& miss) {
    const scene::Settings& settings = of.call().settings;
    if (settings.sampling == scene::Sampling::conservative) {
        return miss.margin < 0
                   ? fmt::format(
                         "{} does not overlap the pixel's square: at its most inside corner {} = "
                         "{} "
                         "px².",
                         of.name(),
                         edge_names[miss.edge],
                         square_pixels(miss.margin + 1)
                     )
                   : fmt::format("The bounding box of {} ends before the pixel.", of.name());
    }
    if (settings.samples > 1) {
        return fmt::format(
            "{} covers none of the pixel's {} samples: at the center {} = {} px².",
            of.name(),
            settings.samples,
            edge_names[miss.edge],
            square_pixels(miss.value)
        );
    }
    if (miss.value == 0) {
        return fmt::format(
            "{} does not cover the pixel: its center lies exactly on {}, which a neighbor owns.",
            of.name(),
            edge_names[miss.edge]
        );
    }
    return fmt::format(
        "{} does not cover the pixel: {} = {} px² < 0.",
        of.name(),
        edge_names[miss.edge],
        square_pixels(miss.value)
    );
}

/// The piece that comes nearest to covering the pixel speaks for all.
TriangleAtPixel not_covered(const Case& of, const trace::TriangleDetail& detail) {
    std::optional<Miss> nearest;
    for (const trace::PieceDetail& piece : detail.pieces) {
        if (piece.setup) {
            const Miss miss = miss_of(*piece.setup, of.pixel);
            nearest = !nearest || miss.margin > nearest->margin ? miss : *nearest;
        }
    }
    std::string sentence = fmt::format("{} does not pass through the pixel.", of.name());
    if (nearest) {
        sentence = miss_sentence(of, *nearest);
    } else if (!detail.pieces.empty() && detail.pieces[0].planes) {
        const raster::PlaneTest test = raster::test_planes(*detail.pieces[0].planes, of.pixel);
        sentence = fmt::format(
            "{} does not cover the pixel: ρ0, ρ1, ρ2 = {}, {}, {} and 1/w = {}.",
            of.name(),
            real(test.edges[1]),
            real(test.edges[2]),
            real(test.edges[0]),
            real(test.inv_w)
        );
    }
    return of.verdict(PixelRole::not_covered, std::move(sentence), of.step({of.asked(), "setup"}));
}

/// Whether it covers the pixel, where rows show only the nearest: a ray hits it, or the pieces that
/// scanlines cross hold the pixel's center.
bool is_behind_another(const Case& of, const trace::TriangleDetail& detail) {
    const trace::Recording& recording = of.recording();
    if (!recording.settings().sweeps() ||
        recording.final_pixels[of.pixel].last_fragment == trace::no_fragment) {
        return false;
    }
    if (recording.settings().visibility == scene::Visibility::ray_cast) {
        return ray_hit(of).has_value();
    }
    return std::ranges::any_of(detail.pieces, [&of](const trace::PieceDetail& piece) {
        return piece.setup && piece.setup->covers(piece.setup->evaluate(of.pixel));
    });
}

TriangleAtPixel hidden(const Case& of) {
    const trace::Recording& recording = of.recording();
    const std::uint32_t nearest = recording.final_pixels[of.pixel].last_fragment;
    return of.verdict(
        PixelRole::hidden,
        fmt::format(
            "{} covers the pixel, and {} is nearer there.",
            of.name(),
            who(recording, recording.run_of_fragment(nearest).triangle)
        ),
        trace::last_step_of_fragment(recording, nearest)
    );
}

/// It went on to traversal and never came to the pixel.
TriangleAtPixel passed_by(const Case& of, const trace::TriangleDetail& detail) {
    if (of.is_triangle()) {
        const std::optional<RayHit> hit = ray_hit(of);
        const std::optional<Beyond> beyond = hit ? beyond_plane(of, *hit) : std::nullopt;
        if (beyond) {
            return cut_away(of, beyond->plane, beyond->distance);
        }
    }
    if (!of.call().drawable().contains(of.pixel)) {
        return of.verdict(
            PixelRole::beyond_viewport,
            fmt::format("{} is drawn within the viewport, and the pixel lies outside.", of.name()),
            of.step({"setup"})
        );
    }
    if (is_behind_another(of, detail)) {
        return hidden(of);
    }
    return not_covered(of, detail);
}

std::string no_place_sentence(const Case& of, bool at_eye) {
    return at_eye ? fmt::format("{} has a vertex with w = 0, which has no place.", of.name())
                  : fmt::format("{} has a vertex beyond {} pixels.", of.name(), whole(4194304));
}

/// The verdict over the triangle, where it ended before its fragments.
TriangleAtPixel removed(const Case& of) {
    const trace::TriangleDetail detail =
        trace::triangle_detail(of.recording(), of.object(), of.own());
    const TriangleVerdict verdict = of.recording().triangles[of.triangle].verdict;
    switch (verdict) {
    case TriangleVerdict::outside: return outside(of, detail);
    case TriangleVerdict::back_facing:
    case TriangleVerdict::front_facing: return culled(of, detail, verdict);
    case TriangleVerdict::degenerate:
        return of.verdict(
            PixelRole::degenerate,
            fmt::format("{} encloses no area once its vertices are snapped.", of.name()),
            of.step({"facing"})
        );
    case TriangleVerdict::behind_the_eye:
        return of.verdict(
            PixelRole::behind_the_eye, no_place_sentence(of, true), of.step({"divide"})
        );
    case TriangleVerdict::too_large:
        return of.verdict(
            PixelRole::too_large, no_place_sentence(of, false), of.step({"viewport"})
        );
    case TriangleVerdict::stuck:
        return of.verdict(
            PixelRole::stuck,
            fmt::format("{} was passed over: the ordering found no moment for it.", of.name()),
            of.recording().triangles[of.triangle].first_step
        );
    case TriangleVerdict::drawn:
    case TriangleVerdict::unseen:
    case TriangleVerdict::no_sample_covered: return passed_by(of, detail);
    }
    HS_CHECK(false, "every verdict says why");
    return {};
}

std::string with_capital(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

TriangleAtPixel judged(const Case& of) {
    const std::vector<std::uint32_t> fragments = fragments_of(of);
    if (!fragments.empty()) {
        const auto written = std::ranges::find_if(fragments, [&](std::uint32_t i) {
            return of.recording().fragments[i].written();
        });
        if (written == fragments.end()) {
            return failed(of, fragments.front());
        }
        const raster::CoverageMask samples = samples_shown(of);
        return samples != 0 ? shown(of, *written, samples) : overwritten(of, *written);
    }
    // Nothing yet: it is still to come, or it never does
    const std::string later = fmt::format("{} comes later.", of.name());
    const std::vector<std::uint32_t> coming =
        fragments_up_to(of, of.recording().final_pixels[of.pixel].last_fragment);
    if (!coming.empty()) {
        return of.verdict(
            PixelRole::not_drawn_yet,
            later,
            trace::last_step_of_fragment(of.recording(), coming.back())
        );
    }
    TriangleAtPixel verdict = removed(of);
    return verdict.step > of.player.step()
               ? of.verdict(PixelRole::not_drawn_yet, later, verdict.step)
               : verdict;
}

} // namespace

TriangleAtPixel
triangle_at_pixel(const trace::Player& player, PixelPos pixel, std::uint32_t triangle) {
    TriangleAtPixel verdict = judged({player, pixel, triangle});
    verdict.sentence = with_capital(std::move(verdict.sentence));
    return verdict;
}

std::vector<TriangleAtPixel> triangles_at_pixel(const trace::Player& player, PixelPos pixel) {
    std::vector<TriangleAtPixel> list;
    const trace::Recording& recording = player.recording();
    for (std::uint32_t triangle = 0; triangle < recording.triangles.size(); ++triangle) {
        const Case of{player, pixel, triangle};
        if ((of.is_triangle() && ray_hit(of)) || !fragments_of(of).empty()) {
            list.push_back(triangle_at_pixel(player, pixel, triangle));
        }
    }
    return list;
}

} // namespace hs::explain
