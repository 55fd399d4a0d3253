#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "rocking/integrate/polynomial.hpp"
#include "support/lowest_value.hpp"

namespace rocking::support {

/// The polynomial of a guard over a step, divided by known zeros at the start, with its accuracy.
class GuardPolynomial {
 public:
  GuardPolynomial(std::span<const double> coefficients, double length) : count_(coefficients.size()) {
    std::ranges::copy(coefficients, c_.begin());
    double power = 1.0;
    for (std::size_t k = 0; k < count_; ++k, power *= length) {
      const double term = std::abs(c_[k]) * power;
      size_ += term;
      if (c_[k] == 0.0 || k + most_padding + 2 < count_) continue;
      last_but_one_ = last_;
      last_ = term;
    }
  }

  /// Effect of one rounding of each coefficient, over the step.
  [[nodiscard]] double rounding() const { return static_cast<double>(count_) * 0x1p-53 * size_; }
  /// The last two terms at the end of the step: the neglected part of a series is of this size.
  [[nodiscard]] double last_terms() const { return last_but_one_ + last_; }

  [[nodiscard]] double at(double x) const { return integrate::evaluate(coefficients(), x); }
  [[nodiscard]] double slope_at(double x) const { return integrate::jet_at(coefficients(), x).first; }

  /// Lowest value found by dense evaluation, from the start of the step on.
  [[nodiscard]] double lowest_until(double time) const {
    std::array<double, integrate::max_coefficients> storage;
    return lowest_value(integrate::scale_to_unit(coefficients(), time, storage));
  }

 private:
  static constexpr std::size_t most_padding = 3;  ///< zeros in place of further coefficients

  [[nodiscard]] std::span<const double> coefficients() const { return {c_.data(), count_}; }

  std::array<double, integrate::max_coefficients> c_;
  std::size_t count_;
  double size_ = 0.0;  ///< sum of the sizes of all terms at the end of the step
  double last_but_one_ = 0.0;
  double last_ = 0.0;
};

}  // namespace rocking::support
