#include "core/scene/image_file.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>

namespace hs::scene {

namespace {

constexpr int max_side = 16384;

Diagnostic complaint(const std::filesystem::path& path, const std::string& message) {
    return {path.string(), 0, 0, message};
}

/// OpenImageIO explains itself at length; the first sentence says what is wrong.
std::string first_sentence(const std::string& text) {
    const std::size_t end = std::min(text.find('\n'), text.find(". "));
    return text.empty() ? "OpenImageIO does not say why" : text.substr(0, end);
}

/// Whether a PNG stops before its last chunk, IEND (PNG specification, section 5.3). libpng prints
/// a line of its own about such files, so they never reach it. Other formats, and files that cannot
/// be read at all, are left to OpenImageIO.
bool png_ends_early(const std::filesystem::path& path) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    std::ifstream file(path, std::ios::binary);
    std::array<char, 8> bytes{};
    if (!file.read(bytes.data(), bytes.size()) ||
        std::string_view{bytes.data(), bytes.size()} != signature) {
        return false;
    }
    while (file.read(bytes.data(), bytes.size())) {
        // A chunk: length, name, content, check sum
        std::streamoff length = 0;
        for (unsigned i = 0; i < 4; ++i) {
            length = length * 256 + static_cast<unsigned char>(bytes[i]);
        }
        if (std::string_view{bytes.data() + 4, 4} == "IEND") {
            return false;
        }
        constexpr std::streamoff check_sum = 4;
        file.seekg(length + check_sum, std::ios::cur);
    }
    return true;
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
    constexpr int most_channels = 64;
    if (spec.nchannels < 1 || spec.nchannels > most_channels || spec.depth > 1 || spec.deep) {
        return fmt::format("the image must be flat and have 1 to {} channels", most_channels);
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

/// 8-bit values become v/255, correctly rounded; OpenImageIO multiplies by an inexact 1/255.
bool read_row(OIIO::ImageInput& input, int y, std::vector<float>& row) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.format != OIIO::TypeDesc::UINT8) {
        return input.read_scanline(spec.y + y, 0, OIIO::TypeDesc::FLOAT, row.data());
    }
    std::vector<unsigned char> bytes(row.size());
    const bool good = input.read_scanline(spec.y + y, 0, OIIO::TypeDesc::UINT8, bytes.data());
    std::ranges::transform(bytes, row.begin(), [](unsigned char byte) {
        return static_cast<float>(byte) / 255.0F;
    });
    return good;
}

/// Row by row, so that a header that lies about its size costs nothing before the first missing
/// row.
std::optional<std::string> read_rows(OIIO::ImageInput& input, Texture& texture) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> row(static_cast<std::size_t>(spec.width) * channels);
    for (int y = 0; y < spec.height; ++y) {
        if (!read_row(input, y, row)) {
            return fmt::format("row {} cannot be read: {}", y, first_sentence(input.geterror()));
        }
        for (std::size_t x = 0; x < row.size(); x += channels) {
            texture.texels.push_back(to_rgba(&row[x], spec.nchannels));
            if (!is_finite(texture.texels.back())) {
                return fmt::format("pixel {},{} is not a finite number", x / channels, y);
            }
        }
    }
    return std::nullopt;
}

} // namespace

Result<Texture> load_texture(const std::filesystem::path& path) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1; // else colors come multiplied by alpha
    if (png_ends_early(path)) {
        return complaint(path, "the image ends in the middle; copy it again");
    }
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &wishes);
    if (!input) {
        return complaint(path, "the image cannot be opened: " + first_sentence(OIIO::geterror()));
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
