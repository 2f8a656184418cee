#include "app/viewer/viewer.hpp"

#include "app/lesson/session.hpp"
#include "app/viewer/export_job.hpp"
#include "app/viewer/lesson_form.hpp"
#include "app/viewer/open_job.hpp"
#include "app/viewer/panels.hpp"
#include "app/viewer/screen_picture.hpp"
#include "app/viewer/search.hpp"
#include "app/viewer/space_lines.hpp"
#include "app/viewer/timeline_bands.hpp"
#include "app/viewer/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace hs::viewer {
namespace {

constexpr double search_milliseconds = 3.0; ///< of a frame, spent on a search under way

/// "31,17" or "31 17"; nothing for any other text.
std::optional<PixelPos> parse_pixel(std::string_view text) {
    PixelPos pixel;
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, pixel.x);
    if (x.ec != std::errc{} || x.ptr == end) {
        return std::nullopt;
    }
    const char* rest = x.ptr;
    while (rest != end && (*rest == ',' || *rest == ' ')) {
        ++rest;
    }
    const auto y = std::from_chars(rest, end, pixel.y);
    if (rest == x.ptr || y.ec != std::errc{} || y.ptr != end) {
        return std::nullopt;
    }
    return pixel;
}

/// Panels of formulas and curves need more room than a view that can be zoomed.
float side_share(const State& state) {
    if (!state.show_side) {
        return 0.0F;
    }
    if (state.side == SidePanel::beside) {
        return 0.5F;
    }
    return state.side == SidePanel::space ? 0.44F : 0.64F;
}

/// The tab of the inspector that is about a step.
std::optional<InspectorTab> tab_about(const trace::Step& step) {
    if (step.in_vertex_stage()) {
        return InspectorTab::vertex;
    }
    if (step.in_triangle()) {
        return step.has_pixel() ? InspectorTab::fragment : InspectorTab::triangle;
    }
    return step.kind == trace::StepKind::resolve ? std::optional{InspectorTab::fragment}
                                                 : std::nullopt;
}

bool is_about_steps(InspectorTab tab) {
    return tab == InspectorTab::vertex || tab == InspectorTab::triangle ||
           tab == InspectorTab::fragment;
}

} // namespace

Viewer::Viewer()
    : search_(std::make_unique<Search>()),
      lesson_form_(std::make_unique<LessonForm>()),
      picture_(std::make_unique<ScreenPicture>()),
      lines_(std::make_unique<SpaceLines>()),
      bands_(std::make_unique<TimelineBands>()) {}

Viewer::~Viewer() = default;

// ---- what is shown

void Viewer::open(const std::filesystem::path& file, const OpenOptions& options) {
    background_.start(
        fmt::format("Opening {}", file.filename().string()),
        [file, options](const Background::Progress& progress) {
            return open_job(file, options.assignments, options.at, progress);
        }
    );
}

void Viewer::set_recording(std::shared_ptr<const trace::Recording> recording) {
    document_.show(std::move(recording));
    const PixelRect image = document_.recording().settings().image();
    if (state_.selected && !image.contains(*state_.selected)) {
        state_.selected.reset();
    }
    state_.hovered.reset();
    state_.planes.reset();
    state_.playing = false;
    state_.notice.clear();
    if (search_->begun()) {
        start_search(); // the same question about the new frame
    }
}

std::optional<std::string> Viewer::export_shown(const std::filesystem::path& file) {
    Result<Background::Job> job = export_job(document_, state_.screen.content, file);
    if (!job) {
        return job.diagnostics().front().to_string();
    }
    background_.start(fmt::format("Writing {}", file.filename().string()), std::move(*job));
    return std::nullopt;
}

void Viewer::seek(trace::StepId step) {
    if (document_.is_open()) {
        document_.player().seek(step);
    }
}

std::optional<std::string> Viewer::go_to(std::string_view path) {
    if (!document_.is_open()) {
        return "nothing is open yet";
    }
    if (const std::optional<PixelPos> pixel = parse_pixel(path)) {
        const PixelRect image = document_.recording().settings().image();
        if (!image.contains(*pixel)) {
            return fmt::format(
                "pixel {},{} lies outside the image of {} × {} pixels",
                pixel->x,
                pixel->y,
                image.width(),
                image.height()
            );
        }
        select(*pixel);
        return std::nullopt;
    }
    const Result<trace::StepId> step = trace::find_step(document_.recording(), path);
    if (!step) {
        return step.diagnostics().front().message;
    }
    seek(*step);
    return std::nullopt;
}

std::optional<std::string> Viewer::change_settings(const scene::Settings& settings) {
    if (std::optional<std::string> complaint = scene::check_combination(settings)) {
        return complaint;
    }
    auto changed = std::make_shared<scene::Scene>(document_.scene());
    changed->settings = settings;
    change_scene(std::move(changed));
    return std::nullopt;
}

