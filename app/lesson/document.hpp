// What a lesson says, ready to be drawn: a flat list of blocks made of styled spans. Markdown is
// read once (markdown.hpp); the window and the terminal draw from this.
#pragma once

#include <string>
#include <vector>

namespace hs::lesson {

/// Where something stands in the lesson's file. Both count from 1; 0 means "the whole".
struct Place {
    int line = 0;
    int column = 0;
    friend bool operator==(const Place&, const Place&) = default;
};

/// A stretch of text in one style.
struct Span {
    std::string text;
    bool emphasis = false;
    bool strong = false;
    bool code = false;   ///< monospaced
    bool quoted = false; ///< a value read from the trace: worth a different color
    std::string link;    ///< target, "" for plain text
    /// What stands between the braces of `{{…}}`; empty once the value is filled in, or for plain
    /// text.
    std::string placeholder;
    Place place;
};
using Spans = std::vector<Span>;

enum class BlockKind {
    paragraph,
    heading,
    list_item,
    code,
    quote,
    table,
    rule
};

enum class Align {
    left,
    center,
    right
};

/// One block. Lists are sequences of items, each with its depth and its bullet or number.
struct Block {
    BlockKind kind = BlockKind::paragraph;
    int level = 0;      ///< heading: 1 … 6; list item: depth, from 1
    std::string marker; ///< list item: "•" or "2."; empty for a further paragraph of an item
    Spans spans;        ///< all but table and rule; code keeps its line breaks
    std::vector<Align> columns;            ///< table
    std::vector<std::vector<Spans>> cells; ///< table: rows of cells, the heading row first
    Place place;
};
using Document = std::vector<Block>;

/// Calls `visit` for every list of spans in a document: those of its blocks and of table cells.
template <typename Visit>
void for_each_text(Document& document, Visit visit) {
    for (Block& block : document) {
        visit(block.spans);
        for (std::vector<Spans>& row : block.cells) {
            for (Spans& cell : row) {
                visit(cell);
            }
        }
    }
}

/// For terminals and tests: paragraphs wrapped at `width` columns, tables aligned, styles dropped.
std::string to_plain_text(const Document& document, int width = 80);

/// The text of spans, styles dropped.
std::string to_plain_text(const Spans& spans);

} // namespace hs::lesson
