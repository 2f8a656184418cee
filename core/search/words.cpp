#include "core/search/expression.hpp"

#include <cctype>

namespace hs::search {
namespace {

bool begins_name(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool goes_on(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Reads on from a place in a text.
class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool done() const { return rest_.empty(); }
    [[nodiscard]] char next() const { return rest_.front(); }
    void skip() { rest_.remove_prefix(1); }

    /// "fragment.pixel.x" or "triangle.vertices[0]", the latter as "triangle.vertices.0".
    std::string take_name() {
        std::string name = take_word();
        for (;;) {
            if (rest_.size() > 1 && next() == '.' && begins_name(rest_[1])) {
                skip();
                name += '.' + take_word();
            } else if (const std::string index = take_index(); !index.empty()) {
                name += '.' + index;
            } else {
                return name;
            }
        }
    }

    /// What stands between two equal quotes, as written.
    std::string take_text() {
        const char quote = next();
        skip();
        std::string text;
        while (!done() && next() != quote) {
            if (next() == '\\' && rest_.size() > 1) {
                skip();
            }
            text += next();
            skip();
        }
        if (!done()) {
            skip();
        }
        return text;
    }

private:
    std::string take_word() {
        std::string word;
        while (!done() && goes_on(next())) {
            word += next();
            skip();
        }
        return word;
    }

    std::string take_index() {
        const std::size_t end = rest_.find(']');
        if (done() || next() != '[' || end == std::string_view::npos || end == 1) {
            return "";
        }
        const std::string_view index = rest_.substr(1, end - 1);
        if (index.find_first_not_of("0123456789") != std::string_view::npos) {
            return "";
        }
        rest_.remove_prefix(end + 1);
        return std::string{index};
    }

    std::string_view rest_;
};

} // namespace

Words words_of(std::string_view text) {
    Words words;
    Reader reader(text);
    while (!reader.done()) {
        if (begins_name(reader.next())) {
            words.names.push_back(reader.take_name());
        } else if (reader.next() == '"' || reader.next() == '\'') {
            words.texts.push_back(reader.take_text());
        } else {
            reader.skip();
        }
    }
    return words;
}

} // namespace hs::search
