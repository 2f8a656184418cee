#include "app/lesson/document.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace hs::lesson {

namespace {

/// Columns a text takes in a terminal: its code points. Lessons hold no wider characters.
std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// Breaks lines between words. The first line starts with `first`, the others with as many blanks.
std::string wrap(std::string_view text, const std::string& first, std::size_t width) {
    const std::string indent(columns(first), ' ');
    std::string result = first;
    std::size_t used = columns(first);
    bool line_empty = true;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
        const std::string_view word = text.substr(from, end - from);
        const std::size_t length = columns(word);
        if (!line_empty && used + 1 + length > width) {
            result += '\n' + indent;
            used = indent.size();
            line_empty = true;
        }
        if (!word.empty()) {
            result += (line_empty ? "" : " ");
            used += length + (line_empty ? 0 : 1);
            result += word;
            line_empty = false;
        }
        if (end < text.size() && text[end] == '\n') {
            result += '\n' + indent;
            used = indent.size();
            line_empty = true;
        }
        from = end + 1;
    }
    return result + '\n';
}

std::string indent_lines(std::string_view text, std::string_view indent) {
    std::string result;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        result.append(indent).append(text.substr(from, end - from)).append("\n");
        from = end + 1;
    }
    return result;
}

std::string pad(const std::string& text, std::size_t width, Align align) {
    const std::string blanks(width - std::min(width, columns(text)), ' ');
    const std::size_t half = align == Align::center ? blanks.size() / 2 : 0;
    return align == Align::right ? blanks + text
                                 : blanks.substr(0, half) + text + blanks.substr(half);
}

std::string print_table(const Block& table) {
    std::vector<std::size_t> widths(table.columns.size(), 0);
    for (const std::vector<Spans>& row : table.cells) {
        for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i) {
            widths[i] = std::max(widths[i], columns(to_plain_text(row[i])));
        }
    }
    std::string result;
    for (const std::vector<Spans>& row : table.cells) {
        std::string line;
        for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i) {
            line += "  " + pad(to_plain_text(row[i]), widths[i], table.columns[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        result += line + '\n';
    }
    return result;
}

std::string print_block(const Block& block, std::size_t width) {
    std::string text = to_plain_text(block.spans);
    switch (block.kind) {
    case BlockKind::paragraph: return wrap(text, "", width);
    case BlockKind::heading:
        return std::string(static_cast<std::size_t>(block.level), '#') + " " + text + '\n';
    case BlockKind::list_item: {
        const std::string indent(2 * static_cast<std::size_t>(block.level), ' ');
        return wrap(text, indent + (block.marker.empty() ? " " : block.marker) + " ", width);
    }
    case BlockKind::code: return indent_lines(text, "    ");
    case BlockKind::quote: return wrap(text, "  | ", width);
    case BlockKind::table: return print_table(block);
    case BlockKind::rule: return std::string(std::min<std::size_t>(width, 40), '-') + '\n';
    }
    return text;
}

} // namespace

std::string to_plain_text(const Spans& spans) {
    std::string text;
    for (const Span& span : spans) {
        text += span.text;
    }
    return text;
}

std::string to_plain_text(const Document& document, int width) {
    std::string result;
    const Block* before = nullptr;
    for (const Block& block : document) {
        const bool in_list = block.kind == BlockKind::list_item && before != nullptr &&
                             before->kind == BlockKind::list_item;
        if (before != nullptr && !in_list) {
            result += '\n';
        }
        result += print_block(block, static_cast<std::size_t>(std::max(width, 20)));
        before = &block;
    }
    return result;
}

} // namespace hs::lesson
