// Keys as the viewer knows them; hosts translate theirs. ImGui 1.86 names only 22.
#pragma once

#include <cstdint>
#include <string>

namespace hs::viewer {

enum class Key : std::uint8_t {
    none,
    // clang-format off
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    // clang-format on
    left,
    right,
    up,
    down,
    home,
    end,
    page_up,
    page_down,
    space,
    enter,
    escape,
    tab,
    backspace,
    del,
    comma,
    period,
    plus,
    minus,
    question,
};
inline constexpr int key_count = static_cast<int>(Key::question) + 1;

struct KeyPress {
    Key key = Key::none;
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

/// "Ctrl+→": as menus and the sheet of keys print it.
std::string to_string(const KeyPress& press);

} // namespace hs::viewer
