#include "app/lesson/session.hpp"

#include "app/lesson/placeholder.hpp"
#include "app/lesson/quantity.hpp"
#include "core/trace/player.hpp"

#include <algorithm>
#include <utility>

namespace hs::lesson {

namespace {

constexpr int most_attempts = 2;

/// Errors of texts and expressions carry no file of their own: theirs is the lesson's.
void add_problems(Diagnostics& problems, Diagnostics more, const Lesson& lesson) {
    for (Diagnostic& problem : more) {
        if (problem.file.empty()) {
            problem.file = lesson.file.string();
        }
        problems.push_back(std::move(problem));
    }
}

} // namespace

Session::Session(std::shared_ptr<const Lesson> lesson)
    : lesson_(std::move(lesson)), recordings_(std::make_shared<RecordingCache>()) {
    HS_CHECK(lesson_ != nullptr && !lesson_->steps.empty(), "the loader gives a lesson steps");
    load();
}

// Going from step to step

void Session::go_to(std::size_t step) {
    index_ = std::min(step, lesson_->steps.size() - 1);
    load();
}

bool Session::next() {
    if (index_ + 1 >= lesson_->steps.size()) {
        return false;
    }
    go_to(index_ + 1);
    return true;
}

bool Session::previous() {
    if (index_ == 0) {
        return false;
    }
    go_to(index_ - 1);
    return true;
}

void Session::load() {
    problems_.clear();
    changes_.assign(step().changes.size(), std::nullopt);
    asked_ = record(scene_of_step(*lesson_, index_));
    recording_ = asked_;
    find_stand();
    fill_in_narration();
    fill_in_question();
    ++revision_;
}

Session::Frame Session::record(const SceneChoice& choice) {
    const RecordingCache::Entry& entry = recordings_->get(choice);
    if (!entry) {
        add_problems(problems_, entry.diagnostics(), *lesson_);
        return nullptr;
    }
    return *entry;
}

void Session::find_stand() {
    stand_ = 0;
    if (recording_ == nullptr) {
        return;
    }
    stand_ = recording_->end_step;
    if (step().stand.empty()) {
        return;
    }
    const Result<trace::StepId> found = trace::find_step(*recording_, step().stand);
    if (found) {
        stand_ = *found;
    } else if (recording_ == asked_) {
        // In a changed frame a fragment may well be missing; in the lesson's own it is an error
        const Place place = step().stand_place;
        problems_.push_back(
            {lesson_->file.string(), place.line, place.column, found.diagnostics().front().message}
        );
    }
}

Evaluator Session::evaluator(const SceneChoice& choice, const Frame& frame) const {
    const trace::StepId last = frame->end_step;
    return {recordings_, choice, frame, trace::describe_step(*frame, std::min(stand_, last))};
}

// Texts with the trace's numbers

std::span<const std::string> Session::hidden() const {
    const QuestionState now = state();
    const bool open = now == QuestionState::open || now == QuestionState::retry;
    return open ? std::span<const std::string>{step().hide} : std::span<const std::string>{};
}

bool Session::is_hidden(std::string_view quantity) const {
    return std::ranges::any_of(hidden(), [quantity](const std::string& group) {
        return is_in_group(quantity, group);
    });
}

void Session::fill_in_narration() {
    narration_ = step().narration;
    change_prompts_.assign(step().changes.size(), {});
    if (recording_ == nullptr) {
        return;
    }
    const Evaluator evaluate = evaluator(changed_scene(), recording_);
    const Filling filling{
        .evaluate = &evaluate,
        .is_hidden = [this](std::string_view quantity) { return is_hidden(quantity); },
        .named_values = {},
    };
    Diagnostics problems;
    // A written number is the lesson's own frame's; in a changed frame the trace says another
    narration_ = fill_in(step().narration, filling, problems);
    for (std::size_t i = 0; i < step().changes.size(); ++i) {
        const Change& change = step().changes[i];
        change_prompts_[i] = fill_in_text(change.prompt, change.place, filling, problems);
    }
    if (recording_ == asked_) {
        add_problems(problems_, std::move(problems), *lesson_);
    }
}

void Session::fill_in_question() {
    prompt_.clear();
    reveal_.clear();
    right_answer_.reset();
    if (!step().question || asked_ == nullptr) {
        return;
    }
    const Question& question = *step().question;
    const Evaluator evaluate = evaluator(scene_of_step(*lesson_, index_), asked_);
    const Result<Value> right = evaluate(question.answer);
    if (!right) {
        add_problems(problems_, right.diagnostics(), *lesson_);
        return;
    }
    Diagnostics problems;
    Filling filling{
        .evaluate = &evaluate,
        .is_hidden = [this](std::string_view quantity) { return is_hidden(quantity); },
        .named_values = {},
    };
    prompt_ = fill_in_text(question.prompt, question.place, filling, problems);
    if (state() == QuestionState::revealed) {
        right_answer_ = asked_part(question, *right);
        filling.named_values = {{"right", *right_answer_}};
        reveal_ = fill_in_text(question.reveal, question.place, filling, problems);
    }
    add_problems(problems_, std::move(problems), *lesson_);
}

// Answering

const Session::Answered* Session::answered() const {
    const auto found = answers_.find(index_);
    return found == answers_.end() ? nullptr : &found->second;
}

QuestionState Session::state() const {
    if (!step().question) {
        return QuestionState::none;
    }
    const Answered* const before = answered();
    return before == nullptr  ? QuestionState::open
           : before->revealed ? QuestionState::revealed
                              : QuestionState::retry;
}

bool Session::can_answer() const {
    const QuestionState now = state();
    return asked_ != nullptr && (now == QuestionState::open || now == QuestionState::retry);
}

const Answer* Session::prediction() const {
    const Answered* const before = answered();
    return before == nullptr ? nullptr : &before->prediction;
}

const Grade* Session::grade() const {
    const Answered* const before = answered();
    return before == nullptr ? nullptr : &before->last;
}

const Grade& Session::answer(const Value& value) {
    HS_CHECK(can_answer(), "answers are taken while the question is open");
    const SceneChoice scene = scene_of_step(*lesson_, index_);
    Result<Grade> graded = lesson::grade(*step().question, value, evaluator(scene, asked_));
    Grade grade;
    if (graded) {
        grade = std::move(*graded);
    } else {
        add_problems(problems_, graded.diagnostics(), *lesson_);
    }
    const int attempts = answered() == nullptr ? 1 : answered()->attempts + 1;
    const bool reveal = grade.right || attempts >= most_attempts;
    return log_answer({value}, std::move(grade), reveal);
}

void Session::give_up() {
    HS_CHECK(can_answer(), "answers are taken while the question is open");
    log_answer({std::nullopt}, {}, true);
}

const Grade& Session::log_answer(Answer answer, Grade grade, bool reveal) {
    const bool first = answered() == nullptr;
    Answered& answered = answers_.try_emplace(index_).first->second;
    if (first) {
        answered.prediction = answer; // and stays, whatever is answered later
    }
    answered.last = std::move(grade);
    ++answered.attempts;
    answered.revealed = reveal;
    log_.push_back({index_, answered.attempts, std::move(answer), answered.last});
    fill_in_narration();
    fill_in_question();
    return answered.last;
}

// Changing the scene

SceneChoice Session::changed_scene() const {
    SceneChoice choice = scene_of_step(*lesson_, index_);
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        if (changes_[i]) {
            const Change& change = step().changes[i];
            choice.assignments.push_back({change.key, change.values[*changes_[i]]});
        }
    }
    return choice;
}

std::optional<std::size_t> Session::changed(std::size_t change) const {
    return changes_[change];
}

void Session::change(std::size_t change, std::optional<std::size_t> value) {
    HS_CHECK(
        change < changes_.size() && (!value || *value < step().changes[change].values.size()),
        "changes are picked from the step's lists"
    );
    changes_[change] = value;
    problems_.clear();
    recording_ = record(changed_scene());
    find_stand();
    fill_in_narration();
    ++revision_;
}

std::string Session::watched(std::size_t change) const {
    if (recording_ == nullptr) {
        return {};
    }
    if (is_hidden(step().changes[change].watch.quantity)) {
        return "?";
    }
    const Evaluator evaluate = evaluator(changed_scene(), recording_);
    const Result<Value> value = evaluate(step().changes[change].watch);
    return value ? print_value(*value) : value.diagnostics().front().message;
}

} // namespace hs::lesson
