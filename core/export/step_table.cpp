// Every step with its address: what the playhead shows of where it stands.
#include "core/export/column.hpp"

namespace hs::exporting {
const trace::Step& StepAddresses::operator()(trace::StepId step) {
    const bool outlined =
        step >= recording_->first_triangle_step && step < recording_->first_resolve_step;
    if (!outlined) {
        alone_ = trace::describe_step(*recording_, step);
        return alone_;
    }
    if (stretch_.steps.empty() || step < stretch_.first_step ||
        step - stretch_.first_step >= stretch_.steps.size()) {
        stretch_ = trace::outline(*recording_, trace::index_entry_of_step(*recording_, step));
    }
    return stretch_.steps[step - stretch_.first_step];
}

Table step_table(const SharedRecording& recording, trace::StepId last) {
    Table table{.name = "steps", .rows = last + 1, .columns = {}};
    const auto addresses =
        std::make_shared<StepAddresses>(recording); // the columns go hand in hand
    const auto at = [addresses](std::size_t row) -> const trace::Step& {
        return (*addresses)(row);
    };
    std::vector<Column>& columns = table.columns;
    columns.push_back(named_column<trace::StepKind>("step.kind", [at](std::size_t row) {
        return at(row).kind;
    }));
    columns.push_back(named_column<trace::Stage>("step.stage", [at](std::size_t row) {
        return trace::stage_of(at(row).kind);
    }));
    columns.push_back(column<std::uint32_t>("step.object_index", [at](std::size_t row) {
        return at(row).object;
    }));
    columns.push_back(column<std::uint32_t>("step.vertex", [at](std::size_t row) {
        return at(row).vertex;
    }));
    columns.push_back(column<std::uint32_t>("step.triangle", [at](std::size_t row) {
        return at(row).triangle;
    }));
    columns.push_back(column<std::uint16_t, 2>("step.pixel", [at](std::size_t row) {
        const PixelPos pixel = at(row).pixel;
        return std::array{static_cast<std::uint16_t>(pixel.x), static_cast<std::uint16_t>(pixel.y)};
    }));
    columns.push_back(column<std::uint8_t>("step.covered", [at](std::size_t row) {
        return static_cast<std::uint8_t>(at(row).covered ? 1 : 0);
    }));
    columns.push_back(column<std::uint8_t>("step.passed", [at](std::size_t row) {
        return static_cast<std::uint8_t>(at(row).passed ? 1 : 0);
    }));
    return table;
}

} // namespace hs::exporting
