// The values of tests, merging and resolving: what meets at a pixel, and who left what was there.
#include "core/explain/value_list.hpp"
#include "core/framebuffer/depth.hpp"
#include "core/math/interpolate.hpp"
#include "core/trace/history.hpp"
#include "core/trace/player.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

using trace::Left;
using trace::StepKind;

// ---- what a pixel held

/// A number of a pixel or of one of its samples: "pixel color.r", "sample 2 depth".
std::string of_pixel(int sample, const std::string& what) {
    return sample < 0 ? "pixel " + what : fmt::format("sample {} {}", sample, what);
}

/// The step that left what is found there from `last` backward: a fragment's merge, or `start`.
std::string left_by(const trace::Recording& recording, std::uint32_t last, int sample, Left what) {
    const std::uint32_t fragment = trace::last_writer(recording, last, sample, what);
    if (fragment == trace::no_fragment) {
        return "start";
    }
    return trace::step_path(
        trace::describe_step(recording, trace::last_step_of_fragment(recording, fragment))
    );
}

/// What was there when this step's fragment came.
template <typename T>
Term<T> held_before(
    const StepContext& context, int sample, const std::string& what, T value, Left kind
) {
    const std::uint32_t previous = context.recording.fragments[context.step.fragment].previous;
    const std::string name = of_pixel(sample, what);
    return operand(name, value, {left_by(context.recording, previous, sample, kind), name, {}});
}

// ---- formats

const Operation eight_bits{"8 bits", 0, UnitRule::none, [](std::span<const Number> n) -> Number {
                               const auto v = std::get<float>(n[0]);
                               return framebuffer::unpack(framebuffer::pack(glm::vec4{v})).r;
                           }};

template <scene::DepthFormat format>
Number stored_depth(std::span<const Number> n) {
    return framebuffer::store_depth(std::get<float>(n[0]), format);
}
const Operation depth_float{"clamp", 0, UnitRule::none, stored_depth<scene::DepthFormat::float32>};
const Operation depth_24{"24 bits", 0, UnitRule::none, stored_depth<scene::DepthFormat::unorm24>};
const Operation depth_16{"16 bits", 0, UnitRule::none, stored_depth<scene::DepthFormat::unorm16>};

Real as_stored_color(const Real& channel, scene::ColorFormat format) {
    return format == scene::ColorFormat::rgba32f ? channel : call<float>(eight_bits, channel);
}

Real as_stored_depth(const Real& depth, scene::DepthFormat format) {
    return call<float>(
        format == scene::DepthFormat::float32   ? depth_float
        : format == scene::DepthFormat::unorm24 ? depth_24
                                                : depth_16,
        depth
    );
}

template <scene::ColorFormat format>
Number average(std::span<const Number> n) {
    framebuffer::PixelSamples samples;
    samples.count = static_cast<int>(n.size());
    for (int s = 0; s < samples.count; ++s) {
        samples[s].color.r = std::get<float>(n[static_cast<std::size_t>(s)]);
    }
    return framebuffer::resolve(samples, format).color.r;
}
const Operation average_float{"average", 0, UnitRule::none, average<scene::ColorFormat::rgba32f>};
const Operation average_8{
    "average in 8 bits", 0, UnitRule::none, average<scene::ColorFormat::rgba8>};

// ---- tests

Whole count(const char* symbol, int value, const char* given) {
    return operand(symbol, std::int64_t{value}, {{}, {}, given});
}

void add_scissor(ValueList& list, const StepContext& context) {
    const PixelRect& rect = *context.call().settings.scissor;
    const auto inside = [](const char* axis, int at, int low, int high) {
        const Whole p = count(axis, at, "the fragment's pixel");
        return call<bool>(operations::greater_or_equal, p, count("low", low, "settings.scissor")) &&
               call<bool>(operations::less, p, count("high", high, "settings.scissor"));
    };
    const PixelPos p = context.step.pixel;
    list.add("passes", inside("x", p.x, rect.x0, rect.x1) && inside("y", p.y, rect.y0, rect.y1));
}

/// The number of the triangle a pixel shows, −1 for none.
std::int64_t owner_number(std::uint32_t triangle) {
    return triangle == trace::no_triangle ? std::int64_t{-1} : std::int64_t{triangle};
}

