#include "app/host/glfw_keys.hpp"

#include <GLFW/glfw3.h>

#include <array>
#include <optional>
#include <utility>

namespace hs::host {
namespace {

using viewer::Key;

Key offset(Key first, int by) {
    return static_cast<Key>(static_cast<int>(first) + by);
}

std::optional<Key> printed_key(char printed) {
    if (printed >= 'a' && printed <= 'z') {
        return offset(Key::a, printed - 'a');
    }
    if (printed >= '0' && printed <= '9') {
        return offset(Key::digit_0, printed - '0');
    }
    switch (printed) {
    case ',': return Key::comma;
    case '.': return Key::period;
    case '+':
    case '=': return Key::plus;
    case '-': return Key::minus;
    default: return std::nullopt;
    }
}

constexpr std::array<std::pair<int, Key>, 17> named_keys{{
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_KP_ADD, Key::plus},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
}};

Key key_of(int key, int scancode) {
    for (const auto& [glfw, ours] : named_keys) {
        if (glfw == key) {
            return ours;
        }
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) {
        return offset(Key::f1, key - GLFW_KEY_F1);
    }
    const char* const printed = glfwGetKeyName(key, scancode);
    return printed == nullptr ? Key::none : printed_key(printed[0]).value_or(Key::none);
}

} // namespace

viewer::KeyPress translate_key(int key, int scancode, int mods) {
    return {
        .key = key_of(key, scancode),
        .ctrl = (mods & GLFW_MOD_CONTROL) != 0,
        .shift = (mods & GLFW_MOD_SHIFT) != 0,
        .alt = (mods & GLFW_MOD_ALT) != 0,
    };
}

} // namespace hs::host
