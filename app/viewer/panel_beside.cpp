// Beside: the same frame with one setting, or one entry of camera and objects, changed. Both
// playheads stand on corresponding steps, both pictures show the same pixels at the same size.
#include "app/viewer/panels.hpp"
#include "app/viewer/screen_picture.hpp"
#include "app/viewer/screen_view.hpp"
#include "app/viewer/setting_text.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"
#include "core/explain/setting_effect.hpp"
#include "core/scene/scene_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hs::viewer {
namespace {

void ask(Context& context, const std::string& key, const std::string& value) {
    const auto complaint = context.viewer.show_beside({key, value});
    context.state.notice = complaint ? *complaint + "." : "";
}

void choose_key(Context& context, const std::string& current) {
    const scene::Settings& settings = context.document.scene().settings;
    const char* const preview = current.empty() ? "choose a setting" : current.c_str();
    if (!ImGui::BeginCombo("##key", preview, ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        const std::string key{info.key};
        const std::vector<std::string> values = values_beside(settings, key);
        if (!values.empty() && ImGui::Selectable(key.c_str(), key == current)) {
            ask(context, key, values.front());
        }
        tooltip(info.explanation);
    }
    ImGui::EndCombo();
}

void choose_value(Context& context, const scene::Assignment& change) {
    if (!ImGui::BeginCombo("##value", change.value.c_str(), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (const std::string& value : values_beside(context.document.scene().settings, change.path)) {
        if (ImGui::Selectable(value.c_str(), value == change.value)) {
            ask(context, change.path, value);
        }
    }
    ImGui::EndCombo();
}

void draw_choice(Context& context) {
    const std::optional<scene::Assignment>& change = context.viewer.beside().change();
    const UseFont use{context.theme.fonts.small_mono};
    const float room = ImGui::GetContentRegionAvail().x;
    const float needed = text_size(context.theme.fonts.small_mono, "hierarchical").x;
    const float half = room * 0.5F - context.theme.units(1);
    const bool abreast = half > needed + context.theme.units(12); // with the arrow
    const bool alone = change && scene::is_scene_entry(change->path);
    ImGui::SetNextItemWidth(abreast && !alone ? half : room);
    choose_key(context, change ? change->path : "");
    if (change) {
        const scene::Assignment shown = *change; // choosing replaces it
        if (alone) {
            return; // any number of values: the facts below tell this one
        }
        if (abreast) {
            ImGui::SameLine();
        }
        ImGui::SetNextItemWidth(abreast ? half : room);
        choose_value(context, shown);
    }
}

/// The same pixels, drawn from the other document.
void draw_picture(Context& context, const Rect& area) {
    Beside& beside = context.viewer.beside();
    Context other{
        context.viewer, beside.document(), context.state, context.theme, context.textures};
    const Rect main = std::exchange(context.state.screen.area, area);
    const bool fitted = std::exchange(context.state.screen.fitted, false); // by the main picture
    draw_screen_view(other, {area.width, area.height}, beside.picture());
    context.state.screen.fitted = context.state.screen.fitted || fitted;
    draw_readout(other, {area.x, area.bottom(), area.width, context.theme.units(5)});
    context.state.screen.area = main;
}

/// Where the eye of the triangle's corners stands to clipping: w > 0 is in front of it.
void draw_corners(Context& context) {
    const trace::TriangleDetail* triangle = context.document.triangle_detail();
    if (triangle == nullptr || context.viewer.beside().change()->path != "clip.enabled") {
        return;
    }
    std::string text;
    for (const trace::VertexDetail& corner : triangle->corners) {
        const float w = corner.work.clip.w;
        const char* const where = w > 0.0F    ? "in front of the eye"
                                  : w == 0.0F ? "p_z = eye_z: no divide"
                                              : "behind the eye: mirrored";
        text += fmt::format("{}w = {:>8}  {}", text.empty() ? "" : "\n", explain::number(w), where);
    }
    small_mono(context.theme, text);
}

void draw_difference(Context& context) {
    const Theme& theme = context.theme;
    const trace::Difference& difference = context.viewer.beside().difference();
    if (difference.color.empty()) {
        caption(
            theme,
            difference.depths == 0
                ? std::string{"In the end both pictures and both depth buffers are equal."}
                : fmt::format(
                      "In the end both pictures are equal; {} depths differ.", difference.depths
                  ),
            Tone::text
        );
        return;
    }
    const PixelPos first = difference.color.front();
    caption(
        theme,
        fmt::format(
            "In the end {} pixels and {} depths differ; the first pixel is {}.",
            difference.color.size(),
            difference.depths,
            explain::pixel(first)
        ),
        Tone::text
    );
    if (button(theme, "pick it", "Picks the first pixel that differs")) {
        context.viewer.select(first);
    }
    ImGui::SameLine();
    if (button(
            theme,
            "mark all",
            "Marks every pixel that differs in both pictures (D)",
            "",
            context.state.beside.show_difference
        )) {
        context.viewer.run(Command::toggle_difference);
    }
}

void draw_place(Context& context) {
    const Theme& theme = context.theme;
    Beside& beside = context.viewer.beside();
    const trace::Match match = beside.match();
    const Named<trace::Match>& found = named(match);
    if (match == trace::Match::same_step) {
        caption(theme, "Both stand on the same step.");
    } else {
        caption(theme, fmt::format("{}: {}.", found.name, found.explanation), Tone::text);
    }
    if (match != trace::Match::same_step) {
        small_mono(theme, trace::step_path(beside.document().player().current()), Tone::quiet);
    }
    row(theme,
        "visited",
        fmt::format(
            "{} | {} pixels so far",
            context.document.player().counters().traversal.pixels,
            beside.document().player().counters().traversal.pixels
        ));
    const bool by_count = context.state.beside.by_count;
    if (button(
            theme,
            by_count ? "in step by count" : "in step by pixel",
            "By pixel: both stand at the same pixel of the same triangle, where they can.\n"
            "By count: both have taken as many steps into it."
        )) {
        context.state.beside.by_count = !by_count;
    }
}

void draw_facts(Context& context) {
    const scene::Assignment& change = *context.viewer.beside().change();
    const bool entry = scene::is_scene_entry(change.path);
    const auto value = [&](const Document& document) {
        return entry ? scene::print_entry(document.scene(), change.path)
                     : scene::print_setting(document.recording().settings(), change.path);
    };
    small_mono(
        context.theme,
        fmt::format("{} | {}", value(context.document), value(context.viewer.beside().document())),
        Tone::accent
    );
    draw_place(context);
    draw_difference(context);
    draw_corners(context);
    if (entry) {
        caption(
            context.theme,
            "Camera and objects are the same but for this. Both playheads stand at the same "
            "triangle; a pixel of one may be a pixel of another triangle beside it."
        );
        return;
    }
    const std::string_view effect = explain::effect_of_setting(change.path);
    caption(
        context.theme,
        effect.empty() ? fmt::format("It is {}.", scene::find_setting(change.path)->explanation)
                       : std::string{effect}
    );
}

} // namespace

void draw_beside(Context& context, const Rect& rect) {
    const Theme& theme = context.theme;
    const Beside& beside = context.viewer.beside();
    begin_panel("beside", rect, theme, false);
    draw_choice(context);
    if (!context.viewer.shows_beside()) {
        context.state.beside.area = {};
        empty_note(
            theme,
            !beside.complaint().empty() ? fmt::format("It cannot be: {}.", beside.complaint())
            : beside.change()
                ? std::string{"Being recorded …"}
                : std::string{"Choose a setting and another value for it: the same frame is "
                              "recorded with it and stepped beside this one. View › beside "
                              "has the classic pairs."}
        );
        end_panel();
        return;
    }
    // Facts take a third, the picture the rest
    const float top = ImGui::GetCursorScreenPos().y;
    const float pad = theme.units(3);
    const float readout = theme.units(6);
    const float facts = std::max(theme.units(24), (rect.bottom() - top) * 0.36F);
    Rect& area = context.state.beside.area;
    area = {
        rect.x + pad,
        top,
        rect.width - 2.0F * pad,
        std::max(8.0F, rect.bottom() - facts - readout - top)};
    draw_picture(context, area);
    begin_panel("facts beside", {rect.x, area.bottom() + readout, rect.width, facts}, theme, true);
    draw_facts(context);
    end_panel();
    end_panel();
}

} // namespace hs::viewer
