#include "core/shading/shade.hpp"

#include <glm/geometric.hpp>

namespace hs::shading {

glm::vec3 to_viewer(const ShadingInputs& in, const glm::vec3& eye_position) {
    const float distance = glm::length(eye_position);
    if (in.orthographic || distance == 0.0F) {
        return {0.0F, 0.0F, -in.forward};
    }
    return -eye_position / distance;
}

} // namespace hs::shading
