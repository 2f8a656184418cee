#include "core/explain/registers.hpp"

#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/made_scene.hpp"

#include <map>
#include <optional>

using namespace hs;
using explain::RegisterMove;
using explain::Registers;
using trace::StepKind;

namespace {

std::shared_ptr<const trace::Recording> recorded(scene::TraversalKind kind) {
    auto scene = tests::clip_space_scene(
        {{-0.9F, -0.7F, 0.0F, 1.0F}, {0.8F, -0.9F, 0.0F, 1.0F}, {0.3F, 0.95F, 0.0F, 1.0F}}, 16, 16
    );
    scene->settings.traversal = kind;
    return trace::record(scene).value();
}

std::optional<Registers> registers_at(const trace::Player& player) {
    return explain::registers_at(
        player.detail(), player.current(), player.recording().settings().traversal
    );
}

std::int64_t added(const Registers& registers, unsigned k) {
    const explain::EdgeRegisters& edge = registers.edges[k];
    switch (registers.move) {
    case RegisterMove::evaluated: return 0;
    case RegisterMove::right: return edge.a;
    case RegisterMove::left: return -edge.a;
    case RegisterMove::down:
    case RegisterMove::next_row: return edge.b;
    }
    return 0;
}

} // namespace

TEST_CASE("one addition leads from pixel to pixel, as the traversal went", "[explain][traversal]") {
    for (const scene::TraversalKind kind :
         {scene::TraversalKind::incremental, scene::TraversalKind::serpentine}) {
        const auto recording = recorded(kind);
        trace::Player player(recording);
        std::map<PixelPos, raster::EdgeValues> told; // by the steps before
        std::optional<PixelPos> last;
        std::map<RegisterMove, int> moves;
        for (trace::StepId id = recording->first_triangle_step; id < recording->end_step; ++id) {
            player.seek(id);
            const trace::Step& step = player.current();
            if (step.kind != StepKind::edge_test) {
                continue;
            }
            const auto registers = registers_at(player);
            REQUIRE(registers);
            ++moves[registers->move];
            CHECK((registers->move == RegisterMove::evaluated) == !last.has_value());
            if (last && registers->move != RegisterMove::next_row) {
                CHECK(registers->from == *last);
            }
            const raster::EdgeValues& edges = player.detail().visit->edges;
            for (unsigned k = 0; k < 3; ++k) {
                const explain::EdgeRegisters& edge = registers->edges[k];
                CHECK(edge.now == edges[k]);
                CHECK(edge.now == edge.before + added(*registers, k));
                CHECK((!last || edge.before == told.at(registers->from)[k]));
            }
            told[step.pixel] = edges;
            last = step.pixel;
        }
        const bool zigzag = kind == scene::TraversalKind::serpentine;
        CHECK(moves[RegisterMove::right] > 20);
        CHECK((moves[RegisterMove::left] > 20) == zigzag);
        CHECK((moves[RegisterMove::down] > 5) == zigzag);
        CHECK((moves[RegisterMove::next_row] > 5) == !zigzag);
    }
}

TEST_CASE("within a tile, registers start from its first corner", "[explain][traversal]") {
    const auto recording = recorded(scene::TraversalKind::hierarchical);
    trace::Player player(recording);
    int evaluated = 0;
    int moved = 0;
    for (trace::StepId id = recording->first_triangle_step; id < recording->end_step; ++id) {
        player.seek(id);
        const auto registers = registers_at(player);
        CHECK(registers.has_value() == player.current().has_pixel());
        if (!registers) {
            continue;
        }
        const raster::TileTest& tile = *player.detail().traversal->tile;
        CHECK(tile.pixels.contains(registers->from));
        if (registers->move == RegisterMove::evaluated) {
            ++evaluated;
            for (unsigned k = 0; k < 3; ++k) {
                CHECK(registers->edges[k].now == tile.corners[0][k]);
            }
        } else {
            ++moved;
        }
    }
    CHECK(evaluated > 0);
    CHECK(moved > evaluated);
}

TEST_CASE("what evaluates at every pixel keeps no registers", "[explain][traversal]") {
    for (const scene::TraversalKind kind :
         {scene::TraversalKind::bounding_box, scene::TraversalKind::edge_walk}) {
        const auto recording = recorded(kind);
        trace::Player player(recording);
        player.seek(recording->end_step - 1);
        CHECK_FALSE(registers_at(player));
    }
}
