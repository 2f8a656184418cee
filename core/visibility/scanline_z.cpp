#include "core/visibility/scanline_z.hpp"

#include <algorithm>

namespace hs::visibility {

std::vector<PixelSpan> pixel_spans(const ScanState& state, int width) {
    // Active edges come from left to right: the first of a polygon begins its span
    std::vector<PixelSpan> spans;
    for (const ActiveScanEdge& active : state.active) {
        const std::int32_t polygon = state.scene->table.edge(active.edge).polygon;
        const int x = first_pixel(std::clamp(active.x, 0.0, static_cast<double>(width)));
        const auto open = std::ranges::find_if(spans, [&](const PixelSpan& span) {
            return span.polygon == polygon && span.x_end < 0;
        });
        if (open == spans.end()) {
            spans.push_back({polygon, x, -1});
        } else {
            open->x_end = x;
        }
    }
    std::ranges::stable_sort(spans, {}, &PixelSpan::polygon);
    return spans;
}

std::vector<PixelSpan> visible_spans(const LineBuffer& line) {
    std::vector<PixelSpan> spans;
    for (std::size_t i = 0; i < line.polygon.size(); ++i) {
        const int x = static_cast<int>(i);
        if (spans.empty() || spans.back().polygon != line.polygon[i]) {
            spans.push_back({line.polygon[i], x, x});
        }
        spans.back().x_end = x + 1;
    }
    return spans;
}

} // namespace hs::visibility