std::optional<std::string> Viewer::show_beside(const scene::Assignment& change) {
    if (std::optional<std::string> complaint = beside_.ask(change)) {
        return complaint;
    }
    state_.side = SidePanel::beside;
    state_.show_side = true;
    return std::nullopt;
}

void Viewer::start_search() {
    state_.search.complaint.clear();
    if (const auto complaint = search_->start(document_, state_.search.text)) {
        state_.search.complaint = *complaint;
    }
}

void Viewer::change_camera(const scene::Camera& camera) {
    auto changed = std::make_shared<scene::Scene>(document_.scene());
    changed->camera = camera;
    change_scene(std::move(changed));
}

void Viewer::change_scene(std::shared_ptr<const scene::Scene> changed) {
    // While the frame is recorded, further changes are changes of the same scene
    SceneChange present = document_.recording().frame->shared_scene();
    if (done_.empty() || done_.back() != present) {
        done_.push_back(std::move(present));
    }
    undone_.clear();
    record_anew(std::move(changed));
}

/// Returns to the scene at the end of one list; the present one goes to the other.
void Viewer::take_back(std::vector<SceneChange>& from, std::vector<SceneChange>& to) {
    SceneChange scene = std::move(from.back());
    from.pop_back();
    to.push_back(document_.recording().frame->shared_scene());
    record_anew(std::move(scene));
}

void Viewer::record_anew(std::shared_ptr<const scene::Scene> changed) {
    const std::string at = trace::step_path(document_.player().current());
    state_.values_before = {at, {}};
    for (const explain::StepValue& value : document_.values()) {
        state_.values_before.texts[value.name] = explain::value_text(*value.expression);
    }
    background_.start(
        "Recording",
        [scene = std::move(changed), at](const Background::Progress& progress) {
            return record_job(scene, at, progress);
        }
    );
}

void Viewer::select(PixelPos pixel) {
    state_.selected = pixel;
}

void Viewer::follow(const explain::Origin& origin) {
    const auto source = explain::source_of(document_.recording(), origin);
    if (!source) {
        return;
    }
    ValueTrail& trail = state_.values;
    trail.back.push_back({trace::step_path(document_.player().current()), trail.open});
    seek(source->step);
    trail.open = source->value;
    trail.operand = -1;
    trail.scroll = true;
    state_.tab = InspectorTab::values;
}

void Viewer::go_to_lesson_step(std::size_t step) {
    session_->go_to(step);
    follow_lesson();
}

/// Shows what the lesson's step shows, when it has changed.
void Viewer::follow_lesson() {
    if (session_ == nullptr || session_->revision() == lesson_revision_) {
        return;
    }
    lesson_revision_ = session_->revision();
    lesson_form_->follow(session_->index());
    state_.problems = session_->problems();
    if (session_->recording() == nullptr) {
        return;
    }
    if (!document_.is_open() || document_.player().shared_recording() != session_->recording()) {
        set_recording(session_->recording());
        forget_changes();
        state_.screen.fitted = true;
    }
    seek(session_->stand());
    apply_lesson_views(session_->step(), state_);
    followed_ = tab_about(document_.player().current());
}

/// From vertices to triangles to fragments the inspector comes along; within each, and on tabs
/// about something else, it stays where it was put.
void Viewer::follow_step() {
    if (!document_.is_open()) {
        return;
    }
    const std::optional<InspectorTab> about = tab_about(document_.player().current());
    if (about && about != followed_ && is_about_steps(state_.tab)) {
        state_.tab = *about;
    }
    followed_ = about;
}

/// Makes the second frame when there is none for what is open, and keeps its playhead in step.
void Viewer::follow_beside() {
    const bool visible = state_.show_side && state_.side == SidePanel::beside;
    if (!document_.is_open() || !visible) {
        return;
    }
    if (!busy()) {
        if (std::shared_ptr<const scene::Scene> scene = beside_.take_work(document_)) {
            background_.start(
                "Recording beside",
                [scene = std::move(scene),
                 main = document_.player().shared_recording()](const Background::Progress& progress
                ) { return beside_job(scene, *main, progress); }
            );
        }
    }
    if (beside_.is_beside(document_)) {
        beside_.follow(document_, state_.beside.by_count);
    }
}

bool Viewer::moving() const {
    return state_.space.morph_goal.has_value() || search_->running();
}

bool Viewer::shows_beside() const {
    return state_.show_side && state_.side == SidePanel::beside && beside_.is_beside(document_);
}

/// Of a change that was stopped there is nothing to undo.
void Viewer::forget_unmade_changes() {
    const auto is_present = [this](const SceneChange& scene) {
        return document_.is_open() && scene == document_.recording().frame->shared_scene();
    };
    std::erase_if(done_, is_present);
    std::erase_if(undone_, is_present);
}

void Viewer::forget_changes() {
    done_.clear();
    undone_.clear();
    state_.values.back.clear();
    state_.values_before = {};
}

