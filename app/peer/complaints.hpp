// What is wrong with what a caller gave, as a sentence; empty when nothing is.
#pragma once

#include "osmesa.hpp"

namespace hs::peer {

[[nodiscard]] std::string
complain_about_size(int width, int height, int samples, bool wide_viewport);

/// About triangles that name a vertex which does not exist.
[[nodiscard]] std::string
complain_about_indices(std::size_t vertex_count, std::span<const glm::uvec3> triangles);

[[nodiscard]] std::string complain_about_options(const DrawOptions& options);

} // namespace hs::peer
