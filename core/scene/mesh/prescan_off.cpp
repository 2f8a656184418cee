// OFF: OpenMesh reads [ST][C][N]OFF as text, one vertex or face per line; what is missing it takes
// from the next line or makes up.
#include "core/scene/mesh/prescan.hpp"
#include "core/scene/mesh/text_scanner.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

namespace hs::scene::mesh {

namespace {

struct Header {
    bool texture = false;
    bool color = false;
    bool normal = false;
};

bool cut(std::string_view& text, std::string_view prefix) {
    const bool found = text.starts_with(prefix);
    text.remove_prefix(found ? prefix.size() : 0);
    return found;
}

std::optional<Header> parse_header(std::string_view line) {
    Header header;
    header.texture = cut(line, "ST");
    header.color = cut(line, "C");
    header.normal = cut(line, "N");
    return line == "OFF" ? std::optional{header} : std::nullopt;
}

class OffScan {
public:
    explicit OffScan(std::string_view bytes) : size_(bytes.size()), lines_(bytes) {}

    std::optional<Flaw> run() {
        const auto header = parse_header(lines_.next().value_or(""));
        if (!header) {
            return flaw(
                "the first line must be OFF, COFF, NOFF, STOFF or a mixture, and nothing else"
            );
        }
        header_ = *header;
        if (auto found = scan_counts()) {
            return found;
        }
        for (std::int64_t i = 0; i < vertices_; ++i) {
            if (auto found = scan_vertex(i)) {
                return found;
            }
        }
        for (std::int64_t i = 0; i < faces_; ++i) {
            if (auto found = scan_face(i)) {
                return found;
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] Flaw flaw(std::string message) const {
        return {lines_.number(), std::move(message)};
    }

    std::optional<Flaw> scan_counts() {
        constexpr std::int64_t most = 0x7FFFFFFF; // OpenMesh numbers them with int
        std::string_view rest = lines_.next_filled().value_or("");
        const auto vertices = parse_whole(next_word(rest));
        const auto faces = parse_whole(next_word(rest));
        const auto edges = parse_whole(next_word(rest));
        if (!vertices || !faces || !edges || *vertices < 0 || *faces < 0 || *vertices > most ||
            *faces > most || !rest.empty()) {
            return flaw("the numbers of vertices, faces and edges are expected here");
        }
        // "0 0 0" and "3 0 1 2", each with a line break
        if (*vertices * 6 + *faces * 8 > static_cast<std::int64_t>(size_) + 1) {
            return flaw("the file is too short for so many vertices and faces");
        }
        vertices_ = *vertices;
        faces_ = *faces;
        return std::nullopt;
    }

    std::optional<Flaw> scan_vertex(std::int64_t number) {
        const auto line = lines_.next_filled();
        if (!line) {
            return flaw(fmt::format("the file ends before vertex {} of {}", number, vertices_));
        }
        std::string_view rest = *line;
        const int needed = header_.normal ? 6 : 3;
        if (!skip_numbers(rest, needed)) {
            return flaw(fmt::format("vertex {} needs {} finite numbers", number, needed));
        }
        return scan_extras(rest);
    }

    /// Colors and texture coordinates; OpenMesh counts them by single spaces.
    [[nodiscard]] std::optional<Flaw> scan_extras(std::string_view rest) const {
        if (rest.find("  ") != std::string_view::npos ||
            rest.find('\t') != std::string_view::npos) {
            return flaw("numbers after the position must be separated by single spaces");
        }
        int count = 0;
        while (!rest.empty()) {
            if (!skip_numbers(rest, 1)) {
                return flaw("a finite number is expected");
            }
            ++count;
        }
        const int colors = count - (header_.texture ? 2 : 0);
        const bool good = header_.color ? colors == 0 || colors == 3 || colors == 4 : colors == 0;
        if (!good) {
            return flaw("there are more or fewer numbers than the first line of the file announces"
            );
        }
        return std::nullopt;
    }

    std::optional<Flaw> scan_face(std::int64_t number) {
        const auto line = lines_.next_filled();
        if (!line) {
            return flaw(fmt::format("the file ends before face {} of {}", number, faces_));
        }
        std::string_view rest = *line;
        const auto corners = parse_whole(next_word(rest));
        if (!corners || *corners < 3 || *corners > static_cast<std::int64_t>(max_polygon_corners)) {
            return flaw(fmt::format(
                "face {} needs a number of corners from 3 to {}", number, max_polygon_corners
            ));
        }
        for (std::int64_t i = 0; i < *corners; ++i) {
            const auto index = parse_whole(next_word(rest));
            if (!index || *index < 0 || *index >= vertices_) {
                return flaw(
                    fmt::format("face {} needs vertex numbers from 0 to {}", number, vertices_ - 1)
                );
            }
        }
        if (!rest.empty() && !header_.color) {
            return flaw("numbers after the corners are colors, which need COFF in the first line");
        }
        return std::nullopt;
    }

    std::size_t size_;
    LineScanner lines_;
    Header header_;
    std::int64_t vertices_ = 0;
    std::int64_t faces_ = 0;
};

} // namespace

std::optional<Flaw> prescan_off(std::string_view bytes) {
    return OffScan{bytes}.run();
}

} // namespace hs::scene::mesh
