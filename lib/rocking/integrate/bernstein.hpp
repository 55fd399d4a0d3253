#pragma once

#include <cstddef>

namespace rocking::integrate {

/// C(i,k)/C(n,k), by k and i: the weight of coefficient k of a polynomial of degree n in its Bernstein coefficient i on
/// [0, 1]; 0 where i < k.
/// Source: Farouki & Rajan (1987), CAGD 4, 191-216.
template <std::size_t n>
struct BernsteinWeights {
  double of[n + 1][n + 1];
};

template <std::size_t n>
[[nodiscard]] consteval BernsteinWeights<n> bernstein_weights() {
  const auto binomial = [](std::size_t from, std::size_t k) {
    double value = 1.0;  // an integer below 2^53
    for (std::size_t m = 0; m < k; ++m) value = value * static_cast<double>(from - m) / static_cast<double>(m + 1);
    return value;
  };
  BernsteinWeights<n> weights{};
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = k; i <= n; ++i) weights.of[k][i] = binomial(i, k) / binomial(n, k);
  }
  return weights;
}

}  // namespace rocking::integrate
