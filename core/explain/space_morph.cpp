#include "core/explain/space_morph.hpp"

#include <algorithm>
#include <cmath>

namespace hs::explain {

std::optional<glm::vec3>
morphed(const glm::vec4& eye, const glm::vec4& clip, const DepthDirections& directions, float at) {
    const glm::vec3 in_eye{eye.x, eye.y, -directions.forward * eye.z};
    const glm::vec3 in_clip{clip.x, clip.y, -clip.w};
    if (at <= 1.0F) {
        const float part = std::max(at, 0.0F);
        return in_eye * (1.0F - part) + in_clip * part; // affine: scales x and y
    }

    // Divide by less than w at first, by all of it in the end
    const float part = std::min(at - 1.0F, 1.0F);
    const float divisor = (1.0F - part) + part * clip.w;
    constexpr float smallest = 1.0e-6F;
    if (!(divisor > smallest)) {
        return std::nullopt;
    }
    const float toward_viewer = directions.ndc_grows_with_distance ? -1.0F : 1.0F;
    const glm::vec3 numerator{
        clip.x, clip.y, (1.0F - part) * -clip.w + part * (toward_viewer * clip.z)};
    return numerator * (1.0F / divisor);
}

} // namespace hs::explain
