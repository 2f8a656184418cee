// `{{ndc.x of vertex 2}}` in narration: numbers that come from the trace, so that they cannot rot.
//
// The full form is `{{0.25 = ndc.x of object 0 / vertex 2 : 3}}`: the number as a web page shows it
// (checked against the trace, never shown by the program), quantity, subject, digits after the
// point. Only the quantity is needed.
#pragma once

#include "app/lesson/document.hpp"
#include "app/lesson/evaluate.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace hs::lesson {

struct Placeholder {
    std::optional<std::string> written; ///< the number before `=`
    std::string quantity;
    std::string of;
    int digits = -1; ///< −1: as many as needed
};

/// Errors: digits that are no number, an unknown quantity, a subject that is not understood.
Result<Placeholder> parse_placeholder(std::string_view text);

/// What placeholders are filled with.
struct Filling {
    const Evaluator* evaluate = nullptr;                    ///< never null in use
    std::function<bool(std::string_view)> is_hidden;        ///< these read "?"; may be empty
    std::map<std::string, Value, std::less<>> named_values; ///< `{{right}}` and `{{wrong}}`
};

/// Replaces every placeholder by its value. What cannot be filled in stays as written and is
/// reported, and so is a written number that is not the trace's.
Document fill_in(Document document, const Filling& filling, Diagnostics& problems);

/// A text from a fenced block: Markdown, filled in.
Document
fill_in_text(std::string_view markdown, Place place, const Filling& filling, Diagnostics& problems);

} // namespace hs::lesson
