// Words for messages about names: which there are, and "did you mean …?".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hs {

/// The candidate with the smallest edit distance, empty when none is near enough to be a plausible
/// slip of the fingers (at most a third of the letters, at least one).
std::string_view nearest_name(std::string_view text, std::span<const std::string_view> candidates);

/// `; did you mean "depth.test"?`, or nothing.
std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates);

/// `"none", "back" or "front"`.
std::string list_of_choices(std::span<const std::string_view> choices);

} // namespace hs
