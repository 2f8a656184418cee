// Markdown in, blocks out, through md4c (CommonMark with tables). md4c gives no line numbers; the
// texts it hands over point into the input, so places are found by subtracting.
#pragma once

#include "app/lesson/document.hpp"
#include "core/base/diagnostic.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hs::lesson {

/// A fenced block of a lesson's own language: TOML for the loader, not for readers.
struct FencedBlock {
    std::string text;
    Place place;        ///< of the fence
    int first_line = 0; ///< of `text` in the file
};

using MarkdownPart = std::variant<Block, FencedBlock>;

struct Markdown {
    std::vector<MarkdownPart> parts; ///< in the order of the file
    Diagnostics problems;            ///< without a file: fences and placeholders never closed
};

/// Blocks fenced with the word `halfspace` come back as FencedBlock.
Markdown parse_markdown(std::string_view text);

/// A short text from inside a fenced block; everything in it stands at `place`.
Document parse_short_markdown(std::string_view text, Place place, Diagnostics& problems);

} // namespace hs::lesson
