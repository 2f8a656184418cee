#include "core/pipeline/row_bands.hpp"

#include <numeric>

namespace hs::pipeline {
namespace {

/// Estimated cost of drawing, by row, in pixels visited.
class RowCosts {
public:
    explicit RowCosts(const PixelRect& image) : image_(image) {
        costs_.resize(static_cast<std::size_t>(image.height()));
    }

    /// A triangle's setup and its bounding box, spread over its rows. One that must be clipped, or
    /// covers no row, is left out.
    void add(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) {
        if ((a.outcode | b.outcode | c.outcode) != 0) {
            return;
        }
        constexpr double setup = 32; // as long as visiting so many pixels
        const auto [left, right] =
            std::minmax({a.window.fixed.x, b.window.fixed.x, c.window.fixed.x});
        const auto [top, bottom] =
            std::minmax({a.window.fixed.y, b.window.fixed.y, c.window.fixed.y});
        const int first = std::clamp(top / subpixel_scale, 0, image_.height() - 1);
        const int last = std::clamp(bottom / subpixel_scale, first, image_.height() - 1);
        const double width = static_cast<double>(right - left) / subpixel_scale;
        for (int y = first; y <= last; ++y) {
            costs_[static_cast<std::size_t>(y)] += width + setup / (last - first + 1);
        }
    }

    /// The first row of the part that begins after `share` of the whole cost.
    [[nodiscard]] int row_at(double share) const {
        const double goal = share * std::accumulate(costs_.begin(), costs_.end(), 0.0);
        double sum = 0.0;
        for (std::size_t y = 0; y < costs_.size(); ++y) {
            if (sum >= goal && goal > 0.0) {
                return static_cast<int>(y);
            }
            sum += costs_[y];
        }
        return image_.height();
    }

private:
    PixelRect image_;
    std::vector<double> costs_;
};

} // namespace

std::vector<PixelRect> balanced_bands(const Frame& frame, unsigned threads) {
    constexpr std::size_t samples_per_call = 4096; // triangles
    const PixelRect image = frame.settings().image();
    RowCosts costs(image);
    for (const DrawCall& call : frame.calls()) {
        const std::size_t stride = call.triangles().size() / samples_per_call + 1;
        for (std::size_t i = 0; i < call.triangles().size(); i += stride) {
            const scene::TriangleIndices& t = call.triangles()[i];
            costs.add(call.vertices[t.a], call.vertices[t.b], call.vertices[t.c]);
        }
    }

    std::vector<PixelRect> bands;
    int top = 0;
    for (unsigned i = 1; i <= threads; ++i) {
        const int bottom = i == threads
                               ? image.height()
                               : std::max(top, costs.row_at(static_cast<double>(i) / threads));
        bands.push_back({image.x0, top, image.x1, bottom});
        top = bottom;
    }
    return bands;
}

} // namespace hs::pipeline
