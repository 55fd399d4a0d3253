#pragma once

#include <variant>

namespace rocking {

/// Uniform law: every value in [low, high) is equally likely.
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

/// A number, or the law from which each realisation draws it once, at its start.
using Quantity = std::variant<double, Uniform, Normal>;

/// Whether it has a law.
[[nodiscard]] bool is_drawn(const Quantity& quantity);

/// An interval that contains every value of a quantity.
struct Reach {
  double least;
  double largest;
};

/// Of a normal law: the mean and 8.6 standard deviations on both sides. No draw lies farther out: Box and Muller's
/// radius of the smallest uniform number, 2^-53, is sqrt(-2 ln 2^-53) = 8.572.
[[nodiscard]] Reach reach_of(const Quantity& quantity);

/// Mean of the law, or the number itself.
[[nodiscard]] double mean_of(const Quantity& quantity);

}  // namespace rocking
