#include "core/scene/mesh/text_scanner.hpp"

#include <charconv>
#include <cmath>
#include <limits>

namespace hs::scene::mesh {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    const std::size_t last = text.find_last_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, last - first + 1);
}

/// `from_chars` knows no leading plus, streams do.
std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

} // namespace

std::optional<std::string_view> LineScanner::next() {
    if (rest_.empty()) {
        return std::nullopt;
    }
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    ++number_;
    return trim(line);
}

std::optional<std::string_view> LineScanner::next_filled() {
    std::optional<std::string_view> line = next();
    while (line && line->empty()) {
        line = next();
    }
    return line;
}

std::string_view next_word(std::string_view& text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        text = {};
        return {};
    }
    text.remove_prefix(first);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

std::optional<float> parse_number(std::string_view word) {
    const std::string_view digits = without_plus(word);
    double number = 0.0;
    const char* end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, number);
    const bool fits = std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
    if (error != std::errc{} || rest != end || !fits) {
        return std::nullopt;
    }
    return static_cast<float>(number);
}

std::optional<std::int64_t> parse_whole(std::string_view word) {
    const std::string_view digits = without_plus(word);
    std::int64_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional{number} : std::nullopt;
}

bool skip_numbers(std::string_view& text, int count) {
    for (int i = 0; i < count; ++i) {
        if (!parse_number(next_word(text))) {
            return false;
        }
    }
    return true;
}

} // namespace hs::scene::mesh
