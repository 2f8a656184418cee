// PLY: OpenMesh believes counts, loops forever in a header without end, reads no strips, and
// misreads properties it does not expect. Source: Greg Turk, The PLY Polygon File Format, 1994.
#include "core/scene/mesh/prescan.hpp"
#include "core/scene/mesh/text_scanner.hpp"
#include "core/scene/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

namespace hs::scene::mesh {

namespace {

enum class Encoding {
    text,
    little_endian,
    big_endian
};

struct ScalarType {
    std::string_view name;
    std::size_t size;
    bool is_float;
    bool is_signed;
};

constexpr ScalarType scalar_types[] = {
    {"char", 1, false, true},
    {"int8", 1, false, true},
    {"uchar", 1, false, false},
    {"uint8", 1, false, false},
    {"short", 2, false, true},
    {"int16", 2, false, true},
    {"ushort", 2, false, false},
    {"uint16", 2, false, false},
    {"int", 4, false, true},
    {"int32", 4, false, true},
    {"uint", 4, false, false},
    {"uint32", 4, false, false},
    {"float", 4, true, true},
    {"float32", 4, true, true},
    {"double", 8, true, true},
    {"float64", 8, true, true},
};

const ScalarType* find_type(std::string_view name) {
    const auto* found = std::ranges::find(scalar_types, name, &ScalarType::name);
    return found == std::end(scalar_types) ? nullptr : found;
}

struct Property {
    std::string_view name;
    const ScalarType* type = nullptr;
    bool is_list = false; ///< then its count is one byte
};

struct Element {
    std::string_view name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

constexpr std::string_view geometry_names[] = {"x", "y", "z", "nx", "ny", "nz", "u", "v", "s", "t"};
constexpr std::string_view color_names[] = {
    "red", "green", "blue", "alpha", "diffuse_red", "diffuse_green", "diffuse_blue"};

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

// ---- header
// ------------------------------------------------------------------------------------------------------

class HeaderScan {
public:
    explicit HeaderScan(std::string_view bytes) : lines_(bytes) {}

    std::optional<Flaw> run() {
        const auto first = lines_.next();
        if (!first || (*first != "ply" && *first != "PLY")) {
            return flaw("the first line must be ply");
        }
        if (auto message = scan_format(lines_.next().value_or(""))) {
            return flaw(*message);
        }
        bool after_comment = false;
        while (auto line = lines_.next()) {
            if (*line == "end_header") {
                return after_comment && encoding != Encoding::text
                           ? flaw("a comment just before end_header makes OpenMesh lose count: "
                                  "move it up")
                           : check_elements();
            }
            after_comment = line->starts_with("comment");
            if (auto message = scan_line(*line)) {
                return flaw(*message);
            }
        }
        return flaw("the header has no end_header");
    }

    [[nodiscard]] const LineScanner& lines() const { return lines_; }

    Encoding encoding = Encoding::text;
    std::vector<Element> elements;

private:
    [[nodiscard]] Flaw flaw(std::string message) const {
        return {lines_.number(), std::move(message)};
    }

    std::optional<std::string> scan_format(std::string_view line) {
        const std::string_view keyword = next_word(line);
        const std::string_view name = next_word(line);
        if (keyword != "format") {
            return std::string{"the second line must be the format"};
        }
        if (name == "binary_little_endian") {
            encoding = Encoding::little_endian;
        } else if (name == "binary_big_endian") {
            encoding = Encoding::big_endian;
        } else if (name != "ascii") {
            return fmt::format("the format \"{}\" is not known", name);
        }
        return parse_number(next_word(line))
                   ? std::nullopt
                   : std::optional<std::string>{"the format has no version"};
    }

    std::optional<std::string> scan_line(std::string_view line) {
        const std::string_view keyword = next_word(line);
        if (keyword == "comment") {
            return std::nullopt;
        }
        if (keyword == "obj_info") {
            return scan_info(line);
        }
        if (keyword == "element") {
            return scan_element(line);
        }
        if (keyword == "property" && !elements.empty()) {
            return scan_property(line);
        }
        return fmt::format("\"{}\" is not expected in the header", keyword);
    }

