#include "core/explain/term.hpp"

#include "core/explain/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace hs::explain {
namespace {

constexpr int of_and = 1;
constexpr int of_comparison = 2;
constexpr int of_sum = 3;
constexpr int of_product = 4;
constexpr int of_sign = 5;
constexpr int of_function = 6;

/// Of two numbers of one type; truth values are not calculated with.
template <typename Function>
Number binary(std::span<const Number> n, Function function) {
    return std::visit(
        [&](auto a) -> Number {
            using T = decltype(a);
            if constexpr (!std::is_same_v<T, bool>) {
                return function(a, std::get<T>(n[1]));
            } else {
                HS_CHECK(false, "truth values are neither added nor compared");
                return false;
            }
        },
        n[0]
    );
}

/// As pipeline and IEEE 754 have it: 1/0 is infinite.
template <typename T>
__attribute__((no_sanitize("float-divide-by-zero"))) T quotient(T a, T b) {
    return a / b;
}

Number divide_numbers(std::span<const Number> n) {
    if (const auto* a = std::get_if<float>(&n[0])) {
        return quotient(*a, std::get<float>(n[1]));
    }
    return quotient(std::get<double>(n[0]), std::get<double>(n[1]));
}

Number negate_number(std::span<const Number> n) {
    return std::visit(
        [](auto a) -> Number {
            if constexpr (std::is_same_v<decltype(a), bool>) {
                return !a;
            } else {
                return -a;
            }
        },
        n[0]
    );
}

template <typename To>
Number convert(std::span<const Number> n) {
    return std::visit([](auto a) -> Number { return static_cast<To>(a); }, n[0]);
}

int unit_after(const Operation& operation, const std::vector<ExpressionPtr>& operands) {
    switch (operation.unit) {
    case UnitRule::first: return operands[0]->subpixels;
    case UnitRule::product: return operands[0]->subpixels + operands[1]->subpixels;
    case UnitRule::quotient: return operands[0]->subpixels - operands[1]->subpixels;
    case UnitRule::none: return 0;
    case UnitRule::subpixels: return 1;
    }
    HS_CHECK(false, "every unit rule is handled");
    return 0;
}

/// In pixels and their powers; float where it was one.
double in_pixels(double value, int subpixels) {
    return value * std::exp2(-8.0 * subpixels);
}

int precedence(const Expression& e) {
    if (e.operation == nullptr) {
        return of_function;
    }
    if (e.operation->symbol.empty()) {
        return precedence(*e.operands[0]); // conversions are not written
    }
    return e.operation->precedence == 0 ? of_function : e.operation->precedence;
}

/// Constants of a method have few digits: all are written.
std::string leaf_number(const Expression& e) {
    return e.symbol.empty() ? exact_text(e) : value_text(e);
}

std::string leaf_symbol(const Expression& e) {
    return e.symbol.empty() ? exact_text(e) : e.symbol;
}

using LeafText = std::string (*)(const Expression&);

std::string write(const Expression& e, LeafText leaf);

/// Operations of equal rank are done from left to right: what is not says so by parentheses.
std::string write_operand(const Expression& e, int rank, bool first, LeafText leaf) {
    const std::string text = write(e, leaf);
    const bool loose = precedence(e) < rank || (!first && precedence(e) == rank);
    const bool sign_inside = !first && text.front() == '-';
    const bool several_words = e.operation == nullptr && leaf == leaf_symbol &&
                               e.symbol.find_first_of(" /") != std::string::npos;
    return loose || sign_inside || several_words ? "(" + text + ")" : text;
}

std::string write(const Expression& e, LeafText leaf) {
    if (e.operation == nullptr) {
        return leaf(e);
    }
    const Operation& operation = *e.operation;
    if (operation.symbol.empty()) {
        return write(*e.operands[0], leaf);
    }
    if (operation.precedence == 0) {
        std::string list;
        for (const ExpressionPtr& each : e.operands) {
            list += (list.empty() ? "" : ", ") + write(*each, leaf);
        }
        return fmt::format("{}({})", operation.symbol, list);
    }
    if (e.operands.size() == 1) {
        return std::string{operation.symbol} +
               write_operand(*e.operands[0], operation.precedence, false, leaf);
    }
    return write_operand(*e.operands[0], operation.precedence, true, leaf) +
           std::string{operation.symbol} +
           write_operand(*e.operands[1], operation.precedence, false, leaf);
}

void gather(const ExpressionPtr& e, std::vector<ExpressionPtr>& list) {
    if (e->operation != nullptr) {
        for (const ExpressionPtr& each : e->operands) {
            gather(each, list);
        }
        return;
    }
    const auto same = [&e](const ExpressionPtr& other) {
        return other->symbol == e->symbol && other->origin == e->origin;
    };
    if (!e->symbol.empty() && std::ranges::none_of(list, same)) {
        list.push_back(e);
    }
}

} // namespace

