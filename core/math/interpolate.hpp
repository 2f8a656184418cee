// Linear interpolation, always in difference form.
//
// v0 + λ1 (v1 − v0) + λ2 (v2 − v0) returns v exactly when all three values are v; the weighted sum
// λ0 v0 + λ1 v1 + λ2 v2 does not in about 30 % of cases, and coplanar surfaces and `equal` depth
// tests hang on it.
#pragma once

namespace hs::math {

/// Between two values: t = 0 gives a, t = 1 gives a + (b − a), which may differ from b in the last
/// bit.
template <typename T>
[[nodiscard]] T interpolate(T a, T b, T t) {
    return a + t * (b - a);
}

/// Over a triangle; λ0 = 1 − λ1 − λ2 is implied.
template <typename T>
[[nodiscard]] T interpolate(T v0, T v1, T v2, T lambda1, T lambda2) {
    return v0 + lambda1 * (v1 - v0) + lambda2 * (v2 - v0);
}

} // namespace hs::math
