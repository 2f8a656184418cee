// What keys, menus and buttons do.
#include "app/lesson/session.hpp"
#include "app/viewer/export_job.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/search.hpp"
#include "app/viewer/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hs::viewer {
namespace {

constexpr float zoom_factor = 1.25F;
constexpr float largest_zoom = 256.0F;
constexpr float smallest_zoom = 0.05F;

bool needs_recording(Command command) {
    const CommandGroup group = command_info(command).group;
    const bool of_window = command == Command::toggle_side || command == Command::next_side;
    return (group == CommandGroup::stepping || group == CommandGroup::pixel ||
            group == CommandGroup::view || command == Command::export_shown) &&
           !of_window;
}

} // namespace

std::string Viewer::why_not(Command command) const {
    if (needs_recording(command) && !document_.is_open()) {
        return "Nothing is open yet: open a scene, a mesh or a lesson first.";
    }
    if (command == Command::undo || command == Command::redo) {
        const bool empty = command == Command::undo ? done_.empty() : undone_.empty();
        return busy()  ? "The frame is being recorded."
               : empty ? fmt::format(
                             "Nothing has been {}.", command == Command::undo ? "changed" : "undone"
                         )
                       : "";
    }
    const bool of_lesson = command_info(command).group == CommandGroup::lesson;
    if (of_lesson && session_ == nullptr) {
        return "No lesson is open.";
    }
    if (command == Command::lesson_next &&
        session_->index() + 1 == session_->lesson().steps.size()) {
        return "This is the lesson's last step.";
    }
    if (command == Command::lesson_previous && session_->index() == 0) {
        return "This is the lesson's first step.";
    }
    if (of_lesson) {
        return why_no_answer(command);
    }
    if (!needs_recording(command)) {
        return "";
    }
    if (command == Command::toggle_difference && !shows_beside()) {
        return "No second frame stands beside this one.";
    }
    const bool nudges = command >= Command::nudge_left && command <= Command::nudge_down;
    if (nudges && !state_.selected) {
        return "No pixel is picked: click one in the screen view.";
    }
    if (command == Command::next_match || command == Command::previous_match) {
        return why_no_match(command);
    }
    if (command >= Command::next_value && command <= Command::value_back) {
        return why_no_value(command);
    }
    const trace::StepId step = document_.player().step();
    const bool forward = command == Command::step_forward ||
                         command == Command::operation_forward ||
                         command == Command::triangle_forward || command == Command::go_end;
    const bool back = command == Command::step_back || command == Command::operation_back ||
                      command == Command::triangle_back || command == Command::go_start;
    if (forward && step == document_.player().end()) {
        return "The playhead stands at the end.";
    }
    return back && step == 0 ? "The playhead stands at the start." : "";
}

/// Why there is no match to go to. Precondition: a document is open.
std::string Viewer::why_no_match(Command command) const {
    if (!search_->is_of(document_)) {
        return "Nothing has been searched for: Ctrl+F asks what.";
    }
    const bool forward = command == Command::next_match;
    const auto direction = forward ? trace::Direction::forward : trace::Direction::backward;
    if (search_->find(document_.player().step(), direction)) {
        return "";
    }
    return forward ? "Nothing after this step matches." : "Nothing before this step matches.";
}

/// Why the tab of values has nothing to do. Precondition: a document is open.
std::string Viewer::why_no_value(Command command) const {
    const ValueTrail& trail = state_.values;
    if (command == Command::value_back) {
        return trail.back.empty() ? "No operand has been followed." : "";
    }
    if (command != Command::next_value && command != Command::previous_value &&
        trail.open.empty()) {
        return "No value is open: E opens the step's values one by one.";
    }
    return command == Command::follow_operand && trail.operand < 0
               ? "No operand is chosen: O chooses one after the other."
               : "";
}

