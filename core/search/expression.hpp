// Questions people write: `fragment.fate == "depth failed" and fragment.pixel.x < 32`, in Lua 5.4
// (https://www.lua.org/manual/5.4/). What is not a number or a comparison is out of reach: no
// libraries but math, and a bounded number of operations and bytes.
#pragma once

#include "core/base/diagnostic.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hs::search {

/// What a name stands for. Enumerators are their names.
using Value = std::variant<std::int64_t, double, std::string_view>;

/// A name an expression may use.
struct Name {
    std::string path; ///< "fragment.pixel.x"; a number at the end is an index: "….vertices.0"
    std::function<Value()> read;         ///< its value now
    std::vector<std::string> meanings{}; ///< the texts it can be, if it is one
};

/// An expression that is true or false.
class Expression {
public:
    /// Longest text, in bytes.
    static constexpr std::size_t longest = 4096;

    /// Errors, in one sentence each, located by line: syntax; a name that does not exist; a text
    /// that no name can ever be; too long. An expression compiles but once, and is asked often.
    static Result<Expression> compile(std::string_view text, std::vector<Name> names);

    Expression(const Expression&) = delete;
    Expression& operator=(const Expression&) = delete;
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;
    ~Expression();

    /// Is it true now? Errors: neither true nor false, a comparison of what cannot be compared, too
    /// many operations, too much memory.
    Result<bool> operator()();

    /// Indices into `names`, in the order the text mentions them.
    [[nodiscard]] const std::vector<std::size_t>& mentioned() const;

private:
    class Machine;
    explicit Expression(std::unique_ptr<Machine> machine);
    std::unique_ptr<Machine> machine_;
};

/// Names and texts of an expression as they stand there, without understanding it: dotted names
/// ("fragment.pixel.x"), indices in brackets included, and quoted texts without their quotes.
struct Words {
    std::vector<std::string> names;
    std::vector<std::string> texts;
};
[[nodiscard]] Words words_of(std::string_view text);

} // namespace hs::search
