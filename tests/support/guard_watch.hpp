#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "rocking/dynamics/automaton.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "support/guard_polynomial.hpp"
#include "support/model_guards.hpp"

namespace rocking::support {

/// Steps of a guard, by what was observed.
struct GuardSteps {
  std::uint64_t armed = 0;
  std::uint64_t spared = 0;  ///< required by the model, but known to be out of reach
  std::uint64_t fired = 0;
  // Faults:
  std::uint64_t missed = 0;   ///< armed, and below zero before the end of the step
  std::uint64_t unarmed = 0;  ///< not armed, and below zero
  std::uint64_t unlike = 0;   ///< armed, and different from the model
  std::uint64_t made_up = 0;  ///< fired, and not zero at that instant

  [[nodiscard]] std::uint64_t offences() const { return missed + unarmed + unlike + made_up; }
};

struct GuardTally {
  std::uint64_t steps = 0;  ///< steps in which time advanced
  std::uint64_t ended_by_event = 0;
  std::array<GuardSteps, dynamics::guard_count> guards;

  [[nodiscard]] std::uint64_t offences() const {
    std::uint64_t sum = 0;
    for (const GuardSteps& guard : guards) sum += guard.offences();
    return sum;
  }
};

/// Observes every guard in every step of a motion, over the time that the integrator accepted.
///
/// The polynomial of an armed guard must not be below zero before the end of the step; this is tested at hundreds of
/// points, more densely where it is low. It must also agree with the equations of the model. A guard that is not armed
/// must be above zero by these equations; this is tested at some points.
template <class Motion>
class GuardWatch {
 public:
  GuardWatch(const dynamics::Setting& setting, bool vertical, GuardTally& tally)
      : setting_(setting), vertical_(vertical), tally_(tally) {}

  /// The integrator has accepted the part `time` of a step of `length`. `sticks_anyway`: friction is not tested.
  void before_move(const Motion& motion, double length, double time, bool sticks_anyway) {
    time_ = time;
    resolution_ = motion.time_resolution();
    armed_.fill(std::nullopt);
    motion.for_each_guard(integrate::every_guard, [&](std::size_t guard, std::span<const double> coefficients) {
      armed_[guard].emplace(coefficients, length);
    });
    const dynamics::State end = motion.state_at(time);
    const bool ends_run = !std::isfinite(end.tilt + end.tilt_rate + end.slip + end.slip_rate);
    if (!(time > 0.0) || ends_run) return;
    ++tally_.steps;
    look_for_dips();
    compare_with_model(motion, length, sticks_anyway);
  }

  void before_reset(const integrate::FiredGuards& fired) {
    if (time_ > 0.0 && fired.any()) ++tally_.ended_by_event;
    for (std::size_t guard = 0; guard < guards; ++guard) {
      if (!fired[guard]) continue;
      ++tally_.guards[guard].fired;
      if (!is_zero_at_end(guard)) ++tally_.guards[guard].made_up;
    }
  }

 private:
  static constexpr std::size_t guards = dynamics::guard_count;
  static constexpr std::size_t model_points = 12;
  using Values = std::array<double, model_points>;

  /// Number of passes over the coefficients that round each once. The integrator scales them, changes their basis,
  /// bisects (often only near a root, where the rounded values shrink with the interval: two passes in all), evaluates,
  /// and knows the time of the root to three roundings. The observer scales, multiplies and adds. A fifth of one pass
  /// has been observed.
  static constexpr double passes = 1 + 1 + 2 + 1 + 3 + 1 + 2;

  /// Neglected part of a series, in units of its last two terms and the tolerance: as if each further term were about
  /// 3 % smaller than the one before. A factor of nine has been observed.
  static constexpr double left_out = 32.0;

  /// Near D = 0, at a tenth of its value without friction, forces grow without bound and their series are useless.
  static constexpr double near_painleve = 1.0 / 30.0;

  void look_for_dips() {
    for (std::size_t guard = 0; guard < guards; ++guard) {
      if (!armed_[guard]) continue;
      ++tally_.guards[guard].armed;
      if (!(armed_[guard]->lowest_until(time_) >= -passes * armed_[guard]->rounding())) ++tally_.guards[guard].missed;
    }
  }

