// A plot of one quantity over another, in a rectangle of a panel.
#pragma once

#include "app/viewer/theme.hpp"

#include <imgui.h>

#include <string_view>

namespace hs::viewer {

/// Takes room in the panel and maps values to it. Precondition: the ranges are not empty.
class Plot {
public:
    struct Range {
        double low = 0.0;
        double high = 1.0;
        bool logarithmic = false; ///< low > 0 then
    };

    Plot(const Theme& theme, float height, Range x, Range y);

    [[nodiscard]] ImVec2 at(double x, double y) const;
    void line(double x0, double y0, double x1, double y1, ImU32 color, float width) const;
    void vertical(double x, ImU32 color, float width) const;
    void horizontal(double y, ImU32 color, float width) const;
    /// `name(x)` from one end to the other, in straight pieces.
    template <typename Function>
    void curve(const Function& function, ImU32 color, float width) const;
    /// Below the plot, around x; not beyond the panel.
    void label_below(double x, std::string_view text, ImU32 color) const;
    /// Left of the plot, at y.
    void label_left(double y, std::string_view text, ImU32 color) const;

private:
    [[nodiscard]] double x_at(double part) const;

    const Theme& theme_;
    ImDrawList& list_;
    Range x_;
    Range y_;
    ImVec2 min_;
    ImVec2 max_;
    float left_edge_;
    float right_edge_;
};

template <typename Function>
void Plot::curve(const Function& function, ImU32 color, float width) const {
    constexpr int pieces = 240;
    for (int i = 0; i < pieces; ++i) {
        const double from = x_at(static_cast<double>(i) / pieces);
        const double to = x_at(static_cast<double>(i + 1) / pieces);
        line(from, function(from), to, function(to), color, width);
    }
}

} // namespace hs::viewer
