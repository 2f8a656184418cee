// `halfspace check`: lessons verified without a display.
#include "app/lesson/check.hpp"

#include "app/command/command.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"

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

std::string
as_text(const std::filesystem::path& lesson, const Diagnostics& problems, const Common& common) {
    if (problems.empty()) {
        return common.quiet ? "" : lesson.string() + ": all is well\n";
    }
    std::string text;
    for (const Diagnostic& problem : problems) {
        text += problem.to_string() + '\n';
    }
    return text;
}

nlohmann::ordered_json as_json(const std::filesystem::path& lesson, const Diagnostics& problems) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Diagnostic& problem : problems) {
        list.push_back(
            {{"file", problem.file},
             {"line", problem.line},
             {"column", problem.column},
             {"message", problem.message}}
        );
    }
    return {{"lesson", lesson.string()}, {"problems", list}};
}

int check(const Options& options, const Common& common) {
    for (const std::filesystem::path& path : options.lessons) {
        if (!lesson::is_lesson(path)) {
            return fail(
                {{.file = path.string(),
                  .message = "is not a lesson; name a folder with a lesson.md, or the file"}}
            );
        }
    }
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    std::string text;
    bool good = true;
    for (const std::filesystem::path& path : options.lessons) {
        const Diagnostics problems = problems_of(path);
        good = good && problems.empty();
        text += as_text(path, problems, common);
        document.push_back(as_json(path, problems));
    }
    return print(common.json ? document.dump() + '\n' : text, good ? status_done : status_no);
}

} // namespace

Command add_check(CLI::App& program, const Common& common) {
    auto options = std::make_shared<Options>();
    CLI::App* app = program.add_subcommand(
        "check", "Verify lessons: scenes, steps, quoted numbers, questions and answers"
    );
    app->footer("Exit status 1 when something does not hold. Example:\n  halfspace check lessons/*/"
    );
    app->add_option("LESSON", options->lessons, "lesson folders or lesson.md files")->required();
    return {app, [options, &common] { return check(*options, common); }};
}

} // namespace hs::command
