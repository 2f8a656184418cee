// 1/x where x may be 0: the infinity of IEEE 754, which later stages turn into a verdict.
#pragma once

namespace hs::math {

/// The one place that may divide by zero, so the one place the sanitizer is told not to stop at.
[[nodiscard]] inline __attribute__((no_sanitize("float-divide-by-zero"))) float reciprocal(float x
) {
    return 1.0F / x;
}

} // namespace hs::math
