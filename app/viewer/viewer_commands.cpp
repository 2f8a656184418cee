// What keys, menus and buttons do.
#include "app/lesson/session.hpp"
#include "app/viewer/viewer.hpp"

#include <algorithm>

namespace hs::viewer {
namespace {

constexpr float zoom_factor = 1.25F;
constexpr float largest_zoom = 256.0F;
constexpr float smallest_zoom = 0.05F;
constexpr float presentation_factor = 1.5F;

bool needs_recording(Command command) {
    const CommandGroup group = command_info(command).group;
    const bool of_window = command == Command::toggle_space;
    return (group == CommandGroup::stepping || group == CommandGroup::pixel ||
            group == CommandGroup::view) &&
           !of_window;
}

} // namespace

std::string Viewer::why_not(Command command) const {
    if (needs_recording(command) && !document_.is_open()) {
        return "Nothing is open yet: open a scene, a mesh or a lesson first.";
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
    if (!needs_recording(command)) {
        return "";
    }
    const bool nudges = command >= Command::nudge_left && command <= Command::nudge_down;
    if (nudges && !state_.selected) {
        return "No pixel is picked: click one in the screen view.";
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
    if (!run_stepping(command) && !run_view(command)) {
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
    } else if (is(Command::toggle_space)) {
        state_.show_space = !state_.show_space;
    } else {
        return false;
    }
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
    if (is(Command::go_to)) {
        ask(Prompt::go_to);
    } else if (is(Command::open)) {
        ask(Prompt::open_file);
    } else if (is(Command::lesson_next)) {
        go_to_lesson_step(session_->index() + 1);
    } else if (is(Command::lesson_previous)) {
        go_to_lesson_step(session_->index() - 1);
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