namespace operations {

using Numbers = std::span<const Number>;

const Operation add{" + ", of_sum, UnitRule::first, [](Numbers n) {
                        return binary(n, [](auto a, auto b) -> Number { return a + b; });
                    }};
const Operation subtract{" − ", of_sum, UnitRule::first, [](Numbers n) {
                             return binary(n, [](auto a, auto b) -> Number { return a - b; });
                         }};
const Operation multiply{"·", of_product, UnitRule::product, [](Numbers n) {
                             return binary(n, [](auto a, auto b) -> Number { return a * b; });
                         }};
const Operation divide{" / ", of_product, UnitRule::quotient, divide_numbers};
const Operation negate{"−", of_sign, UnitRule::first, negate_number};
const Operation less{" < ", of_comparison, UnitRule::none, [](Numbers n) {
                         return binary(n, [](auto a, auto b) -> Number { return a < b; });
                     }};
const Operation less_or_equal{" ≤ ", of_comparison, UnitRule::none, [](Numbers n) {
                                  return binary(n, [](auto a, auto b) -> Number { return a <= b; });
                              }};
const Operation greater{" > ", of_comparison, UnitRule::none, [](Numbers n) {
                            return binary(n, [](auto a, auto b) -> Number { return a > b; });
                        }};
const Operation greater_or_equal{" ≥ ", of_comparison, UnitRule::none, [](Numbers n) {
                                     return binary(n, [](auto a, auto b) -> Number {
                                         return a >= b;
                                     });
                                 }};
const Operation equal{" = ", of_comparison, UnitRule::none, [](Numbers n) {
                          return binary(n, [](auto a, auto b) -> Number { return a == b; });
                      }};
const Operation not_equal{" ≠ ", of_comparison, UnitRule::none, [](Numbers n) {
                              return binary(n, [](auto a, auto b) -> Number { return a != b; });
                          }};
const Operation both{" and ", of_and, UnitRule::none, [](Numbers n) -> Number {
                         return std::get<bool>(n[0]) && std::get<bool>(n[1]);
                     }};
const Operation smaller{"min", 0, UnitRule::first, [](Numbers n) {
                            return binary(n, [](auto a, auto b) -> Number {
                                return std::min(a, b);
                            });
                        }};
const Operation larger{"max", 0, UnitRule::first, [](Numbers n) {
                           return binary(n, [](auto a, auto b) -> Number {
                               return std::max(a, b);
                           });
                       }};
const Operation to_float{"", 0, UnitRule::first, convert<float>};
const Operation to_double{"", 0, UnitRule::first, convert<double>};

} // namespace operations

ExpressionPtr apply(const Operation& operation, std::vector<ExpressionPtr> operands) {
    std::vector<Number> numbers;
    for (const ExpressionPtr& each : operands) {
        numbers.push_back(each->value);
    }
    return std::make_shared<Expression>(Expression{
        .value = operation.apply(numbers),
        .subpixels = unit_after(operation, operands),
        .operation = &operation,
        .operands = std::move(operands)});
}

Number evaluate(const Expression& expression) {
    if (expression.operation == nullptr) {
        return expression.value;
    }
    std::vector<Number> numbers;
    for (const ExpressionPtr& each : expression.operands) {
        numbers.push_back(evaluate(*each));
    }
    return expression.operation->apply(numbers);
}

bool same_bits(const Number& a, const Number& b) {
    if (const auto* real = std::get_if<float>(&a)) {
        const auto* other = std::get_if<float>(&b);
        return other != nullptr &&
               std::bit_cast<std::uint32_t>(*real) == std::bit_cast<std::uint32_t>(*other);
    }
    if (const auto* wide = std::get_if<double>(&a)) {
        const auto* other = std::get_if<double>(&b);
        return other != nullptr &&
               std::bit_cast<std::uint64_t>(*wide) == std::bit_cast<std::uint64_t>(*other);
    }
    return a == b;
}

std::string in_symbols(const Expression& expression) {
    return write(expression, leaf_symbol);
}

std::string in_numbers(const Expression& expression) {
    return write(expression, leaf_number);
}

std::string value_text(const Expression& e) {
    if (const auto* truth = std::get_if<bool>(&e.value)) {
        return *truth ? "true" : "false";
    }
    if (const auto* count = std::get_if<std::int64_t>(&e.value)) {
        return e.subpixels == 0 ? whole(*count)
                                : number(static_cast<float>(
                                      in_pixels(static_cast<double>(*count), e.subpixels)
                                  ));
    }
    if (const auto* real = std::get_if<float>(&e.value)) {
        return number(static_cast<float>(in_pixels(static_cast<double>(*real), e.subpixels)));
    }
    return number(static_cast<float>(in_pixels(std::get<double>(e.value), e.subpixels)));
}

std::size_t width(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; // not the rest of a character
    }));
}

std::string exact_text(const Expression& e) {
    const auto fraction = [&e](auto value) {
        return e.subpixels > 0 ? fmt::format("{}/{}", value, std::exp2(8 * e.subpixels))
                               : fmt::format("{}", value);
    };
    return std::visit(
        [&](auto value) {
            using T = decltype(value);
            if constexpr (std::is_same_v<T, std::int64_t>) {
                return fraction(value);
            } else if constexpr (std::is_same_v<T, bool>) {
                return fmt::format("{}", value);
            } else {
                return fmt::format("{}", std::ldexp(value, -8 * e.subpixels));
            }
        },
        e.value
    );
}

std::string_view unit_of(const Expression& expression) {
    switch (expression.subpixels) {
    case 1: return "px";
    case 2: return "px²";
    case -1: return "1/px";
    case -2: return "1/px²";
    default: return "";
    }
}

std::vector<ExpressionPtr> operands_of(const ExpressionPtr& expression) {
    std::vector<ExpressionPtr> list;
    gather(expression, list);
    return list;
}

} // namespace hs::explain
