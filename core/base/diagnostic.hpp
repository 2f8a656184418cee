// Located messages for bad input, and Result: a value or the reasons why there is none.
//
// Three kinds of failure never mix: a programmer's mistake is a check (check.hpp), a user's bad
// input is a Diagnostic, a rare but legal number is handled where it occurs and shown as a step.
#pragma once

#include "core/base/check.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hs {

/// One sentence about bad input and where it stands. Lines and columns count from 1; 0 means "the
/// whole".
struct Diagnostic {
    std::string file{};
    int line = 0;
    int column = 0;
    std::string message{}; ///< Says what is wrong and what to do, without a final full stop.

    /// "file:line:column: message", leaving out what is unknown.
    [[nodiscard]] std::string to_string() const;
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or at least one diagnostic. The command line prints the first, the window lists all.
template <typename T>
class [[nodiscard]] Result {
public:
    // Both conversions are implicit on purpose: `return mesh;` and `return Diagnostic{...};` read
    // as they should.
    Result(T value) : content_(std::move(value)) {} // NOLINT(google-explicit-constructor)
    Result(Diagnostic diagnostic)                   // NOLINT(google-explicit-constructor)
        : content_(Diagnostics{std::move(diagnostic)}) {}
    Result(Diagnostics diagnostics) // NOLINT(google-explicit-constructor)
        : content_(std::move(diagnostics)) {
        HS_CHECK(!std::get<Diagnostics>(content_).empty(), "a failed Result says why");
    }

    [[nodiscard]] explicit operator bool() const { return std::holds_alternative<T>(content_); }
    [[nodiscard]] T& operator*() { return value(); }
    [[nodiscard]] const T& operator*() const { return value(); }
    [[nodiscard]] T* operator->() { return &value(); }
    [[nodiscard]] const T* operator->() const { return &value(); }

    [[nodiscard]] T& value() {
        HS_CHECK(*this, "asked a failed Result for its value");
        return std::get<T>(content_);
    }
    [[nodiscard]] const T& value() const {
        HS_CHECK(*this, "asked a failed Result for its value");
        return std::get<T>(content_);
    }
    /// Valid only for a failed result.
    [[nodiscard]] const Diagnostics& diagnostics() const {
        HS_CHECK(!*this, "asked a good Result for its diagnostics");
        return std::get<Diagnostics>(content_);
    }

private:
    std::variant<T, Diagnostics> content_;
};

/// For functions that succeed without a value: `return done;`.
struct Done {};
inline constexpr Done done{};

} // namespace hs
