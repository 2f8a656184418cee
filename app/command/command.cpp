#include "app/command/command.hpp"

#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "core/scene/scene_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

namespace hs::command {
namespace {

/// A whole number that fills the text.
std::optional<int> parse_int(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    return whole ? std::optional{number} : std::nullopt;
}

Result<std::vector<scene::Assignment>> assignments_of(const Common& common, bool size_is_image) {
    std::vector<scene::Assignment> assignments;
    for (const std::string& text : common.set) {
        Result<scene::Assignment> assignment = scene::parse_assignment(text);
        if (!assignment) {
            return assignment.diagnostics();
        }
        assignments.push_back(std::move(*assignment));
    }
    if (size_is_image && !common.size.empty()) {
        const Result<Size> size = parse_size(common.size);
        if (!size) {
            return size.diagnostics();
        }
        assignments.push_back({"size", fmt::format("[{}, {}]", size->width, size->height)});
    }
    return assignments;
}

/// The scene file behind a lesson's first step, and the changes the step makes.
Result<lesson::SceneChoice> scene_choice(const std::filesystem::path& file) {
    if (!lesson::is_lesson(file)) {
        return lesson::SceneChoice{file, {}};
    }
    const Result<lesson::Lesson> opened = lesson::load_lesson(file);
    if (!opened) {
        return opened.diagnostics();
    }
    return lesson::scene_of_step(*opened, 0);
}

/// A bar on stderr, drawn over itself; nothing where stderr is no terminal.
class ProgressBar {
public:
    explicit ProgressBar(const Common& common)
        : shown_(!common.quiet && ::isatty(STDERR_FILENO) == 1) {}
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ProgressBar(ProgressBar&&) = delete;
    ProgressBar& operator=(ProgressBar&&) = delete;
    ~ProgressBar() {
        if (shown_) {
            std::fputs("\r\033[K", stderr);
        }
    }
    void show(double part) const {
        constexpr int width = 40;
        if (shown_) {
            const auto full = static_cast<int>(part * width);
            fmt::print(stderr, "\rrecording [{:=<{}}{: <{}}]", "", full, "", width - full);
        }
    }

private:
    bool shown_;
};

} // namespace

int fail(const Diagnostics& diagnostics) {
    std::string line = "halfspace: " + diagnostics.front().to_string();
    if (diagnostics.size() > 1) {
        line += fmt::format(" (and {} more)", diagnostics.size() - 1);
    }
    fmt::print(stderr, "{}\n", line);
    return status_bad_input;
}

Result<Size> parse_size(const std::string& text) {
    constexpr int largest = 8192;
    // 0 stands for what is no number: it is out of range anyway
    const std::size_t cross = std::min(text.find('x'), text.size());
    const std::string_view behind = std::string_view{text}.substr(cross);
    const int width = parse_int(std::string_view{text}.substr(0, cross)).value_or(0);
    const int height = behind.empty() ? 0 : parse_int(behind.substr(1)).value_or(0);
    if (width < 1 || width > largest || height < 1 || height > largest) {
        return Diagnostic{
            .file = "--size",
            .message = fmt::format(
                "'{}' is not a size; write WIDTHxHEIGHT with numbers from 1 to {}", text, largest
            )};
    }
    return Size{width, height};
}

Result<PixelPos> parse_pixel(const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto x = parse_int(std::string_view{text}.substr(0, comma));
    const auto y = comma == std::string::npos ? std::nullopt
                                              : parse_int(std::string_view{text}.substr(comma + 1));
    if (!x || !y) {
        return Diagnostic{
            .file = "--pixel",
            .message =
                fmt::format("'{}' is not a pixel; write X,Y, counted from the top left", text)};
    }
    return PixelPos{*x, *y};
}

Result<std::shared_ptr<const scene::Scene>>
load_input(const std::filesystem::path& file, const Common& common, bool size_is_image) {
    Result<lesson::SceneChoice> choice = scene_choice(file);
    if (!choice) {
        return choice.diagnostics();
    }
    Result<std::vector<scene::Assignment>> given = assignments_of(common, size_is_image);
    if (!given) {
        return given.diagnostics();
    }
    std::vector<scene::Assignment>& all = choice->assignments;
    all.insert(all.end(), given->begin(), given->end());
    Result<scene::Scene> scene = scene::load_scene(choice->file, all);
    if (!scene) {
        return scene.diagnostics();
    }
    return std::shared_ptr<const scene::Scene>(std::make_shared<scene::Scene>(std::move(*scene)));
}

Result<std::shared_ptr<const trace::Recording>>
record_input(const std::filesystem::path& file, const Common& common, bool size_is_image) {
    Result<std::shared_ptr<const scene::Scene>> scene = load_input(file, common, size_is_image);
    if (!scene) {
        return scene.diagnostics();
    }
    const ProgressBar bar(common);
    trace::RecordOptions options;
    options.threads = common.threads == 0 ? options.threads : common.threads;
    options.progress = [&bar](double part) {
        bar.show(part);
        return true;
    };
    return trace::record(*scene, options);
}

Result<std::shared_ptr<trace::Player>>
stand_on(std::shared_ptr<const trace::Recording> recording, const std::string& at) {
    auto player = std::make_shared<trace::Player>(std::move(recording));
    if (!at.empty()) {
        Result<trace::StepId> step = trace::find_step(player->recording(), at);
        if (!step) {
            Diagnostics diagnostics = step.diagnostics();
            diagnostics.front().file = "--at";
            return diagnostics;
        }
        player->seek(*step);
    }
    return player;
}

} // namespace hs::command
