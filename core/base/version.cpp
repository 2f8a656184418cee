#include "core/base/version.hpp"

namespace hs {

std::string_view program_version() {
    return HALFSPACE_VERSION;
}

} // namespace hs
