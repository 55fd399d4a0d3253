#pragma once

#include <variant>

namespace rocking::experiment {

/// A law on an interval: every value in [low, high) equally likely.
struct Uniform {
  double low = 0.0;
  double high = 0.0;
  friend bool operator==(const Uniform&, const Uniform&) = default;
};

/// N(mean, sigma^2).
struct Normal {
  double mean = 0.0;
  double sigma = 0.0;
  friend bool operator==(const Normal&, const Normal&) = default;
};

/// A number, or the law from which each realisation draws it once.
using Quantity = std::variant<double, Uniform, Normal>;

}  // namespace rocking::experiment
