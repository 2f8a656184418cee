#include "core/scene/image_file.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

namespace hs::scene {

namespace {

constexpr int max_side = 16384;

Diagnostic complaint(const std::filesystem::path& path, const std::string& message) {
    return {path.string(), 0, 0, message};
}

/// OpenImageIO explains itself in several lines, with its own prefixes; the first says what is
/// wrong.
std::string first_line(const std::string& text) {
    return text.empty() ? "OpenImageIO does not say why" : text.substr(0, text.find('\n'));
}

std::optional<std::string> check_size(const OIIO::ImageSpec& spec) {
    if (spec.width < 1 || spec.height < 1 || spec.width > max_side || spec.height > max_side) {
        return fmt::format(
            "an image can have 1 to {} pixels per side, not {} x {}",
            max_side,
            spec.width,
            spec.height
        );
    }
    if (spec.nchannels < 1 || spec.depth > 1) {
        return std::string{"the image must be flat and have at least one channel"};
    }
    return std::nullopt;
}

/// Gray, gray with alpha, RGB or RGBA to RGBA; channels beyond the fourth are left out.
glm::vec4 to_rgba(const float* channel, int count) {
    switch (count) {
    case 1: return {channel[0], channel[0], channel[0], 1.0F};
    case 2: return {channel[0], channel[0], channel[0], channel[1]};
    case 3: return {channel[0], channel[1], channel[2], 1.0F};
    default: return {channel[0], channel[1], channel[2], channel[3]};
    }
}

bool is_finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// Row by row, so that a header that lies about its size costs nothing before the first missing
/// row.
std::optional<std::string> read_rows(OIIO::ImageInput& input, Texture& texture) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<float> row;
    for (int y = 0; y < spec.height; ++y) {
        const auto count =
            static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
        row.resize(count);
        if (!input.read_scanline(spec.y + y, 0, OIIO::TypeDesc::FLOAT, row.data())) {
            return fmt::format("row {} cannot be read: {}", y, first_line(input.geterror()));
        }
        for (int x = 0; x < spec.width; ++x) {
            const auto first =
                static_cast<std::size_t>(x) * static_cast<std::size_t>(spec.nchannels);
            texture.texels.push_back(to_rgba(&row[first], spec.nchannels));
            if (!is_finite(texture.texels.back())) {
                return fmt::format("pixel {},{} is not a finite number", x, y);
            }
        }
    }
    return std::nullopt;
}

} // namespace

Result<Texture> load_texture(const std::filesystem::path& path) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1; // else colors come multiplied by alpha
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &wishes);
    if (!input) {
        return complaint(path, "the image cannot be opened: " + first_line(OIIO::geterror()));
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (const auto message = check_size(spec)) {
        return complaint(path, *message);
    }
    Texture texture;
    texture.name = path.filename().string();
    texture.width = spec.width;
    texture.height = spec.height;
    if (const auto message = read_rows(*input, texture)) {
        return complaint(path, *message);
    }
    return texture;
}

} // namespace hs::scene
