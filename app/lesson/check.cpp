#include "app/lesson/check.hpp"

#include "app/lesson/evaluate.hpp"
#include "app/lesson/grade.hpp"
#include "app/lesson/placeholder.hpp"
#include "app/lesson/recordings.hpp"
#include "core/trace/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>
#include <utility>

namespace hs::lesson {

namespace {

/// Everything that is verified of one lesson.
class Checker {
public:
    explicit Checker(const Lesson& lesson)
        : lesson_(lesson), recordings_(std::make_shared<RecordingCache>()) {}

    Diagnostics run();

private:
    void check_step(std::size_t index);
    void check_question(const Question& question, const Evaluator& evaluate);
    void check_kind(const Question& question, const Value& right);
    void check_wrong(const Question& question, const WrongAnswer& wrong, const Evaluator& evaluate);
    void check_change(const Change& change, const SceneChoice& scene, const Evaluator& evaluate);
    void check_claim(const Check& check, const Evaluator& evaluate);
    void check_text(const std::string& text, Place place, const Filling& filling);
    std::optional<Value> read(const Expression& expression, const Evaluator& evaluate);
    void check_participation();
    void check_prerequisites();

    void add(Place place, std::string message) {
        found_.push_back({lesson_.file.string(), place.line, place.column, std::move(message)});
    }
    void add(Diagnostics problems) {
        for (Diagnostic& problem : problems) {
            if (problem.file.empty()) {
                problem.file = lesson_.file.string();
            }
            found_.push_back(std::move(problem));
        }
    }

