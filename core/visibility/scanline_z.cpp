#include "core/visibility/scanline_z.hpp"

#include <algorithm>

namespace hs::visibility {

std::vector<PixelSpan> pixel_spans(const ScanState& state, int width) {
    // Active edges come from left to right: the first of a polygon begins its span
    std::vector<PixelSpan> spans;
    for (const ActiveScanEdge& active : state.active) {
        const std::int32_t polygon =
            state.table.edges[static_cast<std::size_t>(active.edge)].polygon;
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

} // namespace hs::visibility