    /// OpenMesh takes every word of such a line for a keyword.
    static std::optional<std::string> scan_info(std::string_view line) {
        constexpr std::string_view keywords[] = {"comment", "element", "property", "end_header"};
        for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
            if (is_one_of(word, keywords)) {
                return fmt::format("an obj_info line must not contain the keyword {}", word);
            }
        }
        return std::nullopt;
    }

    std::optional<std::string> scan_element(std::string_view line) {
        Element element;
        element.name = next_word(line);
        const auto count = parse_whole(next_word(line));
        if (!count || *count < 0 || *count > 0x7FFFFFFF || !next_word(line).empty()) {
            return std::string{"an element needs a name and a count"};
        }
        if (element.name == "tristrips") {
            return std::string{"triangle strips are not read: save the mesh with faces"};
        }
        element.count = *count;
        elements.push_back(element);
        return std::nullopt;
    }

    std::optional<std::string> scan_property(std::string_view line) {
        Property property;
        std::string_view type = next_word(line);
        if (type == "list") {
            property.is_list = true;
            const std::string_view count_type = next_word(line);
            if (count_type != "uchar" && count_type != "uint8") {
                return std::string{"the count of a list must be an uchar"};
            }
            type = next_word(line);
        }
        property.type = find_type(type);
        property.name = next_word(line);
        if (property.type == nullptr || property.name.empty() ||
            find_type(property.name) != nullptr) {
            return std::string{"a property needs a known type and a name"};
        }
        elements.back().properties.push_back(property);
        return check_property(elements.back().name, property);
    }

    [[nodiscard]] std::optional<std::string>
    check_property(std::string_view element, const Property& property) const {
        const bool binary = encoding != Encoding::text;
        if (element == "vertex") {
            return check_vertex_property(property, binary);
        }
        if (element != "face") {
            return std::nullopt; // after the faces; OpenMesh stops there
        }
        const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
        if (property.is_list != corners) {
            return fmt::format(
                "the property {} of faces is not read: only vertex_indices is a list", property.name
            );
        }
        if (binary && !corners) {
            return fmt::format(
                "in binary files faces can have no property {} beside vertex_indices", property.name
            );
        }
        if (corners && (property.type->is_float || property.type->size == 2)) {
            return std::string{"vertex_indices must be of the type int or uint"};
        }
        return std::nullopt;
    }

