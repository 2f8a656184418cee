// OBJ: OpenMesh drops lines it cannot parse, which shifts every later index, and passes indices on
// unchecked.
#include "core/scene/mesh/prescan.hpp"
#include "core/scene/mesh/text_scanner.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <array>

namespace hs::scene::mesh {

namespace {

/// Positions, texture coordinates, normals: in the order in which a face's corner names them.
using Counts = std::array<std::int64_t, 3>;
constexpr std::array<std::string_view, 3> attribute_words{"v", "vt", "vn"};
constexpr std::array<std::string_view, 3> attribute_names{"vertex", "texture coordinate", "normal"};

/// Which of `v`, `vt`, `vn` a line is; 3: none.
std::size_t attribute_of(std::string_view word) {
    std::size_t i = 0;
    while (i < attribute_words.size() && attribute_words[i] != word) {
        ++i;
    }
    return i;
}

std::optional<std::string> check_attribute(std::string_view rest, std::size_t attribute) {
    const int needed = attribute == 1 ? 2 : 3;
    if (!skip_numbers(rest, needed)) {
        return fmt::format("a {} needs {} finite numbers", attribute_names[attribute], needed);
    }
    return std::nullopt;
}

/// `v x y z r g b` is a colored vertex.
bool has_color(std::string_view rest) {
    return skip_numbers(rest, 6);
}

class ObjScan {
public:
    explicit ObjScan(std::string_view bytes) : bytes_(bytes) {}

    std::optional<Flaw> run() {
        if (auto flaw = scan_attributes()) {
            return flaw;
        }
        if (colored_ != 0 && colored_ != total_[0]) {
            return Flaw{0, "some vertices have colors and some have not: give all of them one"};
        }
        return scan_faces();
    }

private:
    std::optional<Flaw> scan_attributes() {
        LineScanner lines{bytes_};
        while (auto line = lines.next()) {
            std::string_view rest = *line;
            const std::size_t attribute = attribute_of(next_word(rest));
            if (attribute == attribute_words.size()) {
                continue;
            }
            if (auto message = check_attribute(rest, attribute)) {
                return Flaw{lines.number(), *message};
            }
            ++total_[attribute];
            colored_ += attribute == 0 && has_color(rest) ? 1 : 0;
        }
        return std::nullopt;
    }

    std::optional<Flaw> scan_faces() {
        LineScanner lines{bytes_};
        Counts so_far{};
        while (auto line = lines.next()) {
            std::string_view rest = *line;
            const std::string_view word = next_word(rest);
            const std::size_t attribute = attribute_of(word);
            if (attribute < attribute_words.size()) {
                ++so_far[attribute];
            } else if (word == "f") {
                if (auto message = check_face(rest, so_far)) {
                    return Flaw{lines.number(), *message};
                }
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::string>
    check_face(std::string_view rest, const Counts& so_far) const {
        std::size_t corners = 0;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
            if (auto message = check_corner(word, so_far)) {
                return message;
            }
            ++corners;
        }
        if (corners < 3 || corners > max_polygon_corners) {
            return fmt::format("a face has 3 to {} corners, not {}", max_polygon_corners, corners);
        }
        return std::nullopt;
    }

    /// `7`, `7/2`, `7//3` or `7/2/3`; negative numbers count back from the latest.
    [[nodiscard]] std::optional<std::string>
    check_corner(std::string_view word, const Counts& so_far) const {
        std::string_view rest = word;
        for (std::size_t i = 0; i < attribute_words.size(); ++i) {
            const std::size_t slash = rest.find('/');
            const std::string_view part = rest.substr(0, slash);
            if (part.empty() && i != 1) {
                return fmt::format("the corner \"{}\" is not of the form v/vt/vn", word);
            }
            if (auto message = part.empty() ? std::nullopt : check_index(part, i, so_far[i])) {
                return message;
            }
            if (slash == std::string_view::npos) {
                return std::nullopt;
            }
            rest.remove_prefix(slash + 1);
        }
        return fmt::format("the corner \"{}\" is not of the form v/vt/vn", word);
    }

    [[nodiscard]] std::optional<std::string>
    check_index(std::string_view part, std::size_t attribute, std::int64_t so_far) const {
        const std::optional<std::int64_t> number = parse_whole(part);
        if (!number) {
            return fmt::format(
                "\"{}\" is not the number of a {}", part, attribute_names[attribute]
            );
        }
        const std::int64_t index = *number < 0 ? so_far + *number + 1 : *number;
        if (index < 1 || index > total_[attribute]) {
            return fmt::format(
                "there is no {} {}: the file has {}",
                attribute_names[attribute],
                *number,
                total_[attribute]
            );
        }
        return std::nullopt;
    }

    std::string_view bytes_;
    Counts total_{};
    std::int64_t colored_ = 0;
};

} // namespace

std::optional<Flaw> prescan_obj(std::string_view bytes) {
    return ObjScan{bytes}.run();
}

} // namespace hs::scene::mesh
