// `halfspace compare`: what every traversal spends on a scene, or on one triangle of it; or what
// every visible-surface algorithm makes of the scene.
#include "app/command/command.hpp"
#include "core/trace/comparison.hpp"
#include "core/trace/visibility_growth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string at;
    bool visibility = false;
    bool growth = false;
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

/// "triangle 3 at (31, 17), the z-buffer triangle 5"; empty where the pictures agree.
std::string first_difference(const trace::VisibilityOutcome& row) {
    if (!row.from_z_buffer.first) {
        return "";
    }
    const auto name = [](std::uint32_t triangle) {
        return triangle == trace::no_triangle ? std::string{"background"}
                                              : fmt::format("triangle {}", triangle);
    };
    const PixelPos p = *row.from_z_buffer.first;
    return fmt::format(
        "({}, {}) shows {}, should show {}", p.x, p.y, name(row.shown), name(row.nearest)
    );
}

std::string as_table(const std::vector<trace::VisibilityOutcome>& rows) {
    std::string text = fmt::format(
        "{:<15}{:>12}{:>12}{:>9}{:>12}{:>12}{:>17}  first such pixel\n",
        "visibility",
        "decisions",
        "questions",
        "cuts",
        "fragments",
        "written",
        "unlike z-buffer"
    );
    for (const trace::VisibilityOutcome& row : rows) {
        if (!row.refusal.empty()) {
            text += fmt::format("{:<15}{}\n", name_of(row.visibility), row.refusal);
            continue;
        }
        std::string line = fmt::format(
            "{:<15}{:>12}{:>12}{:>9}{:>12}{:>12}{:>17}  {}",
            name_of(row.visibility),
            row.decision_count,
            row.questions,
            row.cuts,
            row.fragments,
            row.written,
            row.from_z_buffer.pixels,
            first_difference(row)
        );
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

template <typename Kind, typename Counts>
void add_counts(nlohmann::ordered_json& object, const Counts& counts) {
    for (const Named<Kind>& kind : names<Kind>()) {
        if (const std::uint64_t count = counts[static_cast<std::size_t>(kind.value)]; count > 0) {
            object[std::string{kind.name}] = count;
        }
    }
}

nlohmann::ordered_json decisions_json(const trace::VisibilityOutcome& row) {
    nlohmann::ordered_json decisions = nlohmann::ordered_json::object();
    add_counts<visibility::OrderEventKind>(decisions, row.decisions);
    add_counts<visibility::SweepEventKind>(decisions, row.sweeps);
    return decisions;
}

std::string as_json(const std::vector<trace::VisibilityOutcome>& rows) {
    auto document = nlohmann::ordered_json::array();
    for (const trace::VisibilityOutcome& row : rows) {
        nlohmann::ordered_json entry{{"visibility", name_of(row.visibility)}};
        if (!row.refusal.empty()) {
            entry["refusal"] = row.refusal;
            document.push_back(entry);
            continue;
        }
        entry["decisions"] = decisions_json(row);
        entry["questions"] = row.questions;
        entry["cuts"] = row.cuts;
        entry["parts"] = row.parts;
        entry["fragments"] = row.fragments;
        entry["written"] = row.written;
        entry["pixels_unlike_z_buffer"] = row.from_z_buffer.pixels;
        if (const auto& first = row.from_z_buffer.first) {
            // Triangles over the whole frame, −1 the background
            entry["first_pixel"] = {first->x, first->y};
            entry["shown"] = static_cast<std::int32_t>(row.shown);
            entry["nearest"] = static_cast<std::int32_t>(row.nearest);
        }
        document.push_back(entry);
    }
    return document.dump() + '\n';
}

int run_visibility(const Options& options, const Common& common) {
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto rows = trace::compare_visibility((*recording)->scene());
    return print(common.json ? as_json(rows) : as_table(rows));
}

/// A column for every number of triangles, a row for every algorithm; "–" where it was refused.
std::string as_table(const std::vector<trace::GrowthPoint>& points) {
    std::string text = fmt::format("{:<15}", "triangles");
    for (const trace::GrowthPoint& point : points) {
        text += fmt::format("{:>12}", point.triangles);
    }
    text += '\n';
    for (const Named<scene::Visibility>& kind : names<scene::Visibility>()) {
        text += fmt::format("{:<15}", kind.name);
        for (const trace::GrowthPoint& point : points) {
            const auto& outcome = point.outcomes[static_cast<std::size_t>(kind.value)];
            text += outcome.refusal.empty() ? fmt::format("{:>12}", outcome.questions)
                                            : fmt::format("{:>12}", "-");
        }
        text += '\n';
    }
    return text;
}

std::string as_json(const std::vector<trace::GrowthPoint>& points) {
    auto document = nlohmann::ordered_json::array();
    for (const trace::GrowthPoint& point : points) {
        nlohmann::ordered_json questions = nlohmann::ordered_json::object();
        for (const trace::VisibilityOutcome& outcome : point.outcomes) {
            if (outcome.refusal.empty()) {
                questions[std::string{name_of(outcome.visibility)}] = outcome.questions;
            }
        }
        document.push_back({{"triangles", point.triangles}, {"questions", questions}});
    }
    return document.dump() + '\n';
}

int run_growth(const Options& options, const Common& common) {
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto points = trace::visibility_growth((*recording)->scene());
    return print(common.json ? as_json(points) : as_table(points));
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
    if (step.of_triangle()) {
        only = trace::TriangleNumber{step.object, step.triangle};
    }
    const auto rows = trace::compare_traversals((*recording)->frame->shared_scene(), only);
    return print(common.json ? as_json(rows) : as_table(rows));
}

} // namespace

Command add_compare(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "compare", "Compare traversals, or visible-surface algorithms, on a scene"
    );
    app->footer("Examples:\n"
                "  halfspace compare scene.toml --at 'object 0 / triangle 12'\n"
                "  halfspace compare scene.toml --visibility\n"
                "  halfspace compare mesh.obj --growth");
    app->add_option("FILE", options->file, file_help)->required();
    app->add_option("--at", options->at, "only the triangle of this step");
    app->add_flag(
        "--visibility",
        options->visibility,
        "compare every visible-surface algorithm's picture with the z-buffer's instead"
    );
    app->add_flag(
        "--growth",
        options->growth,
        "count the questions every visible-surface algorithm asks as the scene's polygons double"
    );
    const auto run = [options, &common] {
        return options->growth       ? run_growth(*options, common)
               : options->visibility ? run_visibility(*options, common)
                                     : run_compare(*options, common);
    };
    return {app, run, true};
}

} // namespace hs::command
