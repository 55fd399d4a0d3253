#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/split_mix.hpp"

namespace rocking::support {

/// Coefficients in order of increasing power.
using Polynomial = std::vector<double>;

inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

/// factor * product of (t - root).
inline Polynomial from_roots(double factor, const std::vector<double>& roots) {
  Polynomial p{factor};
  for (const double root : roots) p = product(p, {-root, 1.0});
  return p;
}

/// Polynomials of different kinds: random coefficients that decrease or grow, random and clustered roots, offsets that
/// turn double roots into near misses and close roots.
inline Polynomial random_polynomial(SplitMix& draw) {
  const int degree = 5 + draw.below(11);
  Polynomial p;
  if (draw.below(2) == 0) {
    const double decay = std::exp2(draw.uniform(-3.0, 1.0));
    double size = 1.0;
    for (int k = 0; k <= degree; ++k, size *= decay) p.push_back(size * draw.uniform(-1.0, 1.0));
    if (draw.below(4) == 0) p[0] = 0.0;
    return p;
  }
  std::vector<double> roots;
  while (static_cast<int>(roots.size()) < degree) {
    const double root = draw.uniform(-0.3, 1.3);
    const int times = std::min(1 + draw.below(3), degree - static_cast<int>(roots.size()));
    const double spread = draw.below(2) == 0 ? 0.0 : std::exp2(draw.uniform(-30.0, -3.0));
    for (int i = 0; i < times; ++i) roots.push_back(root + i * spread);
  }
  p = from_roots(draw.below(2) == 0 ? 1.0 : -1.0, roots);
  if (draw.below(3) == 0) p[0] += std::exp2(draw.uniform(-50.0, -5.0)) * (draw.below(2) == 0 ? 1.0 : -1.0);
  return p;
}

}  // namespace rocking::support
