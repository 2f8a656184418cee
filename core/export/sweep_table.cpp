// What scanlines and rays found, and the decisions of one of them. Every row of the image is run
// again.
#include "core/export/column.hpp"
#include "core/pipeline/run_sweep.hpp"
#include "core/trace/sweep_detail.hpp"

namespace hs::exporting {
namespace {

/// A triangle over the whole frame, −1 for the background, and its piece.
struct Shown {
    std::int32_t triangle = -1;
    std::int32_t piece = 0;
};

Shown shown(const trace::Recording& recording, std::int32_t polygon) {
    if (polygon < 0) {
        return {};
    }
    const pipeline::PieceName& piece = recording.order.sweep->polygon(polygon);
    const std::uint32_t triangle = recording.objects[piece.object].first_triangle + piece.triangle;
    return {static_cast<std::int32_t>(triangle), piece.piece};
}

struct SpanRow {
    int row = 0;
    double x = 0.0;
    double x_end = 0.0;
    Shown shown;
};

std::vector<SpanRow> spans_of(const trace::Recording& recording) {
    std::vector<SpanRow> spans;
    const scene::Settings& settings = recording.settings();
    if (!recording.order.sweep || !recording.order.sweep->scan) {
        return spans;
    }
    const auto& scan = recording.order.sweep->scan;
    visibility::SilentSweep silent;
    const PixelRect region = pipeline::swept_region(*recording.frame);
    for (int row = region.y0; row < region.y1; ++row) {
        const auto add = [&](std::int32_t polygon, double x, double x_end) {
            spans.push_back({row, x, x_end, shown(recording, polygon)});
        };
        if (settings.visibility == scene::Visibility::scanline) {
            const auto emit = [&](const visibility::ScanSpan& span) {
                add(span.polygon, span.x, span.x_end);
            };
            visibility::scan_row(scan, row, settings.width, silent, emit);
        } else {
            const auto emit = [&](const visibility::LineBuffer& line) {
                for (const visibility::PixelSpan& span : visibility::visible_spans(line)) {
                    add(span.polygon, span.x, span.x_end);
                }
            };
            visibility::scan_row_with_line_buffer(scan, row, settings.width, silent, emit);
        }
    }
    return spans;
}

struct RayRow {
    PixelPos pixel;
    Shown shown;
    visibility::RayMeeting meeting;
};

std::vector<RayRow> rays_of(const trace::Recording& recording) {
    std::vector<RayRow> rays;
    if (recording.settings().visibility != scene::Visibility::ray_cast) {
        return rays;
    }
    const pipeline::Frame& frame = *recording.frame;
    const pipeline::Sweep& sweep = *recording.order.sweep;
    visibility::SilentSweep silent;
    const PixelRect region = pipeline::swept_region(frame);
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const visibility::RayCast cast = visibility::cast_ray(
                pipeline::pixel_ray(frame, sweep, {x, y}), sweep.triangles, silent
            );
            rays.push_back({{x, y}, shown(recording, cast.nearest), cast.meeting});
        }
    }
    return rays;
}

std::array<std::uint16_t, 2> as_array(PixelPos pixel) {
    return {static_cast<std::uint16_t>(pixel.x), static_cast<std::uint16_t>(pixel.y)};
}

} // namespace

Table span_table(const SharedRecording& recording) {
    const auto all = std::make_shared<const std::vector<SpanRow>>(spans_of(*recording));
    Table table{.name = "spans", .rows = all->size(), .columns = {}};
    table.columns.push_back(column<std::uint16_t>("span.row", [all](std::size_t row) {
        return static_cast<std::uint16_t>((*all)[row].row);
    }));
    table.columns.push_back(column<double>("span.x", [all](std::size_t row) {
        return (*all)[row].x;
    }));
    table.columns.push_back(column<double>("span.x_end", [all](std::size_t row) {
        return (*all)[row].x_end;
    }));
    table.columns.push_back(column<std::int32_t>("span.triangle", [all](std::size_t row) {
        return (*all)[row].shown.triangle;
    }));
    table.columns.push_back(column<std::int32_t>("span.piece", [all](std::size_t row) {
        return (*all)[row].shown.piece;
    }));
    return table;
}

Table ray_table(const SharedRecording& recording) {
    const auto all = std::make_shared<const std::vector<RayRow>>(rays_of(*recording));
    Table table{.name = "rays", .rows = all->size(), .columns = {}};
    table.columns.push_back(column<std::uint16_t, 2>("ray.pixel", [all](std::size_t row) {
        return as_array((*all)[row].pixel);
    }));
    table.columns.push_back(column<std::int32_t>("ray.triangle", [all](std::size_t row) {
        return (*all)[row].shown.triangle;
    }));
    table.columns.push_back(column<double>("ray.t", [all](std::size_t row) {
        return (*all)[row].meeting.t;
    }));
    table.columns.push_back(column<double, 3>("ray.weights", [all](std::size_t row) {
        const glm::dvec3& weights = (*all)[row].meeting.weights;
        return std::array{weights.x, weights.y, weights.z};
    }));
    return table;
}

Table sweep_table(const trace::Player& player) {
    using visibility::SweepEvent;
    const SharedRecording recording = player.shared_recording();
    auto detail = std::make_shared<trace::SweepDetail>();
    if (recording->in_row(player.step())) {
        *detail = trace::sweep_detail(*recording, player.current());
    }
    Table table{.name = "sweep", .rows = detail->decisions.size(), .columns = {}};
    const auto number = [&](const char* name, auto get) {
        table.columns.push_back(column<std::int32_t>(
            std::string{"sweep."} + name,
            [recording, detail, get](std::size_t row) -> std::int32_t {
                return get(*recording, detail->decisions[row]);
            }
        ));
    };
    const auto value = [&table, detail](const char* name, double SweepEvent::*member) {
        table.columns.push_back(column<double>(
            std::string{"sweep."} + name,
            [detail, member](std::size_t row) { return detail->decisions[row].*member; }
        ));
    };
    table.columns.push_back(named_column<visibility::SweepEventKind>(
        "sweep.decision", [detail](std::size_t row) { return detail->decisions[row].kind; }
    ));
    table.columns.push_back(column<std::uint8_t>("sweep.verdict", [detail](std::size_t row) {
        return static_cast<std::uint8_t>(detail->decisions[row].verdict ? 1 : 0);
    }));
    number("edge", [](const auto&, const SweepEvent& event) { return event.edge; });
    number("triangle", [](const auto& of, const SweepEvent& event) {
        return shown(of, event.polygon).triangle;
    });
    number("other_triangle", [](const auto& of, const SweepEvent& event) {
        return shown(of, event.other).triangle;
    });
    value("x", &SweepEvent::x);
    value("x_end", &SweepEvent::x_end);
    value("value", &SweepEvent::value);
    value("other_value", &SweepEvent::other_value);
    table.columns.push_back(column<double, 3>("sweep.weights", [detail](std::size_t row) {
        const glm::dvec3& weights = detail->decisions[row].weights;
        return std::array{weights.x, weights.y, weights.z};
    }));
    return table;
}

} // namespace hs::exporting
