#include "tests/support/recorded_values.hpp"

#include "core/trace/player.hpp"
#include "core/trace/sweep_detail.hpp"

#include <fmt/format.h>

namespace hs::tests {
namespace {

using trace::StepKind;
using Values = std::vector<std::pair<std::string, explain::Number>>;

constexpr std::array axes{"x", "y", "z", "w"};
constexpr std::array channels{"r", "g", "b", "a"};
constexpr std::array edges{"E01", "E12", "E20"};

void add(Values& list, const std::string& prefix, const glm::vec4& v, const auto& parts) {
    for (int k = 0; k < 4; ++k) {
        list.emplace_back(prefix + parts[static_cast<std::size_t>(k)], v[k]);
    }
}

void add_vertex(Values& list, const trace::Step& step, const pipeline::VertexWork& work) {
    if (step.kind == StepKind::vertex_world) {
        add(list, "world.", math::to_vec4(work.world), axes);
    } else if (step.kind == StepKind::vertex_eye) {
        add(list, "eye.", math::to_vec4(work.eye), axes);
    } else if (step.kind == StepKind::vertex_clip) {
        add(list, "clip.", math::to_vec4(work.clip), axes);
    } else {
        add(list, "color.", work.varyings.color(), channels);
    }
}

/// An edge that begins has a place, a question an answer, everything else a number.
void add_sweep(Values& list, const visibility::SweepEvent& event) {
    using enum visibility::SweepEventKind;
    if (event.kind == edge_in) {
        list.emplace_back("x", event.x);
        return;
    }
    list.emplace_back("value", event.value);
    list.emplace_back("verdict", event.verdict);
    if (event.kind == compare || event.kind == depth || event.kind == keep) {
        list.emplace_back("other value", event.other_value);
    }
}

void add_outcodes(
    Values& list,
    const trace::Recording& recording,
    const trace::Step& step,
    const trace::TriangleDetail& triangle
) {
    const int corners = step.primitive == scene::PrimitiveKind::triangle ? 3 : 2;
    const geometry::ClipVolume& volume = recording.frame->calls()[step.object].volume;
    const std::uint32_t draw = recording.draw_of_step(step.id);
    const bool whole = recording.order.draws[draw].part < 0;
    for (int corner = 0; whole && corner < corners; ++corner) {
        for (int k = 0; k < volume.count; ++k) {
            list.emplace_back(
                fmt::format("v{}.{}", corner, name_of(static_cast<geometry::ClipPlane>(k))),
                math::signed_distance(
                    volume.planes[static_cast<unsigned>(k)],
                    math::to_vec4(triangle.corners[static_cast<unsigned>(corner)].work.clip)
                )
            );
        }
    }
}

/// The vertices that the pass made, in the order it made them.
void add_clip(
    Values& list,
    const trace::Recording& recording,
    const trace::Step& step,
    const trace::TriangleDetail& triangle
) {
    const pipeline::DrawCall& call = recording.frame->calls()[step.object];
    for (const trace::ClipPass& pass : triangle.passes) {
        if (pass.plane != step.plane) {
            continue;
        }
        const math::HalfSpace& plane = call.volume.planes[static_cast<std::size_t>(step.plane)];
        std::vector<bool> inside;
        for (int i = 0; i < pass.before.count; ++i) {
            const float d = math::signed_distance(plane, math::to_vec4(pass.before[i].position));
            list.emplace_back(fmt::format("d{}", i), d);
            inside.push_back(math::inside(d));
        }
        int made = 0;
        int at = 0;
        const auto is_cut = [&] {
            const std::string name = fmt::format("cut {}.", made++);
            const geometry::ClipVertex& vertex = pass.after[at++];
            add(list, name, math::to_vec4(vertex.position), axes);
            add(list, name + "color.", vertex.varyings.color(), channels);
        };
        const bool segment = pass.before.count == 2;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            const bool there = inside[i == 0 ? inside.size() - 1 : i - 1];
            if (inside[i] != there && !(segment && inside[i])) {
                is_cut();
            }
            at += inside[i] ? 1 : 0;
        }
    }
}

unsigned corner_count(const trace::Step& step) {
    return step.primitive == scene::PrimitiveKind::triangle ? 3
           : step.primitive == scene::PrimitiveKind::line   ? 2
                                                            : 1;
}

void add_window(Values& list, const trace::Step& step, const trace::PieceDetail& piece) {
    for (unsigned k = 0; k < corner_count(step); ++k) {
        const geometry::WindowVertex& v = piece.window[k];
        const std::string who = fmt::format("v{}.", k);
        if (step.kind == StepKind::divide) {
            list.emplace_back(who + "inv_w", v.inv_w);
            if (v.status != geometry::WindowStatus::at_eye) {
                list.emplace_back(who + "ndc.x", v.ndc.x);
                list.emplace_back(who + "ndc.y", v.ndc.y);
                list.emplace_back(who + "ndc.z", v.ndc.z);
            }
            continue;
        }
        list.emplace_back(who + "window.x", v.window.x);
        list.emplace_back(who + "window.y", v.window.y);
        list.emplace_back(who + "window.depth", v.window.depth);
        if (v.status == geometry::WindowStatus::placed) {
            list.emplace_back(who + "fixed.x", std::int64_t{v.fixed.x});
            list.emplace_back(who + "fixed.y", std::int64_t{v.fixed.y});
        }
    }
}

void add_function(Values& list, const std::string& name, const raster::PixelFunction& f) {
    list.emplace_back(name + ".a", f.a);
    list.emplace_back(name + ".b", f.b);
    list.emplace_back(name + ".c", f.c);
}

std::string rho_name(unsigned edge) {
    return fmt::format("ρ{}", (edge + 2) % 3);
}

std::string clip_name(const raster::PixelClip& clip) {
    return std::string{name_of(static_cast<geometry::ClipPlane>(clip.plane))};
}

void add_setup(Values& list, const trace::Step& step, const trace::PieceDetail& piece) {
    if (piece.setup) {
        for (unsigned k = 0; k < 3; ++k) {
            const raster::EdgeFunction& e = piece.setup->edges[k];
            list.emplace_back(fmt::format("{}.a", edges[k]), e.a);
            list.emplace_back(fmt::format("{}.b", edges[k]), e.b);
            list.emplace_back(fmt::format("{}.c", edges[k]), e.c);
        }
        list.emplace_back("2A", piece.setup->doubled_area);
        list.emplace_back("1/2A", piece.setup->inv_doubled_area);
    }
    if (piece.planes) {
        for (unsigned k = 0; k < 3; ++k) {
            add_function(list, rho_name(k), piece.planes->edges[k].rho);
        }
        for (unsigned i = 0; i < static_cast<unsigned>(piece.planes->clip_count); ++i) {
            add_function(list, clip_name(piece.planes->clips[i]), piece.planes->clips[i].distance);
        }
    }
    if (piece.line) {
        list.emplace_back("first x", std::int64_t{piece.line->first.x});
        list.emplace_back("first y", std::int64_t{piece.line->first.y});
        if (step.primitive == scene::PrimitiveKind::line) {
            list.emplace_back("n", std::int64_t{piece.line->steps});
            list.emplace_back("m", std::int64_t{piece.line->rise});
        }
    }
}

void add_planes(Values& list, const trace::PieceDetail& piece, const raster::PlaneTest& test) {
    for (unsigned k = 0; k < 3; ++k) {
        list.emplace_back(rho_name(k), test.edges[k]);
    }
    list.emplace_back("1/w", test.inv_w);
    for (unsigned i = 0; i < static_cast<unsigned>(piece.planes->clip_count); ++i) {
        list.emplace_back(clip_name(piece.planes->clips[i]), test.clips[i]);
    }
}

void add_crossings(Values& list, const auto& table) {
    for (int i = 0; i < table.count; ++i) {
        const raster::ScanEdge& edge = table.edges[static_cast<unsigned>(i)];
        list.emplace_back(
            fmt::format("{}.x", edges[static_cast<unsigned>(edge.edge)]), std::int64_t{edge.x}
        );
    }
}

void add_line_step(
    Values& list,
    const trace::Recording& recording,
    const trace::Step& step,
    const trace::StepDetail& detail
) {
    const raster::LineStep& line = *detail.traversal->line;
    const scene::Settings& settings = recording.frame->calls()[step.object].settings;
    if (step.primitive == scene::PrimitiveKind::point) {
        list.emplace_back("x", std::int64_t{line.pixel.x});
        list.emplace_back("y", std::int64_t{line.pixel.y});
        return;
    }
    if (settings.line_algorithm == scene::LineAlgorithm::dda) {
        const bool steep = detail.triangle->pieces[0].line->steep;
        list.emplace_back(steep ? "x" : "y", static_cast<float>(line.after));
        list.emplace_back("across", std::int64_t{steep ? line.pixel.x : line.pixel.y});
        return;
    }
    list.emplace_back("e", static_cast<std::int64_t>(line.before));
    list.emplace_back("next e", static_cast<std::int64_t>(line.after));
    if (line.number > 0) {
        list.emplace_back("moves across", line.moved);
    }
}

void add_traversal(
    Values& list,
    const trace::Recording& recording,
    const trace::Step& step,
    const trace::StepDetail& detail
) {
    const trace::TraversalDetail& traversal = *detail.traversal;
    if (step.kind == StepKind::edge_table) {
        add_crossings(list, *traversal.edge_table);
    } else if (step.kind == StepKind::active_edges) {
        add_crossings(list, *traversal.active);
    } else if (step.kind == StepKind::span) {
        list.emplace_back("first", std::int64_t{traversal.span->first});
        list.emplace_back("end", std::int64_t{traversal.span->end});
    } else if (step.kind == StepKind::tile_test) {
        constexpr std::array corners{"top left", "top right", "bottom left", "bottom right"};
        for (unsigned i = 0; i < 4; ++i) {
            for (unsigned k = 0; k < 3; ++k) {
                list.emplace_back(
                    fmt::format("{} {}", corners[i], edges[k]), traversal.tile->corners[i][k]
                );
            }
        }
    } else if (step.kind == StepKind::line_step) {
        add_line_step(list, recording, step, detail);
    }
}

void add_visit(Values& list, const trace::Step& step, const trace::StepDetail& detail) {
    const bool sampled = step.kind == StepKind::sample_test;
    const raster::EdgeValues& values =
        sampled ? detail.samples[static_cast<std::size_t>(step.sample)].edges : detail.visit->edges;
    for (unsigned k = 0; k < 3; ++k) {
        list.emplace_back(edges[k], values[k]);
    }
    list.emplace_back("covered", step.covered);
}

void add_interpolation(Values& list, const trace::FragmentDetail& fragment) {
    for (unsigned k = 0; k < 3; ++k) {
        list.emplace_back(fmt::format("λ{}", k), fragment.fragment.barycentric[k]);
        list.emplace_back(fmt::format("b{}", k), fragment.fragment.barycentric_clip[k]);
    }
    list.emplace_back("depth", fragment.fragment.depth);
    add(list, "color.", fragment.fragment.varyings.color(), channels);
}

/// The facts: what the log says the pixel is after the step's fragment.
void add_merge(Values& list, const trace::Recording& recording, const trace::Step& step) {
    const trace::FragmentRecord& record = recording.fragments[step.fragment];
    if (recording.samples.active()) {
        const framebuffer::PixelSamples after = recording.samples.after(step.fragment);
        for (int s = 0; s < after.count; ++s) {
            if (raster::has_sample(record.passed, s)) {
                add(list, fmt::format("sample {} color.", s), after[s].color, channels);
            }
        }
        return;
    }
    const glm::vec4 color = recording.float_color() ? recording.color32f[step.fragment]
                                                    : framebuffer::unpack(record.color);
    add(list, "pixel color.", color, channels);
    if (record.depth_written) {
        list.emplace_back("pixel depth", record.depth);
    }
    list.emplace_back(
        "pixel owner", std::int64_t{recording.run_of_fragment(step.fragment).triangle}
    );
}

void add_fragment(
    Values& list,
    const trace::Recording& recording,
    const trace::Step& step,
    const trace::FragmentDetail& fragment
) {
    if (step.kind == StepKind::interpolate) {
        add_interpolation(list, fragment);
    } else if (step.kind == StepKind::shade) {
        add(list, "color.", fragment.shaded->color, channels);
    } else if (step.kind == StepKind::merge) {
        add_merge(list, recording, step);
    } else {
        list.emplace_back("passes", step.passed);
    }
    if (step.kind == StepKind::depth_test) {
        list.emplace_back("fragment depth", fragment.depth_test->depth);
        list.emplace_back("stored depth", fragment.depth_test->stored);
    }
}

void add_pixel(Values& list, const trace::Recording& recording, const trace::Step& step) {
    // Not owned: it outlives the player
    trace::Player player({std::shared_ptr<void>{}, &recording});
    player.seek(step.id);
    const PixelPos p = step.kind == StepKind::start ? PixelPos{0, 0} : step.pixel;
    add(list, "pixel color.", player.color(p), channels);
    list.emplace_back("pixel depth", player.pixel(p).depth);
}

} // namespace