void add_closed(ValueList& list, const StepContext& context) {
    const std::uint32_t owner = trace::pixel_before(context.recording, context.step.fragment).triangle;
    const Whole held = held_before(context, -1, "owner", owner_number(owner), Left::color);
    list.add("passes", call<bool>(operations::less, held, Whole{std::int64_t{0}}));
}

/// The depth at the step's sample, from the edge functions there.
Real add_depth_at_sample(ValueList& list, const StepContext& context) {
    const trace::SampleDetail& sample =
        context.detail.samples[static_cast<std::size_t>(context.step.sample)];
    const Real inverse =
        context.value(StepKind::setup, "1/2A", context.piece().setup->inv_doubled_area, -2);
    const auto edge = [&](unsigned k) {
        return to_float(context.value(StepKind::sample_test, edge_names[k], sample.edges[k], 2));
    };
    const Real lambda1 = list.add("λ1", edge(2) * inverse);
    const Real lambda2 = list.add("λ2", edge(0) * inverse);
    const auto depth = [&](unsigned corner) {
        return context.value(
            StepKind::viewport,
            fmt::format("v{}.window.depth", corner),
            context.piece().window[corner].window.depth
        );
    };
    return list.add("depth", math::interpolate(depth(0), depth(1), depth(2), lambda1, lambda2));
}

Truth compared_by(scene::CompareOp op, const Real& depth, const Real& stored) {
    switch (op) {
    case scene::CompareOp::never: return Truth{false};
    case scene::CompareOp::less: return call<bool>(operations::less, depth, stored);
    case scene::CompareOp::lequal: return call<bool>(operations::less_or_equal, depth, stored);
    case scene::CompareOp::equal: return call<bool>(operations::equal, depth, stored);
    case scene::CompareOp::gequal: return call<bool>(operations::greater_or_equal, depth, stored);
    case scene::CompareOp::greater: return call<bool>(operations::greater, depth, stored);
    case scene::CompareOp::notequal: return call<bool>(operations::not_equal, depth, stored);
    case scene::CompareOp::always: return Truth{true};
    }
    HS_CHECK(false, "every comparison is handled");
    return Truth{false};
}

void add_depth_test(ValueList& list, const StepContext& context) {
    const trace::FragmentDetail& fragment = *context.detail.fragment;
    const pipeline::DepthTest& test = *fragment.depth_test;
    const Real depth =
        test.sample >= 0 ? add_depth_at_sample(list, context)
                         : context.value(StepKind::interpolate, "depth", fragment.fragment.depth);
    const Real rounded =
        list.add("fragment depth", as_stored_depth(depth, context.recording.settings().depth_format));
    const Real stored = list.add(
        "stored depth", held_before(context, test.sample, "depth", test.stored, Left::depth)
    );
    list.add("passes", compared_by(test.op, rounded, stored));
}

// ---- merging

Real source(const StepContext& context, unsigned channel) {
    return context.value(
        StepKind::shade,
        fmt::format("color.{}", channel_names[channel]),
        context.detail.fragment->shaded->color[static_cast<int>(channel)]
    );
}

/// One channel, with what was there where blending asks for it.
Real merged(const StepContext& context, int sample, unsigned k, const glm::vec4& before) {
    const Real color = source(context, k);
    if (!context.call().settings.blend_enabled) {
        return color;
    }
    const Real alpha = source(context, 3);
    const Real keep = Real{1.0F} - alpha;
    const Real held = held_before(
        context,
        sample,
        fmt::format("color.{}", channel_names[k]),
        before[static_cast<int>(k)],
        Left::color
    );
    return k == 3 ? color + held * keep : color * alpha + held * keep;
}

void add_merged_color(
    ValueList& list, const StepContext& context, int sample, const glm::vec4& before
) {
    for (unsigned k = 0; k < 4; ++k) {
        const std::string prefix = sample < 0 ? "" : fmt::format("sample {} ", sample);
        const Real after = list.add(
            fmt::format("{}merged.{}", prefix, channel_names[k]), merged(context, sample, k, before)
        );
        list.add(
            of_pixel(sample, fmt::format("color.{}", channel_names[k])),
            as_stored_color(after, context.recording.settings().color_format)
        );
    }
}

