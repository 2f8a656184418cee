#include "app/command/input.hpp"

#include "app/command/interrupt.hpp"
#include "app/command/output.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/library.hpp"
#include "app/viewer/viewer.hpp"
#include "core/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
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

} // namespace

Result<Size> parse_size(std::string_view text) {
    constexpr int largest = 8192;
    // 0 stands for what is no number: it is out of range anyway
    const std::size_t cross = std::min(text.find('x'), text.size());
    const std::string_view behind = text.substr(cross);
    const int width = parse_int(text.substr(0, cross)).value_or(0);
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

Result<PixelPos> parse_pixel(std::string_view text) {
    // Pixels are not negative, so that this stands for what is no number
    constexpr int nothing = -1;
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view behind = text.substr(comma);
    const int x = parse_int(text.substr(0, comma)).value_or(nothing);
    const int y = behind.empty() ? nothing : parse_int(behind.substr(1)).value_or(nothing);
    if (x < 0 || y < 0) {
        return Diagnostic{
            .file = "--pixel",
            .message =
                fmt::format("'{}' is not a pixel; write X,Y, counted from the top left", text)};
    }
    return PixelPos{x, y};
}

Diagnostic outside_image(PixelPos pixel, const trace::Recording& recording) {
    return {
        .file = "--pixel",
        .message = fmt::format(
            "{},{} lies outside the image; pixels are 0,0 to {},{}",
            pixel.x,
            pixel.y,
            recording.width() - 1,
            recording.height() - 1
        )};
}

Result<std::string>
output_format(const std::filesystem::path& file, std::initializer_list<std::string_view> known) {
    const std::string extension = file.extension().string();
    if (std::find(known.begin(), known.end(), extension) != known.end()) {
        return extension;
    }
    const std::string choices = list_of_choices({known.begin(), known.size()});
    return Diagnostic{
        .file = file.string(),
        .message = fmt::format("the name must end in {}: it chooses the format", choices)};
}

Result<std::vector<scene::Assignment>> assignments_of(const Common& common) {
    std::vector<scene::Assignment> assignments;
    for (const std::string& text : common.set) {
        Result<scene::Assignment> assignment = scene::parse_assignment(text);
        if (!assignment) {
            return assignment.diagnostics();
        }
        assignments.push_back(std::move(*assignment));
    }
    if (!common.size.empty()) {
        const Result<Size> size = parse_size(common.size);
        if (!size) {
            return size.diagnostics();
        }
        assignments.push_back({"size", fmt::format("[{}, {}]", size->width, size->height)});
    }
    return assignments;
}

Result<Source> find_source(const std::filesystem::path& file, const Common& common) {
    Source source{.file = file, .assignments = {}};
    if (lesson::is_lesson(file)) {
        const Result<lesson::Lesson> opened = lesson::load_lesson(file);
        if (!opened) {
            return opened.diagnostics();
        }
        lesson::SceneChoice choice = lesson::scene_of_step(*opened, 0);
        source = {std::move(choice.file), std::move(choice.assignments)};
    }
    const Result<std::vector<scene::Assignment>> given = assignments_of(common);
    if (!given) {
        return given.diagnostics();
    }
    source.assignments.insert(source.assignments.end(), given->begin(), given->end());
    return source;
}

Result<std::shared_ptr<const scene::Scene>> load(const Source& source) {
    Result<scene::Scene> scene = scene::load_scene(source.file, source.assignments);
    if (!scene) {
        return scene.diagnostics();
    }
    return std::shared_ptr<const scene::Scene>(std::make_shared<scene::Scene>(std::move(*scene)));
}

Result<std::shared_ptr<const trace::Recording>> record(const Source& source, const Common& common) {
    const Result<std::shared_ptr<const scene::Scene>> scene = load(source);
    if (!scene) {
        return scene.diagnostics();
    }
    const ProgressBar bar(common.quiet);
    trace::RecordOptions options;
    options.threads = common.threads == 0 ? options.threads : common.threads;
    options.progress = [&bar](double part) {
        bar.show(part);
        return !stop_requested();
    };
    return trace::record(*scene, options);
}

Result<std::shared_ptr<const trace::Recording>>
record_file(const std::filesystem::path& file, const Common& common) {
    const Result<Source> source = find_source(file, common);
    if (!source) {
        return source.diagnostics();
    }
    return record(*source, common);
}

Result<Done> show_beside(viewer::Viewer& viewer, const std::string& beside) {
    if (beside.empty()) {
        return done;
    }
    const Result<scene::Assignment> change = scene::parse_assignment(beside);
    if (!change) {
        Diagnostics problems = change.diagnostics();
        problems.front().file = "--beside";
        return problems;
    }
    if (std::optional<std::string> complaint = viewer.show_beside(*change)) {
        return Diagnostic{.file = "--beside", .message = std::move(*complaint)};
    }
    return done;
}

Result<std::shared_ptr<trace::Player>>
stand_on(std::shared_ptr<const trace::Recording> recording, const std::string& at) {
    auto player = std::make_shared<trace::Player>(std::move(recording));
    if (!at.empty()) {
        const Result<trace::StepId> step = trace::find_step(player->recording(), at);
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
