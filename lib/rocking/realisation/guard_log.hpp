#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/realisation/guard_minimum.hpp"

namespace rocking {

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
