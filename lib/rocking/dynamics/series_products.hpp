#pragma once

#include <type_traits>
#include <utility>

#include "rocking/base/lane.hpp"

/// Coefficients of products of Taylor series.
namespace rocking::dynamics::kernel {

/// sum_{i < k} a_i b_{k - i}: coefficient k of the product without its newest term a_k b_0. Summed from the middle
/// outwards, so that the newest coefficients, which are computed last, are needed last.
template <int k, base::Lane Real>
[[nodiscard]] inline Real product_but_newest(const Real* a, const Real* b) {
  using base::fused;
  if constexpr (k == 0) {
    return Real(0.0);
  } else if constexpr (k == 1) {
    return a[0] * b[1];
  } else {
    constexpr int middle = k / 2;
    Real sum = a[middle] * b[k - middle];
    if constexpr (k % 2 == 1) sum = fused(a[k - middle], b[middle], sum);
#pragma GCC unroll 16
    for (int i = middle - 1; i >= 1; --i) {
      sum = fused(a[i], b[k - i], sum);
      sum = fused(a[k - i], b[i], sum);
    }
    return fused(a[0], b[k], sum);
  }
}

/// sum a_i b_{k - i} over low <= i <= high, from the middle outwards; at least one term.
template <int k, int low, int high, base::Lane Real>
[[nodiscard]] inline Real part_of_product(const Real* a, const Real* b) {
  using base::fused;
  constexpr int middle = (low + high) / 2;
  Real sum = a[middle] * b[k - middle];
  if constexpr ((high - low) % 2 == 1) sum = fused(a[middle + 1], b[k - middle - 1], sum);
#pragma GCC unroll 16
  for (int i = middle - 1; i >= low; --i) {
    sum = fused(a[i], b[k - i], sum);
    sum = fused(a[low + high - i], b[k - low - high + i], sum);
  }
  return sum;
}

/// (a b)_k.
template <int k, base::Lane Real>
[[nodiscard]] inline Real product(const Real* a, const Real* b) {
  using base::fused;
  return fused(a[k], b[0], product_but_newest<k>(a, b));
}

template <int k>
inline constexpr double over = 1.0 / k;

/// Calls step(0), ..., step(count - 1) with compile-time constants.
template <int count, class Step>
inline void repeat(Step&& step) {
  [&]<int... k>(std::integer_sequence<int, k...>) { (step(std::integral_constant<int, k>{}), ...); }
  (std::make_integer_sequence<int, count>{});
}

}  // namespace rocking::dynamics::kernel
