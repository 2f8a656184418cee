// An image whose texels shading looks up.
#pragma once

#include <glm/vec4.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace hs::scene {

/// Row 0 is the top row; texel (i, j) covers u in [i/width, (i+1)/width). At least one texel.
/// Values as stored in the file (8-bit values as v/255), unassociated alpha, no color-space
/// conversion.
struct Texture {
    std::string name;
    int width = 1;
    int height = 1;
    std::vector<glm::vec4> texels;

    [[nodiscard]] const glm::vec4& texel(int i, int j) const {
        return texels
            [static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(i)];
    }
};

} // namespace hs::scene
