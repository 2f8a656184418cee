#include "core/explain/depth_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hs::explain {

double DepthCurve::depth(double distance) const {
    const double part = (distance - near) / (far - near);
    const double grows = perspective ? part * far / distance : part;
    return reversed ? 1.0 - grows : grows;
}

double DepthCurve::distance(double depth) const {
    const double grows = reversed ? 1.0 - depth : depth;
    return perspective ? near * far / (far - grows * (far - near)) : near + grows * (far - near);
}

DepthCurve depth_curve(const scene::Camera& camera, scene::DepthConvention convention) {
    const scene::Projection& p = camera.projection;
    const bool identity = p.kind == scene::ProjectionKind::identity;
    const bool opengl = convention == scene::DepthConvention::opengl;
    return {
        .near = identity ? (opengl ? -1.0 : 0.0) : static_cast<double>(p.near),
        .far = identity ? 1.0 : static_cast<double>(p.far),
        .perspective = p.kind == scene::ProjectionKind::perspective ||
                       p.kind == scene::ProjectionKind::frustum,
        .reversed = convention == scene::DepthConvention::reversed};
}

double depth_step(double depth, scene::DepthFormat format) {
    switch (format) {
    case scene::DepthFormat::unorm16: return 1.0 / 65535.0;
    case scene::DepthFormat::unorm24: return 1.0 / 16777215.0;
    case scene::DepthFormat::float32: {
        const float value = std::clamp(static_cast<float>(depth), 0.0F, 1.0F);
        const float next = std::nextafter(value, 2.0F);
        return static_cast<double>(next) - static_cast<double>(value);
    }
    }
    HS_CHECK(false, "every depth format is handled");
    return 0.0;
}

namespace {

/// Depth is computed as A + B/d in float32, where A is what it tends to: half a unit in A's last
/// place is lost, however finely the buffer could store the result. Reversed depth tends to
/// almost 0.
double computing_error(const DepthCurve& curve) {
    constexpr double half_unit = 1.0 / 16777216.0;
    const double tends_to =
        curve.reversed && curve.perspective ? curve.near / (curve.far - curve.near) : 1.0;
    return half_unit * tends_to;
}

} // namespace

double resolved_distance(const DepthCurve& curve, double distance, scene::DepthFormat format) {
    const double depth = curve.depth(distance);
    const double slope = curve.perspective ? curve.near * curve.far / (curve.far - curve.near) /
                                                 (distance * distance)
                                           : 1.0 / (curve.far - curve.near);
    return std::max(depth_step(depth, format), computing_error(curve)) / slope;
}

double distance_of_half(const DepthCurve& curve) {
    return curve.distance(0.5);
}

std::vector<PixelPos> fighting_pixels(const trace::Recording& recording) {
    const scene::Settings& settings = recording.settings();
    const bool reversed = settings.depth_convention == scene::DepthConvention::reversed;
    struct Nearest {
        float first = std::numeric_limits<float>::infinity();
        float second = std::numeric_limits<float>::infinity();
    };
    const PixelRect image = settings.image();
    const auto width = static_cast<std::size_t>(image.width());
    const auto index = [width](PixelPos p) {
        return static_cast<std::size_t>(p.y) * width + static_cast<std::size_t>(p.x);
    };
    std::vector<Nearest> nearest(width * static_cast<std::size_t>(image.height()));
    for (std::size_t i = 0; i < recording.fragments.size(); ++i) {
        const trace::FragmentRecord& fragment = recording.fragments[i];
        // What is nearer is smaller, in this loop
        const float depth = reversed ? -fragment.depth : fragment.depth;
        Nearest& here = nearest[index(fragment.pixel())];
        if (depth < here.first) {
            here.second = here.first;
            here.first = depth;
        } else {
            here.second = std::min(here.second, depth);
        }
    }

    constexpr double steps = 2.0;
    std::vector<PixelPos> pixels;
    for (int y = image.y0; y < image.y1; ++y) {
        for (int x = image.x0; x < image.x1; ++x) {
            const Nearest& here = nearest[index({x, y})];
            const double depth = std::fabs(static_cast<double>(here.first));
            const double apart = static_cast<double>(here.second) - static_cast<double>(here.first);
            if (std::isfinite(apart) && apart <= steps * depth_step(depth, settings.depth_format)) {
                pixels.push_back({x, y});
            }
        }
    }
    return pixels;
}

} // namespace hs::explain
