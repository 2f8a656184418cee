#include "tests/support/mesa.hpp"

#include "tests/support/catch.hpp"

#include <string>

namespace hs::tests {

peer::Context* mesa() {
    static std::string why_not;
    static std::optional<peer::Context> context = peer::Context::create(&why_not);
    if (!context) {
        WARN("not compared with Mesa: " << why_not);
        return nullptr;
    }
    return &*context;
}

} // namespace hs::tests
