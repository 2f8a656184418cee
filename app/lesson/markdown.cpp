#include "app/lesson/markdown.hpp"

#include "app/lesson/markdown_builder.hpp"

#include <limits>

namespace hs::lesson {

namespace {

constexpr unsigned flags = MD_FLAG_TABLES;

MarkdownBuilder& builder(void* user) {
    return *static_cast<MarkdownBuilder*>(user);
}

MD_PARSER parser() {
    MD_PARSER events{};
    events.flags = flags;
    events.enter_block = [](MD_BLOCKTYPE type, void* detail, void* user) {
        builder(user).enter_block(type, detail);
        return 0;
    };
    events.leave_block = [](MD_BLOCKTYPE type, void* /*detail*/, void* user) {
        builder(user).leave_block(type);
        return 0;
    };
    events.enter_span = [](MD_SPANTYPE type, void* detail, void* user) {
        builder(user).enter_span(type, detail);
        return 0;
    };
    events.leave_span = [](MD_SPANTYPE type, void* /*detail*/, void* user) {
        builder(user).leave_span(type);
        return 0;
    };
    events.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* user) {
        builder(user).add_text(type, {text, size});
        return 0;
    };
    return events;
}

} // namespace

Markdown parse_markdown(std::string_view text) {
    HS_CHECK(text.size() < std::numeric_limits<MD_SIZE>::max(), "the loader limits the size");
    MarkdownBuilder events(text);
    const MD_PARSER how = parser();
    const int failed = md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &how, &events);
    Markdown result = events.take();
    if (failed != 0) {
        result.problems.push_back({"", 0, 0, "the Markdown could not be read: out of memory"});
    }
    return result;
}

Document parse_short_markdown(std::string_view text, Place place, Diagnostics& problems) {
    Markdown markdown = parse_markdown(text);
    for (Diagnostic& problem : markdown.problems) {
        problems.push_back({"", place.line, place.column, std::move(problem.message)});
    }
    Document document;
    for (MarkdownPart& part : markdown.parts) {
        if (auto* const block = std::get_if<Block>(&part)) {
            document.push_back(std::move(*block));
        }
    }
    for (Block& block : document) {
        block.place = place;
    }
    for_each_text(document, [place](Spans& spans) {
        for (Span& span : spans) {
            span.place = place;
        }
    });
    return document;
}

} // namespace hs::lesson
