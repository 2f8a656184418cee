#include "core/explain/registers.hpp"

#include "core/raster/edge_steps.hpp"

#include <fmt/format.h>

namespace hs::explain {
namespace {

constexpr std::array edge_numbers{"01", "12", "20"};

/// The pixels that values are moved through, and the setup they are of.
struct Walk {
    const raster::TriangleSetup& setup;
    PixelRect box;
    bool serpentine = false;
};

std::optional<Walk>
walk_of(const trace::StepDetail& detail, const trace::Step& step, scene::TraversalKind traversal) {
    if (!step.has_pixel() || !detail.triangle) {
        return std::nullopt;
    }
    const auto& setup = detail.triangle->pieces[static_cast<std::size_t>(step.piece)].setup;
    if (!setup) {
        return std::nullopt; // a line, or across the eye
    }
    switch (traversal) {
    case scene::TraversalKind::incremental: return Walk{*setup, setup->bounds};
    case scene::TraversalKind::serpentine: return Walk{*setup, setup->bounds, true};
    case scene::TraversalKind::hierarchical:
        if (detail.traversal && detail.traversal->tile) {
            return Walk{*setup, detail.traversal->tile->pixels};
        }
        return std::nullopt;
    case scene::TraversalKind::brute_force: // these evaluate at every pixel, or at every span
    case scene::TraversalKind::bounding_box:
    case scene::TraversalKind::edge_walk:
    case scene::TraversalKind::edge_table:
    case scene::TraversalKind::homogeneous: return std::nullopt;
    }
    HS_CHECK(false, "every traversal is handled");
}

/// One step back along the walk.
void trace_back(Registers& registers, const Walk& walk) {
    const PixelPos p = registers.pixel;
    const bool leftward = walk.serpentine && (p.y - walk.box.y0) % 2 != 0;
    const int row_begin = leftward ? walk.box.x1 - 1 : walk.box.x0;
    if (p.x != row_begin) {
        registers.from = {p.x + (leftward ? 1 : -1), p.y};
        registers.move = leftward ? RegisterMove::left : RegisterMove::right;
    } else if (p.y != walk.box.y0) {
        registers.from = {p.x, p.y - 1};
        registers.move = walk.serpentine ? RegisterMove::down : RegisterMove::next_row;
    } else {
        registers.from = p;
    }
}

} // namespace

std::optional<Registers> registers_at(
    const trace::StepDetail& detail, const trace::Step& step, scene::TraversalKind traversal
) {
    const std::optional<Walk> walk = walk_of(detail, step, traversal);
    if (!walk) {
        return std::nullopt;
    }
    Registers registers;
    registers.pixel = step.pixel;
    registers.keeps_rows = !walk->serpentine;
    trace_back(registers, *walk);
    const raster::EdgeSteps steps = raster::edge_steps(walk->setup);
    const raster::EdgeValues row = walk->setup.evaluate({walk->box.x0, step.pixel.y});
    const raster::EdgeValues before = walk->setup.evaluate(registers.from);
    const raster::EdgeValues now = walk->setup.evaluate(step.pixel);
    for (unsigned k = 0; k < 3; ++k) {
        registers.edges[k] = {row[k], before[k], now[k], steps.right[k], steps.down[k]};
    }
    return registers;
}

std::string addition(const Registers& registers, unsigned k) {
    const char* const edge = edge_numbers[k];
    switch (registers.move) {
    case RegisterMove::evaluated: break;
    case RegisterMove::right: return fmt::format("E{} + a{}", edge, edge);
    case RegisterMove::left: return fmt::format("E{} − a{}", edge, edge);
    case RegisterMove::down: return fmt::format("E{} + b{}", edge, edge);
    case RegisterMove::next_row: return fmt::format("row{} + b{}", edge, edge);
    }
    HS_CHECK(false, "what was evaluated is no sum");
    return "";
}

} // namespace hs::explain
