#include "core/shading/shade.hpp"

#include <glm/geometric.hpp>

namespace hs::shading {

glm::vec3 to_viewer(const glm::vec3& eye_position, bool orthographic) {
    const float distance = glm::length(eye_position);
    if (orthographic || distance == 0.0F) {
        return {0.0F, 0.0F, 1.0F};
    }
    return -eye_position / distance;
}

} // namespace hs::shading
