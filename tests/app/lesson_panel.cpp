// The lesson panel by keyboard alone: predict, commit, reveal; what it points at; where it leads.
#include "app/lesson/quantity.hpp"
#include "app/lesson/session.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/lesson_pointer.hpp"
#include "tests/app/window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

#include <fmt/format.h>

#include <set>

using namespace hs;
using lesson::QuestionKind;
using lesson::QuestionState;
using test::Window;
using viewer::Key;

namespace {

std::unique_ptr<Window> with_lesson(int width = 1280, int height = 720) {
    auto window = std::make_unique<Window>(width, height);
    window->viewer.open(test::source_dir() / "lessons" / "01-one-triangle");
    window->settle();
    REQUIRE(window->viewer.session() != nullptr);
    return window;
}

/// Turns pages by key until a question of this kind comes.
lesson::Session& at_question(Window& window, QuestionKind kind) {
    lesson::Session& session = *window.viewer.session();
    while (!session.step().question || session.step().question->kind != kind) {
        REQUIRE(session.index() + 1 < session.lesson().steps.size());
        window.key(Key::page_down);
    }
    return session;
}

/// The right answer and a known wrong one, read from the trace as the grader reads them.
struct Answers {
    double right = 0.0;
    double wrong = 0.0;
    std::string misconception;
};

Answers numbers_of(const Window& window, const lesson::Question& question) {
    const trace::Player& player = window.viewer.document().player();
    const auto read = [&](const lesson::Expression& e) {
        const auto value =
            lesson::read_quantity(e.quantity, e.of, player.recording(), player.current());
        REQUIRE(value);
        return e.times * std::get<double>(*value) + e.plus;
    };
    const lesson::WrongAnswer& wrong = question.wrong.front();
    return {read(question.answer), read(*wrong.answer), wrong.misconception};
}

} // namespace

TEST_CASE("a question is answered by keyboard alone: predict, commit, reveal", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = at_question(*window, QuestionKind::value);
    const Answers answers = numbers_of(*window, *session.step().question);
    REQUIRE(session.state() == QuestionState::open);

    window->key(Key::enter); // into the field
    window->host.text(fmt::format("{}", answers.wrong));
    window->settle();
    CHECK(session.state() == QuestionState::open); // nothing is committed by typing
    window->key(Key::enter);
    CHECK(session.state() == QuestionState::retry);
    CHECK(session.grade()->misconception == answers.misconception);

    window->key(Key::enter);
    window->host.text(fmt::format("{}", answers.right));
    window->key(Key::enter);
    CHECK(session.state() == QuestionState::revealed);
    CHECK(session.grade()->right);
    REQUIRE(session.prediction() != nullptr);
    CHECK(std::get<double>(*session.prediction()->value) == Approx(answers.wrong));
}

TEST_CASE("a choice is made with C and committed with Enter", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = at_question(*window, QuestionKind::choice);
    window->key(Key::enter); // nothing is chosen yet
    CHECK(session.state() == QuestionState::open);
    window->key(Key::c);
    CHECK(window->viewer.lesson_form().choice == 0);
    CHECK(session.state() == QuestionState::open);
    window->key(Key::c);
    CHECK(window->viewer.lesson_form().choice == 1);
    window->key(Key::c, false, true);
    CHECK(window->viewer.lesson_form().choice == 0);
    window->key(Key::enter);
    CHECK(session.state() != QuestionState::open);
    CHECK(session.prediction() != nullptr);
}

TEST_CASE("pixels are picked by nudging, marked with X and committed with Enter", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = at_question(*window, QuestionKind::pixels);
    window->viewer.select({5, 7});
    window->key(Key::x);
    window->key(Key::right, false, false, true);
    window->key(Key::x);
    CHECK(window->viewer.lesson_form().picked == std::vector<PixelPos>{{5, 7}, {6, 7}});
    window->key(Key::x); // takes it back
    CHECK(window->viewer.lesson_form().picked == std::vector<PixelPos>{{5, 7}});
    window->key(Key::enter);
    CHECK(session.state() == QuestionState::retry);
}

TEST_CASE("Ctrl+Enter says \"I don't know\" and reveals", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = at_question(*window, QuestionKind::value);
    window->key(Key::enter, true);
    CHECK(session.state() == QuestionState::revealed);
    REQUIRE(session.prediction() != nullptr);
    CHECK_FALSE(session.prediction()->value.has_value());
}

TEST_CASE("every step of a lesson moves the playhead where it stands, both ways", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = *window->viewer.session();
    std::vector<trace::StepId> stands;
    while (true) {
        CHECK(window->step() == session.stand());
        stands.push_back(window->step());
        window->key(Key::left); // stepping on one's own does not disturb the lesson
        if (session.index() + 1 == session.lesson().steps.size()) {
            break;
        }
        window->key(Key::page_down);
    }
    CHECK(std::set<trace::StepId>(stands.begin(), stands.end()).size() > 3);
    for (std::size_t i = stands.size() - 1; i-- > 0;) {
        window->key(Key::page_up);
        CHECK(window->step() == stands[i]);
    }
}

TEST_CASE("what a lesson highlights is framed, and nothing is without a lesson", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = *window->viewer.session();
    bool any = false;
    while (true) {
        for (const std::string& name : session.step().highlight) {
            CHECK(viewer::points_at(window->viewer, name));
            any = true;
        }
        CHECK_FALSE(viewer::points_at(window->viewer, "no such quantity"));
        CHECK(window->host.cut_text().empty());
        if (session.index() + 1 == session.lesson().steps.size()) {
            break;
        }
        window->key(Key::page_down);
    }
    CHECK(any);
    CHECK_FALSE(viewer::points_at(Window::with_scene()->viewer, "ndc.x"));
}

TEST_CASE("a frame around what is highlighted changes the picture", "[app]") {
    const auto window = with_lesson();
    lesson::Session& session = *window->viewer.session();
    const auto framed = [&](const char* quantity) {
        const lesson::LessonStep& step = session.step();
        return std::ranges::find(step.highlight, quantity) != step.highlight.end();
    };
    while (!framed("E01")) {
        window->key(Key::page_down);
    }
    window->viewer.state().left = viewer::LeftTab::scene; // the frame is the inspector's
    window->settle();
    const ImU32 accent = window->viewer.theme()[viewer::Tone::accent];
    const auto accents = [&] {
        const host::Picture picture = window->host.picture();
        const viewer::Rect area = window->viewer.layout().inspector;
        int count = 0;
        for (int y = static_cast<int>(area.y) + 40; y < static_cast<int>(area.bottom()); ++y) {
            for (int x = static_cast<int>(area.x); x < static_cast<int>(area.right()); ++x) {
                count += picture.at(x, y) == accent ? 1 : 0;
            }
        }
        return count;
    };
    const int with = accents();
    window->viewer.state().tab = viewer::InspectorTab::state; // nothing pointed at there
    window->settle();
    CHECK(with > accents() + 100);
}
