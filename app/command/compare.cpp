// `halfspace compare`: what every traversal spends on a scene, or on one triangle of it.
#include "app/command/command.hpp"
#include "core/trace/comparison.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
};

double per_fragment(std::uint64_t count, const trace::TraversalCost& row) {
    return row.fragments == 0 ? 0.0
                              : static_cast<double>(count) / static_cast<double>(row.fragments);
}

std::string as_table(const std::vector<trace::TraversalCost>& rows) {
    std::string text = fmt::format(
        "{:<14}{:>12}{:>12}{:>10}{:>14}{:>16}{:>12}{:>11}{:>14}\n",
        "traversal",
        "fragments",
        "pixels",
        "tiles",
        "evaluations",
        "multiplications",
        "additions",
        "divisions",
        "pixels/frag."
    );
    for (const trace::TraversalCost& row : rows) {
        text += fmt::format(
            "{:<14}{:>12}{:>12}{:>10}{:>14}{:>16}{:>12}{:>11}{:>14.2f}\n",
            name_of(row.traversal),
            row.fragments,
            row.cost.pixels,
            row.cost.tiles,
            row.cost.evaluations,
            row.cost.multiplications(),
            row.cost.additions(),
            row.cost.divisions,
            per_fragment(row.cost.pixels, row)
        );
    }
    return text;
}

std::string as_json(const std::vector<trace::TraversalCost>& rows) {
    auto document = nlohmann::ordered_json::array();
    for (const trace::TraversalCost& row : rows) {
        document.push_back(
            {{"traversal", name_of(row.traversal)},
             {"fragments", row.fragments},
             {"pixels_visited", row.cost.pixels},
             {"tiles_visited", row.cost.tiles},
             {"edge_evaluations", row.cost.evaluations},
             {"multiplications", row.cost.multiplications()},
             {"additions", row.cost.additions()},
             {"divisions", row.cost.divisions},
             {"pixels_per_fragment", per_fragment(row.cost.pixels, row)},
             {"tiles_per_fragment", per_fragment(row.cost.tiles, row)}}
        );
    }
    return document.dump() + '\n';
}

int run_compare(const Options& options, const Common& common) {
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    const trace::Step& step = (*player)->current();
    std::optional<trace::TriangleNumber> only;
    if (step.in_triangle()) {
        only = trace::TriangleNumber{step.object, step.triangle};
    }
    const auto rows = trace::compare_traversals((*recording)->frame->shared_scene(), only);
    return print(common.json ? as_json(rows) : as_table(rows));
}

} // namespace

Command add_compare(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app =
        program.add_subcommand("compare", "Compare what every traversal spends on a scene");
    app->footer("Example:\n  halfspace compare scene.toml --at 'object 0 / triangle 12'");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--at", options->at, "only the triangle of this step");
    return {app, [options, &common] { return run_compare(*options, common); }, true};
}

} // namespace hs::command
