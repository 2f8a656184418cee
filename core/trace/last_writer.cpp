#include "core/trace/last_writer.hpp"

namespace hs::trace {
namespace {

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

std::uint32_t
last_writer(const Recording& recording, std::uint32_t fragment, int sample, Left what) {
    while (fragment != no_fragment && !left(recording, fragment, sample, what)) {
        fragment = recording.fragments[fragment].previous;
    }
    return fragment;
}

} // namespace hs::trace
