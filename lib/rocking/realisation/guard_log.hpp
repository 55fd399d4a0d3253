#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rocking/base/jet.hpp"
#include "rocking/dynamics/armed_guards.hpp"
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

/// The rate at which a guard that depends on the state was reached: of theta over psi, of V, or of the friction limit.
struct GuardCrossing {
  dynamics::Guard guard;
  double rate;
};

/// How a motion reaches the guards of impact, slip and the friction limit, and how it passes them.
class GuardLog {
 public:
  /// In the order of time; without the impacts of a chatter that has ended.
  [[nodiscard]] const std::vector<GuardCrossing>& crossings() const { return crossings_; }

  /// Passages of the guards that do not fire, in the order of time.
  [[nodiscard]] const std::vector<GuardMinimum>& minima() const { return minima_; }

  void add(const GuardCrossing& crossing) { crossings_.push_back(crossing); }

  /// A chatter has ended, the last impact of which has just been added.
  void forget_chatter() {
    while (!crossings_.empty() && crossings_.back().guard == dynamics::Guard::tilt) crossings_.pop_back();
  }

  /// Adds the minima up to time `length` of the step that the motion is about to make.
  template <class Motion>
  void note_minima(const Motion& motion, double length) {
    using dynamics::Guard;
    const dynamics::ArmedGuards armed = motion.armed_guards();
    const auto wanted = [](std::size_t guard) {
      return guard == static_cast<std::size_t>(Guard::tilt) || guard == static_cast<std::size_t>(Guard::slip) ||
             guard == static_cast<std::size_t>(Guard::friction_inward) ||
             guard == static_cast<std::size_t>(Guard::friction_outward);
    };
    visit_guards(armed, motion.series().rows(), wanted, [&](std::size_t number, std::span<const double> coefficients) {
      const auto guard = static_cast<Guard>(number);
      const std::size_t zeros = guard == Guard::tilt              ? armed.tilt_zeros()
                                : guard == Guard::slip            ? armed.slip_zeros()
                                : guard == Guard::friction_inward ? armed.inward_zeros()
                                                                  : armed.outward_zeros();
      const auto least = local_minimum(coefficients, zeros, length);
      if (!least) return;
      const double unit = guard == Guard::tilt ? motion.setting().block.shape_angle : 1.0;
      minima_.push_back({.guard = guard, .value = *least / unit});
    });
  }

 private:
  std::vector<GuardCrossing> crossings_;
  std::vector<GuardMinimum> minima_;
};

}  // namespace rocking
