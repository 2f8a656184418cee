// The course, headless: every lesson that comes with the program holds, and a student who takes it
// from end to end is graded as the trace says.
#include "app/lesson/check.hpp"
#include "app/lesson/library.hpp"
#include "app/lesson/session.hpp"
#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <algorithm>
#include <set>

namespace hs::lesson {

namespace {

std::shared_ptr<const Lesson> open(const std::filesystem::path& folder) {
    return std::make_shared<const Lesson>(load_lesson(folder).value());
}

std::vector<std::filesystem::path> course() {
    return find_lessons(test::source_dir() / "lessons");
}

/// The answer a student with a misconception gives.
Value value_of(const WrongAnswer& wrong, Session& session) {
    if (!wrong.answer) {
        return wrong.choice;
    }
    const Evaluator evaluate(
        std::make_shared<RecordingCache>(),
        scene_of_step(session.lesson(), session.index()),
        session.recording(),
        trace::describe_step(*session.recording(), session.stand())
    );
    return evaluate(*wrong.answer).value();
}

/// Answers one question with each of its misconceptions, each in a session of its own.
void try_wrong_answers(const std::shared_ptr<const Lesson>& lesson, std::size_t step) {
    for (const WrongAnswer& wrong : lesson->steps[step].question->wrong) {
        INFO(wrong.misconception);
        Session session(lesson);
        session.go_to(step);
        const Grade& grade = session.answer(value_of(wrong, session));
        CHECK_FALSE(grade.right);
        CHECK(grade.misconception == wrong.misconception);
        CHECK(grade.message.size() > 20);
        CHECK(session.state() == QuestionState::retry);
    }
}

/// Gives the answer that giving up reveals.
void answer_right(Session& session) {
    Session peek(std::make_shared<const Lesson>(session.lesson()));
    peek.go_to(session.index());
    peek.give_up();
    REQUIRE(peek.right_answer().has_value());
    CHECK(session.answer(*peek.right_answer()).right);
    CHECK(session.state() == QuestionState::revealed);
    CHECK_FALSE(to_plain_text(session.reveal()).empty());
}

/// Chooses every value of a change, then takes it back; the watched quantity must notice.
void try_change(Session& session, std::size_t change) {
    INFO(session.step().title);
    std::set<std::string> watched;
    for (std::size_t k = 0; k < session.step().changes[change].values.size(); ++k) {
        session.change(change, k);
        CHECK(session.problems().empty());
        watched.insert(session.watched(change));
    }
    CHECK(watched.size() > 1);
    session.change(change, std::nullopt);
}

} // namespace

TEST_CASE("the program finds the lessons it comes with", "[lesson]") {
    CHECK_FALSE(find_lessons(lessons_folder()).empty());
    CHECK(is_lesson(course().front()));
    CHECK(is_lesson(course().front() / "lesson.md"));
    CHECK_FALSE(is_lesson(test::source_dir()));
}

TEST_CASE("every lesson of the course loads and holds", "[lesson]") {
    for (const std::filesystem::path& folder : course()) {
        INFO(folder);
        const Result<Lesson> lesson = load_lesson(folder);
        std::string problems;
        for (const Diagnostic& problem : lesson ? check_lesson(*lesson) : lesson.diagnostics()) {
            problems += problem.to_string() + '\n';
        }
        CHECK(problems.empty());
    }
}

TEST_CASE("every question reveals an answer that is graded right", "[lesson]") {
    for (const std::filesystem::path& folder : course()) {
        Session session(open(folder));
        do {
            INFO(session.step().title);
            CHECK(session.problems().empty());
            CHECK_FALSE(to_plain_text(session.narration()).empty());
            if (session.state() != QuestionState::none) {
                answer_right(session);
            }
        } while (session.next());
    }
}

TEST_CASE("every misconception of the course is graded wrong and called by its name", "[lesson]") {
    std::size_t count = 0;
    for (const std::filesystem::path& folder : course()) {
        const auto lesson = open(folder);
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            if (lesson->steps[step].question) {
                try_wrong_answers(lesson, step);
                count += lesson->steps[step].question->wrong.size();
            }
        }
    }
    CHECK(count >= 15);
}

TEST_CASE("a change does not tell what its step's question hides", "[lesson]") {
    std::size_t hidden = 0;
    for (const std::filesystem::path& folder : course()) {
        Session session(open(folder));
        do {
            for (std::size_t i = 0; i < session.step().changes.size(); ++i) {
                const bool asked = session.is_hidden(session.step().changes[i].watch.quantity);
                CHECK((session.watched(i) == "?") == asked);
                hidden += asked ? 1 : 0;
            }
        } while (session.next());
    }
    CHECK(hidden > 0);
}

TEST_CASE("every change of the course changes what it says to watch", "[lesson]") {
    for (const std::filesystem::path& folder : course()) {
        Session session(open(folder));
        do {
            if (session.state() != QuestionState::none) {
                answer_right(session); // what the question hides may be what a change watches
            }
            for (std::size_t change = 0; change < session.step().changes.size(); ++change) {
                try_change(session, change);
            }
        } while (session.next());
    }
}

} // namespace hs::lesson
