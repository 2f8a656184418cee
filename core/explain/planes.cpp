// Homogeneous rasterization in words and formulas.
#include "core/explain/numbers.hpp"
#include "core/explain/traversal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace hs::explain {
namespace {

constexpr std::array<const char*, 3> edge_names{"E01", "E12", "E20"};
constexpr std::array<int, 3> opposite{2, 0, 1}; ///< the vertex an edge does not touch

std::string value(double v) {
    return number(static_cast<float>(v));
}

std::string clip_name(const raster::PixelClip& clip) {
    return std::string{name_of(static_cast<geometry::ClipPlane>(clip.plane))};
}

} // namespace

std::string plane_sentence(
    const std::string& who,
    const trace::Step& step,
    const raster::HomogeneousSetup& setup,
    const raster::PlaneTest& test
) {
    if (test.inside) {
        return fmt::format(
            "Pixel {} lies inside the three planes through the eye and {}, with 1/w = {} > 0: a "
            "fragment is born.",
            pixel(step.pixel),
            who,
            value(test.inv_w)
        );
    }
    std::vector<std::string> reasons;
    for (unsigned k = 0; k < 3; ++k) {
        if (test.edges[k] < 0.0) {
            reasons.push_back(
                fmt::format("plane {} gives {} < 0", edge_names[k], value(test.edges[k]))
            );
        }
    }
    if (test.inv_w <= 0.0) {
        reasons.push_back(fmt::format("1/w = {} is not in front of the eye", value(test.inv_w)));
    }
    for (unsigned i = 0; i < static_cast<unsigned>(setup.clip_count); ++i) {
        if (test.clips[i] < 0.0) {
            reasons.push_back(fmt::format(
                "it is {} outside plane {}", value(-test.clips[i]), clip_name(setup.clips[i])
            ));
        }
    }
    if (reasons.empty()) {
        reasons.emplace_back("it lies exactly on an edge that a neighbor owns");
    }
    return fmt::format(
        "Pixel {} lies outside {}: {}.", pixel(step.pixel), who, fmt::join(reasons, ", ")
    );
}

std::vector<Formula> plane_formulas(
    const trace::Step& step, const raster::HomogeneousSetup& setup, const raster::PlaneTest& test
) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::PixelFunction& f = setup.edges[k].rho;
        list.push_back(
            {fmt::format("plane {} at pixel {}", edge_names[k], pixel(step.pixel)),
             fmt::format("ρ{} = b{}/w = a·x + b·y + c", opposite[k], opposite[k]),
             fmt::format(
                 "{}·{} + {}·{} + {}",
                 value(f.a),
                 step.pixel.x,
                 value(f.b),
                 step.pixel.y,
                 value(f.c)
             ),
             value(test.edges[k])}
        );
    }
    list.push_back(
        {"1/w at the pixel",
         "1/w = ρ0 + ρ1 + ρ2 > 0",
         fmt::format(
             "{} + {} + {}", value(test.edges[1]), value(test.edges[2]), value(test.edges[0])
         ),
         value(test.inv_w)}
    );
    for (unsigned i = 0; i < static_cast<unsigned>(setup.clip_count); ++i) {
        list.push_back(
            {fmt::format("distance to plane {}", clip_name(setup.clips[i])),
             "d/w = ρ0·d0 + ρ1·d1 + ρ2·d2 ≥ 0",
             "",
             value(test.clips[i])}
        );
    }
    return list;
}

std::vector<Formula> plane_setup_formulas(const raster::HomogeneousSetup& setup) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::PixelFunction& f = setup.edges[k].rho;
        list.push_back(
            {fmt::format("plane through the eye and edge {}", edge_names[k]),
             "(v_from × v_to) / det",
             fmt::format("a = {}, b = {}\nc = {}", value(f.a), value(f.b), value(f.c)),
             setup.edges[k].snapped ? "exact: both vertices have a place in the window"
                                    : "a vertex has no place in the window"}
        );
    }
    return list;
}

} // namespace hs::explain