    static std::optional<std::string> check_vertex_property(const Property& property, bool binary) {
        if (property.is_list) {
            return fmt::format("the list {} of vertices is not read", property.name);
        }
        if (is_one_of(property.name, geometry_names) &&
            (!property.type->is_float || (binary && property.type->size != 4))) {
            return fmt::format("{} must be of the type float", property.name);
        }
        const bool color = is_one_of(property.name, color_names);
        if (color && (property.type->size == 8 || property.type->size == 2)) {
            return fmt::format("{} must be of the type uchar or float", property.name);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Flaw> check_elements() const {
        if (elements.size() < 2 || elements[0].name != "vertex" || elements[1].name != "face") {
            return flaw("the elements vertex and face must come first, in this order");
        }
        for (const std::string_view axis : {"x", "y", "z"}) {
            if (std::ranges::count(elements[0].properties, axis, &Property::name) != 1) {
                return flaw(fmt::format("vertices need the property {} once", axis));
            }
        }
        const auto& properties = elements[1].properties;
        if (properties.empty() || !properties[0].is_list ||
            std::ranges::count(properties, true, &Property::is_list) != 1) {
            return flaw("faces need vertex_indices as their first property, once");
        }
        return std::nullopt;
    }

    LineScanner lines_;
};

// ---- data
// --------------------------------------------------------------------------------------------------------

/// One number after the other, from text or bytes.
class NumberStream {
public:
    NumberStream(std::string_view data, Encoding encoding, int line)
        : data_(data), encoding_(encoding), line_(line) {}

    /// Nothing at the end of the file or for what is no finite number.
    std::optional<double> next(const ScalarType& type) {
        return encoding_ == Encoding::text ? next_text(type) : next_binary(type);
    }
    /// 0 in binary files.
    [[nodiscard]] int line() const { return encoding_ == Encoding::text ? line_ : 0; }

private:
    std::optional<double> next_text(const ScalarType& type) {
        const std::size_t before = data_.find_first_not_of(" \t\r\n\v\f");
        const std::string_view skipped = data_.substr(0, before);
        line_ += static_cast<int>(std::ranges::count(skipped, '\n'));
        const std::string_view word = next_word(data_);
        if (type.is_float) {
            const auto number = parse_number(word);
            return number ? std::optional{static_cast<double>(*number)} : std::nullopt;
        }
        const auto whole = parse_whole(word);
        return whole ? std::optional{static_cast<double>(*whole)} : std::nullopt;
    }

    std::optional<double> next_binary(const ScalarType& type) {
        if (data_.size() < type.size) {
            return std::nullopt;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.size; ++i) {
            const std::size_t place = encoding_ == Encoding::little_endian ? i : type.size - 1 - i;
            bits |= std::uint64_t{static_cast<unsigned char>(data_[i])} << (8 * place);
        }
        data_.remove_prefix(type.size);
        if (type.is_float) {
            const double number =
                type.size == 8
                    ? std::bit_cast<double>(bits)
                    : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
            return std::isfinite(number) ? std::optional{number} : std::nullopt;
        }
        const auto shift = static_cast<unsigned>(64 - 8 * type.size);
        return type.is_signed
                   ? static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift)
                   : static_cast<double>(bits);
    }

    std::string_view data_;
    Encoding encoding_;
    int line_;
};

std::optional<std::string> scan_vertex(NumberStream& numbers, const Element& vertices) {
    for (const Property& property : vertices.properties) {
        const auto number = numbers.next(*property.type);
        if (!number) {
            return fmt::format("{} is missing or no finite number", property.name);
        }
        const double most = property.type->is_float ? 1.0 : 255.0;
        if (is_one_of(property.name, color_names) && (*number < 0.0 || *number > most)) {
            return fmt::format("{} must be from 0 to {}", property.name, most);
        }
    }
    return std::nullopt;
}

std::optional<std::string>
scan_face(NumberStream& numbers, const Element& faces, std::int64_t vertex_count) {
    constexpr ScalarType count_type{"uchar", 1, false, false};
    for (const Property& property : faces.properties) {
        const auto count = property.is_list ? numbers.next(count_type) : std::optional{1.0};
        const double fewest = property.is_list ? 3.0 : 1.0;
        if (!count || *count < fewest || *count > static_cast<double>(max_polygon_corners)) {
            return fmt::format("a number of corners from 3 to {} is expected", max_polygon_corners);
        }
        for (int i = 0; i < static_cast<int>(*count); ++i) {
            const auto number = numbers.next(*property.type);
            const bool in_range =
                number && *number >= 0.0 && *number < static_cast<double>(vertex_count);
            if (!number || (property.is_list && !in_range)) {
                return fmt::format("a vertex number from 0 to {} is expected", vertex_count - 1);
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Flaw> prescan_ply(std::string_view bytes) {
    HeaderScan header{bytes};
    if (auto flaw = header.run()) {
        return flaw;
    }
    const Element& vertices = header.elements[0];
    const Element& faces = header.elements[1];
    // One character or byte per number at least, beside what separates them.
    if (static_cast<std::size_t>(vertices.count) * vertices.properties.size() > bytes.size() ||
        static_cast<std::size_t>(faces.count) * 4 > bytes.size()) {
        return Flaw{
            0,
            fmt::format(
                "the file is too short for {} vertices and {} faces", vertices.count, faces.count
            )};
    }
    NumberStream numbers{header.lines().rest(), header.encoding, header.lines().number() + 1};
    for (std::int64_t i = 0; i < vertices.count; ++i) {
        if (auto message = scan_vertex(numbers, vertices)) {
            return Flaw{
                numbers.line(), fmt::format("vertex {} of {}: {}", i, vertices.count, *message)};
        }
    }
    for (std::int64_t i = 0; i < faces.count; ++i) {
        if (auto message = scan_face(numbers, faces, vertices.count)) {
            return Flaw{numbers.line(), fmt::format("face {} of {}: {}", i, faces.count, *message)};
        }
    }
    return std::nullopt;
}

} // namespace hs::scene::mesh
