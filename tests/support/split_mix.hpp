#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "rocking/base/elementary.hpp"

namespace rocking::support {

/// A small random number generator for tests: the same numbers on every machine, from a seed that a failing test can
/// print. Source: Steele, Lea, Flood (2014), "Fast splittable pseudorandom number generators", OOPSLA.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// Uniform in (0, 1).
  [[nodiscard]] double uniform() { return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Integer in 0 ... bound - 1.
  [[nodiscard]] int below(int bound) { return static_cast<int>(bits() % static_cast<std::uint64_t>(bound)); }

  /// N(0, 1), by Box and Muller.
  [[nodiscard]] double normal() {
    const double radius = std::sqrt(-2.0 * base::natural_logarithm(uniform()));
    return radius * base::sin_cos(2.0 * std::numbers::pi * uniform()).cosine;
  }

 private:
  std::uint64_t state_;
};

}  // namespace rocking::support
