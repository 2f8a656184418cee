#include "app/lesson/markdown_builder.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace hs::lesson {

namespace {

constexpr std::string_view fence_word = "halfspace";

std::string_view text_of(const MD_ATTRIBUTE& attribute) {
    return {attribute.text, attribute.size};
}

bool same_style(const Span& a, const Span& b) {
    return a.emphasis == b.emphasis && a.strong == b.strong && a.code == b.code && a.link == b.link;
}

Align align_of(MD_ALIGN align) {
    return align == MD_ALIGN_RIGHT    ? Align::right
           : align == MD_ALIGN_CENTER ? Align::center
                                      : Align::left;
}

/// The named entities a lesson is likely to hold; others stay as written.
std::string_view decode_entity(std::string_view entity) {
    struct Row {
        std::string_view entity;
        std::string_view text;
    };
    static constexpr std::array<Row, 7> table{{
        {"&amp;", "&"},
        {"&lt;", "<"},
        {"&gt;", ">"},
        {"&quot;", "\""},
        {"&nbsp;", "\u00a0"},
        {"&lambda;", "λ"},
        {"&times;", "×"},
    }};
    const auto* const row = std::ranges::find(table, entity, &Row::entity);
    return row == table.end() ? entity : row->text;
}

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \n");
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

} // namespace

MarkdownBuilder::MarkdownBuilder(std::string_view source) : source_(source), line_starts_{0} {
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source[i] == '\n') {
            line_starts_.push_back(i + 1);
        }
    }
}

std::size_t MarkdownBuilder::offset_of(const char* text) const {
    const std::less<> before;
    const char* const begin = source_.data();
    const bool inside = !before(text, begin) && !before(begin + source_.size(), text);
    return inside ? static_cast<std::size_t>(text - begin) : std::string_view::npos;
}

Place MarkdownBuilder::place_of(std::size_t offset) const {
    const auto after = std::ranges::upper_bound(line_starts_, offset);
    const auto line = static_cast<std::size_t>(after - line_starts_.begin());
    return {static_cast<int>(line), static_cast<int>(offset - line_starts_[line - 1]) + 1};
}

void MarkdownBuilder::complain(Place place, std::string message) {
    result_.problems.push_back({"", place.line, place.column, std::move(message)});
}

void MarkdownBuilder::open(BlockKind kind) {
    close();
    block_ = Block{};
    block_.kind = kind;
    is_open_ = true;
    spans_ = &block_.spans;
    if (kind == BlockKind::list_item) {
        block_.level = static_cast<int>(lists_.size());
        block_.marker = std::exchange(marker_, {});
    }
}

/// Text without a paragraph around it: the item of a list without blank lines.
void MarkdownBuilder::open_implied() {
    if (!is_open_) {
        open(lists_.empty() ? BlockKind::paragraph : BlockKind::list_item);
    }
}

void MarkdownBuilder::close() {
    if (!is_open_) {
        return;
    }
    is_open_ = false;
    if (block_.kind != BlockKind::table) {
        close_spans(block_.spans);
    }
    result_.parts.emplace_back(std::move(block_));
    spans_ = nullptr;
}

/// Makes placeholders spans of their own. Only now is a text complete that md4c gave in pieces.
void MarkdownBuilder::close_spans(Spans& spans) {
    const bool code_block = block_.kind == BlockKind::code;
    if (code_block && !spans.empty() && spans.back().text.ends_with('\n')) {
        spans.back().text.pop_back();
    }
    Spans split;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        split_placeholders(spans[i], origins_[i], split);
    }
    spans = std::move(split);
    origins_.clear();
    if (block_.place.line == 0 && !spans.empty()) {
        block_.place = spans.front().place;
    }
}

