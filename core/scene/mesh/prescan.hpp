// What OpenMesh's readers do not notice: missing pieces, NaN, indices out of range, headers that
// they misread. A file that passes its prescan is read as its author meant it; one that does not is
// refused with the line and the reason.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hs::scene::mesh {

/// What is wrong, and in which line (0: the format has no lines, or the whole file).
struct Flaw {
    int line = 0;
    std::string message;
};

std::optional<Flaw> prescan_obj(std::string_view bytes);
std::optional<Flaw> prescan_off(std::string_view bytes);
std::optional<Flaw> prescan_ply(std::string_view bytes);
std::optional<Flaw> prescan_stl(std::string_view bytes);
std::optional<Flaw> prescan_om(std::string_view bytes);

} // namespace hs::scene::mesh
