// The buffers of a step as plain numbers: what every picture and array file is made from.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/trace/player.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hs::exporting {

/// One buffer. Values are row by row from the top, channels of a pixel side by side.
struct Layer {
    std::string name;                  ///< "color", as in --what and in NPZ
    std::vector<std::string> channels; ///< as in EXR: "R" "G" "B" "A", "Z", "triangle"
    int width = 0;
    int height = 0;
    bool whole_numbers = false; ///< triangle numbers and counts
    std::vector<float> values;
};

/// The names `make_layers` knows, each with one sentence.
struct LayerName {
    std::string_view name;
    std::string_view explanation;
};
std::span<const LayerName> layer_names();

/// The named buffers at the player's step. Edge functions (in pixel²) and barycentric weights are
/// those of the current triangle over the whole image; elsewhere than at a step of a triangle that
/// was set up they are an error, as is an unknown name.
Result<std::vector<Layer>>
make_layers(const trace::Player& player, std::span<const std::string> names);

} // namespace hs::exporting
