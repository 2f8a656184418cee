// The scene: what is drawn, and every setting of the frame, editable.
#include "app/viewer/panels.hpp"
#include "app/viewer/setting_text.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <map>

namespace hs::viewer {
namespace {

void apply(Context& context, std::string_view key, const scene::SettingValue& value) {
    scene::Settings changed = context.document.scene().settings;
    std::optional<std::string> complaint = scene::assign(changed, key, value);
    if (!complaint) {
        complaint = context.viewer.change_settings(changed);
    }
    context.state.notice = complaint ? *complaint + "." : "";
}

scene::SettingValue text_value(const std::string& text) {
    scene::SettingValue value;
    value.value.emplace<std::string>(text);
    return value;
}

void edit_choice(Context& context, const scene::SettingInfo& info) {
    const scene::Settings& settings = context.document.scene().settings;
    const auto value = scene::read_setting(settings, info.key);
    const std::string current = value ? std::get<std::string>(value->value) : "";
    if (!ImGui::BeginCombo("##value", current.c_str(), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (const std::string_view choice : info.choices) {
        const std::string label{choice};
        if (ImGui::Selectable(label.c_str(), choice == current)) {
            apply(context, info.key, text_value(label));
        }
    }
    ImGui::EndCombo();
}

void edit_boolean(Context& context, const scene::SettingInfo& info) {
    const auto value = scene::read_setting(context.document.scene().settings, info.key);
    bool truth = value && std::get<bool>(value->value);
    if (ImGui::Checkbox("##value", &truth)) {
        apply(context, info.key, scene::SettingValue{truth});
    }
}

/// A text field that keeps what is being typed and hands it over on Enter or when it is left.
void edit_text(Context& context, const scene::SettingInfo& info) {
    static constexpr std::string_view unset = "–";
    const scene::Settings& settings = context.document.scene().settings;
    const auto value = scene::read_setting(settings, info.key);
    std::string text = value ? scene::print_setting(settings, info.key) : std::string{unset};
    const UseFont use{context.theme.fonts.small_mono};
    ImGui::InputText("##value", &text, ImGuiInputTextFlags_AutoSelectAll);
    if (!ImGui::IsItemDeactivatedAfterEdit()) {
        return;
    }
    if (const auto parsed = parse_setting_text(text)) {
        apply(context, info.key, *parsed);
    } else {
        context.state.notice =
            fmt::format("\"{}\" is not a number or a list like [1, 2, 3, 4].", text);
    }
}

void edit_color(Context& context, const scene::SettingInfo& info) {
    const auto value = scene::read_setting(context.document.scene().settings, info.key);
    std::array<float, 4> color{};
    const auto* list = value ? std::get_if<scene::SettingValue::List>(&value->value) : nullptr;
    for (std::size_t i = 0; list != nullptr && i < color.size(); ++i) {
        color[i] = static_cast<float>(std::get<double>((*list)[i].value));
    }
    const ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreview;
    ImGui::ColorEdit4("##value", color.data(), flags);
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        scene::SettingValue::List changed;
        for (const float channel : color) {
            changed.emplace_back().value = static_cast<double>(channel);
        }
        scene::SettingValue list_value;
        list_value.value = std::move(changed);
        apply(context, info.key, list_value);
    }
}

void edit(Context& context, const scene::SettingInfo& info) {
    switch (info.type) {
    case scene::SettingType::choice: edit_choice(context, info); return;
    case scene::SettingType::boolean: edit_boolean(context, info); return;
    case scene::SettingType::color: edit_color(context, info); return;
    case scene::SettingType::number:
    case scene::SettingType::list: edit_text(context, info); return;
    }
    HS_CHECK(false, "every type of setting has an editor");
}

void draw_setting(Context& context, const scene::SettingInfo& info) {
    const Theme& theme = context.theme;
    const std::string_view why = why_ignored(context.document.scene().settings, info.key);
    ImGui::PushID(info.key.data());
    ImGui::AlignTextToFramePadding();
    const UseFont small{theme.fonts.small};
    ImGui::PushStyleColor(ImGuiCol_Text, theme[why.empty() ? Tone::text : Tone::quiet]);
    ImGui::TextUnformatted(info.key.data(), info.key.data() + info.key.size());
    std::string tip = std::string{info.explanation} + ".";
    if (!info.opengl.empty()) {
        tip += fmt::format("\nOpenGL: {}", info.opengl);
    }
    tooltip(tip);
    ImGui::SameLine(std::min(theme.units(32), ImGui::GetWindowWidth() * 0.55F));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::BeginDisabled(!why.empty());
    ImGui::BeginGroup();
    edit(context, info);
    ImGui::EndGroup();
    ImGui::EndDisabled();
    tooltip(why);
    ImGui::PopStyleColor();
    ImGui::PopID();
}

void draw_objects(Context& context) {
    const Theme& theme = context.theme;
    const trace::Recording& recording = context.document.recording();
    const scene::Scene& scene = context.document.scene();
    heading(theme, "Objects");
    ImGuiListClipper clipper; // scenes may have thousands
    clipper.Begin(static_cast<int>(scene.objects.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const trace::ObjectRange& range = recording.objects[index];
            const bool current = context.document.player().current().object == index;
            const std::string label = fmt::format("{} {}", i, scene.objects[index].name);
            const float room = ImGui::GetContentRegionAvail().x;
            ImGui::PushID(i);
            if (ImGui::Selectable(shorten(theme.fonts.text, label, room).c_str(), current) &&
                range.triangle_count > 0) {
                context.viewer.seek(trace::last_step_of_triangle(recording, range.first_triangle));
            }
            tooltip(fmt::format(
                "{}: {} vertices, {} primitives. Click to go to its first triangle.",
                scene.objects[index].name,
                range.vertex_count,
                range.triangle_count
            ));
            ImGui::PopID();
        }
    }
}

void draw_camera(Context& context) {
    const Theme& theme = context.theme;
    const scene::Camera& camera = context.document.scene().camera;
    const scene::Projection& projection = camera.projection;
    heading(theme, "Camera");
    const UseFont small{theme.fonts.small_mono};
    const auto line = [&](const char* label, const std::string& value) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme[Tone::quiet]);
        ImGui::TextUnformatted(label);
        ImGui::PopStyleColor();
        ImGui::SameLine(theme.units(22));
        ImGui::TextUnformatted(value.c_str());
    };
    const auto vector = [](const glm::vec3& v) {
        return fmt::format("{:.2f} {:.2f} {:.2f}", v.x, v.y, v.z);
    };
    line("projection", std::string{name_of(projection.kind)});
    if (projection.kind == scene::ProjectionKind::identity) {
        return;
    }
    line("eye", vector(camera.eye));
    line("target", vector(camera.target));
    line("near, far", fmt::format("{:.2f} {:.2f}", projection.near, projection.far));
    if (projection.kind == scene::ProjectionKind::perspective) {
        line("fov y", fmt::format("{:.1f}°", projection.fov_y));
    }
}

} // namespace

void draw_scene(Context& context) {
    const Theme& theme = context.theme;
    if (!context.document.is_open()) {
        empty_note(
            theme,
            "Objects, camera and settings of the scene will stand here. Every setting can be "
            "changed, and the frame is recorded anew at the same step."
        );
        return;
    }
    draw_objects(context);
    draw_camera(context);
    heading(theme, "Settings");
    for (const scene::SettingInfo& info : scene::setting_infos()) {
        draw_setting(context, info);
    }
}

} // namespace hs::viewer
