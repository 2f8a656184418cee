#include "core/export/picture_file.hpp"

#include "core/export/whole_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

namespace hs::exporting {
namespace {

namespace fs = std::filesystem;

OIIO::ImageSpec make_spec(
    int width, int height, int channels, const OIIO::TypeDesc& type, const Attributes& attributes
) {
    OIIO::ImageSpec spec(width, height, channels, type);
    for (const auto& [name, text] : attributes) {
        spec.attribute(name, text);
    }
    return spec;
}

/// Writes an image whose samples are in `data`, of the type the spec names. OpenImageIO encodes
/// into memory: what fails while a file is written, it does not always tell.
Result<Done> write_image(const fs::path& path, const OIIO::ImageSpec& spec, const void* data) {
    const auto cannot_write = [&path](const std::string& why) {
        return Diagnostic{
            .file = path.string(), .message = fmt::format("cannot be written: {}", why)};
    };
    OIIO::Filesystem::IOVecOutput encoded;
    const std::unique_ptr<OIIO::ImageOutput> output =
        OIIO::ImageOutput::create(path.filename().string(), &encoded);
    if (!output) {
        return cannot_write(OIIO::geterror());
    }
    const bool written = output->open(path.filename().string(), spec) &&
                         output->write_image(spec.format, data) && output->close();
    if (!written) {
        return cannot_write(output->geterror());
    }
    return write_bytes(path, [&encoded](ByteSink& sink) {
        const std::vector<unsigned char>& bytes = encoded.buffer();
        sink.write(std::as_bytes(std::span{bytes.data(), bytes.size()}));
    });
}

/// What black and white mean in a gray picture.
struct Range {
    float low = 0.0F;
    float high = 1.0F;
};

Range gray_range(const Layer& layer) {
    if (layer.name == "depth" || layer.name == "barycentric") {
        return {};
    }
    if (layer.whole_numbers) {
        return {0.0F, 65535.0F};
    }
    const auto [low, high] = std::minmax_element(layer.values.begin(), layer.values.end());
    return {*low, *high > *low ? *high : *low + 1.0F};
}

Result<Done> write_gray16(const fs::path& path, const Layer& layer, Attributes attributes) {
    const Range range = gray_range(layer);
    std::vector<std::uint16_t> gray;
    gray.reserve(layer.values.size());
    for (const float value : layer.values) {
        const float unit = (value - range.low) / (range.high - range.low);
        gray.push_back(
            static_cast<std::uint16_t>(std::lround(std::clamp(unit, 0.0F, 1.0F) * 65535.0F))
        );
    }
    attributes.emplace_back("halfspace:range", fmt::format("[{}, {}]", range.low, range.high));
    const auto channels = static_cast<int>(layer.channels.size());
    return write_image(
        path,
        make_spec(layer.width, layer.height, channels, OIIO::TypeDesc::UINT16, attributes),
        gray.data()
    );
}

std::vector<framebuffer::Rgba8> packed_colors(const Layer& layer) {
    std::vector<framebuffer::Rgba8> pixels;
    pixels.reserve(layer.values.size() / 4);
    for (std::size_t i = 0; i < layer.values.size(); i += 4) {
        pixels.push_back(framebuffer::pack(
            {layer.values[i], layer.values[i + 1], layer.values[i + 2], layer.values[i + 3]}
        ));
    }
    return pixels;
}

std::vector<framebuffer::Rgba8> number_colors(const Layer& layer) {
    std::vector<framebuffer::Rgba8> pixels;
    pixels.reserve(layer.values.size());
    for (const float number : layer.values) {
        pixels.push_back(number_color(static_cast<std::int64_t>(number)));
    }
    return pixels;
}

} // namespace

framebuffer::Rgba8 number_color(std::int64_t number) {
    const auto bits = static_cast<std::uint64_t>(number + 1);
    std::uint32_t color = 0xFF000000U;
    for (unsigned bit = 0; bit < 24; ++bit) {
        const unsigned channel = bit % 3;
        const unsigned place = 7 - bit / 3;
        color |= static_cast<std::uint32_t>(bits >> bit & 1U) << (8 * channel + place);
    }
    return color;
}

Result<Done> write_png(const fs::path& path, const Layer& layer, const Attributes& attributes) {
    if (layer.name == "color" || layer.name == "triangle") {
        const auto pixels = layer.name == "color" ? packed_colors(layer) : number_colors(layer);
        return write_png(path, layer.width, layer.height, pixels, attributes);
    }
    return write_gray16(path, layer, attributes);
}

Result<Done> write_png(
    const fs::path& path,
    int width,
    int height,
    std::span<const framebuffer::Rgba8> pixels,
    const Attributes& attributes
) {
    OIIO::ImageSpec spec = make_spec(width, height, 4, OIIO::TypeDesc::UINT8, attributes);
    spec.attribute("oiio:UnassociatedAlpha", 1); // or colors are multiplied by alpha
    return write_image(path, spec, pixels.data());
}

Result<Done>
write_exr(const fs::path& path, std::span<const Layer> layers, const Attributes& attributes) {
    const int width = layers.front().width;
    const int height = layers.front().height;
    std::size_t channels = 0;
    for (const Layer& layer : layers) {
        channels += layer.channels.size();
    }
    OIIO::ImageSpec spec =
        make_spec(width, height, static_cast<int>(channels), OIIO::TypeDesc::FLOAT, attributes);
    spec.attribute("compression", "zip");
    spec.channelnames.clear();

    // Interleave the channels of all layers
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<float> values(pixels * channels);
    std::size_t first = 0;
    for (const Layer& layer : layers) {
        const std::size_t stride = layer.channels.size();
        for (std::size_t i = 0; i < pixels; ++i) {
            std::copy_n(&layer.values[i * stride], stride, &values[i * channels + first]);
        }
        spec.channelnames.insert(
            spec.channelnames.end(), layer.channels.begin(), layer.channels.end()
        );
        first += stride;
    }
    return write_image(path, spec, values.data());
}

} // namespace hs::exporting
