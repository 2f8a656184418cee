// The lesson: what it says, what it asks, what was predicted and what came out.
#include "app/lesson/session.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/rich_text.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/widgets.hpp"
#include "core/explain/numbers.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <utility>

namespace hs::viewer {
namespace {

using lesson::QuestionKind;
using lesson::QuestionState;
using lesson::Session;

void draw_steps(Context& context, Session& session) {
    const Theme& theme = context.theme;
    const lesson::Lesson& lesson = session.lesson();
    caption(theme, fmt::format("step {} of {}", session.index() + 1, lesson.steps.size()));
    ImGui::SetNextItemWidth(-1.0F);
    const std::string current = fmt::format("{}. {}", session.index() + 1, session.step().title);
    if (ImGui::BeginCombo("##steps", current.c_str())) {
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const std::string label = fmt::format("{}. {}", i + 1, lesson.steps[i].title);
            if (ImGui::Selectable(label.c_str(), i == session.index())) {
                context.viewer.go_to_lesson_step(i);
            }
        }
        ImGui::EndCombo();
    }
}

void draw_input(Context& context, const lesson::Question& question, LessonForm& form) {
    const Theme& theme = context.theme;
    if (question.kind == QuestionKind::value) {
        const UseFont use{theme.fonts.mono};
        ImGui::SetNextItemWidth(theme.units(36));
        if (std::exchange(form.wants_keyboard, false)) {
            ImGui::SetKeyboardFocusHere();
        }
        const bool entered = ImGui::InputText(
            "##number",
            &form.number,
            ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_EnterReturnsTrue |
                ImGuiInputTextFlags_AutoSelectAll
        );
        if (entered) {
            context.viewer.run(Command::lesson_answer);
        }
        if (!question.unit.empty()) {
            ImGui::SameLine();
            ImGui::TextUnformatted(question.unit.c_str());
        }
    } else if (question.kind == QuestionKind::pixels) {
        words(
            theme,
            fmt::format(
                "Click pixels in the screen view, or nudge (Alt+arrows) and press X; once more "
                "takes "
                "one back. Picked: {}.",
                form.picked.size()
            ),
            Tone::quiet
        );
    } else {
        for (std::size_t i = 0; i < question.choices.size(); ++i) {
            const bool chosen = form.choice == static_cast<int>(i);
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::RadioButton("##choice", chosen)) {
                form.choice = static_cast<int>(i);
            }
            ImGui::SameLine();
            words(theme, question.choices[i].text);
            if (ImGui::IsItemClicked()) {
                form.choice = static_cast<int>(i);
            }
            ImGui::PopID();
        }
    }
}

/// What a student answered, in the question's own words.
std::string answer_text(const lesson::Question& question, const lesson::Answer& answer) {
    if (!answer.value) {
        return "I don't know";
    }
    std::string printed = lesson::print_value(*answer.value);
    for (const lesson::Choice& choice : question.choices) {
        if (choice.value == printed) {
            return choice.text;
        }
    }
    return printed;
}

void draw_result(Context& context, Session& session) {
    const Theme& theme = context.theme;
    const lesson::Question& question = *session.step().question;
    const lesson::Grade* grade = session.grade();
    if (const lesson::Answer* prediction = session.prediction()) {
        row(theme, "prediction", answer_text(question, *prediction));
    }
    if (grade != nullptr) {
        const bool right = grade->right;
        words(theme, right ? "▲ right" : "▼ not yet", right ? Tone::pass : Tone::fail);
        if (!grade->misconception.empty()) {
            words(theme, "This comes from: " + grade->misconception + ".", Tone::fail);
        }
        if (!grade->message.empty()) {
            words(theme, grade->message);
        }
    }
    if (session.state() == QuestionState::revealed) {
        if (session.right_answer()) {
            row(theme, "answer", answer_text(question, {*session.right_answer()}));
        }
        draw_document(theme, session.reveal());
    }
}

void draw_question(Context& context, Session& session) {
    const Theme& theme = context.theme;
    const QuestionState state = session.state();
    if (state == QuestionState::none) {
        return;
    }
    ImGui::Separator();
    heading(theme, "Question");
    draw_document(theme, session.prompt());
    if (session.can_answer()) {
        LessonForm& form = context.viewer.lesson_form();
        const lesson::Question& question = *session.step().question;
        draw_input(context, question, form);
        const Draft draft = draft_of(question, form);
        const char* const label = state == QuestionState::retry ? "submit again" : "submit";
        if (button(theme, label, "compare with the trace (Enter)", draft.why)) {
            session.answer(*draft.value);
        }
        ImGui::SameLine();
        if (button(theme, "I don't know", "shows the answer with its numbers (Ctrl+Enter)")) {
            session.give_up();
        }
    }
    draw_result(context, session);
}

void draw_changes(Context& context, Session& session) {
    const Theme& theme = context.theme;
    const std::vector<lesson::Change>& changes = session.step().changes;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Separator();
        heading(theme, "Change");
        draw_document(theme, session.change_prompt(i));
        std::vector<Segment> list;
        std::vector<std::string> tips; // live as long as the list that points to them
        tips.reserve(changes[i].values.size());
        for (std::size_t k = 0; k < changes[i].values.size(); ++k) {
            const std::string& value = changes[i].values[k];
            tips.push_back(fmt::format("{} = {}", changes[i].key, value));
            const std::string& label = changes[i].labels.empty() ? value : changes[i].labels[k];
            list.push_back({label, tips.back(), ""});
        }
        const std::optional<std::size_t> now = session.changed(i);
        const int chosen = now ? static_cast<int>(*now) : -1;
        const int clicked = segments(theme, "values", list, chosen);
        if (clicked >= 0) {
            const bool undo = clicked == chosen;
            session.change(
                i, undo ? std::nullopt : std::optional{static_cast<std::size_t>(clicked)}
            );
        }
        row(theme, "now", session.watched(i), Tone::accent);
        ImGui::PopID();
    }
}

void draw_turning(Context& context) {
    ImGui::Dummy({0.0F, context.theme.units(2)});
    for (const Command command : {Command::lesson_previous, Command::lesson_next}) {
        const CommandInfo& info = command_info(command);
        const bool next = command == Command::lesson_next;
        const std::string tip = fmt::format("{} ({})", info.name, to_string(info.key));
        if (button(
                context.theme, next ? "next ▶" : "◀ previous", tip, context.viewer.why_not(command)
            )) {
            context.viewer.run(command);
        }
        if (!next) {
            ImGui::SameLine();
        }
    }
}

} // namespace

void draw_lesson(Context& context) {
    Session& session = *context.viewer.session();
    const Theme& theme = context.theme;
    context.viewer.lesson_form().follow(session.index());
    heading(theme, session.lesson().title);
    draw_steps(context, session);
    ImGui::Dummy({0.0F, theme.units(1)});
    if (session.index() == 0) {
        draw_document(theme, session.lesson().introduction);
    }
    draw_document(theme, session.narration());
    draw_question(context, session);
    draw_changes(context, session);
    draw_turning(context);
}

} // namespace hs::viewer
