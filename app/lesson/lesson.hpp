// A lesson: a folder with `lesson.md`, scenes beside it. Markdown whose fenced `halfspace` blocks
// (TOML) say which scene, where to stand, what to ask. docs/lessons.md is the recipe for authors.
#pragma once

#include "app/lesson/document.hpp"
#include "core/base/diagnostic.hpp"
#include "core/base/named.hpp"
#include "core/base/pixel.hpp"
#include "core/scene/scene_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hs::lesson {

/// A quantity of the trace (quantity.hpp has the closed list) of something in the frame, possibly
/// under other settings: answers, wrong answers and checks are expressions, never literals.
struct Expression {
    std::string quantity; ///< "ndc.x"
    std::string of;       ///< "object 0 / vertex 1"; parts left out come from the step stood on
    double times = 1.0;   ///< numbers only: times · quantity + plus
    double plus = 0.0;
    std::vector<scene::Assignment> settings; ///< read from the same scene with these changed
    Place place;
};

enum class QuestionKind : std::uint8_t {
    choice,
    value,
    pixels,
    pass_fail
};

/// One of the answers offered. `value` is what the expression prints when this one is right.
struct Choice {
    std::string text;
    std::string value;
};

/// A wrong answer with a known cause.
struct WrongAnswer {
    std::string misconception;        ///< its name: "no divide by w"
    std::optional<Expression> answer; ///< how it comes about; empty when `choice` says it
    std::string choice;               ///< the value of a choice
    std::string message;              ///< Markdown with placeholders
    Place place;
};

struct Question {
    QuestionKind kind = QuestionKind::value;
    std::string prompt; ///< Markdown with placeholders
    Expression answer;
    double tolerance = 0.0;          ///< value
    std::string unit;                ///< value: shown behind the field, may be empty
    std::vector<Choice> choices;     ///< choice and pass-fail
    std::optional<PixelRect> region; ///< pixels: only these are asked
    std::vector<WrongAnswer> wrong;
    std::string reveal; ///< Markdown with placeholders: the formula, filled in
    Place place;
};

/// Something the student may change, and what to watch meanwhile.
struct Change {
    std::string prompt;              ///< Markdown with placeholders
    std::string key;                 ///< path of an entry of the scene, as for --set
    std::vector<std::string> values; ///< to choose from, at least two: TOML, strings without quotes
    std::vector<std::string> labels; ///< what their buttons say, one for each; may be empty
    Expression watch;
    Place place;
};

/// A claim verified without a display.
struct Check {
    std::string claim; ///< a sentence that can be false
    Expression left;
    enum class Relation : std::uint8_t {
        equals,
        less_than,
        greater_than
    };
    Relation relation = Relation::equals;
    std::optional<Expression> right; ///< empty: the literal
    std::string literal;             ///< a number or a name, as print_value would print it
    double tolerance = 0.0;
    Place place;
};

/// What the screen or space view is to show.
enum class View : std::uint8_t {
    unchanged,
    color,
    depth,
    triangle,
    overdraw,
    complexity,
    edge0,
    edge1,
    edge2,
    barycentric,
    object,
    world,
    eye,
    clip,
    ndc,
    projection,
    precision,
    clipping,
    cost,
    registers,
    normals,
    order,
    search,
};

/// Which inspector to bring to the front.
enum class Panel : std::uint8_t {
    unchanged,
    vertex,
    triangle,
    fragment,
    values,
    history,
    matrices,
    state
};

struct LessonStep {
    std::string title;
    Document narration; ///< with placeholders; Session::narration() has them filled in
    std::string scene;  ///< relative to the lesson's folder; "": as in the step before
    /// Changes to the scene; they hold in the following steps too, until a step names a scene.
    std::vector<scene::Assignment> settings;
    std::string stand; ///< the step path to stand on; "": `end`
    View view = View::unchanged;
    Panel panel = Panel::unchanged;
    std::vector<std::string> highlight; ///< quantities or their first words: "ndc.x", "ndc"
    std::vector<std::string> hide;      ///< likewise; shown as `?` until the question is revealed
    std::optional<Question> question;
    std::vector<Change> changes;
    std::vector<Check> checks;
    std::string note;  ///< for the presenter, Markdown
    Place place;       ///< of the heading
    Place scene_place; ///< of `scene`, `settings` and `step` in their block, for errors
    Place settings_place;
    Place stand_place;
};

struct Lesson {
    std::filesystem::path folder;
    std::filesystem::path file; ///< lesson.md, as messages name it
    std::string title;
    int order = 0;
    int minutes = 0;
    std::vector<std::string> prerequisites; ///< names of lesson folders
    std::vector<std::string> objectives;    ///< what the student can do afterwards
    Document introduction;                  ///< what stands before the first step
    std::vector<LessonStep> steps;          ///< at least one
};

/// Opens a lesson's folder or its lesson.md. Errors: everything wrong with the file, located.
/// Whether its scenes load and its answers hold is check_lesson's business (check.hpp).
Result<Lesson> load_lesson(const std::filesystem::path& path);

/// The same from text; `file` names it in messages, scenes resolve against its folder.
Result<Lesson> parse_lesson(std::string_view text, const std::filesystem::path& file);

/// The scene a step shows: the last one named, with all changes since.
struct SceneChoice {
    std::filesystem::path file;
    std::vector<scene::Assignment> assignments;
};
SceneChoice scene_of_step(const Lesson& lesson, std::size_t step);

} // namespace hs::lesson

namespace hs {
template <>
std::span<const Named<lesson::QuestionKind>> names<lesson::QuestionKind>();
template <>
std::span<const Named<lesson::View>> names<lesson::View>();
template <>
std::span<const Named<lesson::Panel>> names<lesson::Panel>();
} // namespace hs
