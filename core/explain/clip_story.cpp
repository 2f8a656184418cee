#include "core/explain/clip_story.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

namespace hs::explain {

OutcodeVerdict outcode_verdict(const std::array<geometry::Outcode, 3>& outcodes) {
    const unsigned any = static_cast<unsigned>(outcodes[0]) | outcodes[1] | outcodes[2];
    const unsigned all = static_cast<unsigned>(outcodes[0]) & outcodes[1] & outcodes[2];
    return any == 0   ? OutcodeVerdict::accepted
           : all != 0 ? OutcodeVerdict::rejected
                      : OutcodeVerdict::undecided;
}

std::string plane_names(geometry::Outcode outcode) {
    std::string text;
    for (int k = 0; k < geometry::max_clip_planes; ++k) {
        if ((static_cast<unsigned>(outcode) >> static_cast<unsigned>(k) & 1U) != 0) {
            text += text.empty() ? "" : ", ";
            text += name_of(static_cast<geometry::ClipPlane>(k));
        }
    }
    return text;
}

std::string_view plane_distance(geometry::ClipPlane plane, scene::DepthConvention convention) {
    const bool zero_to_one = convention != scene::DepthConvention::opengl;
    const bool reversed = convention == scene::DepthConvention::reversed;
    switch (plane) {
    case geometry::ClipPlane::near: return reversed ? "w − z" : zero_to_one ? "z" : "w + z";
    case geometry::ClipPlane::far: return reversed ? "z" : "w − z";
    case geometry::ClipPlane::left: return "w + x";
    case geometry::ClipPlane::right: return "w − x";
    case geometry::ClipPlane::bottom: return "w + y";
    case geometry::ClipPlane::top: return "w − y";
    case geometry::ClipPlane::user0:
    case geometry::ClipPlane::user1: return "a·x + b·y + c·z + d";
    }
    HS_CHECK(false, "every clip plane is handled");
    return "";
}

std::vector<ClipPassStory>
clip_story(const trace::TriangleDetail& triangle, const scene::Settings& settings) {
    const geometry::ClipVolume volume =
        geometry::clip_volume(settings, triangle.corners[0].transforms.projection.matrix);
    std::vector<ClipPassStory> story;
    for (const trace::ClipPass& pass : triangle.passes) {
        const math::HalfSpace& plane = volume.planes[static_cast<std::size_t>(pass.plane)];
        ClipPassStory told{.plane = pass.plane, .distances = {}, .cuts = {}};
        for (int i = 0; i < pass.before.count; ++i) {
            told.distances.push_back(
                math::signed_distance(plane, math::to_vec4(pass.before[i].position))
            );
        }
        const int edges = pass.before.count == 2 ? 1 : pass.before.count; // a line has one
        for (int i = 0; i < edges; ++i) {
            const int j = (i + 1) % pass.before.count;
            const float di = told.distances[static_cast<std::size_t>(i)];
            const float dj = told.distances[static_cast<std::size_t>(j)];
            if (math::inside(di) == math::inside(dj)) {
                continue;
            }
            ClipCut cut;
            cut.inside = math::inside(di) ? i : j;
            cut.outside = math::inside(di) ? j : i;
            cut.d_inside = math::inside(di) ? di : dj;
            cut.d_outside = math::inside(di) ? dj : di;
            cut.t = cut.d_inside / (cut.d_inside - cut.d_outside);
            cut.made = geometry::intersect_edge(
                pass.before[cut.inside], cut.d_inside, pass.before[cut.outside], cut.d_outside
            );
            told.cuts.push_back(cut);
        }
        story.push_back(std::move(told));
    }
    return story;
}

std::vector<std::string> reasons_to_clip(const trace::TriangleDetail& triangle) {
    std::vector<std::string> reasons;
    for (unsigned k = 0; k < 3; ++k) {
        const math::ClipPosition& clip = triangle.corners[k].work.clip;
        if (clip.w == 0.0F) {
            reasons.push_back(fmt::format(
                "v{} has w = 0: it lies in the plane through the eye, and dividing by 0 gives it "
                "no "
                "place.",
                k
            ));
        } else if (clip.w < 0.0F) {
            reasons.push_back(fmt::format(
                "v{} has w = {} < 0: it lies behind the eye. Divided, ({}, {}) becomes ({}, {}): "
                "the signs turn around, and the triangle would wrap through infinity.",
                k,
                number(clip.w),
                number(clip.x),
                number(clip.y),
                number(clip.x / clip.w),
                number(clip.y / clip.w)
            ));
        }
    }
    return reasons;
}

} // namespace hs::explain
