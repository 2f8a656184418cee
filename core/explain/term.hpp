// Numbers that remember how they were computed.
//
// A Term is a float, a double, a whole number or a truth value in arithmetic, and keeps the
// expression it came from. What computes a value, written for Terms, in the order of the pipeline,
// so yields at once the value, the formula in symbols, the formula with numbers, and where each
// operand came from; functions of the pipeline that are templates of their scalar run with Terms
// as they are. A property test holds every value to the bit of what was recorded.
#pragma once

#include "core/base/check.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hs::explain {

using Number = std::variant<bool, std::int64_t, float, double>;

/// Where an operand came from: a value of a step, or something that was given.
struct Origin {
    std::string step;  ///< the path of the step that produced it; empty: none did
    std::string value; ///< what it is called among that step's values
    std::string given; ///< without a step: "camera.projection", "vertex 5 of object 0"; empty: it is
                       ///< a constant of the method
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// In which unit a result is: whole numbers count 1/256 pixel, 1/65536 pixel² and so on.
enum class UnitRule : std::uint8_t {
    first, ///< that of the first operand
    product,
    quotient,
    none,
    subpixels ///< 1/256 pixel, whatever the operands are in
};

/// What can be done with numbers, and how it is written.
struct Operation {
    std::string_view symbol; ///< between two operands, or a function's name; empty: not written
    int precedence = 0;      ///< of what stands between operands; 0: a function
    UnitRule unit = UnitRule::first;
    Number (*apply)(std::span<const Number>) = nullptr;
};

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;

/// A number, and either the operation that gave it or, for an operand, its symbol and its origin.
struct Expression {
    Number value;
    int subpixels = 0; ///< the value is in 256^−subpixels: 1 pixels, 2 pixel², −2 per pixel²
    const Operation* operation = nullptr;
    std::vector<ExpressionPtr> operands{};
    std::string symbol{}; ///< empty: a constant, written as itself
    Origin origin{};
};

namespace operations {

extern const Operation add;
extern const Operation subtract;
extern const Operation multiply;
extern const Operation divide; ///< of real numbers
extern const Operation negate;
extern const Operation less;
extern const Operation less_or_equal;
extern const Operation greater;
extern const Operation greater_or_equal;
extern const Operation equal;
extern const Operation not_equal;
extern const Operation both;      ///< a and b
extern const Operation smaller;   ///< min
extern const Operation larger;    ///< max
extern const Operation to_float;  ///< from whole numbers and doubles
extern const Operation to_double; ///< from whole numbers and floats

} // namespace operations

[[nodiscard]] ExpressionPtr
apply(const Operation& operation, std::vector<ExpressionPtr> operands);

template <typename T>
class Term {
public:
    // Constants stand in formulas as they stand in code
    // NOLINTNEXTLINE(google-explicit-constructor)
    Term(T constant) : expression_(std::make_shared<Expression>(Expression{.value = constant})) {}
    explicit Term(ExpressionPtr expression) : expression_(std::move(expression)) {
        HS_CHECK(std::holds_alternative<T>(expression_->value), "a term has its number's type");
    }

    [[nodiscard]] T value() const { return std::get<T>(expression_->value); }
    [[nodiscard]] const ExpressionPtr& expression() const { return expression_; }

    friend Term operator+(const Term& a, const Term& b) { return make(operations::add, a, b); }
    friend Term operator-(const Term& a, const Term& b) { return make(operations::subtract, a, b); }
    friend Term operator*(const Term& a, const Term& b) { return make(operations::multiply, a, b); }
    friend Term operator/(const Term& a, const Term& b) { return make(operations::divide, a, b); }
    friend Term operator-(const Term& a) {
        return Term{apply(operations::negate, {a.expression_})};
    }

private:
    static Term make(const Operation& operation, const Term& a, const Term& b) {
        return Term{apply(operation, {a.expression_, b.expression_})};
    }

    ExpressionPtr expression_;
};

using Real = Term<float>;
using Wide = Term<double>;
using Whole = Term<std::int64_t>;
using Truth = Term<bool>;

/// An operand with a name and an origin.
template <typename T>
[[nodiscard]] Term<T> operand(std::string symbol, T value, Origin origin, int subpixels = 0) {
    return Term<T>{std::make_shared<Expression>(Expression{
        .value = value,
        .subpixels = subpixels,
        .symbol = std::move(symbol),
        .origin = std::move(origin)})};
}

/// A function of any terms: R is what it returns.
template <typename R, typename... Terms>
[[nodiscard]] Term<R> call(const Operation& operation, const Terms&... terms) {
    return Term<R>{apply(operation, {terms.expression()...})};
}

template <typename T>
[[nodiscard]] Real to_float(const Term<T>& term) {
    return call<float>(operations::to_float, term);
}
template <typename T>
[[nodiscard]] Wide to_double(const Term<T>& term) {
    return call<double>(operations::to_double, term);
}
[[nodiscard]] inline Truth operator&&(const Truth& a, const Truth& b) {
    return call<bool>(operations::both, a, b);
}

/// Does the operations again, from the operands on.
[[nodiscard]] Number evaluate(const Expression& expression);

/// Same type and same bits.
[[nodiscard]] bool same_bits(const Number& a, const Number& b);

/// "m00·x + m01·y"
[[nodiscard]] std::string in_symbols(const Expression& expression);
/// The same with a number for every symbol.
[[nodiscard]] std::string in_numbers(const Expression& expression);
/// An expression's value as people read it, in pixels where it counts parts of pixels: "16.0000".
[[nodiscard]] std::string value_text(const Expression& expression);
/// How many characters wide a text is; symbols take several bytes.
[[nodiscard]] std::size_t width(std::string_view text);
/// Its value to the last bit: "0.1", "1048576/65536", "true".
[[nodiscard]] std::string exact_text(const Expression& expression);
/// What it counts: "px", "px²", "1/px²"; empty without a unit.
[[nodiscard]] std::string_view unit_of(const Expression& expression);

/// The operands that have symbols, each once, in the order they are read.
[[nodiscard]] std::vector<ExpressionPtr> operands_of(const ExpressionPtr& expression);

} // namespace hs::explain
