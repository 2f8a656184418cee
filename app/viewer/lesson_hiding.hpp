// What a lesson hides until its question is answered.
#pragma once

#include <string_view>

namespace hs::viewer {

class Viewer;

/// Whether the open lesson hides any number at the step it stands on.
bool hides_numbers(Viewer& viewer);

/// Whether it hides a space ("ndc") or one that gives it away, an earlier one's successor: from the
/// first hidden space of world, eye, clip, ndc, window on, all are.
bool hides_space(Viewer& viewer, std::string_view space);

/// Whether it hides something that only a tab other than the vertex's shows.
bool hides_beyond_vertex(Viewer& viewer);

inline constexpr std::string_view hidden_note =
    "The numbers here are hidden until the lesson's question is answered.";

} // namespace hs::viewer
