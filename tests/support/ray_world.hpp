// Embree's answer to "what does this ray hit first?". Only in builds with Embree.
#pragma once

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace hs::tests {

/// A world of loose triangles for rays.
class RayWorld {
public:
    explicit RayWorld(const std::vector<glm::vec4>& corners);
    RayWorld(const RayWorld&) = delete;
    RayWorld& operator=(const RayWorld&) = delete;
    RayWorld(RayWorld&&) = delete;
    RayWorld& operator=(RayWorld&&) = delete;
    ~RayWorld();

    /// The first triangle hit, or −1. Distances count in multiples of the direction.
    [[nodiscard]] int
    first_hit(const glm::vec3& origin, const glm::vec3& direction, float near, float far) const;

private:
    RTCDevice device_;
    RTCScene scene_;
};

} // namespace hs::tests
