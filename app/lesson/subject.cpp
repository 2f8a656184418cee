#include "app/lesson/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

namespace hs::lesson {

namespace {

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional{number} : std::nullopt;
}

std::optional<PixelPos> parse_pixel(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto x = parse_number<int>(trim(text.substr(0, comma)));
    const auto y = parse_number<int>(trim(text.substr(std::min(comma + 1, text.size()))));
    return x && y ? std::optional{PixelPos{*x, *y}} : std::nullopt;
}

/// "triangle 2 piece 1" is two words with a number each.
bool read_part(std::string_view part, Subject& subject) {
    const std::size_t space = part.find(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    const std::string_view word = part.substr(0, space);
    const std::string_view rest = trim(part.substr(space));
    if (word == "triangle" && rest.find("piece") != std::string_view::npos) {
        const std::size_t piece = rest.find("piece");
        subject.triangle = parse_number<std::uint32_t>(trim(rest.substr(0, piece)));
        return subject.triangle && read_part(rest.substr(piece), subject);
    }
    if (word == "pixel" || word == "fragment") {
        subject.pixel = parse_pixel(rest);
        return subject.pixel.has_value();
    }
    std::optional<std::uint32_t>* const number = word == "object"     ? &subject.object
                                                 : word == "vertex"   ? &subject.vertex
                                                 : word == "triangle" ? &subject.triangle
                                                 : word == "piece"    ? &subject.piece
                                                                      : nullptr;
    if (number == nullptr) {
        return false;
    }
    *number = parse_number<std::uint32_t>(rest);
    return number->has_value();
}

} // namespace

Result<Subject> parse_subject(std::string_view text) {
    Subject subject;
    if (trim(text).empty() || trim(text) == "frame") {
        return subject;
    }
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t slash = std::min(text.find('/', from), text.size());
        const std::string_view part = trim(text.substr(from, slash - from));
        if (!read_part(part, subject)) {
            return Diagnostic{
                "",
                0,
                0,
                fmt::format(
                    "\"{}\" is not understood: write for instance \"object 0 / vertex 2\" or "
                    "\"triangle 0 / pixel 8,6\"",
                    part
                )};
        }
        from = slash + 1;
    }
    return subject;
}

Subject subject_of(const trace::Step& step) {
    Subject subject;
    if (step.in_vertex_stage()) {
        subject.object = step.object;
        subject.vertex = step.vertex;
    } else if (step.in_triangle()) {
        subject.object = step.object;
        subject.triangle = step.triangle;
    }
    if (step.has_piece()) {
        subject.piece = static_cast<std::uint32_t>(step.piece);
    }
    if (step.has_pixel()) {
        subject.pixel = step.pixel;
    }
    return subject;
}

std::optional<std::string> find_missing(const Subject& subject, const trace::Recording& recording) {
    const std::uint32_t object_number = subject.object.value_or(0);
    if (object_number >= recording.objects.size()) {
        return fmt::format("there is no object {} in the scene", object_number);
    }
    const trace::ObjectRange& object = recording.objects[object_number];
    if (subject.vertex && *subject.vertex >= object.vertex_count) {
        return fmt::format("object {} has no vertex {}", object_number, *subject.vertex);
    }
    if (subject.triangle && *subject.triangle >= object.triangle_count) {
        return fmt::format("object {} has no triangle {}", object_number, *subject.triangle);
    }
    if (subject.pixel && !recording.settings().image().contains(*subject.pixel)) {
        return fmt::format("pixel {},{} is outside the image", subject.pixel->x, subject.pixel->y);
    }
    return std::nullopt;
}

} // namespace hs::lesson
