// `halfspace query`: which vertices, triangles, fragments or steps match an expression.
#include "core/search/query.hpp"

#include "app/command/command.hpp"
#include "app/command/interrupt.hpp"
#include "core/export/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace hs::command {
namespace {

struct Options {
    std::filesystem::path file;
    std::string expression;
    std::string at;
    bool csv = false;
    bool count = false;
    bool names = false;
    std::size_t limit = 1000;
    std::filesystem::path out;
};

/// A row that matched.
struct Match {
    std::size_t row = 0;
    trace::Step step;
    std::vector<search::Value> values;
};

struct Answer {
    search::Query query;          ///< keeps the texts among the values
    std::vector<Match> matches{}; ///< the first `limit`
    std::size_t count = 0;
};

/// Goes through all rows; only the first `limit` matches are kept, the others counted.
Result<Answer>
find_matches(const trace::Player& player, const Options& options, const Common& common) {
    Result<search::Query> prepared = search::Query::prepare(player, options.expression);
    if (!prepared) {
        return prepared.diagnostics();
    }
    constexpr std::size_t between_looks = 65536;
    const ProgressBar progress(common.quiet);
    Answer answer{.query = std::move(*prepared)};
    search::Query& query = answer.query;
    for (std::size_t row = 0; row < query.size(); ++row) {
        if (row % between_looks == 0) {
            progress.show(static_cast<double>(row) / static_cast<double>(query.size()));
            if (stop_requested()) {
                return Diagnostic{.message = "stopped"};
            }
        }
        const Result<bool> matched = query.matches(row);
        if (!matched) {
            return matched.diagnostics();
        }
        if (*matched && answer.count++ < options.limit && !options.count) {
            answer.matches.push_back(
                {row,
                 trace::describe_step(player.recording(), query.step_of(row)),
                 query.values(row)}
            );
        }
    }
    return answer;
}

std::string text_of(const search::Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return fmt::format("{}", *whole);
    }
    if (const auto* real = std::get_if<double>(&value)) {
        return fmt::format("{}", static_cast<float>(*real)); // columns of reals are float32
    }
    return std::string{std::get<std::string_view>(value)};
}

nlohmann::ordered_json json_of(const search::Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return *whole;
    }
    if (const auto* real = std::get_if<double>(&value)) {
        return *real;
    }
    return std::get<std::string_view>(value);
}

/// Columns as wide as their widest entry.
std::string as_table(const Answer& answer) {
    std::vector<std::vector<std::string>> lines{{"step"}};
    const std::vector<std::string> columns = answer.query.columns();
    lines.front().insert(lines.front().end(), columns.begin(), columns.end());
    lines.front().emplace_back("path");
    for (const Match& match : answer.matches) {
        std::vector<std::string> line{fmt::format("#{}", match.step.id)};
        for (const search::Value& value : match.values) {
            line.push_back(text_of(value));
        }
        line.push_back(trace::step_path(match.step));
        lines.push_back(std::move(line));
    }
    std::string text;
    for (const std::vector<std::string>& line : lines) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            std::size_t width = 0;
            for (const std::vector<std::string>& other : lines) {
                width = std::max(width, other[i].size());
            }
            text += fmt::format("{:>{}}  ", line[i], width);
        }
        text += line.back() + '\n';
    }
    if (answer.count > answer.matches.size()) {
        text += fmt::format("and {} more; see --limit\n", answer.count - answer.matches.size());
    }
    return text;
}

std::string as_csv(const Answer& answer) {
    std::string text = fmt::format("step,path,{}", name_of(answer.query.rows()));
    for (const std::string& column : answer.query.columns()) {
        text += ',' + column;
    }
    text += '\n';
    for (const Match& match : answer.matches) {
        text += fmt::format("{},\"{}\",{}", match.step.id, trace::step_path(match.step), match.row);
        for (const search::Value& value : match.values) {
            text += ',' + text_of(value);
        }
        text += '\n';
    }
    return text;
}

std::string as_json(const Answer& answer) {
    nlohmann::ordered_json document{
        {"searched", name_of(answer.query.rows())},
        {"count", answer.count},
        {"matches", nlohmann::ordered_json::array()}};
    const std::vector<std::string> columns = answer.query.columns();
    for (const Match& match : answer.matches) {
        nlohmann::ordered_json entry{
            {"step", match.step.id}, {"path", trace::step_path(match.step)}, {"row", match.row}};
        for (std::size_t i = 0; i < columns.size(); ++i) {
            entry[columns[i]] = json_of(match.values[i]);
        }
        document["matches"].push_back(std::move(entry));
    }
    return document.dump() + '\n';
}

/// Every name an expression may use, and the texts it can be.
std::string as_names(const trace::Player& player) {
    std::string text;
    for (const search::KnownName& name : search::known_names(player)) {
        text += fmt::format("{:<24}{}\n", name.path, fmt::join(name.meanings, ", "));
    }
    return text;
}

int show(const Answer& answer, const Options& options, const Common& common) {
    const int status = answer.count == 0 ? status_no : status_done;
    if (!options.out.empty()) {
        const bool json = options.out.extension() == ".json";
        const Result<Done> written =
            exporting::write_text(options.out, json ? as_json(answer) : as_csv(answer));
        return written ? status : fail(written.diagnostics());
    }
    if (options.count && !common.json) {
        return print(fmt::format("{}\n", answer.count), status);
    }
    return print(
        common.json   ? as_json(answer)
        : options.csv ? as_csv(answer)
                      : as_table(answer),
        status
    );
}

int run_query(const Options& options, const Common& common) {
    if (!options.out.empty()) {
        if (const auto format = output_format(options.out, {".csv", ".json"}); !format) {
            return fail(format.diagnostics());
        }
        if (const Result<Done> good = exporting::check_writable(options.out); !good) {
            return fail(good.diagnostics());
        }
    }
    const auto recording = record_file(options.file, common);
    if (!recording) {
        return fail(recording.diagnostics());
    }
    const auto player = stand_on(*recording, options.at);
    if (!player) {
        return fail(player.diagnostics());
    }
    if (options.names) {
        return print(as_names(**player));
    }
    const Result<Answer> answer = find_matches(**player, options, common);
    return answer ? show(*answer, options, common) : fail(answer.diagnostics());
}

} // namespace

Command add_query(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "query", "List the vertices, triangles, fragments or steps that match an expression"
    );
    app->footer(
        "The expression is Lua over the columns of the exported tables; --names lists them.\n"
        "Exit status 1: nothing matches.\n\n"
        "Examples:\n"
        "  halfspace query scene.toml 'fragment.fate == \"depth failed\"'\n"
        "  halfspace query scene.toml 'triangle.clip_planes ~= 0 and a.clip.w <= 0' --json\n"
        "  halfspace query bunny.ply 'fragment.depth - fragment.stored_depth > 0.01' --count"
    );
    app->add_option("FILE", options->file, file_help)->required();
    CLI::Option* expression =
        app->add_option("EXPRESSION", options->expression, "true or false for a row, in Lua");
    CLI::Option* names = app->add_flag("--names", options->names, "list what can be named instead");
    names->excludes(expression);
    app->add_option("--at", options->at, "only what happened up to this step");
    app->add_option("--limit", options->limit, "how many matches to list; 1000 unless told");
    app->add_flag("--count", options->count, "only say how many match");
    app->add_flag("--csv", options->csv, "print CSV instead of a table");
    app->add_option("-o,--output", options->out, "write to .csv or .json instead of printing");
    return {app, [options, &common] { return run_query(*options, common); }, true};
}

} // namespace hs::command
