// Every fragment in execution order, and the runs they come in.
#include "core/export/column.hpp"
#include "core/framebuffer/depth.hpp"

#include <algorithm>

namespace hs::exporting {
namespace {

using trace::Recording;

/// Who a fragment belongs to. Going on from the last one asked for is quick.
class Owner {
public:
    explicit Owner(SharedRecording recording) : recording_(std::move(recording)) {}

    std::uint32_t operator()(std::size_t fragment) {
        const std::vector<trace::Run>& runs = recording_->runs;
        if (fragment < runs[run_].first_fragment) {
            run_ = 0;
        }
        while (run_ + 1 < runs.size() && runs[run_ + 1].first_fragment <= fragment) {
            ++run_;
        }
        return runs[run_].triangle;
    }

private:
    SharedRecording recording_;
    std::size_t run_ = 0;
};

/// The depth a pixel held before a fragment: a fold over the fragments before it, carried along
/// while rows are asked for in order.
class StoredDepth {
public:
    explicit StoredDepth(SharedRecording recording) : recording_(std::move(recording)) {}

    float operator()(std::size_t fragment) {
        if (held_.empty() || fragment < next_) {
            const scene::Settings& settings = recording_->settings();
            held_.assign(
                static_cast<std::size_t>(settings.width) *
                    static_cast<std::size_t>(settings.height),
                framebuffer::store_depth(settings.depth_clear(), settings.depth_format)
            );
            next_ = 0;
        }
        for (; next_ < fragment; ++next_) {
            const trace::FragmentRecord& earlier = recording_->fragments[next_];
            if (earlier.depth_written) {
                held_[place_of(earlier.pixel())] = earlier.depth;
            }
        }
        return held_[place_of(recording_->fragments[fragment].pixel())];
    }

private:
    [[nodiscard]] std::size_t place_of(PixelPos p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(recording_->width()) +
               static_cast<std::size_t>(p.x);
    }

    SharedRecording recording_;
    std::vector<float> held_; ///< per pixel, before fragment `next_`
    std::size_t next_ = 0;
};

std::array<float, 4> color_after(const Recording& recording, std::size_t fragment) {
    const glm::vec4 color = recording.float_color()
                                ? recording.color32f[fragment]
                                : framebuffer::unpack(recording.fragments[fragment].color);
    return {color.r, color.g, color.b, color.a};
}

} // namespace

Table fragment_table(const SharedRecording& recording, std::uint32_t fragments) {
    Table table{.name = "fragments", .rows = fragments, .columns = {}};
    std::vector<Column>& columns = table.columns;
    columns.push_back(column<std::uint32_t>("fragment.triangle", Owner(recording)));
    columns.push_back(column<std::uint16_t, 2>("fragment.pixel", [recording](std::size_t row) {
        const trace::FragmentRecord& fragment = recording->fragments[row];
        return std::array{fragment.x, fragment.y};
    }));
    columns.push_back(column<float>("fragment.depth", [recording](std::size_t row) {
        return recording->fragments[row].depth;
    }));
    columns.push_back(column<float>("fragment.stored_depth", StoredDepth(recording)));
    columns.push_back(column<float, 4>("fragment.color", [recording](std::size_t row) {
        return color_after(*recording, row);
    }));
    columns.push_back(named_column<fragment::FragmentFate>(
        "fragment.fate", [recording](std::size_t row) { return recording->fragments[row].fate; }
    ));
    if (recording->samples.active()) {
        columns.push_back(column<std::uint8_t>("fragment.coverage", [recording](std::size_t row) {
            return recording->fragments[row].coverage;
        }));
        columns.push_back(column<std::uint8_t>("fragment.passed", [recording](std::size_t row) {
            return recording->fragments[row].passed;
        }));
    }
    return table;
}

Table run_table(const SharedRecording& recording, std::uint32_t fragments) {
    const std::vector<trace::Run>& runs = recording->runs;
    const auto end = std::lower_bound(
        runs.begin(),
        runs.end(),
        fragments,
        [](const trace::Run& run, std::uint32_t count) { return run.first_fragment < count; }
    );
    Table table{
        .name = "runs", .rows = static_cast<std::size_t>(end - runs.begin()), .columns = {}};
    table.columns.push_back(column<std::uint32_t>("run.triangle", [recording](std::size_t row) {
        return recording->runs[row].triangle;
    }));
    table.columns.push_back(column<std::uint16_t>("run.piece", [recording](std::size_t row) {
        return recording->runs[row].piece;
    }));
    table.columns.push_back(column<std::uint16_t>("run.pass", [](std::size_t) {
        return std::uint16_t{0}; // a z-buffer draws the scene once
    }));
    table.columns.push_back(column<std::uint64_t>(
        "run.first_fragment",
        [recording](std::size_t row) -> std::uint64_t {
            return recording->runs[row].first_fragment;
        }
    ));
    return table;
}

} // namespace hs::exporting