/// Why the lesson's question cannot be answered so; empty for commands that turn its pages.
std::string Viewer::why_no_answer(Command command) const {
    if (command == Command::lesson_next || command == Command::lesson_previous) {
        return "";
    }
    if (!session_->can_answer()) {
        return "There is no question to answer.";
    }
    const lesson::QuestionKind kind = session_->step().question->kind;
    const bool chooses =
        command == Command::lesson_choose_next || command == Command::lesson_choose_previous;
    const bool has_choices =
        kind == lesson::QuestionKind::choice || kind == lesson::QuestionKind::pass_fail;
    if (chooses && !has_choices) {
        return "The question has no answers to choose from.";
    }
    if (command == Command::lesson_mark && kind != lesson::QuestionKind::pixels) {
        return "The question does not ask for pixels.";
    }
    return command == Command::lesson_mark && !state_.selected
               ? "No pixel is picked: click one in the screen view."
               : "";
}

void Viewer::key(const KeyPress& press) {
    const bool typing = ImGui::GetIO().WantTextInput;
    if (typing && press.key != Key::escape) {
        return; // the text field has the keyboard
    }
    if (const std::optional<Command> command = find_command(press)) {
        run(*command);
    }
}

void Viewer::text(std::string_view text) {
    if (text == "?" && !ImGui::GetIO().WantTextInput) {
        run(Command::keys);
    }
}

void Viewer::run(Command command) {
    if (!why_not(command).empty()) {
        return;
    }
    if (!run_stepping(command) && !run_value(command) && !run_view(command) &&
        !run_lesson(command)) {
        run_program(command);
    }
}

void Viewer::step(trace::Granularity granularity, trace::Direction direction) {
    state_.playing = false;
    document_.player().advance(granularity, direction);
}

void Viewer::nudge(int dx, int dy) {
    const PixelPos moved{state_.selected->x + dx, state_.selected->y + dy};
    if (document_.recording().settings().image().contains(moved)) {
        select(moved);
    }
}

void Viewer::change_granularity(int direction) {
    const int last = static_cast<int>(trace::Granularity::operation);
    const int changed = std::clamp(static_cast<int>(state_.granularity) + direction, 0, last);
    state_.granularity = static_cast<trace::Granularity>(changed);
}

bool Viewer::run_stepping(Command command) {
    using trace::Direction;
    using trace::Granularity;
    const auto is = [command](Command other) { return command == other; };
    if (is(Command::step_forward)) {
        step(state_.granularity, Direction::forward);
    } else if (is(Command::step_back)) {
        step(state_.granularity, Direction::backward);
    } else if (is(Command::operation_forward)) {
        step(Granularity::operation, Direction::forward);
    } else if (is(Command::operation_back)) {
        step(Granularity::operation, Direction::backward);
    } else if (is(Command::triangle_forward)) {
        step(Granularity::triangle, Direction::forward);
    } else if (is(Command::triangle_back)) {
        step(Granularity::triangle, Direction::backward);
    } else if (is(Command::coarser)) {
        change_granularity(-1);
    } else if (is(Command::finer)) {
        change_granularity(1);
    } else if (is(Command::go_start)) {
        seek(0);
    } else if (is(Command::next_match) || is(Command::previous_match)) {
        const auto direction = is(Command::next_match) ? Direction::forward : Direction::backward;
        seek(*search_->find(document_.player().step(), direction)); // why_not has seen to it
    } else if (is(Command::go_end)) {
        seek(document_.player().end());
    } else if (is(Command::play)) {
        const bool at_end = document_.player().step() == document_.player().end();
        if (!state_.playing && at_end) {
            seek(0);
        }
        state_.playing = !state_.playing;
    } else {
        return false;
    }
    return true;
}

/// Opens the next value, or the first.
void Viewer::choose_value(int by) {
    const auto& values = document_.values();
    const auto count = static_cast<int>(values.size());
    if (count == 0) {
        return;
    }
    ValueTrail& trail = state_.values;
    const auto open = std::ranges::find(values, trail.open, &explain::StepValue::name);
    const auto at = static_cast<int>(open - values.begin());
    const int next = at == count ? (by > 0 ? 0 : count - 1) : (at + by + count) % count;
    trail.open = values[static_cast<std::size_t>(next)].name;
    trail.operand = -1;
    trail.scroll = true;
}

