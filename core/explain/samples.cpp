#include "core/explain/samples.hpp"

#include "core/explain/numbers.hpp"
#include "core/raster/conservative.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>

namespace hs::explain {
namespace {

constexpr std::array edge_names{"E01", "E12", "E20"};

/// At the corner of the pixel's square that lies most inside an edge.
std::int64_t at_corner(const raster::EdgeFunction& edge, std::int64_t center) {
    return center + raster::gain_to_corner(edge);
}

/// A coordinate within the pixel, in sixteenths that are exact to four digits: ".375".
std::string within_pixel(std::int32_t offset) {
    const double place = 0.5 + static_cast<double>(offset) / subpixel_scale;
    return fmt::format("{:.4g}", place).substr(1);
}

/// "sample 2", "samples 0, 2 and 3"
std::string named_samples(raster::CoverageMask samples) {
    return fmt::format("sample{} {}", std::popcount(samples) == 1 ? "" : "s", sample_list(samples));
}

} // namespace

std::string sample_list(raster::CoverageMask samples) {
    std::string list;
    int last = -1;
    for (int s = 0; s < raster::max_samples; ++s) {
        if (!raster::has_sample(samples, s)) {
            continue;
        }
        if (last >= 0) {
            list += (list.empty() ? "" : ", ") + fmt::format("{}", last);
        }
        last = s;
    }
    if (last < 0) {
        return "none";
    }
    return list.empty() ? fmt::format("{}", last) : fmt::format("{} and {}", list, last);
}

std::string sample_place(const raster::SampleOffset& offset) {
    return fmt::format("({}, {})", within_pixel(offset.x), within_pixel(offset.y));
}

std::string sample_sentence(
    const std::string& who, const trace::Step& step, const std::vector<trace::SampleDetail>& samples
) {
    const trace::SampleDetail& sample = samples[static_cast<std::size_t>(step.sample)];
    const std::string where = fmt::format(
        "Sample {} of pixel {}, at {} in it,",
        step.sample,
        pixel(step.pixel),
        sample_place(sample.offset)
    );
    if (sample.covered) {
        return fmt::format("{} lies inside all three edges of {}.", where, who);
    }
    std::string edges;
    for (unsigned k = 0; k < 3; ++k) {
        if (sample.edges[k] < 0) {
            edges += edges.empty() ? "" : ", ";
            edges += fmt::format("{} = {} px² < 0", edge_names[k], square_pixels(sample.edges[k]));
        }
    }
    if (edges.empty()) {
        edges = "it lies exactly on an edge that a neighbor owns";
    }
    return fmt::format("{} lies outside {}: {}.", where, who, edges);
}

std::string samples_merge_sentence(
    const std::string& who, const trace::FragmentRecord& fragment, bool blended
) {
    const auto hidden = static_cast<raster::CoverageMask>(fragment.coverage ^ fragment.passed);
    return fmt::format(
        "{} {} {}{}.",
        who,
        blended ? "is blended into" : "is written to",
        named_samples(fragment.passed),
        hidden != 0 ? fmt::format("; {} failed the depth test", named_samples(hidden))
                    : std::string{}
    );
}

std::string resolve_sentence(const trace::Player& player) {
    const PixelPos p = player.current().pixel;
    const glm::vec4 color = player.color(p);
    return fmt::format(
        "Pixel {} is resolved: the average of its {} samples is {}.",
        pixel(p),
        player.recording().settings().samples,
        point(color.r, color.g, color.b)
    );
}

std::string square_sentence(
    const std::string& who,
    const trace::Step& step,
    const raster::TriangleSetup& setup,
    const raster::EdgeValues& center
) {
    if (step.covered) {
        return fmt::format(
            "The square of pixel {} reaches inside all three edges of {}: a fragment is born.",
            pixel(step.pixel),
            who
        );
    }
    std::string edges;
    for (unsigned k = 0; k < 3; ++k) {
        const std::int64_t corner = at_corner(setup.edges[k], center[k]);
        if (corner <= 0) {
            edges += edges.empty() ? "" : ", ";
            edges += fmt::format("{} = {} px² ≤ 0", edge_names[k], square_pixels(corner));
        }
    }
    return fmt::format(
        "The square of pixel {} lies outside {}; at its most inside corner {}.",
        pixel(step.pixel),
        who,
        edges
    );
}

std::vector<Formula> sample_formulas(
    const raster::TriangleSetup& setup, const trace::Step& step, const trace::SampleDetail& sample
) {
    const raster::EdgeValues center = setup.evaluate(step.pixel);
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = setup.edges[k];
        const bool inside = sample.edges[k] + setup.top_left_bias[k] >= 0;
        list.push_back(
            {fmt::format(
                 "{} at sample {} of pixel {}", edge_names[k], step.sample, pixel(step.pixel)
             ),
             e.owns_ties() ? "E = E(center) + a·dx + b·dy, inside iff E ≥ 0 (top-left edge)"
                           : "E = E(center) + a·dx + b·dy, inside iff E > 0",
             fmt::format(
                 "{} + {}·{} + {}·{}",
                 square_pixels(center[k]),
                 pixels(e.a),
                 pixels(sample.offset.x),
                 pixels(e.b),
                 pixels(sample.offset.y)
             ),
             fmt::format(
                 "{} px²: {}", square_pixels(sample.edges[k]), inside ? "inside" : "outside"
             ),
             {edge_names[k], "covered"}}
        );
    }
    return list;
}

std::vector<Formula>
square_formulas(const raster::TriangleSetup& setup, PixelPos p, const raster::EdgeValues& center) {
    std::vector<Formula> list;
    for (unsigned k = 0; k < 3; ++k) {
        const raster::EdgeFunction& e = setup.edges[k];
        const std::int64_t corner = at_corner(e, center[k]);
        list.push_back(
            {fmt::format("{} at the most inside corner of pixel {}", edge_names[k], pixel(p)),
             "E = E(center) + (|a| + |b|)/2, inside iff E > 0",
             fmt::format(
                 "{} + (|{}| + |{}|)/2", square_pixels(center[k]), pixels(e.a), pixels(e.b)
             ),
             fmt::format("{} px²: {}", square_pixels(corner), corner > 0 ? "inside" : "outside"),
             {edge_names[k], "covered"}}
        );
    }
    return list;
}

Formula samples_merge_formula(const pipeline::Merge& merge) {
    return {
        "merge, sample by sample",
        merge.blended ? "sample = source·a + sample·(1 − a), where it passed"
                      : "sample = source, where it passed",
        fmt::format("source {}", point(merge.source)),
        fmt::format("resolves to {}", point(merge.after))};
}

Formula resolve_formula(const trace::ResolveDetail& resolve) {
    std::string terms;
    for (int s = 0; s < resolve.samples.count; ++s) {
        terms += s == 0 ? "  " : "\n+ ";
        terms += point(resolve.samples[s].color);
    }
    return {
        "resolve",
        fmt::format("color = (Σ samples) / {}", resolve.samples.count),
        fmt::format("{}\nover {}", terms, resolve.samples.count),
        point(resolve.resolved.color)};
}

} // namespace hs::explain
