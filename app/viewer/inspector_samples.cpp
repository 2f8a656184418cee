#include "app/viewer/inspector_samples.hpp"

#include "app/viewer/formula_view.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/samples.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::viewer {
namespace {

constexpr ImGuiTableFlags table_flags =
    ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;

void cell(std::string_view text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void toned_cell(const Theme& theme, std::string_view text, Tone tone) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme[tone]);
    cell(text);
    ImGui::PopStyleColor();
}

/// The row of the sample that the step is about is lit.
void begin_row(const Theme& theme, bool current) {
    ImGui::TableNextRow();
    if (current) {
        ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, theme[Tone::changed]);
    }
}

std::string_view fate_of(const trace::SampleDetail& sample) {
    return !sample.of_fragment ? "–" : sample.passed ? "written" : "failed";
}

/// The first component of everything that is interpolated, by name.
struct Quantity {
    std::string name;
    int index;
};

std::vector<Quantity> quantities(const math::VaryingLayout& layout) {
    std::vector<Quantity> list{{"red", 0}, {"green", 1}, {"blue", 2}, {"alpha", 3}};
    const auto add = [&list](int start, std::initializer_list<const char*> names) {
        for (const char* const name : names) {
            if (start >= 0) {
                list.push_back({name, start++});
            }
        }
    };
    add(layout.uv, {"u", "v"});
    add(layout.normal, {"normal x", "normal y", "normal z"});
    add(layout.eye_position, {"eye x", "eye y", "eye z"});
    return list;
}

void quad_row(const std::string& name, const std::array<float, 4>& values, float ddx, float ddy) {
    ImGui::TableNextRow();
    cell(name);
    ImGui::TableNextColumn();
    const std::string at_pixels = fmt::format(
        "{} {}\n{} {}",
        explain::signed_number(values[0]),
        explain::signed_number(values[1]),
        explain::signed_number(values[2]),
        explain::signed_number(values[3])
    );
    ImGui::TextUnformatted(at_pixels.c_str());
    ImGui::TableNextColumn();
    const std::string differences =
        fmt::format("{}\n{}", explain::signed_number(ddx), explain::signed_number(ddy));
    ImGui::TextUnformatted(differences.c_str());
}

} // namespace

void draw_sample_edges(Context& context, const trace::StepDetail& detail) {
    const UseFont use{context.theme.fonts.small_mono};
    const trace::Step& step = context.document.player().current();
    if (!ImGui::BeginTable("sample edges", 4, table_flags)) {
        return;
    }
    for (const char* const title : {"sample", "E01 px²", "E12 px²", "E20 px²"}) {
        ImGui::TableSetupColumn(title);
    }
    ImGui::TableHeadersRow();
    for (std::size_t s = 0; s < detail.samples.size(); ++s) {
        const trace::SampleDetail& sample = detail.samples[s];
        begin_row(context.theme, step.sample == static_cast<int>(s));
        const char* const mark = sample.covered ? "●" : "○";
        toned_cell(
            context.theme, fmt::format("{} {}", s, mark), sample.covered ? Tone::pass : Tone::fail
        );
        tooltip(fmt::format("at {} in the pixel", explain::sample_place(sample.offset)));
        for (const std::int64_t value : sample.edges) {
            toned_cell(
                context.theme, explain::square_pixels(value), value < 0 ? Tone::fail : Tone::text
            );
        }
    }
    ImGui::EndTable();
}

void draw_sample_fates(Context& context, const trace::StepDetail& detail) {
    const UseFont use{context.theme.fonts.small_mono};
    const trace::Step& step = context.document.player().current();
    if (!ImGui::BeginTable("sample depths", 4, table_flags)) {
        return;
    }
    for (const char* const title : {"sample", "depth", "stored", "fate"}) {
        ImGui::TableSetupColumn(title);
    }
    ImGui::TableHeadersRow();
    for (std::size_t s = 0; s < detail.samples.size(); ++s) {
        const trace::SampleDetail& sample = detail.samples[s];
        begin_row(context.theme, step.sample == static_cast<int>(s));
        ImGui::TableNextColumn();
        swatch(context.theme, sample.after.color);
        ImGui::SameLine();
        ImGui::TextUnformatted(fmt::format("{}", s).c_str());
        cell(sample.of_fragment ? explain::number(sample.depth) : std::string{"–"});
        cell(explain::number(sample.before.depth));
        const Tone tone = !sample.of_fragment ? Tone::quiet
                          : sample.passed     ? Tone::pass
                                              : Tone::fail;
        toned_cell(context.theme, fate_of(sample), tone);
    }
    ImGui::EndTable();
}

void draw_resolve(Context& context, const trace::ResolveDetail& resolve) {
    const Theme& theme = context.theme;
    heading(
        theme, fmt::format("Pixel {}", explain::pixel(context.document.player().current().pixel))
    );
    caption(theme, "its samples become one color: their average");
    for (int s = 0; s < resolve.samples.count; ++s) {
        swatch(theme, resolve.samples[s].color);
        ImGui::SameLine();
        mono(theme, fmt::format("{}  {}", s, explain::point(resolve.samples[s].color)));
    }
    ImGui::Separator();
    swatch(theme, resolve.resolved.color);
    ImGui::SameLine();
    mono(theme, explain::point(resolve.resolved.color));
    draw_formula(context, explain::resolve_formula(resolve), true);
}

void draw_quad(Context& context, const trace::QuadDetail& detail) {
    const Theme& theme = context.theme;
    heading(theme, "Derivatives");
    std::string helpers;
    for (int i = 0; i < 4; ++i) {
        if (detail.quad.helper[static_cast<unsigned>(i)]) {
            helpers += (helpers.empty() ? "" : ", ") + explain::pixel(detail.quad.pixel(i));
        }
    }
    caption(
        theme,
        fmt::format(
            "differences in the block of 2 × 2 pixels from {}; helpers, which are not covered: {}",
            explain::pixel(detail.quad.origin),
            helpers.empty() ? "none" : helpers
        )
    );
    const UseFont use{theme.fonts.small_mono};
    if (!ImGui::BeginTable("quad", 3, table_flags)) {
        return;
    }
    ImGui::TableSetupColumn("", 0, 0.7F);
    ImGui::TableSetupColumn("at the four pixels", 0, 1.6F);
    ImGui::TableSetupColumn("∂/∂x, ∂/∂y", 0, 0.9F);
    ImGui::TableHeadersRow();
    const auto at_pixels = [&detail](auto&& value) {
        std::array<float, 4> values{};
        for (unsigned i = 0; i < 4; ++i) {
            values[i] = value(detail.quad.fragments[i]);
        }
        return values;
    };
    quad_row(
        "depth",
        at_pixels([](const raster::Fragment& f) { return f.depth; }),
        detail.fine.depth_ddx,
        detail.fine.depth_ddy
    );
    for (const Quantity& quantity : quantities(detail.layout)) {
        quad_row(
            quantity.name,
            at_pixels([&](const raster::Fragment& f) { return f.varyings[quantity.index]; }),
            detail.fine.ddx[quantity.index],
            detail.fine.ddy[quantity.index]
        );
    }
    ImGui::EndTable();
}

} // namespace hs::viewer
