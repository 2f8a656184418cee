// Image files through OpenImageIO: textures in, pictures out.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/scene/texture.hpp"

#include <filesystem>

namespace hs::scene {

/// Reads any image OpenImageIO knows, at most 16384 x 16384. Gray becomes RGB, missing alpha 1, no
/// color conversion.
Result<Texture> load_texture(const std::filesystem::path& path);

} // namespace hs::scene
