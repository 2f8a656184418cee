// A lesson being taken: where one is, what was predicted, what came out. Knows no window.
#pragma once

#include "app/lesson/evaluate.hpp"
#include "app/lesson/grade.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/recordings.hpp"
#include "app/lesson/value.hpp"
#include "core/trace/recording.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hs::lesson {

/// An answer as given; no value: "I don't know".
struct Answer {
    std::optional<Value> value;
};

/// One line of the log of answers.
struct LoggedAnswer {
    std::size_t step = 0;
    int attempt = 1; ///< 1 or 2
    Answer answer;
    Grade grade;
};

enum class QuestionState : std::uint8_t {
    none,     ///< the step asks nothing
    open,     ///< no answer yet
    retry,    ///< one wrong answer, one try left
    revealed, ///< right, wrong twice, or "I don't know"
};

class Session {
public:
    /// Stands on the first step.
    explicit Session(std::shared_ptr<const Lesson> lesson);

    [[nodiscard]] const Lesson& lesson() const { return *lesson_; }
    [[nodiscard]] std::size_t index() const { return index_; }
    [[nodiscard]] const LessonStep& step() const { return lesson_->steps[index_]; }

    /// Goes to a step; beyond the last is the last. Answers given there before are kept; changes
    /// made by the student are not.
    void go_to(std::size_t step);
    /// False when there is none.
    bool next();
    bool previous();

    /// What is wrong with the current step: its scene does not load, its path does not exist.
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }
    /// The frame of the current step; null when it could not be recorded.
    [[nodiscard]] const std::shared_ptr<const trace::Recording>& recording() const {
        return recording_;
    }
    /// Where the playhead is to stand.
    [[nodiscard]] trace::StepId stand() const { return stand_; }
    /// Grows with every change of recording or stand, so that a window knows when to follow.
    [[nodiscard]] unsigned revision() const { return revision_; }

    /// The narration with the trace's numbers filled in. What the step hides reads "?".
    [[nodiscard]] const Document& narration() const { return narration_; }
    /// Quantities to show as "?": the step's `hide` until its question is revealed.
    [[nodiscard]] std::span<const std::string> hidden() const;
    /// Whether a quantity ("ndc.x") is among them.
    [[nodiscard]] bool is_hidden(std::string_view quantity) const;

    // The question
    [[nodiscard]] QuestionState state() const;
    [[nodiscard]] const Document& prompt() const { return prompt_; }
    /// The first answer: kept beside the result, never overwritten.
    [[nodiscard]] const Answer* prediction() const;
    /// The last grade, null before the first answer.
    [[nodiscard]] const Grade* grade() const;
    /// Grades an answer, against the scene as the lesson has it whatever the student has changed.
    /// A pass-fail question takes a bool, a choice the `value` of a choice as a string.
    /// Precondition: can_answer().
    const Grade& answer(const Value& value);
    /// "I don't know": reveals at once. Same precondition.
    void give_up();
    /// The question is open or to be retried, and its frame was recorded.
    [[nodiscard]] bool can_answer() const;
    /// The right answer and the formula filled in; empty until revealed.
    [[nodiscard]] const std::optional<Value>& right_answer() const { return right_answer_; }
    [[nodiscard]] const Document& reveal() const { return reveal_; }

    // What may be changed
    /// The value in force: an index into `values`; nothing while it is as the scene has it.
    [[nodiscard]] std::optional<std::size_t> changed(std::size_t change) const;
    /// Records the frame anew with this value; the playhead stays where it stands, or goes to the
    /// end when that step no longer exists. Nothing: as the scene has it.
    void change(std::size_t change, std::optional<std::size_t> value);
    [[nodiscard]] const Document& change_prompt(std::size_t change) const {
        return change_prompts_[change];
    }
    /// The watched quantity in the frame as it is now.
    [[nodiscard]] std::string watched(std::size_t change) const;

    /// Every answer of this session, in order.
    [[nodiscard]] const std::vector<LoggedAnswer>& log() const { return log_; }

private:
    /// What was answered at one step.
    struct Answered {
        Answer prediction;
        Grade last;
        int attempts = 0;
        bool revealed = false;
    };

    using Frame = std::shared_ptr<const trace::Recording>;

    void load();
    Frame record(const SceneChoice& choice);
    void find_stand();
    void fill_in_narration();
    void fill_in_question();
    const Grade& log_answer(Answer answer, Grade grade, bool reveal);
    [[nodiscard]] SceneChoice changed_scene() const;
    [[nodiscard]] Evaluator evaluator(const SceneChoice& choice, const Frame& frame) const;
    [[nodiscard]] const Answered* answered() const;

    std::shared_ptr<const Lesson> lesson_;
    std::size_t index_ = 0;
    std::shared_ptr<RecordingCache> recordings_;
    std::shared_ptr<const trace::Recording> recording_;
    std::shared_ptr<const trace::Recording> asked_; ///< the frame questions are about: unchanged
    trace::StepId stand_ = 0;
    unsigned revision_ = 0;
    Diagnostics problems_;
    Document narration_;
    Document prompt_;
    Document reveal_;
    std::vector<Document> change_prompts_;
    std::optional<Value> right_answer_;
    std::vector<std::optional<std::size_t>> changes_; ///< by change of the current step
    std::map<std::size_t, Answered> answers_;         ///< by step
    std::vector<LoggedAnswer> log_;
};

} // namespace hs::lesson