  /// Guards that fire together are zero to within the time resolution. In a step of zero length a guard may start below
  /// zero, since the forces have jumped.
  [[nodiscard]] bool is_zero_at_end(std::size_t guard) const {
    if (!armed_[guard]) return false;
    const double value = armed_[guard]->at(time_);
    if (time_ == 0.0 && value < 0.0) return true;
    return std::abs(value) <=
           passes * armed_[guard]->rounding() + std::abs(armed_[guard]->slope_at(time_)) * resolution_;
  }

  [[nodiscard]] Circumstances circumstances(const Motion& motion, bool sticks_anyway) const {
    const auto& coefficients = motion.coefficients();
    return {.block = setting_.block,
            .inertia = setting_.inertia,
            .static_friction = coefficients.static_friction(),
            .kinetic_friction = motion.kinetic_friction(),
            .tests_friction = coefficients.has_friction() && !motion.is_off_ground() && !sticks_anyway,
            .was_past_balance = motion.was_past_balance(),
            .waits_for_contact = coefficients.has_friction() && motion.is_off_ground() && !sticks_anyway &&
                                 setting_.inertia == setting_.block.inertia,
            .off_ground = motion.is_off_ground(),
            .vertical = vertical_,
            .cell_end = motion.cell_end()};
  }

  void compare_with_model(const Motion& motion, double length, bool sticks_anyway) {
    const Circumstances now = circumstances(motion, sticks_anyway);
    std::array<std::optional<Values>, guards> wanted;
    double largest_term = 0.0;
    bool is_near_painleve = false;
    for (std::size_t i = 0; i < model_points; ++i) {
      const dynamics::State state = motion.state_at(instant(i));
      const dynamics::BaseMotion base = motion.base_at(instant(i));
      largest_term = std::max(
          largest_term, 2.0 + std::abs(base.horizontal) + std::abs(base.weight) + state.tilt_rate * state.tilt_rate);
      for_each_model_guard(now, state, base, [&](dynamics::Guard name, double value) {
        auto& values = wanted[static_cast<std::size_t>(name)];
        if (!values) values.emplace();
        (*values)[i] = value;
        is_near_painleve = is_near_painleve || (name == dynamics::Guard::determinant && value < near_painleve);
      });
    }
    const double truncation = left_out * setting_.tolerance * setting_.block.shape_angle / length;
    const double rounding = 0x1p-48 * largest_term;  // about thirty terms of the equations
    for (std::size_t guard = 0; guard < guards; ++guard) {
      const bool has_no_series = is_near_painleve && guard == static_cast<std::size_t>(dynamics::Guard::normal);
      if (!has_no_series) compare(guard, wanted[guard], truncation + rounding);
    }
  }

  /// Compares a guard with its values by the model, if the model requires the guard.
  void compare(std::size_t guard, const std::optional<Values>& wanted, double allowance) {
    GuardSteps& seen = tally_.guards[guard];
    if (armed_[guard]) {
      if (!wanted || !is_like(*armed_[guard], *wanted, allowance)) ++seen.unlike;
    } else if (wanted) {
      ++seen.spared;
      if (!(*std::ranges::min_element(*wanted) >= -allowance)) ++seen.unarmed;
    }
  }

  [[nodiscard]] double instant(std::size_t i) const { return time_ * static_cast<double>(i + 1) / model_points; }

  /// Whether a polynomial, times the power of time that was divided out, has these values.
  [[nodiscard]] bool is_like(const GuardPolynomial& polynomial, const Values& values, double allowance) const {
    constexpr int most_zeros = 3;
    allowance += passes * polynomial.rounding() + left_out * polynomial.last_terms();
    Values taken;
    for (std::size_t i = 0; i < model_points; ++i) taken[i] = polynomial.at(instant(i));
    for (int zeros = 0; zeros <= most_zeros; ++zeros) {
      double worst = 0.0;
      for (std::size_t i = 0; i < model_points; ++i) {
        worst = std::max(worst, std::abs(taken[i] - values[i]));
        taken[i] *= instant(i);
      }
      if (worst <= allowance) return true;
    }
    return false;
  }

  dynamics::Setting setting_;
  bool vertical_;
  GuardTally& tally_;
  double time_ = 0.0;
  double resolution_ = 0.0;
  std::array<std::optional<GuardPolynomial>, guards> armed_;
};

}  // namespace rocking::support
