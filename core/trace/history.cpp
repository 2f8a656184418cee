#include "core/trace/history.hpp"

#include "core/framebuffer/depth.hpp"

#include <algorithm>

namespace hs::trace {
namespace {

HistoryRow row_of(const Recording& recording, std::uint32_t fragment) {
    const FragmentRecord& record = recording.fragments[fragment];
    HistoryRow row;
    row.fragment = fragment;
    row.frame_triangle = recording.run_of_fragment(fragment).triangle;
    row.object = recording.object_of_triangle(row.frame_triangle);
    row.triangle = row.frame_triangle - recording.objects[row.object].first_triangle;
    row.triangle_step = recording.triangles[row.frame_triangle].first_step;
    row.depth = record.depth;
    row.fate = record.fate;
    row.after =
        !recording.float_color() ? framebuffer::unpack(record.color) : recording.color32f[fragment];
    return row;
}

/// Whether a fragment left that in the pixel, or in one of its samples.
bool left(const Recording& recording, std::uint32_t fragment, int sample, Left what) {
    const FragmentRecord& record = recording.fragments[fragment];
    if (!record.written() || (sample >= 0 && !raster::has_sample(record.passed, sample))) {
        return false;
    }
    if (what == Left::color) {
        return true;
    }
    const std::uint32_t triangle = recording.run_of_fragment(fragment).triangle;
    const scene::Settings& settings =
        recording.frame->calls()[recording.object_of_triangle(triangle)].settings;
    return settings.visibility == scene::Visibility::z_buffer && settings.depth_write;
}

} // namespace

PixelHistory pixel_history(const Recording& recording, PixelPos pixel, std::size_t limit) {
    HS_CHECK(recording.settings().image().contains(pixel), "a pixel of the image");
    PixelHistory history;
    history.pixel = pixel;

    // Follow the links from the last fragment to the first
    std::uint32_t earliest = no_fragment;
    for (std::uint32_t i = recording.final_pixels[pixel].last_fragment; i != no_fragment;
         i = recording.fragments[i].previous) {
        if (history.rows.size() == limit) {
            ++history.left_out;
            continue;
        }
        history.rows.push_back(row_of(recording, i));
        earliest = i;
    }
    std::reverse(history.rows.begin(), history.rows.end());

    // Carry what the pixel holds from row to row
    const scene::Settings& settings = recording.settings();
    PixelBefore held;
    held.color = !recording.float_color()
                     ? framebuffer::unpack(framebuffer::pack(settings.background))
                     : settings.background;
    held.depth = framebuffer::store_depth(settings.depth_clear(), settings.depth_format);
    if (history.left_out > 0) {
        held = pixel_before(recording, earliest);
    }
    history.initial_color = held.color;
    history.initial_depth = held.depth;
    for (HistoryRow& row : history.rows) {
        row.before = held.color;
        row.stored_depth = held.depth;
        held.color = row.after;
        held.depth = recording.fragments[row.fragment].depth_written ? row.depth : held.depth;
    }
    history.final_color = held.color;
    history.final_depth = held.depth;
    return history;
}

std::uint32_t
last_writer(const Recording& recording, std::uint32_t fragment, int sample, Left what) {
    while (fragment != no_fragment && !left(recording, fragment, sample, what)) {
        fragment = recording.fragments[fragment].previous;
    }
    return fragment;
}

} // namespace hs::trace
