#include "app/lesson/block_reader.hpp"
#include "app/lesson/lesson.hpp"
#include "app/lesson/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

namespace hs::lesson {

namespace {

namespace fs = std::filesystem;

constexpr const char* lesson_name = "lesson.md";
constexpr std::uintmax_t largest_lesson = 4U << 20U;

/// Puts the parts of a file together: header, introduction, steps.
class LessonReader {
public:
    /// `broken`: a fence is not closed, and swallowed what may be missed.
    LessonReader(Lesson& lesson, Complaints& complaints, bool broken)
        : lesson_(lesson), complaints_(complaints), file_(lesson.file.string()), broken_(broken) {}

    void add(Block block) {
        const bool heading = block.kind == BlockKind::heading;
        if (heading && block.level == 2) {
            LessonStep step;
            step.title = to_plain_text(block.spans);
            step.place = block.place;
            step.scene_place = step.settings_place = step.stand_place = block.place;
            lesson_.steps.push_back(std::move(step));
        } else if (heading && block.level == 1) {
            read_title(block);
        } else {
            narration().push_back(std::move(block));
        }
    }

    void add(const FencedBlock& block) {
        const std::optional<toml::table> table = parse_block(block, file_, complaints_);
        broken_ = broken_ || !table;
        if (!has_header_) {
            has_header_ = true;
            if (!lesson_.steps.empty()) {
                complain(
                    block.place,
                    "the lesson's first block (title, minutes, objectives) must "
                    "stand before the first step"
                );
            } else if (table) {
                read_header(*table, block.place, lesson_, complaints_);
            }
        } else if (lesson_.steps.empty()) {
            complain(
                block.place, "this block belongs to no step: steps begin with a heading \"## …\""
            );
        } else if (table) {
            read_step_block(*table, block.place, lesson_.steps.back(), complaints_);
        }
    }

    void finish() {
        if (!has_header_ && !broken_) {
            complain({}, "the lesson has no fenced block with the word halfspace: ```halfspace");
        }
        if (lesson_.steps.empty()) {
            complain({}, "the lesson has no steps: steps begin with a heading \"## …\"");
        } else if (lesson_.steps.front().scene.empty() && !broken_) {
            complain(lesson_.steps.front().place, "the first step must name a scene");
        }
    }

private:
    Document& narration() {
        return lesson_.steps.empty() ? lesson_.introduction : lesson_.steps.back().narration;
    }

    /// The page's own title is for web pages; the program shows the block's.
    void read_title(const Block& block) {
        const std::string title = to_plain_text(block.spans);
        if (!lesson_.title.empty() && title != lesson_.title) {
            complain(
                block.place,
                fmt::format(R"(the page calls itself "{}", its block "{}")", title, lesson_.title)
            );
        }
    }

    void complain(Place place, std::string message) {
        complaints_.add(Diagnostics{{file_, place.line, place.column, std::move(message)}});
    }

    Lesson& lesson_;
    Complaints& complaints_;
    std::string file_;
    bool has_header_ = false;
    bool broken_; ///< a block could not be read: what is missing may stand in it
};

/// Where the text stops being UTF-8; nothing when it never does.
std::optional<std::size_t> find_bad_byte(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80U              ? 1
                                   : (lead & 0xE0U) == 0xC0U ? 2
                                   : (lead & 0xF0U) == 0xE0U ? 3
                                   : (lead & 0xF8U) == 0xF0U ? 4
                                                             : 0;
        if (length == 0 || lead == 0 || i + length > text.size()) {
            return i;
        }
        for (std::size_t k = 1; k < length; ++k) {
            if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) {
                return i;
            }
        }
        i += length;
    }
    return std::nullopt;
}

Result<std::string> read_text(const fs::path& file) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) {
        return Diagnostic{file.string(), 0, 0, "cannot be read: " + error.message()};
    }
    if (size > largest_lesson) {
        return Diagnostic{file.string(), 0, 0, "is larger than 4 MiB: no lesson is that long"};
    }
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) {
        return Diagnostic{file.string(), 0, 0, "cannot be read"};
    }
    return text.str();
}

} // namespace

Result<Lesson> parse_lesson(std::string_view text, const fs::path& file) {
    if (const std::optional<std::size_t> bad = find_bad_byte(text)) {
        const auto lines =
            std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*bad), '\n');
        return Diagnostic{
            file.string(), static_cast<int>(lines) + 1, 0, "this line is not UTF-8 text"};
    }
    Lesson lesson;
    lesson.file = file;
    lesson.folder = file.parent_path();
    Complaints complaints(file.string());
    Markdown markdown = parse_markdown(text);
    for (Diagnostic& problem : markdown.problems) {
        problem.file = file.string();
    }
    const bool broken = !markdown.problems.empty();
    complaints.add(std::move(markdown.problems));
    LessonReader reader(lesson, complaints, broken);
    for (MarkdownPart& part : markdown.parts) {
        std::visit([&](auto& content) { reader.add(std::move(content)); }, part);
    }
    reader.finish();
    if (!complaints.empty()) {
        return complaints.sorted();
    }
    return lesson;
}

Result<Lesson> load_lesson(const fs::path& path) {
    std::error_code error;
    const fs::path file = fs::is_directory(path, error) ? path / lesson_name : path;
    const Result<std::string> text = read_text(file);
    if (!text) {
        return text.diagnostics();
    }
    return parse_lesson(*text, file);
}

SceneChoice scene_of_step(const Lesson& lesson, std::size_t step) {
    SceneChoice choice;
    for (std::size_t i = 0; i <= step; ++i) {
        if (!lesson.steps[i].scene.empty()) {
            choice = {lesson.folder / lesson.steps[i].scene, {}};
        }
        choice.assignments.insert(
            choice.assignments.end(),
            lesson.steps[i].settings.begin(),
            lesson.steps[i].settings.end()
        );
    }
    return choice;
}

} // namespace hs::lesson