Values recorded_values(const trace::Recording& recording, const trace::Step& step) {
    Values list;
    const trace::StepDetail detail = trace::step_detail(recording, step);
    const trace::PieceDetail* piece = nullptr;
    if (step.has_piece() && step.kind >= StepKind::divide) {
        piece = &detail.triangle->pieces[static_cast<std::size_t>(step.piece)];
    }
    if (step.in_vertex_stage()) {
        add_vertex(list, step, detail.vertex->work);
    } else if (step.kind == StepKind::start || step.kind == StepKind::resolve) {
        add_pixel(list, recording, step);
    } else if (step.kind == StepKind::order) {
        const visibility::OrderEvent& event = recording.decisions[step.event];
        list.emplace_back("value", event.value);
    } else if (step.kind == StepKind::sweep) {
        add_sweep(list, trace::sweep_detail(recording, step).last());
    } else if (step.kind == StepKind::outcodes) {
        add_outcodes(list, recording, step, *detail.triangle);
    } else if (step.kind == StepKind::clip_plane) {
        add_clip(list, recording, step, *detail.triangle);
    } else if (step.kind == StepKind::divide || step.kind == StepKind::viewport) {
        add_window(list, step, *piece);
    } else if (step.kind == StepKind::facing && piece->determinant) {
        list.emplace_back("determinant", *piece->determinant);
    } else if (step.kind == StepKind::facing) {
        list.emplace_back("signed doubled area", piece->signed_doubled_area);
    } else if (step.kind == StepKind::setup) {
        add_setup(list, step, *piece);
    } else if (step.kind == StepKind::plane_test) {
        add_planes(list, *piece, *detail.traversal->planes);
    } else if (step.kind == StepKind::edge_test || step.kind == StepKind::sample_test) {
        add_visit(list, step, detail);
    } else if (step.in_fragment()) {
        add_fragment(list, recording, step, *detail.fragment);
    } else if (step.kind != StepKind::end) {
        add_traversal(list, recording, step, detail);
    }
    return list;
}

} // namespace hs::tests
