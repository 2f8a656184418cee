#include "app/lesson/placeholder.hpp"

#include "app/lesson/markdown.hpp"
#include "app/lesson/quantity.hpp"
#include "app/lesson/subject.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace hs::lesson {

namespace {

constexpr std::string_view counted = "number of ";
constexpr int most_digits = 9;

std::string_view trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos
               ? std::string_view{}
               : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

Diagnostic complain(std::string message) {
    return {"", 0, 0, std::move(message)};
}

std::optional<int> parse_digits(std::string_view text) {
    int digits = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, digits);
    const bool whole = error == std::errc{} && rest == end;
    return whole && digits >= 0 && digits <= most_digits ? std::optional{digits} : std::nullopt;
}

/// As many digits as the author wrote: "0.50" has two.
int digits_of(std::string_view written) {
    const std::size_t point = written.find('.');
    return point == std::string_view::npos ? -1 : static_cast<int>(written.size() - point) - 1;
}

/// What a placeholder reads, and whether the page says otherwise.
struct Reading {
    std::string text;
    std::string contradiction; ///< what the trace says; empty where the page agrees or is silent
};

/// A number with a plain hyphen is as good as one with a minus sign.
std::string with_minus(const std::string& text) {
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

Result<Reading> read(const Span& span, const Filling& filling) {
    if (const auto named = filling.named_values.find(span.placeholder);
        named != filling.named_values.end()) {
        return Reading{print_value(named->second), ""};
    }
    const Result<Placeholder> placeholder = parse_placeholder(span.placeholder);
    if (!placeholder) {
        return placeholder.diagnostics();
    }
    if (filling.is_hidden && filling.is_hidden(placeholder->quantity)) {
        return Reading{"?", ""};
    }
    const Result<Value> value = (*filling.evaluate)({
        .quantity = placeholder->quantity,
        .of = placeholder->of,
        .settings = {},
        .place = span.place,
    });
    if (!value) {
        return value.diagnostics();
    }
    Reading reading{print_value(*value, placeholder->digits), ""};
    if (placeholder->written && with_minus(*placeholder->written) != reading.text) {
        reading.contradiction = print_value(*value);
    }
    return reading;
}

void report(Diagnostics& problems, const Span& span, const std::string& message) {
    problems.push_back(
        {"",
         span.place.line,
         span.place.column,
         fmt::format("{{{{{}}}}}: {}", span.placeholder, message)}
    );
}

void fill_span(Span& span, const Filling& filling, Diagnostics& problems) {
    if (span.placeholder.empty()) {
        return;
    }
    Result<Reading> reading = read(span, filling);
    if (!reading) {
        for (const Diagnostic& problem : reading.diagnostics()) {
            report(problems, span, problem.message);
        }
        return;
    }
    if (!reading->contradiction.empty()) {
        report(problems, span, "the trace says " + reading->contradiction);
    }
    span.text = std::move(reading->text);
    span.placeholder.clear();
    span.quoted = true;
}

} // namespace

Result<Placeholder> parse_placeholder(std::string_view text) {
    Placeholder result;
    if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
        result.written = std::string{trim(text.substr(0, equals))};
        result.digits = digits_of(*result.written);
        text = text.substr(equals + 1);
    }
    if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
        const std::optional<int> digits = parse_digits(trim(text.substr(colon + 1)));
        if (!digits) {
            return complain(fmt::format(
                "\"{}\" is no number of digits: write 0 to {}",
                trim(text.substr(colon + 1)),
                most_digits
            ));
        }
        result.digits = *digits;
        text = text.substr(0, colon);
    }
    text = trim(text);
    const std::size_t from = text.starts_with(counted) ? counted.size() : 0;
    const std::size_t of = text.find(" of ", from);
    result.quantity = std::string{trim(text.substr(0, of))};
    result.of = of == std::string_view::npos ? "" : std::string{trim(text.substr(of + 4))};

    const std::string_view name = std::string_view{result.quantity}.substr(from);
    if (find_quantity(name) == nullptr) {
        return complain(describe_unknown_quantity(name));
    }
    if (const Result<Subject> subject = parse_subject(result.of); !subject) {
        return subject.diagnostics();
    }
    return result;
}

Document fill_in(Document document, const Filling& filling, Diagnostics& problems) {
    for_each_text(document, [&](Spans& spans) {
        for (Span& span : spans) {
            fill_span(span, filling, problems);
        }
    });
    return document;
}

Document fill_in_text(
    std::string_view markdown, Place place, const Filling& filling, Diagnostics& problems
) {
    return fill_in(parse_short_markdown(markdown, place, problems), filling, problems);
}

} // namespace hs::lesson
