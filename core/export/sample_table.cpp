// What every sample of every pixel holds at a step, in frames with several samples a pixel.
#include "core/export/column.hpp"

namespace hs::exporting {
namespace {

/// The last fragment that reached each pixel up to the step: the log tells what it left there.
std::vector<std::uint32_t> last_fragments(const trace::Player& player) {
    const trace::Recording& recording = player.recording();
    std::vector<std::uint32_t> last;
    for (int y = 0; y < recording.height(); ++y) {
        for (int x = 0; x < recording.width(); ++x) {
            last.push_back(player.pixel({x, y}).last_fragment);
        }
    }
    return last;
}

} // namespace

Table sample_table(const trace::Player& player) {
    const SharedRecording& recording = player.shared_recording();
    Table table{.name = "samples", .rows = 0, .columns = {}};
    const auto count = static_cast<std::size_t>(recording->settings().samples);
    const auto width = static_cast<std::size_t>(recording->width());
    auto last = std::make_shared<const std::vector<std::uint32_t>>();
    if (recording->samples.active()) {
        last = std::make_shared<const std::vector<std::uint32_t>>(last_fragments(player));
        table.rows = last->size() * count;
    }
    const auto value = [recording, last, count](std::size_t row) {
        const framebuffer::PixelSamples samples = recording->samples.after((*last)[row / count]);
        return samples[static_cast<int>(row % count)];
    };
    table.columns.push_back(column<std::uint16_t, 2>("sample.pixel", [=](std::size_t row) {
        const std::size_t pixel = row / count;
        return std::array{
            static_cast<std::uint16_t>(pixel % width), static_cast<std::uint16_t>(pixel / width)};
    }));
    table.columns.push_back(column<std::uint8_t>("sample.number", [count](std::size_t row) {
        return static_cast<std::uint8_t>(row % count);
    }));
    table.columns.push_back(column<float, 4>("sample.color", [value](std::size_t row) {
        const glm::vec4 color = value(row).color;
        return std::array{color.r, color.g, color.b, color.a};
    }));
    table.columns.push_back(column<float>("sample.depth", [value](std::size_t row) {
        return value(row).depth;
    }));
    return table;
}

} // namespace hs::exporting
