#include "app/viewer/plot.hpp"

#include "app/viewer/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace hs::viewer {
namespace {

/// 0 at the range's low end, 1 at its high end.
double part_of(const Plot::Range& range, double value) {
    if (range.logarithmic) {
        return std::log(value / range.low) / std::log(range.high / range.low);
    }
    return (value - range.low) / (range.high - range.low);
}

} // namespace

Plot::Plot(const Theme& theme, float height, Range x, Range y)
    : theme_(theme), list_(*ImGui::GetWindowDrawList()), x_(x), y_(y) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    left_edge_ = corner.x;
    right_edge_ = corner.x + width;
    min_ = {corner.x + theme.units(9), corner.y + theme.units(2)};
    max_ = {corner.x + width - theme.units(2), corner.y + height - theme.units(5)};
    ImGui::Dummy({width, height});
    list_.AddRectFilled(min_, max_, theme[Tone::window]);
    list_.AddLine({min_.x, max_.y}, max_, theme[Tone::quiet], theme.pixels(1));
    list_.AddLine(min_, {min_.x, max_.y}, theme[Tone::quiet], theme.pixels(1));
}

double Plot::x_at(double part) const {
    return x_.logarithmic ? x_.low * std::pow(x_.high / x_.low, part)
                          : x_.low + part * (x_.high - x_.low);
}

ImVec2 Plot::at(double x, double y) const {
    const auto px = static_cast<float>(std::clamp(part_of(x_, x), 0.0, 1.0));
    const auto py = static_cast<float>(std::clamp(part_of(y_, y), 0.0, 1.0));
    return {min_.x + px * (max_.x - min_.x), max_.y - py * (max_.y - min_.y)};
}

void Plot::line(double x0, double y0, double x1, double y1, ImU32 color, float width) const {
    list_.AddLine(at(x0, y0), at(x1, y1), color, theme_.pixels(width));
}

void Plot::vertical(double x, ImU32 color, float width) const {
    line(x, y_.low, x, y_.high, color, width);
}

void Plot::horizontal(double y, ImU32 color, float width) const {
    const float height = at(x_.low, y).y;
    list_.AddLine({min_.x, height}, {max_.x, height}, color, theme_.pixels(width));
}

void Plot::label_below(double x, std::string_view text, ImU32 color) const {
    ImFont* font = theme_.fonts.small_mono;
    const float width = text_size(font, text).x;
    const float wanted = at(x, y_.low).x - width * 0.5F;
    const float place = std::clamp(wanted, left_edge_, std::max(left_edge_, right_edge_ - width));
    draw_text(list_, font, {place, max_.y + theme_.pixels(2)}, color, text);
}

void Plot::label_left(double y, std::string_view text, ImU32 color) const {
    ImFont* font = theme_.fonts.small_mono;
    const ImVec2 size = text_size(font, text);
    const float x = std::max(left_edge_, min_.x - size.x - theme_.units(1));
    draw_text(list_, font, {x, at(x_.low, y).y - size.y * 0.5F}, color, text);
}

} // namespace hs::viewer
