#include "app/lesson/session.hpp"

#include "core/trace/player.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/paths.hpp"

namespace hs::lesson {

namespace {

/// Two steps around the golden walk's triangle, small enough to read here.
constexpr const char* text = R"(```halfspace
title = "Two steps"
minutes = 1
objectives = ["be tested"]
```

## First

```halfspace
scene = "triangle.toml"
step = "object 0 / triangle 0 / fragment 8,6 / depth test"
hide = ["ndc"]
[question]
kind = "value"
prompt = "x of vertex 2, which is {{ndc.x of vertex 2}}?"
answer = { quantity = "ndc.x", of = "vertex 2" }
tolerance = 0.01
reveal = "It is {{right}}, {{clip.x of vertex 2}} / {{clip.w of vertex 2}}."
[[question.wrong]]
misconception = "no divide by w"
answer = { quantity = "clip.x", of = "vertex 2" }
message = "{{wrong}} is clip x."
[[change]]
prompt = "Change the test."
key = "depth.test"
values = ["less", "greater"]
watch = { quantity = "fragments written" }
[[change]]
prompt = "Empty the picture."
key = "cull"
values = ["none", "front"]
watch = { quantity = "fragments" }
```

NDC x is {{ndc.x of vertex 2}}, clip x is {{clip.x of vertex 2}}, {{fragments written}} fragments
were written.

## Second

```halfspace
step = "object 0 / triangle 0"
[question]
kind = "pixels"
prompt = "Row 7?"
region = [0, 7, 16, 1]
answer = { quantity = "covered pixels", of = "triangle 0" }
reveal = "{{right}}"
[[question.wrong]]
misconception = "every edge keeps its ties"
answer = { quantity = "touched pixels", of = "triangle 0" }
message = "Ties."
```

Text.
)";

std::shared_ptr<const Lesson> lesson() {
    const auto folder = test::source_dir() / "lessons/01-one-triangle";
    return std::make_shared<const Lesson>(parse_lesson(text, folder / "lesson.md").value());
}

PixelSet row_7(int first, int last) {
    std::vector<PixelPos> pixels;
    for (int x = first; x <= last; ++x) {
        pixels.push_back({x, 7});
    }
    return make_pixel_set(std::move(pixels));
}

} // namespace

TEST_CASE("a session stands where the step says", "[lesson]") {
    const Session session(lesson());

    REQUIRE(session.problems().empty());
    const trace::Step step = describe_step(*session.recording(), session.stand());
    CHECK(step.kind == trace::StepKind::depth_test);
    CHECK(step.pixel == PixelPos{8, 6});
}

TEST_CASE("what is hidden reads ? until the question is revealed", "[lesson]") {
    Session session(lesson());

    CHECK(session.is_hidden("ndc.x"));
    CHECK_FALSE(session.is_hidden("clip.x"));
    CHECK(to_plain_text(session.narration()).starts_with("NDC x is ?, clip x is 2,"));
    CHECK(to_plain_text(session.prompt()) == "x of vertex 2, which is ??\n");
    CHECK(session.reveal().empty());
    CHECK_FALSE(session.right_answer().has_value());

    session.give_up();

    CHECK_FALSE(session.is_hidden("ndc.x"));
    CHECK(to_plain_text(session.narration()).starts_with("NDC x is 0.25, clip x is 2,"));
    CHECK(to_plain_text(session.reveal()) == "It is 0.25, 2 / 8.\n");
    CHECK(session.right_answer() == Value{0.25});
}

TEST_CASE("the first answer is kept as the prediction, whatever follows", "[lesson]") {
    Session session(lesson());

    session.answer(2.0);
    session.answer(0.25);

    CHECK(session.prediction()->value == Value{2.0});
    CHECK(session.grade()->right);
    session.next();
    session.previous();
    CHECK(session.prediction()->value == Value{2.0});
    CHECK(session.state() == QuestionState::revealed);
}

TEST_CASE("a recognized misconception is answered with its name and numbers", "[lesson]") {
    Session session(lesson());

    const Grade& grade = session.answer(2.0);

    CHECK_FALSE(grade.right);
    CHECK(grade.misconception == "no divide by w");
    CHECK(grade.message == "2 is clip x.");
}

TEST_CASE("an unknown wrong answer is wrong without a name", "[lesson]") {
    Session session(lesson());

    CHECK_FALSE(session.answer(77.0).right);
    CHECK(session.grade()->misconception.empty());
}

TEST_CASE("an answer within the tolerance is right, one beyond it is wrong", "[lesson]") {
    Session near(lesson());
    Session far(lesson());

    CHECK(near.answer(0.2599).right);
    CHECK_FALSE(far.answer(0.2601).right);
}

TEST_CASE("two wrong answers reveal", "[lesson]") {
    Session session(lesson());

    session.answer(1.0);
    CHECK(session.state() == QuestionState::retry);
    CHECK(session.can_answer());
    session.answer(2.0);

    CHECK(session.state() == QuestionState::revealed);
    CHECK_FALSE(session.can_answer());
}

TEST_CASE("I don't know reveals at once and is logged as such", "[lesson]") {
    Session session(lesson());

    session.give_up();

    CHECK(session.state() == QuestionState::revealed);
    REQUIRE(session.log().size() == 1);
    CHECK_FALSE(session.log()[0].answer.value.has_value());
    CHECK_FALSE(session.log()[0].grade.right);
}

TEST_CASE("the log holds every answer in order", "[lesson]") {
    Session session(lesson());

    session.answer(2.0);
    session.answer(0.25);
    session.next();
    session.answer(row_7(5, 10));

    REQUIRE(session.log().size() == 3);
    CHECK(session.log()[0].attempt == 1);
    CHECK(session.log()[1].attempt == 2);
    CHECK(session.log()[1].grade.right);
    CHECK(session.log()[2].step == 1);
    CHECK(session.log()[2].grade.right);
}

TEST_CASE("wrong pixels are named with the edge that decides", "[lesson]") {
    Session session(lesson());
    session.next();

    const Grade& grade = session.answer(row_7(6, 12));

    CHECK_FALSE(grade.right);
    CHECK(grade.missing == PixelSet{{5, 7}});
    CHECK(grade.extra == PixelSet{{11, 7}, {12, 7}});
    CHECK(
        grade.message == "Pixel (11, 7): E01 = 16, E12 = 0, E20 = 48; E12 is 0 and that edge does "
                         "not own its ties: not covered.\n"
                         "Pixel (12, 7): E01 = 14, E12 = −6; E12 is negative: outside that edge.\n"
                         "Pixel (5, 7): E01 = 28, E12 = 36, E20 = 0; E20 is 0 and that edge owns "
                         "its ties: covered."
    );
}

TEST_CASE("pixels outside the asked region do not count", "[lesson]") {
    Session session(lesson());
    session.next();

    PixelSet picked = row_7(5, 10);
    picked.push_back({0, 15});

    CHECK(session.answer(picked).right);
    CHECK(session.right_answer() == Value{row_7(5, 10)});
}

TEST_CASE("the top-left rule ignored is recognized by the pixels picked", "[lesson]") {
    Session session(lesson());
    session.next();

    CHECK(session.answer(row_7(5, 11)).misconception == "every edge keeps its ties");
}

TEST_CASE("a change records the frame anew, and taking it back restores it", "[lesson]") {
    Session session(lesson());
    const auto before = session.recording();
    const unsigned revision = session.revision();
    CHECK(session.watched(0) == "34");

    session.change(0, 1);

    CHECK(session.revision() > revision);
    CHECK(session.watched(0) == "0");
    CHECK(session.changed(0) == std::optional<std::size_t>{1});
    CHECK(to_plain_text(session.narration()).find("0 fragments") != std::string::npos);

    session.change(0, std::nullopt);
    CHECK(session.recording() == before);
}

TEST_CASE("a change does not change what the question asks", "[lesson]") {
    Session session(lesson());
    session.next();
    session.previous();

    session.change(1, 1);

    CHECK(session.can_answer());
    CHECK(session.answer(0.25).right);
}

TEST_CASE("where the changed frame lacks the step, the playhead goes to the end", "[lesson]") {
    Session session(lesson());

    session.change(1, 1);

    CHECK(session.problems().empty());
    CHECK(session.stand() == session.recording()->end_step);
}

TEST_CASE(
    "a session of a lesson with a missing scene says so and can be walked through", "[lesson]"
) {
    std::string broken = text;
    broken.replace(broken.find("triangle.toml"), 13, "nowhere.toml!");
    const auto folder = test::source_dir() / "lessons/01-one-triangle";
    Session session(
        std::make_shared<const Lesson>(parse_lesson(broken, folder / "lesson.md").value())
    );

    CHECK(session.recording() == nullptr);
    CHECK_FALSE(session.problems().empty());
    CHECK_FALSE(session.can_answer());
    CHECK(session.next());
    CHECK_FALSE(session.next());
}

TEST_CASE("going past the last step stays on the last step", "[lesson]") {
    Session session(lesson());

    session.go_to(99);

    CHECK(session.index() == 1);
    CHECK(session.step().title == "Second");
}

} // namespace hs::lesson
