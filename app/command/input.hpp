// How commands are given input.
#pragma once

#include "core/base/diagnostic.hpp"
#include "core/base/pixel.hpp"
#include "core/scene/scene_file.hpp"
#include "core/trace/player.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hs::viewer {
class Viewer;
}

namespace hs::command {

/// Options any command takes, before or behind its name.
struct Common {
    std::vector<std::string> set; ///< key=value
    std::string size;             ///< WIDTHxHEIGHT
    unsigned threads = 0;         ///< 0: as many as the machine has
    bool quiet = false;           ///< no progress
    bool json = false;            ///< one JSON document instead of text
};

/// "1280x720" to width and height.
struct Size {
    int width = 0;
    int height = 0;
};
Result<Size> parse_size(std::string_view text);

/// "31,17" to a pixel.
Result<PixelPos> parse_pixel(std::string_view text);

/// What is wrong with a pixel that the image has not.
Diagnostic outside_image(PixelPos pixel, const trace::Recording& recording);

/// The file's ending if it is among those a command writes; the error lists them.
Result<std::string>
output_format(const std::filesystem::path& file, std::initializer_list<std::string_view> known);

/// What --set and --size ask for.
Result<std::vector<scene::Assignment>> assignments_of(const Common& common);

/// A scene file or mesh, and how it is changed.
struct Source {
    std::filesystem::path file;
    std::vector<scene::Assignment> assignments;
};

/// A scene, a mesh, or a lesson (the scene of its first step), with --set and --size applied.
Result<Source> find_source(const std::filesystem::path& file, const Common& common);

Result<std::shared_ptr<const scene::Scene>> load(const Source& source);

/// Loads and records, with a progress bar where stderr is a terminal.
Result<std::shared_ptr<const trace::Recording>> record(const Source& source, const Common& common);

/// Both of the above.
Result<std::shared_ptr<const trace::Recording>>
record_file(const std::filesystem::path& file, const Common& common);

/// Asks for the same frame with `key=value` changed, beside it; "" asks for nothing.
Result<Done> show_beside(viewer::Viewer& viewer, const std::string& beside);

/// Stands on the written step; "" is the end.
Result<std::shared_ptr<trace::Player>>
stand_on(std::shared_ptr<const trace::Recording> recording, const std::string& at);

} // namespace hs::command
