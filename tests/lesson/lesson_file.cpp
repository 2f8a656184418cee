#include "app/lesson/lesson.hpp"
#include "tests/support/catch.hpp"

namespace hs::lesson {

namespace {

constexpr const char* text = R"(# Page title

```halfspace
title = "Page title"
order = 3
minutes = 5
prerequisites = ["01-a"]
objectives = ["say what", "say why"]
```

Before the steps.

## One

```halfspace
scene = "a.toml"
settings = { depth.test = "less", camera.eye = [0, 0, 4.5] }
step = "start"
view = "edge1"
panel = "history"
highlight = "ndc"
```

Words.

```halfspace
note = "Slow down here."
[question]
kind = "pass-fail"
prompt = "Well?"
answer = { quantity = "covered", of = "triangle 0 / pixel 1,2" }
reveal = "{{right}}"
```

More words.

## Two

```halfspace
settings = { cull = "back" }
```

## Three

```halfspace
scene = "b.toml"
```
)";

Lesson read() {
    return parse_lesson(text, "course/lesson.md").value();
}

} // namespace

TEST_CASE("the first block describes the lesson", "[lesson]") {
    const Lesson lesson = read();

    CHECK(lesson.title == "Page title");
    CHECK(lesson.order == 3);
    CHECK(lesson.minutes == 5);
    CHECK(lesson.prerequisites == std::vector<std::string>{"01-a"});
    CHECK(lesson.objectives.size() == 2);
    CHECK(to_plain_text(lesson.introduction) == "Before the steps.\n");
}

TEST_CASE("a second-level heading begins a step, which may hold several blocks", "[lesson]") {
    const Lesson lesson = read();

    REQUIRE(lesson.steps.size() == 3);
    const LessonStep& step = lesson.steps[0];
    CHECK(step.title == "One");
    CHECK(step.place.line == 13);
    CHECK(step.stand == "start");
    CHECK(step.stand_place.line == 18);
    CHECK(step.view == View::edge1);
    CHECK(step.panel == Panel::history);
    CHECK(step.highlight == std::vector<std::string>{"ndc"});
    CHECK(step.note == "Slow down here.");
    CHECK(to_plain_text(step.narration) == "Words.\n\nMore words.\n");
    REQUIRE(step.question.has_value());
    CHECK(step.question->choices.size() == 2);
}

TEST_CASE("settings hold until a step names a scene", "[lesson]") {
    const Lesson lesson = read();

    const SceneChoice second = scene_of_step(lesson, 1);
    CHECK(second.file == "course/a.toml");
    REQUIRE(second.assignments.size() == 3);
    CHECK(second.assignments[0].path == "camera.eye");
    CHECK(second.assignments[0].value == "[ 0, 0, 4.5 ]");
    CHECK(second.assignments[1].path == "depth.test");
    CHECK(second.assignments[2].path == "cull");

    const SceneChoice third = scene_of_step(lesson, 2);
    CHECK(third.file == "course/b.toml");
    CHECK(third.assignments.empty());
}

} // namespace hs::lesson
