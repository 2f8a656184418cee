#include "core/trace/step.hpp"

#include <fmt/format.h>

namespace hs {

template <>
std::span<const Named<trace::StepKind>> names<trace::StepKind>() {
    using trace::StepKind;
    static constexpr std::array<Named<StepKind>, 29> table{{
        {StepKind::start, "start", "the framebuffer is cleared"},
        {StepKind::vertex_world, "world", "the model matrix takes the vertex to world space"},
        {StepKind::vertex_eye, "eye", "the view matrix takes the vertex to eye space"},
        {StepKind::vertex_clip,
         "clip space",
         "the projection matrix takes the vertex to clip space"},
        {StepKind::vertex_light, "light", "the vertex is lit"},
        {StepKind::order, "order", "an ordering algorithm decides something about two polygons"},
        {StepKind::sweep, "sweep", "a scanline or a ray decides what is visible"},
        {StepKind::outcodes, "outcodes", "each vertex is held against every clip plane"},
        {StepKind::clip_plane, "clip", "the polygon is cut by one plane"},
        {StepKind::divide, "divide", "clip coordinates are divided by w"},
        {StepKind::viewport, "viewport", "NDC become pixels, snapped to 1/256"},
        {StepKind::facing, "cull", "the sign of the snapped area decides which side is seen"},
        {StepKind::setup, "setup", "the three edge functions, or a line's walk, are set up"},
        {StepKind::edge_table,
         "edge table",
         "edges are sorted into buckets by their first scanline"},
        {StepKind::tile_test, "tile test", "a tile's corners are held against the three edges"},
        {StepKind::active_edges,
         "active edges",
         "the edges that cross the scanline are brought up to date"},
        {StepKind::span, "span", "the pixels between the left and the right edge are found"},
        {StepKind::edge_test, "edge test", "the pixel center is held against the three edges"},
        {StepKind::sample_test,
         "sample test",
         "one of the pixel's samples is held against the three edges"},
        {StepKind::plane_test,
         "plane test",
         "the pixel center is held against the planes through eye and edges"},
        {StepKind::line_step, "line step", "the walk along a line decides which pixel comes next"},
        {StepKind::interpolate, "interpolate", "depth and varyings are interpolated at the pixel"},
        {StepKind::shade, "shade", "the fragment gets its color"},
        {StepKind::scissor_test, "scissor test", "the pixel is held against the scissor rectangle"},
        {StepKind::closed_test,
         "closed test",
         "front to back, a pixel takes only the first fragment that is written"},
        {StepKind::depth_test,
         "depth test",
         "the fragment's depth is compared with the stored one"},
        {StepKind::merge, "merge", "the fragment changes the pixel"},
        {StepKind::resolve, "resolve", "the samples of a pixel are averaged to its color"},
        {StepKind::end, "end", "the frame is finished"},
    }};
    return table;
}

template <>
std::span<const Named<trace::Stage>> names<trace::Stage>() {
    using trace::Stage;
    static constexpr std::array<Named<Stage>, trace::stage_count> table{{
        {Stage::application, "application", "the scene is handed over and the framebuffer cleared"},
        {Stage::vertex, "vertex", "every vertex goes from object space to clip space"},
        {Stage::visibility,
         "visibility",
         "triangles are put in order, or pixels find the nearest of them"},
        {Stage::clip, "clip", "triangles are cut at the view volume"},
        {Stage::divide, "divide", "clip coordinates are divided by w"},
        {Stage::viewport, "viewport", "NDC become snapped window coordinates"},
        {Stage::cull, "cull", "faces turned the wrong way are dropped"},
        {Stage::setup, "setup", "edge functions are prepared"},
        {Stage::traverse, "traverse", "pixels are asked whether they are covered"},
        {Stage::shade, "shade", "fragments get their color"},
        {Stage::test, "test", "scissor, closed and depth tests decide each fragment's fate"},
        {Stage::merge, "merge", "surviving fragments change their pixel"},
    }};
    return table;
}

template <>
std::span<const Named<trace::Granularity>> names<trace::Granularity>() {
    using trace::Granularity;
    static constexpr std::array<Named<Granularity>, 6> table{{
        {Granularity::stage,
         "stage",
         "all vertices, then their order, then all triangles, then all scanlines or rays"},
        {Granularity::object, "object", "one object's vertices, or its triangles"},
        {Granularity::triangle,
         "triangle",
         "one triangle (in the vertex stage: one vertex; in ordering: the next in the order; with "
         "scanlines or rays: one row)"},
        {Granularity::scanline,
         "scanline",
         "one row of a triangle's traversal, or one tile (in ordering: one iteration)"},
        {Granularity::fragment,
         "fragment",
         "one fragment from interpolation to its fate (with rays: one pixel)"},
        {Granularity::operation, "operation", "one step"},
    }};
    return table;
}

} // namespace hs