void add_merged_depth(ValueList& list, const StepContext& context, int sample, float depth) {
    trace::Step test = context.step;
    test.kind = StepKind::depth_test;
    test.sample = sample;
    list.add(
        of_pixel(sample, "depth"),
        operand("fragment depth", depth, {trace::step_path(test), "fragment depth", {}})
    );
}

void add_merged_samples(ValueList& list, const StepContext& context) {
    const scene::Settings& settings = context.call().settings;
    const raster::CoverageMask written =
        context.recording.fragments[context.step.fragment].passed;
    const bool depth = settings.visibility == scene::Visibility::z_buffer && settings.depth_write;
    for (int s = 0; s < settings.samples; ++s) {
        if (!raster::has_sample(written, s)) {
            continue;
        }
        const trace::SampleDetail& sample = context.detail.samples[static_cast<std::size_t>(s)];
        add_merged_color(list, context, s, sample.before.color);
        if (depth) {
            add_merged_depth(list, context, s, sample.after.depth);
        }
    }
}

/// The cleared pixel, or one of its samples.
void add_cleared(ValueList& list, const scene::Settings& settings, int sample) {
    for (unsigned k = 0; k < 4; ++k) {
        const Real channel = operand(
            fmt::format("background.{}", channel_names[k]),
            settings.background[static_cast<int>(k)],
            {{}, {}, "settings.background"}
        );
        list.add(
            of_pixel(sample, fmt::format("color.{}", channel_names[k])),
            as_stored_color(channel, settings.color_format)
        );
    }
    const Real clear =
        operand("depth.clear", settings.depth_clear(), {{}, {}, "settings.depth.clear"});
    list.add(of_pixel(sample, "depth"), as_stored_depth(clear, settings.depth_format));
}

} // namespace

void add_test_values(ValueList& list, const StepContext& context) {
    if (context.step.kind == StepKind::scissor_test) {
        add_scissor(list, context);
    } else if (context.step.kind == StepKind::closed_test) {
        add_closed(list, context);
    } else {
        add_depth_test(list, context);
    }
}

void add_merge_values(ValueList& list, const StepContext& context) {
    if (context.recording.samples.active()) {
        add_merged_samples(list, context);
        return;
    }
    const pipeline::Merge& merge = *context.detail.fragment->merge;
    add_merged_color(list, context, -1, merge.before);
    if (merge.depth_written) {
        add_merged_depth(list, context, -1, merge.depth);
    }
    list.add(
        "pixel owner",
        operand(
            "triangle",
            owner_number(context.detail.fragment->triangle),
            {{}, {}, "number of the triangle over the whole frame"}
        )
    );
}

void add_start_values(ValueList& list, const StepContext& context) {
    const scene::Settings& settings = context.recording.settings();
    add_cleared(list, settings, -1);
    for (int s = 0; settings.samples > 1 && s < settings.samples; ++s) {
        add_cleared(list, settings, s);
    }
    list.add("pixel owner", operand("nobody", owner_number(trace::no_triangle), {{}, {}, "nothing is drawn yet"}));
}

void add_resolve_values(ValueList& list, const StepContext& context) {
    const framebuffer::PixelSamples& samples = context.detail.resolve->samples;
    const std::uint32_t last = context.recording.final_pixels[context.step.pixel].last_fragment;
    const auto held = [&](int sample, const std::string& what, float value, Left kind) {
        const std::string name = of_pixel(sample, what);
        return operand(name, value, {left_by(context.recording, last, sample, kind), name, {}});
    };
    const bool whole = context.recording.settings().color_format == scene::ColorFormat::rgba8;
    for (unsigned k = 0; k < 4; ++k) {
        std::vector<ExpressionPtr> terms;
        const std::string channel = fmt::format("color.{}", channel_names[k]);
        for (int s = 0; s < samples.count; ++s) {
            const float value = samples[s].color[static_cast<int>(k)];
            terms.push_back(held(s, channel, value, Left::color).expression());
        }
        list.add("pixel " + channel, Real{apply(whole ? average_8 : average_float, terms)});
    }
    list.add("pixel depth", held(0, "depth", samples[0].depth, Left::depth));
}

} // namespace hs::explain
