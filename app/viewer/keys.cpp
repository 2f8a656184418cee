#include "app/viewer/keys.hpp"

#include <array>

namespace hs::viewer {
namespace {

constexpr std::array<const char*, key_count> key_names{
    // clang-format off
    "",
    "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M",
    "N", "O", "P", "Q", "R", "S", "T", "U", "V", "W", "X", "Y", "Z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "←", "→", "↑", "↓", "Home", "End", "PageUp", "PageDown", "Space", "Enter", "Esc", "Tab",
    "Backspace", "Delete", ",", ".", "+", "−", "?",
    // clang-format on
};

} // namespace

std::string to_string(const KeyPress& press) {
    std::string text;
    text += press.ctrl ? "Ctrl+" : "";
    text += press.alt ? "Alt+" : "";
    text += press.shift ? "Shift+" : "";
    return text + key_names[static_cast<std::size_t>(press.key)];
}

} // namespace hs::viewer