namespace hs::trace {

Stage stage_of(StepKind kind) {
    switch (kind) {
    case StepKind::start: return Stage::application;
    case StepKind::vertex_world:
    case StepKind::vertex_eye:
    case StepKind::vertex_clip:
    case StepKind::vertex_light: return Stage::vertex;
    case StepKind::order:
    case StepKind::sweep: return Stage::visibility;
    case StepKind::outcodes:
    case StepKind::clip_plane: return Stage::clip;
    case StepKind::divide: return Stage::divide;
    case StepKind::viewport: return Stage::viewport;
    case StepKind::facing: return Stage::cull;
    case StepKind::setup: return Stage::setup;
    case StepKind::edge_table:
    case StepKind::tile_test:
    case StepKind::active_edges:
    case StepKind::span:
    case StepKind::edge_test:
    case StepKind::sample_test:
    case StepKind::plane_test:
    case StepKind::line_step:
    case StepKind::interpolate: return Stage::traverse;
    case StepKind::shade: return Stage::shade;
    case StepKind::scissor_test:
    case StepKind::closed_test:
    case StepKind::depth_test: return Stage::test;
    case StepKind::merge:
    case StepKind::resolve:
    case StepKind::end: return Stage::merge;
    }
    HS_CHECK(false, "every step kind has a stage");
    return Stage::application;
}

std::string primitive_name(const Step& step) {
    const bool triangle = step.primitive == scene::PrimitiveKind::triangle;
    return fmt::format("{} {}", name_of(step.primitive), triangle ? step.triangle : step.number);
}

namespace {

/// "scanline 12 / edge 3", "scanline 12 / object 0 / triangle 3 / pixel 31,12 / depth",
/// "pixel 31,12 / object 0 / triangle 3 / meeting".
std::string sweep_path(const Step& step) {
    const bool ray = step.sweep >= visibility::SweepEventKind::cast;
    const std::string pixel = fmt::format("pixel {},{}", step.pixel.x, step.pixel.y);
    std::string path = ray ? pixel : fmt::format("scanline {}", step.pixel.y);
    const bool by_triangle = step.of_polygon && step.sweep >= visibility::SweepEventKind::clear;
    if (by_triangle) {
        path += fmt::format(" / object {} / triangle {}", step.object, step.triangle);
        path += step.clipped ? fmt::format(" piece {}", step.piece) : std::string{};
    }
    path += step.sweep == visibility::SweepEventKind::depth ? " / " + pixel : std::string{};
    path += fmt::format(" / {}", name_of(step.sweep));
    const bool alone = by_triangle || ray || step.sweep == visibility::SweepEventKind::clear ||
                       step.sweep == visibility::SweepEventKind::active_edges;
    return alone ? path : path + fmt::format(" {}", step.ordinal);
}

} // namespace

std::string step_path(const Step& step) {
    const std::string_view operation = name_of(step.kind);
    if (step.kind == StepKind::start || step.kind == StepKind::end) {
        return std::string{operation};
    }
    if (step.kind == StepKind::resolve) {
        return fmt::format("{} / pixel {},{}", operation, step.pixel.x, step.pixel.y);
    }
    if (step.in_vertex_stage()) {
        return fmt::format(
            "vertex stage / object {} / vertex {} / {}", step.object, step.vertex, operation
        );
    }
    if (step.kind == StepKind::order) {
        return fmt::format("visibility / {} {}", name_of(step.decision), step.ordinal);
    }

    if (step.kind == StepKind::sweep) {
        return sweep_path(step);
    }

    std::string path = fmt::format("object {} / {}", step.object, primitive_name(step));
    if (step.of_triangle() && (step.part || (step.clipped && step.has_piece()))) {
        path += fmt::format(" piece {}", step.piece);
    }
    if (step.kind == StepKind::clip_plane) {
        return path + fmt::format(" / clip / plane {}", name_of(step.plane));
    }
    if (step.kind == StepKind::edge_test || step.kind == StepKind::plane_test ||
        step.kind == StepKind::line_step) {
        return path + fmt::format(" / pixel {},{}", step.pixel.x, step.pixel.y);
    }
    if (step.kind == StepKind::sample_test) {
        return path +
               fmt::format(" / pixel {},{} / sample {}", step.pixel.x, step.pixel.y, step.sample);
    }
    if (step.kind == StepKind::tile_test) {
        return path +
               fmt::format(" / tile {},{} size {}", step.pixel.x, step.pixel.y, step.tile_size);
    }
    if (step.of_scanline()) {
        path += fmt::format(" / scanline {}", step.pixel.y);
    }
    if (step.in_fragment()) {
        path += fmt::format(" / fragment {},{}", step.pixel.x, step.pixel.y);
    }
    if (step.sample >= 0) {
        path += fmt::format(" / sample {}", step.sample);
    }
    return path + fmt::format(" / {}", operation);
}

} // namespace hs::trace
