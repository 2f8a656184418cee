// Small scenes made by hand, for tests that need to know exactly what is in them.
#pragma once

#include "core/scene/scene.hpp"

#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace hs::tests {

/// Triangles in clip space (identity camera), three vertices each, white, in one object.
std::shared_ptr<scene::Scene>
clip_space_scene(const std::vector<glm::vec4>& positions, int width, int height);

/// `count` times the same triangle that covers the whole image, at depth 0.5.
std::shared_ptr<scene::Scene> stacked_scene(int count, int width, int height);

} // namespace hs::tests
