// STL: OpenMesh reads binary files without looking at their end, and text files by the words
// "outer" and "facet".
#include "core/scene/mesh/prescan.hpp"
#include "core/scene/mesh/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace hs::scene::mesh {

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;

bool starts_with_solid(std::string_view bytes) {
    constexpr std::string_view word = "solid";
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const std::string_view start =
        first == std::string_view::npos ? "" : bytes.substr(first, word.size());
    return std::ranges::equal(start, word, [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

std::uint32_t triangle_count(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count); // little-endian, as this machine
    return count;
}

std::optional<Flaw> prescan_binary(std::string_view bytes) {
    if (bytes.size() < header_size) {
        return Flaw{0, "the file is too short for an STL file"};
    }
    const std::uint32_t count = triangle_count(bytes);
    const std::size_t present = (bytes.size() - header_size) / triangle_size;
    if (count > present) {
        return Flaw{0, fmt::format("the file announces {} triangles and holds {}", count, present)};
    }
    for (std::size_t i = 0; i < count; ++i) {
        float numbers[12];
        std::memcpy(numbers, bytes.data() + header_size + i * triangle_size, sizeof numbers);
        if (!std::all_of(numbers + 3, numbers + 12, [](float x) { return std::isfinite(x); })) {
            return Flaw{0, fmt::format("a vertex of triangle {} is not finite", i)};
        }
    }
    return std::nullopt;
}

std::optional<Flaw> check_loop(LineScanner& lines) {
    for (int i = 0; i < 3; ++i) {
        std::string_view rest = lines.next().value_or("");
        const std::string_view word = next_word(rest);
        if ((word != "vertex" && word != "VERTEX") || !skip_numbers(rest, 3)) {
            return Flaw{lines.number(), "a vertex with 3 finite numbers is expected"};
        }
    }
    return std::nullopt;
}

std::optional<Flaw> prescan_text(std::string_view bytes) {
    LineScanner lines{bytes};
    bool ended = false;
    while (auto line = lines.next()) {
        const bool loop = line->find("outer") != std::string_view::npos ||
                          line->find("OUTER") != std::string_view::npos;
        if (auto flaw = loop ? check_loop(lines) : std::nullopt) {
            return flaw;
        }
        ended = line->starts_with("endsolid") || line->starts_with("ENDSOLID") ||
                (ended && line->empty());
    }
    if (!ended) {
        return Flaw{lines.number(), "the file ends before endsolid"};
    }
    return std::nullopt;
}

} // namespace

std::optional<Flaw> prescan_stl(std::string_view bytes) {
    if (!starts_with_solid(bytes)) {
        return prescan_binary(bytes);
    }
    const bool fits_binary =
        bytes.size() > header_size &&
        bytes.size() == header_size + triangle_size * std::size_t{triangle_count(bytes)};
    if (fits_binary) {
        return Flaw{
            0,
            "this binary STL file begins with \"solid\" like a text file: save it with another "
            "header"};
    }
    return prescan_text(bytes);
}

} // namespace hs::scene::mesh
