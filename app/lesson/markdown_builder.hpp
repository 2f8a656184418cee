// Collects md4c's events into blocks. Lists come flat, one block per item; `{{…}}` becomes a span
// of its own.
#pragma once

#include "app/lesson/markdown.hpp"

#include <md4c.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hs::lesson {

class MarkdownBuilder {
public:
    explicit MarkdownBuilder(std::string_view source);

    void enter_block(MD_BLOCKTYPE type, const void* detail);
    void leave_block(MD_BLOCKTYPE type);
    void enter_span(MD_SPANTYPE type, const void* detail);
    void leave_span(MD_SPANTYPE type);
    void add_text(MD_TEXTTYPE type, std::string_view text);

    [[nodiscard]] Markdown take() { return std::move(result_); }

private:
    struct List {
        bool ordered = false;
        unsigned number = 1;
    };

    void open(BlockKind kind);
    void open_implied();
    void close();
    void close_spans(Spans& spans);
    void close_fence();
    void close_html(std::size_t offset);
    void enter_code(const MD_BLOCK_CODE_DETAIL& detail);
    void enter_cell(const MD_BLOCK_TD_DETAIL& detail);
    void append(std::string_view text, const char* origin);
    void split_placeholders(const Span& span, const std::vector<std::size_t>& origin, Spans& into);
    [[nodiscard]] Place place_of(std::size_t offset) const;
    /// Where a text of md4c's stands in the source; `npos` for texts of its own.
    [[nodiscard]] std::size_t offset_of(const char* text) const;
    void complain(Place place, std::string message);

    std::string_view source_;
    std::vector<std::size_t> line_starts_;
    Markdown result_;

    Block block_; ///< the one being filled
    bool is_open_ = false;
    Spans* spans_ = nullptr; ///< where text goes: the block's, or a table cell's
    std::vector<std::vector<std::size_t>> origins_; ///< per span of *spans_, per character
    Span style_;                                    ///< the style of the next text
    int emphasis_ = 0;
    int strong_ = 0;

    std::vector<List> lists_;
    std::string marker_; ///< of the item that has no block yet
    int quotes_ = 0;
    bool in_fence_ = false;
    FencedBlock fence_;
    bool in_html_block_ = false;
    std::string html_;
    std::size_t html_offset_ = 0;
    std::size_t last_offset_ = 0; ///< the end of the last text that came from the source
};

} // namespace hs::lesson
