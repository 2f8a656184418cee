#include "core/base/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace hs {

namespace {

/// Longer texts are no slip of the fingers, and the distance costs their product.
constexpr std::size_t longest_name = 64;

/// Insertions, deletions, replacements and exchanges of neighbors (Damerau 1964; here no letter is
/// touched twice), one row of the table at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
            const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            row[j] = exchanged ? std::min(row[j], before[j - 2] + 1) : row[j];
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
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
