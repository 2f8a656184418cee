// The window's content: one playhead, everything follows it. Knows ImGui, not who shows it.
#pragma once

#include "app/viewer/background.hpp"
#include "app/viewer/beside.hpp"
#include "app/viewer/commands.hpp"
#include "app/viewer/document.hpp"
#include "app/viewer/keys.hpp"
#include "app/viewer/layout.hpp"
#include "app/viewer/state.hpp"
#include "app/viewer/textures.hpp"
#include "app/viewer/theme.hpp"
#include "core/scene/scene_file.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hs::lesson {
class Session;
}

namespace hs::viewer {

class ScreenPicture;
class SpaceLines;
class TimelineBands;
class LessonForm;
class Search;

struct OpenOptions {
    std::string at; ///< the step path to stand on; "": the end
    std::vector<scene::Assignment> assignments;
};

/// A scene as it was before a change.
using SceneChange = std::shared_ptr<const scene::Scene>;

class Viewer {
public:
    Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;
    Viewer(Viewer&&) = delete;
    Viewer& operator=(Viewer&&) = delete;
    ~Viewer();

    // What is shown
    /// Opens a scene, a mesh, a lesson's folder or its lesson.md, beside the window.
    void open(const std::filesystem::path& file, const OpenOptions& options = {});
    void set_recording(std::shared_ptr<const trace::Recording> recording);
    void seek(trace::StepId step);
    /// A written path or a pixel "31,17"; what is wrong with it, or nothing.
    std::optional<std::string> go_to(std::string_view path);
    /// Records the scene anew with other settings and returns to the same step path. What is wrong
    /// with them, or nothing.
    std::optional<std::string> change_settings(const scene::Settings& settings);
    /// Writes what the screen view shows, as it is at the playhead, to a file. What is wrong with
    /// that, or nothing. Precondition: a document is open.
    std::optional<std::string> export_shown(const std::filesystem::path& file);
    /// Shows the frame with one setting changed beside it. What is wrong with that, or nothing.
    std::optional<std::string> show_beside(const scene::Assignment& change);
    /// Searches for what stands in the search field; what is wrong with that stands beside it.
    /// Precondition: a document is open.
    void start_search();
    /// The same with another camera.
    void change_camera(const scene::Camera& camera);
    /// Goes to a step of the lesson. Precondition: there is a lesson.
    void go_to_lesson_step(std::size_t step);
    void select(PixelPos pixel);
    /// Goes to the step a value came from and opens it there; `value_back` returns.
    void follow(const explain::Origin& origin);

    // Input from the host
    void key(const KeyPress& press);
    /// Typed characters, for those that no key names on every keyboard: "?".
    void text(std::string_view text);
    void run(Command command);
    /// Why a command cannot run now, in one sentence; empty when it can.
    [[nodiscard]] std::string why_not(Command command) const;

    // Frames
    /// Loads fonts into ImGui's atlas when size or theme ask for it; true: upload the atlas again.
    /// Call before ImGui::NewFrame.
    bool prepare_fonts(float display_scale);
    /// Call between NewFrame and Render.
    void draw(ImVec2 size, Textures& textures);
    /// Waits for loading and recording, and shows what they brought.
    void finish_background_work();
    [[nodiscard]] bool busy() const { return background_.running(); }
    /// Whether the next frame will differ without any input.
    [[nodiscard]] bool wants_frames() const { return busy() || state_.playing || moving(); }
    /// Whether something goes on that will come to rest by itself: a morph, a search.
    [[nodiscard]] bool moving() const;
    void cancel_background_work() { background_.cancel(); }
    [[nodiscard]] const Background& background() const { return background_; }
    [[nodiscard]] std::string title() const;

    [[nodiscard]] State& state() { return state_; }
    [[nodiscard]] const State& state() const { return state_; }
    [[nodiscard]] Document& document() { return document_; }
    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const Theme& theme() const { return theme_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    [[nodiscard]] Beside& beside() { return beside_; }
    [[nodiscard]] Search& search() { return *search_; }
    /// A second frame stands beside the first one now.
    [[nodiscard]] bool shows_beside() const;
    /// Null when no lesson is open.
    [[nodiscard]] lesson::Session* session() { return session_.get(); }
    [[nodiscard]] LessonForm& lesson_form() { return *lesson_form_; }
    /// Where the last frame drew a pixel's center.
    [[nodiscard]] ImVec2 screen_position(PixelPos pixel) const;

private:
    void receive(Opened opened);
    void change_scene(std::shared_ptr<const scene::Scene> changed);
    void record_anew(std::shared_ptr<const scene::Scene> changed);
    void follow_lesson();
    void follow_step();
    void follow_beside();
    void remember(const std::filesystem::path& file);
    void step(trace::Granularity granularity, trace::Direction direction);
    void nudge(int dx, int dy);
    void change_granularity(int direction);
    void play(double seconds);
    void draw_hairlines() const;
    void close_top();
    [[nodiscard]] std::string why_no_answer(Command command) const;
    [[nodiscard]] std::string why_no_match(Command command) const;
    [[nodiscard]] std::string why_no_value(Command command) const;
    bool run_value(Command command);
    void choose_value(int by);
    void choose_operand(int by);
    void return_to_value();
    void take_back(std::vector<SceneChange>& from, std::vector<SceneChange>& to);
    void forget_unmade_changes();
    void forget_changes();
    void play_morph();
    void choose_answer(int by);
    void hand_in_answer();
    bool run_stepping(Command command);
    bool run_lesson(Command command);
    bool run_view(Command command);
    void run_program(Command command);

    State state_;
    Document document_;
    Theme theme_;
    Layout layout_;
    float fonts_scale_ = 0.0F;
    float display_scale_ = 1.0F;
    Background background_;
    Beside beside_;
    std::shared_ptr<lesson::Session> session_;
    unsigned lesson_revision_ = 0;
    std::vector<SceneChange> undone_;      ///< to be done again, the next one last
    std::vector<SceneChange> done_;        ///< to be undone, the next one last
    std::optional<InspectorTab> followed_; ///< the tab that suited the last step
    std::unique_ptr<Search> search_;
    std::unique_ptr<LessonForm> lesson_form_;
    std::unique_ptr<ScreenPicture> picture_;
    std::unique_ptr<SpaceLines> lines_;
    std::unique_ptr<TimelineBands> bands_;
};

} // namespace hs::viewer
