// Lines, words and numbers of text formats, without copying.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hs::scene::mesh {

/// One line after the other, trimmed; lines count from 1.
class LineScanner {
public:
    explicit LineScanner(std::string_view text) : rest_(text) {}

    /// The next line; nothing at the end.
    std::optional<std::string_view> next();
    /// The next line that is not empty.
    std::optional<std::string_view> next_filled();
    [[nodiscard]] int number() const { return number_; }
    /// What follows the line read last.
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
    int number_ = 0;
};

/// Cuts the first word off the text; empty when there is none.
std::string_view next_word(std::string_view& text);

/// A finite number within the range of float.
std::optional<float> parse_number(std::string_view word);
std::optional<std::int64_t> parse_whole(std::string_view word);

/// Cuts `count` numbers off the text; false when one is missing or no finite number.
bool skip_numbers(std::string_view& text, int count);

} // namespace hs::scene::mesh
