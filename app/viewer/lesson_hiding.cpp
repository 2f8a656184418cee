#include "app/viewer/lesson_hiding.hpp"

#include "app/lesson/session.hpp"
#include "app/viewer/viewer.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace hs::viewer {
namespace {

constexpr std::array<std::string_view, 5> spaces{"world", "eye", "clip", "ndc", "window"};

std::span<const std::string> hidden(Viewer& viewer) {
    const lesson::Session* session = viewer.session();
    return session == nullptr ? std::span<const std::string>{} : session->hidden();
}

/// The place among `spaces` that a quantity belongs to; behind the last for all others.
std::size_t space_of(std::string_view quantity) {
    if (quantity.starts_with("snapped") || quantity.starts_with("fixed")) {
        return spaces.size() - 1;
    }
    const auto* const found = std::ranges::find_if(spaces, [quantity](std::string_view space) {
        return quantity.starts_with(space);
    });
    return static_cast<std::size_t>(found - spaces.begin());
}

} // namespace

bool hides_numbers(Viewer& viewer) {
    return !hidden(viewer).empty();
}

bool hides_space(Viewer& viewer, std::string_view space) {
    const std::size_t asked = space_of(space);
    return asked < spaces.size() &&
           std::ranges::any_of(hidden(viewer), [asked](const std::string& quantity) {
               return space_of(quantity) <= asked;
           });
}

bool hides_beyond_vertex(Viewer& viewer) {
    return std::ranges::any_of(hidden(viewer), [](const std::string& quantity) {
        return space_of(quantity) == spaces.size();
    });
}

} // namespace hs::viewer
