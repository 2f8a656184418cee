#include "app/viewer/layout.hpp"

#include <algorithm>
#include <cmath>

namespace hs::viewer {

std::vector<trace::Stage> strip_stages(const scene::Settings& settings) {
    using trace::Stage;
    const bool rays = settings.visibility == scene::Visibility::ray_cast;
    const auto shown = [&](Stage stage) {
        const bool to_window = stage == Stage::clip || stage == Stage::divide ||
                               stage == Stage::viewport || stage == Stage::setup;
        const bool ordering = stage == Stage::visibility;
        return (!ordering || settings.orders_triangles()) && (!rays || !to_window);
    };
    std::vector<Stage> stages;
    for (int i = 0; i < trace::stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        if (stage == Stage::traverse && settings.sweeps()) {
            stages.push_back(Stage::visibility);
        }
        if (shown(stage)) {
            stages.push_back(stage);
        }
    }
    return stages;
}

Layout make_layout(ImVec2 window, const Theme& theme, float side_share) {
    const float hairline = 1.0F;
    const auto share = [&](float part, float least, float most) {
        return std::floor(keep_within(window.x * part, theme.units(least), theme.units(most)));
    };
    Layout l;
    const float menu_height = theme.units(8);
    const float strip_height = theme.units(13);
    const float sentence_height = theme.units(9);
    const float timeline_height = theme.units(31);
    l.menu = {0.0F, 0.0F, window.x, menu_height};
    l.strip = {0.0F, menu_height + hairline, window.x, strip_height};
    l.timeline = {0.0F, window.y - timeline_height, window.x, timeline_height};
    l.sentence = {0.0F, l.timeline.y - hairline - sentence_height, window.x, sentence_height};

    // The middle row: what is told, what is seen, what is computed
    const float top = l.strip.bottom() + hairline;
    const float height = std::max(0.0F, l.sentence.y - hairline - top);
    // In large type on a small window what is seen keeps half of the width
    const bool cramped = window.x < theme.units(300);
    const float left_width = share(0.21F, cramped ? 50.0F : 66.0F, 96.0F);
    const float inspector_width = share(0.27F, cramped ? 76.0F : 86.0F, 120.0F);
    l.left = {0.0F, top, left_width, height};
    l.inspector = {window.x - inspector_width, top, inspector_width, height};
    const float middle_x = left_width + hairline;
    const float middle_width = std::max(0.0F, l.inspector.x - hairline - middle_x);
    const float side_width = std::floor(middle_width * side_share);
    const float screen_width = std::max(0.0F, middle_width - side_width - hairline);
    const bool shown = side_share > 0.0F;
    l.screen = {middle_x, top, shown ? screen_width : middle_width, height};
    l.side = {l.inspector.x - hairline - side_width, top, side_width, height};
    return l;
}

} // namespace hs::viewer
