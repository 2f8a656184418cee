#include "core/export/layer_file.hpp"

#include "core/export/npz.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace hs::exporting {
namespace {

std::string csv_header(std::span<const Layer> layers) {
    std::string header = "x,y";
    for (const Layer& layer : layers) {
        if (layer.channels.size() == 1) {
            header += ',' + layer.name;
            continue;
        }
        for (std::size_t c = 0; c < layer.channels.size(); ++c) {
            header += ',' + component_name(layer.name, layer.channels.size(), c);
        }
    }
    return header + '\n';
}

/// The numbers of one pixel.
void append_pixel(fmt::memory_buffer& line, const Layer& layer, std::size_t pixel) {
    const std::size_t stride = layer.channels.size();
    for (std::size_t c = 0; c < stride; ++c) {
        const float value = layer.values[pixel * stride + c];
        if (layer.whole_numbers) {
            fmt::format_to(std::back_inserter(line), ",{}", static_cast<std::int32_t>(value));
        } else {
            fmt::format_to(std::back_inserter(line), ",{}", value);
        }
    }
}

/// A line of the file: the pixel's place, then its numbers in every layer.
void set_line(
    fmt::memory_buffer& line, std::span<const Layer> layers, std::size_t x, std::size_t y
) {
    line.clear();
    fmt::format_to(std::back_inserter(line), "{},{}", x, y);
    const std::size_t pixel = y * static_cast<std::size_t>(layers.front().width) + x;
    for (const Layer& layer : layers) {
        append_pixel(line, layer, pixel);
    }
    line.push_back('\n');
}

} // namespace

Result<Done> write_npz(
    const std::filesystem::path& path, std::span<const Layer> layers, const Attributes& attributes
) {
    std::vector<std::vector<std::int32_t>> integers;
    integers.reserve(layers.size()); // members point at what it holds
    std::vector<Member> members;
    for (const Layer& layer : layers) {
        std::vector<std::size_t> shape{
            static_cast<std::size_t>(layer.height), static_cast<std::size_t>(layer.width)};
        if (layer.channels.size() > 1) {
            shape.push_back(layer.channels.size());
        }
        if (layer.whole_numbers) {
            const auto& whole = integers.emplace_back(layer.values.begin(), layer.values.end());
            members.push_back(array_member(layer.name, ColumnType::int32, shape, whole.data()));
        } else {
            const float* values = layer.values.data();
            members.push_back(array_member(layer.name, ColumnType::float32, shape, values));
        }
    }
    members.push_back(manifest_member(attributes));
    return write_archive(path, members);
}

Result<Done> write_csv(const std::filesystem::path& path, std::span<const Layer> layers) {
    return write_bytes(path, [layers](ByteSink& sink) {
        sink.write(csv_header(layers));
        fmt::memory_buffer line;
        const auto width = static_cast<std::size_t>(layers.front().width);
        const auto height = static_cast<std::size_t>(layers.front().height);
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 0; x < width; ++x) {
                set_line(line, layers, x, y);
                sink.write(std::string_view{line.data(), line.size()});
            }
        }
    });
}

} // namespace hs::exporting
