#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "rocking/base/jet.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/integrate/polynomial.hpp"

namespace rocking {

/// The smallest value that a guard has in passing without firing: of theta over psi, of V, or of the friction limit.
struct GuardMinimum {
  dynamics::Guard guard;
  double value;
};

/// The local minimum of x^zeros p(x) within 0 < x < length; absent without one. Of several in a quarter of the length one
/// is found.
[[nodiscard]] inline std::optional<double> local_minimum(std::span<const double> p, std::size_t zeros, double length) {
  const auto value = [&](double x) {
    double power = 1.0;
    for (std::size_t k = 0; k < zeros; ++k) power *= x;
    return power * integrate::evaluate(p, x);
  };
  const auto slope = [&](double x) {
    const auto jet = integrate::jet_at(p, x);
    double power = 1.0;  // x^(zeros - 1)
    for (std::size_t k = 1; k < zeros; ++k) power *= x;
    return zeros == 0 ? jet.first : power * (static_cast<double>(zeros) * jet.value + x * jet.first);
  };
  constexpr int parts = 4;
  std::optional<double> least;
  for (int i = 0; i < parts; ++i) {
    double low = length * i / parts;
    double high = length * (i + 1) / parts;
    if (!(slope(low) < 0.0) || !(slope(high) >= 0.0)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (slope(middle) < 0.0 ? low : high) = middle;
    }
    const double found = value(high);
    if (!least || found < *least) least = found;
  }
  return least;
}

}  // namespace rocking