    const Lesson& lesson_;
    std::shared_ptr<RecordingCache> recordings_;
    Diagnostics found_;
};

Diagnostics Checker::run() {
    check_participation();
    check_prerequisites();
    for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
        check_step(i);
    }
    return std::move(found_);
}

/// Who only presses "next" learns nothing (Hundhausen, Douglas and Stasko 2002).
void Checker::check_participation() {
    const auto& steps = lesson_.steps;
    if (std::ranges::none_of(steps, [](const LessonStep& step) {
            return step.question.has_value();
        })) {
        add({1, 0}, "the lesson asks nothing: at least one step needs a [question]");
    }
    if (std::ranges::all_of(steps, [](const LessonStep& step) { return step.changes.empty(); })) {
        add({1, 0}, "the lesson lets change nothing: at least one step needs a [[change]]");
    }
}

void Checker::check_prerequisites() {
    for (const std::string& name : lesson_.prerequisites) {
        std::error_code error;
        if (!std::filesystem::exists(lesson_.folder / ".." / name / "lesson.md", error)) {
            add({1, 0}, fmt::format("there is no lesson \"{}\" to be a prerequisite", name));
        }
    }
}

void Checker::check_step(std::size_t index) {
    const LessonStep& step = lesson_.steps[index];
    if (!step.hide.empty() && !step.question) {
        add(step.place, "what this step hides is never revealed: it asks no question");
    }

    // The scene loads and the frame is recorded
    const SceneChoice scene = scene_of_step(lesson_, index);
    const RecordingCache::Entry& entry = recordings_->get(scene);
    if (!entry) {
        const bool without_changes = recordings_->get({scene.file, {}}).operator bool();
        add(without_changes ? step.settings_place : step.scene_place,
            without_changes ? "the scene does not load with the settings of this step"
                            : "the scene of this step does not load");
        add(entry.diagnostics());
        return;
    }

    // The step to stand on exists
    const trace::Recording& frame = **entry;
    trace::StepId stand = frame.end_step;
    if (!step.stand.empty()) {
        const Result<trace::StepId> found = trace::find_step(frame, step.stand);
        if (found) {
            stand = *found;
        } else {
            add(step.stand_place, found.diagnostics().front().message);
        }
    }

    // Everything said, asked and claimed holds in that frame
    const Evaluator evaluate(recordings_, scene, *entry, trace::describe_step(frame, stand));
    const Filling filling{.evaluate = &evaluate, .is_hidden = {}, .named_values = {}};
    Diagnostics problems;
    fill_in(step.narration, filling, problems);
    add(std::move(problems));
    check_text(step.note, step.place, filling);
    if (step.question) {
        check_question(*step.question, evaluate);
    }
    for (const Change& change : step.changes) {
        check_text(change.prompt, change.place, filling);
        check_change(change, scene, evaluate);
    }
    for (const Check& check : step.checks) {
        check_claim(check, evaluate);
    }
}

void Checker::check_text(const std::string& text, Place place, const Filling& filling) {
    Diagnostics problems;
    fill_in_text(text, place, filling, problems);
    add(std::move(problems));
}

std::optional<Value> Checker::read(const Expression& expression, const Evaluator& evaluate) {
    Result<Value> value = evaluate(expression);
    if (!value) {
        add(value.diagnostics());
        return std::nullopt;
    }
    return *value;
}

void Checker::check_question(const Question& question, const Evaluator& evaluate) {
    const std::optional<Value> right = read(question.answer, evaluate);
    if (!right) {
        return;
    }
    check_kind(question, *right);
    check_text(question.prompt, question.place, {&evaluate, {}, {}});
    check_text(
        question.reveal, question.place, {&evaluate, {}, {{"right", asked_part(question, *right)}}}
    );
    const Result<Grade> graded = grade(question, *right, evaluate);
    if (!graded) {
        add(graded.diagnostics());
        return;
    }
    if (!graded->right) {
        add(question.place, "the right answer is not graded right");
    }
    for (const WrongAnswer& wrong : question.wrong) {
        check_wrong(question, wrong, evaluate);
    }
}

/// The trace's answer must be one a student can give.
void Checker::check_kind(const Question& question, const Value& right) {
    const bool fits =
        question.kind == QuestionKind::value       ? std::holds_alternative<double>(right)
        : question.kind == QuestionKind::pixels    ? std::holds_alternative<PixelSet>(right)
        : question.kind == QuestionKind::pass_fail ? std::holds_alternative<bool>(right)
                                                   : true;
    if (!fits) {
        add(question.answer.place,
            fmt::format(
                "\"{}\" is no answer to a question of the kind {}: it reads {}",
                question.answer.quantity,
                name_of(question.kind),
                print_value(right)
            ));
    }
    if (question.kind != QuestionKind::choice && question.kind != QuestionKind::pass_fail) {
        return;
    }
    std::set<std::string> values;
    for (const Choice& choice : question.choices) {
        if (!values.insert(choice.value).second) {
            add(question.place, fmt::format("two choices mean \"{}\"", choice.value));
        }
    }
    if (!values.contains(print_value(right))) {
        add(question.place,
            fmt::format("the right answer, {}, is not among the choices", print_value(right)));
    }
    for (const WrongAnswer& wrong : question.wrong) {
        if (!wrong.answer && !values.contains(wrong.choice)) {
            add(wrong.place, fmt::format("there is no choice \"{}\"", wrong.choice));
        }
    }
}

/// A wrong answer is graded wrong, and by its own name.
void Checker::check_wrong(
    const Question& question, const WrongAnswer& wrong, const Evaluator& evaluate
) {
    const std::optional<Value> value =
        wrong.answer ? read(*wrong.answer, evaluate) : std::optional<Value>{wrong.choice};
    if (!value) {
        return;
    }
    const Result<Grade> graded = grade(question, *value, evaluate);
    if (!graded) {
        add(graded.diagnostics());
    } else if (graded->right) {
        add(wrong.place,
            fmt::format(
                "\"{}\" gives the right answer, {}", wrong.misconception, print_value(*value)
            ));
    } else if (graded->misconception != wrong.misconception) {
        add(wrong.place,
            fmt::format(
                R"("{}" cannot be told from "{}": both give {})",
                wrong.misconception,
                graded->misconception,
                print_value(*value)
            ));
    }
}

/// Every value can be recorded, and the watched quantity notices.
void Checker::check_change(
    const Change& change, const SceneChoice& scene, const Evaluator& evaluate
) {
    std::set<std::string> seen;
    std::size_t loaded = 0;
    for (const std::string& value : change.values) {
        SceneChoice changed = scene;
        changed.assignments.push_back({change.key, value});
        const RecordingCache::Entry& entry = recordings_->get(changed);
        if (!entry) {
            add(change.place, fmt::format("{} = {} does not load", change.key, value));
            add(entry.diagnostics());
            continue;
        }
        ++loaded;
        Expression watch = change.watch;
        watch.settings.insert(watch.settings.begin(), {change.key, value});
        const Result<Value> watched = evaluate(watch);
        seen.insert(watched ? print_value(*watched) : watched.diagnostics().front().message);
    }
    if (seen.size() == 1 && loaded == change.values.size()) {
        add(change.place,
            fmt::format("whatever is chosen, {} stays {}", change.watch.quantity, *seen.begin()));
    }
    read(change.watch, evaluate);
}

/// A literal as a number where it is one, else as a name.
Value parse_literal(const std::string& text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? Value{number} : Value{text};
}

bool holds(const Check& check, const Value& left, const Value& right) {
    const auto* const a = std::get_if<double>(&left);
    const auto* const b = std::get_if<double>(&right);
    if (a == nullptr || b == nullptr) {
        return check.relation == Check::Relation::equals && print_value(left) == print_value(right);
    }
    switch (check.relation) {
    case Check::Relation::equals: return std::abs(*a - *b) <= check.tolerance;
    case Check::Relation::less_than: return *a < *b;
    case Check::Relation::greater_than: return *a > *b;
    }
    HS_CHECK(false, "every relation is handled");
    return false;
}

void Checker::check_claim(const Check& check, const Evaluator& evaluate) {
    const std::optional<Value> left = read(check.left, evaluate);
    const std::optional<Value> right =
        check.right ? read(*check.right, evaluate) : std::optional{parse_literal(check.literal)};
    if (left && right && !holds(check, *left, *right)) {
        add(check.place,
            fmt::format(
                "\"{}\" does not hold: {} is {}, against {}",
                check.claim,
                check.left.quantity,
                print_value(*left),
                print_value(*right)
            ));
    }
}

} // namespace

Diagnostics check_lesson(const Lesson& lesson) {
    return Checker(lesson).run();
}

} // namespace hs::lesson
