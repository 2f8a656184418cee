// `halfspace check`: lessons verified without a display.
#include "app/lesson/check.hpp"

#include "app/command/command.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hs::command {
namespace {

struct Options {
    std::vector<std::filesystem::path> lessons;
};

/// Everything wrong with one lesson; empty when all is well.
Diagnostics problems_of(const std::filesystem::path& path) {
    const Result<lesson::Lesson> opened = lesson::load_lesson(path);
    return opened ? lesson::check_lesson(*opened) : opened.diagnostics();
}

int check(const Options& options, const Common& common) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    bool good = true;
    for (const std::filesystem::path& path : options.lessons) {
        if (!lesson::is_lesson(path)) {
            return fail(
                {{.file = path.string(),
                  .message = "is not a lesson; name a folder with a lesson.md, or the file"}}
            );
        }
        const Diagnostics problems = problems_of(path);
        good = good && problems.empty();
        nlohmann::ordered_json lines = nlohmann::ordered_json::array();
        for (const Diagnostic& problem : problems) {
            lines.push_back(problem.to_string());
            if (!common.json) {
                fmt::print("{}\n", problem.to_string());
            }
        }
        document.push_back({{"lesson", path.string()}, {"problems", lines}});
        if (!common.json && !common.quiet && problems.empty()) {
            fmt::print("{}: all is well\n", path.string());
        }
    }
    if (common.json) {
        fmt::print("{}\n", document.dump());
    }
    return good ? status_done : status_no;
}

} // namespace

Command add_check(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "check", "Verify lessons: scenes, steps, quoted numbers, questions and answers"
    );
    app->add_option("LESSON", options->lessons, "lesson folders or lesson.md files")->required();
    return {app, [options, &common] { return check(*options, common); }};
}

} // namespace hs::command