void Viewer::choose_operand(int by) {
    const explain::StepValue* value = explain::find_value(document_.values(), state_.values.open);
    if (value == nullptr) {
        return;
    }
    const auto count = static_cast<int>(explain::operands_of(value->expression).size());
    int& chosen = state_.values.operand;
    chosen = count == 0 ? -1 : chosen < 0 && by < 0 ? count - 1 : (chosen + by + count) % count;
}

void Viewer::return_to_value() {
    ValueTrail& trail = state_.values;
    const ValueTrail::Stop stop = std::move(trail.back.back());
    trail.back.pop_back();
    if (!go_to(stop.step)) { // no complaint: the frame still has the step
        trail.open = stop.value;
        trail.operand = -1;
        trail.scroll = true;
    }
}

bool Viewer::run_value(Command command) {
    const auto is = [command](Command other) { return command == other; };
    if (is(Command::why)) {
        state_.show_why = !state_.show_why || state_.tab != InspectorTab::history;
        state_.tab = InspectorTab::history;
        return true;
    }
    if (is(Command::next_value) || is(Command::previous_value)) {
        choose_value(is(Command::next_value) ? 1 : -1);
    } else if (is(Command::next_operand) || is(Command::previous_operand)) {
        choose_operand(is(Command::next_operand) ? 1 : -1);
    } else if (is(Command::follow_operand)) {
        const explain::StepValue* value =
            explain::find_value(document_.values(), state_.values.open);
        if (value != nullptr) {
            const auto operands = explain::operands_of(value->expression);
            follow(operands[static_cast<std::size_t>(state_.values.operand)]->origin);
        }
    } else if (is(Command::value_back)) {
        return_to_value();
    } else {
        return false;
    }
    state_.tab = InspectorTab::values;
    return true;
}

bool Viewer::run_view(Command command) {
    const auto is = [command](Command other) { return command == other; };
    const auto turn = [this](int by) {
        const int next = (static_cast<int>(state_.screen.content) + by + screen_content_count) %
                         screen_content_count;
        state_.screen.content = static_cast<ScreenContent>(next);
    };
    ScreenView& screen = state_.screen;
    if (is(Command::nudge_left)) {
        nudge(-1, 0);
    } else if (is(Command::nudge_right)) {
        nudge(1, 0);
    } else if (is(Command::nudge_up)) {
        nudge(0, -1);
    } else if (is(Command::nudge_down)) {
        nudge(0, 1);
    } else if (is(Command::fit)) {
        screen.fitted = true;
    } else if (is(Command::zoom_in)) {
        screen.fitted = false;
        screen.zoom = std::min(largest_zoom, screen.zoom * zoom_factor);
    } else if (is(Command::zoom_out)) {
        screen.fitted = false;
        screen.zoom = std::max(smallest_zoom, screen.zoom / zoom_factor);
    } else if (is(Command::next_view)) {
        turn(1);
    } else if (is(Command::previous_view)) {
        turn(-1);
    } else if (is(Command::toggle_grid)) {
        screen.show_grid = !screen.show_grid;
    } else if (is(Command::toggle_numbers)) {
        screen.show_numbers = !screen.show_numbers;
    } else if (is(Command::toggle_helpers)) {
        screen.show_helpers = !screen.show_helpers;
    } else if (is(Command::toggle_side)) {
        state_.show_side = !state_.show_side;
    } else if (is(Command::next_side)) {
        const int next = (static_cast<int>(state_.side) + 1) % side_panel_count;
        state_.side = static_cast<SidePanel>(next);
        state_.show_side = true;
    } else if (is(Command::morph)) {
        play_morph();
    } else if (is(Command::toggle_side_view)) {
        state_.space.side = !state_.space.side;
    } else if (is(Command::find)) {
        state_.side = SidePanel::search;
        state_.show_side = true;
        state_.search.wants_keyboard = true;
    } else if (is(Command::toggle_beside)) {
        const bool shown = state_.show_side && state_.side == SidePanel::beside;
        state_.side = shown ? SidePanel::space : SidePanel::beside;
        state_.show_side = true;
    } else if (is(Command::toggle_difference)) {
        state_.beside.show_difference = !state_.beside.show_difference;
    } else {
        return false;
    }
    return true;
}

