#include "core/base/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace hs {

void check_failed(const char* file, int line, const char* condition, const char* meaning) {
    std::fprintf(stderr, "%s:%d: check failed: %s (%s)\n", file, line, condition, meaning);
    std::abort();
}

} // namespace hs
