// What every traversal would spend on the triangle a step stands on, or on the whole frame.
#include "core/export/column.hpp"
#include "core/trace/comparison.hpp"

namespace hs::exporting {

Table traversal_table(const trace::Player& player) {
    const trace::Step& step = player.current();
    std::optional<trace::TriangleNumber> only;
    if (step.of_triangle()) {
        only = trace::TriangleNumber{step.object, step.triangle};
    }
    const auto costs = std::make_shared<const std::vector<trace::TraversalCost>>(
        trace::compare_traversals(player.recording().frame->shared_scene(), only)
    );
    Table table{.name = "traversals", .rows = costs->size(), .columns = {}};
    table.columns.push_back(named_column<scene::TraversalKind>(
        "traversal.name", [costs](std::size_t row) { return (*costs)[row].traversal; }
    ));
    const auto add = [&table, costs](const char* name, auto get) {
        table.columns.push_back(column<std::uint64_t>(
            std::string{"traversal."} + name,
            [costs, get](std::size_t row) -> std::uint64_t { return get((*costs)[row]); }
        ));
    };
    using trace::TraversalCost;
    add("fragments", [](const TraversalCost& t) { return t.fragments; });
    add("pixels_visited", [](const TraversalCost& t) { return t.cost.pixels; });
    add("tiles_visited", [](const TraversalCost& t) { return t.cost.tiles; });
    add("edge_evaluations", [](const TraversalCost& t) { return t.cost.evaluations; });
    add("multiplications", [](const TraversalCost& t) { return t.cost.multiplications(); });
    add("additions", [](const TraversalCost& t) { return t.cost.additions(); });
    add("divisions", [](const TraversalCost& t) { return t.cost.divisions; });
    return table;
}

} // namespace hs::exporting
