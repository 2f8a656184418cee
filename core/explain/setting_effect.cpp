#include "core/explain/setting_effect.hpp"

#include <algorithm>
#include <array>

namespace hs::explain {
namespace {

struct Effect {
    std::string_view key;
    std::string_view text;
};

constexpr std::array effects{
    Effect{
        "clip.enabled",
        "Without clipping, a vertex behind the eye (w < 0) is divided like any other: x/w and y/w "
        "change sign, it lands on the opposite side of the picture, and its triangle wraps around. "
        "In the plane of the eye (p_z = eye_z, so w = 0) there is nothing to divide by. Clipping "
        "cuts both away before the divide."},
    Effect{
        "shading",
        "Per vertex (gouraud), colors are lit at three points and mixed: a highlight between them "
        "is missed, one at a vertex is smeared. Per fragment (phong), normals are mixed and light "
        "is computed at each one."},
    Effect{
        "interpolation",
        "Linear in the window, the middle of an edge on screen gets the middle of its values. In "
        "perspective that point lies nearer to the far end in space: the values are divided by w, "
        "mixed, and divided by the mixed 1/w."},
    Effect{
        "traversal",
        "Both cover the same pixels; they differ in which pixels they ask and in what order, and "
        "so in what they spend."},
    Effect{
        "depth.format",
        "Depths that round to the same stored value are equal to the depth test: where two "
        "surfaces are that close, the one drawn first wins, not the nearer one."},
};

} // namespace

std::string_view effect_of_setting(std::string_view key) {
    const auto* const found = std::ranges::find(effects, key, &Effect::key);
    return found == effects.end() ? std::string_view{} : found->text;
}

} // namespace hs::explain