void MarkdownBuilder::split_placeholders(
    const Span& span, const std::vector<std::size_t>& origin, Spans& into
) {
    const std::string_view text = span.text;
    std::size_t from = 0;
    const auto add = [&](std::size_t first, std::size_t last, std::string_view placeholder) {
        if (first == last) {
            return;
        }
        Span part = span;
        part.text = text.substr(first, last - first);
        part.placeholder = placeholder;
        part.place = place_of(origin[first]);
        into.push_back(std::move(part));
    };
    for (;;) {
        const std::size_t begin = text.find("{{", from);
        if (begin == std::string_view::npos) {
            break;
        }
        const std::size_t end = text.find("}}", begin);
        if (end == std::string_view::npos) {
            complain(
                place_of(origin[begin]),
                "a placeholder opened by {{ is not closed by }} in the same stretch of text"
            );
            break;
        }
        add(from, begin, "");
        const std::string_view content = trim(text.substr(begin + 2, end - begin - 2));
        if (content.empty()) {
            complain(
                place_of(origin[begin]), "a placeholder names no quantity: {{ndc.x of vertex 1}}"
            );
        }
        add(begin, end + 2, content);
        from = end + 2;
    }
    add(from, text.size(), "");
}

void MarkdownBuilder::append(std::string_view text, const char* origin) {
    if (text.empty()) {
        return;
    }
    style_.emphasis = emphasis_ > 0;
    style_.strong = strong_ > 0;
    const std::size_t offset = offset_of(origin);
    if (spans_->empty() || !same_style(spans_->back(), style_)) {
        spans_->push_back(style_);
        origins_.emplace_back();
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool from_source = offset != std::string_view::npos;
        origins_.back().push_back(from_source ? offset + i : last_offset_);
    }
    spans_->back().text += text;
    if (offset != std::string_view::npos) {
        last_offset_ = offset + text.size();
    }
}

void MarkdownBuilder::add_text(MD_TEXTTYPE type, std::string_view text) {
    if (in_fence_) {
        fence_.text += text;
        if (const std::size_t offset = offset_of(text.data()); offset != std::string_view::npos) {
            last_offset_ = offset + text.size();
        }
        return;
    }
    if (type == MD_TEXT_HTML) {
        if (html_.empty()) {
            html_offset_ = offset_of(text.data());
        }
        html_ += text;
        if (!in_html_block_) {
            close_html(html_offset_);
        }
        return;
    }
    open_implied();
    switch (type) {
    case MD_TEXT_BR: append("\n", nullptr); break;
    case MD_TEXT_SOFTBR: append(" ", nullptr); break;
    case MD_TEXT_NULLCHAR: append("\ufffd", nullptr); break;
    case MD_TEXT_ENTITY: append(decode_entity(text), nullptr); break;
    case MD_TEXT_NORMAL:
    case MD_TEXT_CODE:
    case MD_TEXT_LATEXMATH: append(text, text.data()); break;
    case MD_TEXT_HTML: break; // above
    }
}

/// Comments are the author's own business; other HTML would be seen on web pages only.
void MarkdownBuilder::close_html(std::size_t offset) {
    const std::string_view html = trim(html_);
    if (!html.starts_with("<!--") || !html.ends_with("-->")) {
        complain(
            offset == std::string_view::npos ? Place{} : place_of(offset),
            "HTML is not shown: write Markdown"
        );
    }
    html_.clear();
}

void MarkdownBuilder::enter_code(const MD_BLOCK_CODE_DETAIL& detail) {
    const std::string_view language = text_of(detail.lang);
    const std::size_t offset = offset_of(language.data());
    if (detail.fence_char != 0 && language == fence_word && offset != std::string_view::npos) {
        close();
        const int line = place_of(offset).line;
        fence_ = {.text = {}, .place = {line, 1}, .first_line = line + 1};
        in_fence_ = true;
        last_offset_ = offset + language.size();
        return;
    }
    open(BlockKind::code);
    style_.code = true;
}

/// Reports a fence that runs to the end of the file: md4c closes it silently, and everything after
/// a forgotten fence would be taken for TOML.
void MarkdownBuilder::close_fence() {
    in_fence_ = false;
    const std::string_view rest = source_.substr(std::min(last_offset_, source_.size()));
    if (rest.find("```") == std::string_view::npos && rest.find("~~~") == std::string_view::npos) {
        complain(fence_.place, "this fenced block is never closed: end it with ```");
        return; // what it swallowed is no TOML
    }
    result_.parts.emplace_back(std::move(fence_));
}