/// Slowly, for an audience: to the end that is farther away.
void Viewer::play_morph() {
    constexpr float seconds = 4.0F;
    state_.side = SidePanel::space;
    state_.show_side = true;
    if (!is_on_the_way(state_.space.space)) {
        viewer::show_space(state_.space, Space::eye);
    }
    const float goal = state_.space.morph_goal.value_or(state_.space.morph);
    viewer::show_space(state_.space, goal < 1.0F ? Space::ndc : Space::eye, seconds);
}

void Viewer::choose_answer(int by) {
    const auto count = static_cast<int>(session_->step().question->choices.size());
    int& choice = lesson_form_->choice;
    choice = choice < 0 && by < 0 ? count - 1 : (choice + by + count) % count;
}

/// What is written is handed in; where nothing is, the field takes the keyboard.
void Viewer::hand_in_answer() {
    const Draft draft = draft_of(*session_->step().question, *lesson_form_);
    const bool typing = ImGui::GetIO().WantTextInput;
    const bool number = session_->step().question->kind == lesson::QuestionKind::value;
    if (number && !typing) {
        lesson_form_->wants_keyboard = true;
    } else if (draft.value) {
        session_->answer(*draft.value);
    }
}

bool Viewer::run_lesson(Command command) {
    const auto is = [command](Command other) { return command == other; };
    if (is(Command::lesson_next)) {
        go_to_lesson_step(session_->index() + 1);
    } else if (is(Command::lesson_previous)) {
        go_to_lesson_step(session_->index() - 1);
    } else if (is(Command::lesson_answer)) {
        hand_in_answer();
    } else if (is(Command::lesson_give_up)) {
        session_->give_up();
    } else if (is(Command::lesson_choose_next)) {
        choose_answer(1);
    } else if (is(Command::lesson_choose_previous)) {
        choose_answer(-1);
    } else if (is(Command::lesson_mark)) {
        lesson_form_->toggle(*state_.selected);
    } else {
        return false;
    }
    state_.left = LeftTab::lesson;
    return true;
}

void Viewer::run_program(Command command) {
    const auto is = [command](Command other) { return command == other; };
    const auto ask = [this](Prompt prompt) {
        state_.prompt = prompt;
        state_.prompt_appeared = false;
        state_.prompt_text.clear();
        state_.prompt_error.clear();
    };
    if (is(Command::undo)) {
        take_back(done_, undone_);
    } else if (is(Command::redo)) {
        take_back(undone_, done_);
    } else if (is(Command::go_to)) {
        ask(Prompt::go_to);
    } else if (is(Command::open)) {
        ask(Prompt::open_file);
    } else if (is(Command::export_shown)) {
        ask(Prompt::export_file);
        state_.prompt_text = export_name(document_, state_.screen.content);
    } else if (is(Command::presentation)) {
        state_.presentation = state_.presentation > 1.0F ? 1.0F : presentation_factor;
    } else if (is(Command::theme)) {
        const bool dark = state_.theme == ThemeKind::dark;
        state_.theme = dark ? ThemeKind::light : ThemeKind::dark;
    } else if (is(Command::keys)) {
        state_.show_keys = !state_.show_keys;
    } else if (is(Command::close)) {
        close_top();
    } else if (is(Command::quit)) {
        state_.quit = true;
    }
}

void Viewer::close_top() {
    if (state_.prompt != Prompt::none) {
        state_.prompt = Prompt::none;
    } else if (state_.show_keys) {
        state_.show_keys = false;
    } else if (!state_.problems.empty()) {
        state_.problems.clear();
    } else if (busy()) {
        cancel_background_work();
    } else {
        state_.selected.reset();
    }
}

} // namespace hs::viewer
