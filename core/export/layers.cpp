#include "core/export/layers.hpp"

#include "core/base/fixed.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace hs::exporting {
namespace {

constexpr std::array<LayerName, 9> known{{
    {"color", "the color buffer"},
    {"depth", "the stored depth, exactly as tested"},
    {"triangle", "the owning triangle over the whole frame in file order, -1: background"},
    {"overdraw", "fragments written per pixel"},
    {"complexity", "fragments generated per pixel"},
    {"edge0", "E01 of the current triangle in pixel²"},
    {"edge1", "E12 of the current triangle in pixel²"},
    {"edge2", "E20 of the current triangle in pixel²"},
    {"barycentric", "λ0, λ1, λ2 of the current triangle"},
}};

constexpr float square_pixel = static_cast<float>(subpixel_scale) * subpixel_scale;

/// A layer filled pixel by pixel: `write(pixel, values)` sets as many floats as there are channels.
template <typename Write>
Layer fill(
    const trace::Player& player,
    std::string_view name,
    std::vector<std::string> channels,
    Write write
) {
    Layer layer;
    layer.name = name;
    layer.channels = std::move(channels);
    layer.width = player.recording().width();
    layer.height = player.recording().height();
    const std::size_t stride = layer.channels.size();
    layer.values.resize(
        static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height) * stride
    );
    float* values = layer.values.data();
    for (int y = 0; y < layer.height; ++y) {
        for (int x = 0; x < layer.width; ++x, values += stride) {
            write(PixelPos{x, y}, values);
        }
    }
    return layer;
}

Layer count_layer(const trace::Player& player, std::string_view name) {
    Layer layer = fill(player, name, {std::string{name}}, [&](PixelPos p, float* out) {
        if (name == "triangle") {
            const std::uint32_t owner = player.pixel(p).triangle;
            *out = owner == trace::no_triangle ? -1.0F : static_cast<float>(owner);
        } else {
            *out =
                static_cast<float>(name == "overdraw" ? player.overdraw(p) : player.complexity(p));
        }
    });
    layer.whole_numbers = true;
    return layer;
}

/// The setup of the piece the playhead stands on, or of the triangle's first that has one.
const raster::TriangleSetup* current_setup(const trace::Player& player) {
    const auto& triangle = player.detail().triangle;
    if (!triangle) {
        return nullptr;
    }
    const trace::Step& step = player.current();
    const auto piece = static_cast<std::size_t>(step.has_piece() ? step.piece : 0);
    if (piece >= triangle->pieces.size() || !triangle->pieces[piece].setup) {
        return nullptr;
    }
    return &*triangle->pieces[piece].setup;
}

Result<Layer> triangle_layer(const trace::Player& player, const std::string& name) {
    const raster::TriangleSetup* setup = current_setup(player);
    if (setup == nullptr) {
        return Diagnostic{
            .message = fmt::format(
                "'{}' needs a step of a triangle that was set up; {} is none",
                name,
                trace::step_path(player.current())
            )};
    }
    if (name == "barycentric") {
        return fill(
            player,
            name,
            {"barycentric.0", "barycentric.1", "barycentric.2"},
            [&](PixelPos p, float* out) {
                const raster::EdgeValues e = setup->evaluate(p);
                out[1] = static_cast<float>(e[2]) * setup->inv_doubled_area;
                out[2] = static_cast<float>(e[0]) * setup->inv_doubled_area;
                out[0] = 1.0F - out[1] - out[2];
            }
        );
    }
    const auto edge = static_cast<std::size_t>(name.back() - '0');
    return fill(player, name, {name}, [&](PixelPos p, float* out) {
        *out = static_cast<float>(setup->edges[edge](p)) / square_pixel;
    });
}

Result<Layer> make_layer(const trace::Player& player, const std::string& name) {
    if (name == "color") {
        return fill(player, name, {"R", "G", "B", "A"}, [&](PixelPos p, float* out) {
            const glm::vec4 color = player.color(p);
            out[0] = color.r;
            out[1] = color.g;
            out[2] = color.b;
            out[3] = color.a;
        });
    }
    if (name == "depth") {
        return fill(player, name, {"Z"}, [&](PixelPos p, float* out) {
            *out = player.pixel(p).depth;
        });
    }
    if (name == "triangle" || name == "overdraw" || name == "complexity") {
        return count_layer(player, name);
    }
    if (name == "edge0" || name == "edge1" || name == "edge2" || name == "barycentric") {
        return triangle_layer(player, name);
    }
    std::vector<std::string_view> names;
    names.reserve(known.size());
    for (const LayerName& layer : known) {
        names.push_back(layer.name);
    }
    return Diagnostic{
        .message = fmt::format("'{}' is not a buffer; known are {}", name, fmt::join(names, ", "))};
}

} // namespace

std::span<const LayerName> layer_names() {
    return known;
}

Result<std::vector<Layer>>
make_layers(const trace::Player& player, std::span<const std::string> names) {
    std::vector<Layer> layers;
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (std::find(names.begin(), name, *name) != name) {
            return Diagnostic{.message = fmt::format("'{}' is named twice", *name)};
        }
        Result<Layer> layer = make_layer(player, *name);
        if (!layer) {
            return layer.diagnostics();
        }
        layers.push_back(std::move(*layer));
    }
    return layers;
}

} // namespace hs::exporting