void MarkdownBuilder::enter_cell(const MD_BLOCK_TD_DETAIL& detail) {
    if (block_.cells.size() == 1) {
        block_.columns.push_back(align_of(detail.align));
    }
    block_.cells.back().emplace_back();
    spans_ = &block_.cells.back().back();
}

void MarkdownBuilder::enter_block(MD_BLOCKTYPE type, const void* detail) {
    switch (type) {
    case MD_BLOCK_QUOTE:
        close();
        ++quotes_;
        break;
    case MD_BLOCK_UL:
        close();
        lists_.push_back({});
        break;
    case MD_BLOCK_OL:
        close();
        lists_.push_back({true, static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start});
        break;
    case MD_BLOCK_LI: {
        close();
        List& list = lists_.back();
        marker_ = list.ordered ? std::to_string(list.number++) + "." : "•";
        break;
    }
    case MD_BLOCK_HR:
        open(BlockKind::rule);
        close();
        break;
    case MD_BLOCK_H:
        open(BlockKind::heading);
        block_.level = static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level);
        break;
    case MD_BLOCK_CODE: enter_code(*static_cast<const MD_BLOCK_CODE_DETAIL*>(detail)); break;
    case MD_BLOCK_P:
        open(
            !lists_.empty() ? BlockKind::list_item
            : quotes_ > 0   ? BlockKind::quote
                            : BlockKind::paragraph
        );
        break;
    case MD_BLOCK_TABLE: open(BlockKind::table); break;
    case MD_BLOCK_HTML: in_html_block_ = true; break;
    case MD_BLOCK_TR: block_.cells.emplace_back(); break;
    case MD_BLOCK_TH:
    case MD_BLOCK_TD: enter_cell(*static_cast<const MD_BLOCK_TD_DETAIL*>(detail)); break;
    case MD_BLOCK_DOC:
    case MD_BLOCK_THEAD:
    case MD_BLOCK_TBODY: break;
    }
}

void MarkdownBuilder::leave_block(MD_BLOCKTYPE type) {
    switch (type) {
    case MD_BLOCK_QUOTE:
        close();
        --quotes_;
        break;
    case MD_BLOCK_UL:
    case MD_BLOCK_OL:
        close();
        lists_.pop_back();
        break;
    case MD_BLOCK_CODE:
        if (in_fence_) {
            close_fence();
        } else {
            style_.code = false;
            close();
        }
        break;
    case MD_BLOCK_TH:
    case MD_BLOCK_TD: close_spans(*spans_); break;
    case MD_BLOCK_LI:
    case MD_BLOCK_H:
    case MD_BLOCK_P:
    case MD_BLOCK_TABLE: close(); break;
    case MD_BLOCK_HTML:
        in_html_block_ = false;
        close_html(html_offset_);
        break;
    case MD_BLOCK_DOC:
    case MD_BLOCK_HR:
    case MD_BLOCK_THEAD:
    case MD_BLOCK_TBODY:
    case MD_BLOCK_TR: break;
    }
}

void MarkdownBuilder::enter_span(MD_SPANTYPE type, const void* detail) {
    open_implied();
    if (type == MD_SPAN_EM) {
        ++emphasis_;
    } else if (type == MD_SPAN_STRONG) {
        ++strong_;
    } else if (type == MD_SPAN_CODE) {
        style_.code = true;
    } else if (type == MD_SPAN_A) {
        style_.link = text_of(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
    } else if (type == MD_SPAN_IMG) {
        style_.link = text_of(static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src);
    }
}

void MarkdownBuilder::leave_span(MD_SPANTYPE type) {
    if (type == MD_SPAN_EM) {
        --emphasis_;
    } else if (type == MD_SPAN_STRONG) {
        --strong_;
    } else if (type == MD_SPAN_CODE) {
        style_.code = false;
    } else {
        style_.link.clear();
    }
}

} // namespace hs::lesson