void Viewer::receive(Opened opened) {
    if (opened.cancelled) {
        state_.notice = "Stopped.";
    }
    if (opened.beside) {
        beside_.receive(std::move(opened), document_);
        return;
    }
    if (opened.cancelled) {
        forget_unmade_changes();
        return;
    }
    if (!opened.problems.empty()) {
        state_.problems = std::move(opened.problems);
        return;
    }
    state_.problems.clear();
    if (!opened.notice.empty()) {
        state_.notice = std::move(opened.notice);
        return;
    }
    if (opened.session != nullptr) {
        session_ = std::move(opened.session);
        lesson_revision_ = session_->revision() - 1;
        state_.left = LeftTab::lesson;
        follow_lesson();
    } else {
        set_recording(std::move(opened.recording));
        if (!opened.file.empty()) {
            forget_changes();
            session_.reset();
            state_.left = LeftTab::scene;
            state_.screen.fitted = true;
        }
        if (const auto complaint = opened.at.empty() ? std::nullopt : go_to(opened.at)) {
            state_.notice = "Stands at the end: " + *complaint + ".";
        }
    }
    if (!opened.file.empty()) {
        remember(opened.file);
    }
}

void Viewer::remember(const std::filesystem::path& file) {
    constexpr std::size_t most = 8;
    std::erase(state_.recent, file);
    state_.recent.insert(state_.recent.begin(), file);
    state_.recent.resize(std::min(most, state_.recent.size()));
}

void Viewer::finish_background_work() {
    background_.wait();
    if (std::optional<Opened> opened = background_.take()) {
        receive(std::move(*opened));
    }
}

std::string Viewer::title() const {
    if (!document_.is_open()) {
        return "Halfspace";
    }
    return fmt::format("{} — Halfspace", document_.scene().name);
}

// ---- frames

bool Viewer::prepare_fonts(float display_scale) {
    theme_.kind = state_.theme;
    theme_.scale = display_scale * state_.presentation;
    if (theme_.scale == fonts_scale_) {
        return false;
    }
    theme_.fonts = load_fonts(*ImGui::GetIO().Fonts, theme_.scale);
    fonts_scale_ = theme_.scale;
    return true;
}

void Viewer::play(double seconds) {
    if (!state_.playing || !document_.is_open()) {
        return;
    }
    state_.since_played += seconds;
    if (state_.since_played * static_cast<double>(state_.play_rate) < 1.0) {
        return;
    }
    state_.since_played = 0.0;
    state_.playing = document_.player().advance(state_.granularity, trace::Direction::forward);
}

/// Panels cover the window but for one pixel between them.
void Viewer::draw_hairlines() const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Layout& l = layout_;
    for (const Rect& above : {l.menu, l.strip, l.left, l.sentence}) {
        list.AddRectFilled(
            {0.0F, above.bottom()}, {l.menu.width, above.bottom() + 1.0F}, theme_[Tone::hairline]
        );
    }
    for (const Rect& right : {l.screen, l.side, l.inspector}) {
        list.AddRectFilled(
            {right.x - 1.0F, right.y}, {right.x, right.bottom()}, theme_[Tone::hairline]
        );
    }
}

void Viewer::draw(ImVec2 size, Textures& textures) {
    if (std::optional<Opened> opened = background_.take()) {
        receive(std::move(*opened));
    }
    follow_lesson();
    play(static_cast<double>(ImGui::GetIO().DeltaTime));
    follow_step();
    follow_beside();
    search_->work(search_milliseconds);
    move_on(state_.space, ImGui::GetIO().DeltaTime);
    theme_.kind = state_.theme;
    apply_style(theme_);
    layout_ = make_layout(size, theme_, side_share(state_));

    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin(
        "halfspace",
        nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
            ImGuiWindowFlags_NoScrollWithMouse
    );
    ImGui::PopStyleVar();
    ImGui::PushFont(theme_.fonts.text);

    draw_hairlines();
    Context context{*this, document_, state_, theme_, textures};
    draw_menu(context, layout_.menu);
    draw_strip(context, layout_.strip);
    draw_left(context, layout_.left);
    draw_screen(context, layout_.screen, *picture_);
    if (state_.show_side) {
        draw_side(context, layout_.side, *lines_);
    }
    draw_inspector(context, layout_.inspector);
    draw_sentence(context, layout_.sentence);
    draw_timeline(context, layout_.timeline, *bands_);
    draw_popups(context, size);

    ImGui::PopFont();
    ImGui::End();
}

ImVec2 Viewer::screen_position(PixelPos pixel) const {
    const ScreenView& view = state_.screen;
    const float middle_x = view.area.x + view.area.width * 0.5F;
    const float middle_y = view.area.y + view.area.height * 0.5F;
    return {
        middle_x + (static_cast<float>(pixel.x) + 0.5F - view.center.x) * view.zoom,
        middle_y + (static_cast<float>(pixel.y) + 0.5F - view.center.y) * view.zoom};
}

} // namespace hs::viewer
