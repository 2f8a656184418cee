#include "core/base/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hs {

namespace {

/// Longer texts are no slip of the fingers, and the distance costs their product.
constexpr std::size_t longest_name = 64;

/// Levenshtein 1965, one row of the table at a time (Wagner and Fischer 1974).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substitution = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, substitution});
        }
    }
    return row[b.size()];
}

} // namespace

std::string_view nearest_name(std::string_view text, std::span<const std::string_view> candidates) {
    if (text.empty() || text.size() > longest_name) {
        return {};
    }
    std::string_view nearest;
    std::size_t smallest = std::max<std::size_t>(1, text.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(text, candidate);
        if (distance < smallest) {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates) {
    const std::string_view nearest = nearest_name(text, candidates);
    return nearest.empty() ? "" : "; did you mean \"" + std::string{nearest} + "\"?";
}

std::string list_of_choices(std::span<const std::string_view> choices) {
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        text += i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ";
        text += '"' + std::string{choices[i]} + '"';
    }
    return text;
}

} // namespace hs
