#include "core/export/array_file.hpp"

#include "core/export/npz.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace hs::exporting {

Result<Done> write_npz(const std::filesystem::path& path, std::span<const Layer> layers) {
    std::vector<Member> members;
    for (const Layer& layer : layers) {
        std::vector<std::size_t> shape{
            static_cast<std::size_t>(layer.height), static_cast<std::size_t>(layer.width)};
        if (layer.channels.size() > 1) {
            shape.push_back(layer.channels.size());
        }
        members.push_back(
            array_member(layer.name + ".npy", ColumnType::float32, shape, layer.values.data())
        );
    }
    return write_archive(path, std::move(members));
}

Result<Done> write_csv(const std::filesystem::path& path, std::span<const Layer> layers) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "x,y");
    for (const Layer& layer : layers) {
        for (const std::string& channel : layer.channels) {
            // A layer of one channel is named like the layer, others layer.channel
            if (layer.channels.size() == 1) {
                fmt::format_to(out, ",{}", layer.name);
            } else {
                fmt::format_to(out, ",{}.{}", layer.name, channel);
            }
        }
    }
    fmt::format_to(out, "\n");
    for (int y = 0; y < layers.front().height; ++y) {
        for (int x = 0; x < layers.front().width; ++x) {
            fmt::format_to(out, "{},{}", x, y);
            const auto pixel = static_cast<std::size_t>(y * layers.front().width + x);
            for (const Layer& layer : layers) {
                const std::size_t stride = layer.channels.size();
                for (std::size_t c = 0; c < stride; ++c) {
                    fmt::format_to(out, ",{}", layer.values[pixel * stride + c]);
                }
            }
            fmt::format_to(out, "\n");
        }
    }
    return write_text(path, fmt::to_string(text));
}

} // namespace hs::exporting
