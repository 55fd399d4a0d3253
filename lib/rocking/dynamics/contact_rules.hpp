#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/setting.hpp"

namespace rocking::dynamics {

/// The state of a block on a moving base at an instant, and which contact states the forces of that instant allow. It
/// changes no state; the changes are in contact_changes.hpp and landing.hpp. Every rule is in lib/docs/model.md,
/// section 3.
template <CoefficientSource Coefficients>
class ContactRules {
 public:
  ContactRules(const Setting& setting, const Clock& clock, const Coefficients& coefficients,
               const Excitation& excitation)
      : setting_(setting), clock_(clock), coefficients_(coefficients), excitation_(excitation) {}

  [[nodiscard]] const Setting& setting() const { return setting_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Clock& clock() const { return clock_; }
  [[nodiscard]] const Coefficients& coefficients() const { return coefficients_; }
  [[nodiscard]] const Excitation& excitation() const { return excitation_; }
  [[nodiscard]] bool slips() const { return is_sliding(state_.contact); }

  /// Amplitude of the horizontal base acceleration in force, in g.
  [[nodiscard]] double base_amplitude() { return coefficients_.amplitude(clock_) * excitation_.unit(setting_.block); }

  /// X at which friction changes if the block goes on slipping; absent: nowhere.
  [[nodiscard]] std::optional<double> cell_end() const {
    if constexpr (HasFrictionOfPlace<Coefficients>) {
      if (slips()) return coefficients_.cell_end(state_.slip_direction);
    }
    return std::nullopt;
  }

  /// Horizontal base acceleration alpha now, in g.
  [[nodiscard]] double base_acceleration() {
    if (accelerated_at_ != clock_.now()) {  // several rules need it at the same instant
      accelerated_at_ = clock_.now();
      base_acceleration_ = excitation_.horizontal(clock_, base_amplitude());
    }
    return base_acceleration_;
  }

  /// A hop without slip whose initial rate exceeds this bound is not too small, from the bound of abs(w'). It is
  /// below the rate after nearly every impact, and does not need the base acceleration.
  [[nodiscard]] double fastest_small_hop() {
    return hop_limit() * largest_acceleration(excitation_.most_horizontal(base_amplitude()));
  }

  /// Whether D can vanish at some tilt: the smallest D over all phi is J + 1/2 - sqrt(1 + mu_k^2)/2.
  [[nodiscard]] bool determinant_may_vanish(double kinetic_friction) const {
    const double limit = 2.0 * setting_.inertia + 1.0;
    return 1.0 + kinetic_friction * kinetic_friction >= limit * limit;
  }

 protected:
  /// The block is at X: its friction is that of the cell.
  void find_cell() {
    if constexpr (HasFrictionOfPlace<Coefficients>) coefficients_.place(state_.slip);
  }

  /// It has come to the end of its cell.
  void enter_next_cell() {
    if constexpr (HasFrictionOfPlace<Coefficients>) coefficients_.enter_cell(state_.slip_direction);
  }

  [[nodiscard]] static double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

  [[nodiscard]] BaseMotion base_motion() { return {.horizontal = base_acceleration(), .weight = weight()}; }
  [[nodiscard]] double kinetic_friction_now() { return coefficients_.kinetic_friction(clock_); }
  [[nodiscard]] bool kinetic_equals_static() { return kinetic_friction_now() == coefficients_.static_friction(); }
  [[nodiscard]] bool is_centroidal() const { return setting_.inertia == inertia_ratio(SlideInertia::centroidal); }

  /// Durations of a hop, and heights over psi, up to which it is too small.
  [[nodiscard]] double hop_limit() const { return std::max(setting_.tolerance, clock_.resolution()); }

  /// Forces of rocking without slip.
  [[nodiscard]] Forces sticking_forces() { return rocking_forces(state_, base_motion(), equation_constants(setting_)); }

  /// Whether a rocking block sticks, given the forces that sticking needs. Where sticking needs N <= 0, the block
  /// sticks unless slip keeps it on the base.
  [[nodiscard]] bool friction_holds(const Forces& forces) {
    if (forces.normal <= 0.0) return !slip_keeps_contact(-sign(forces.friction));
    return std::abs(forces.friction) <= coefficients_.static_friction() * forces.normal;
  }

  /// Whether slip that starts from V = 0 in `direction` is accelerated in that direction.
  [[nodiscard]] bool slip_would_last(double direction) {
    return direction * rates_of_slip(direction).slip_acceleration > 0.0;
  }

  /// The same, with N > 0.
  [[nodiscard]] bool slip_keeps_contact(double direction) {
    const SlippingRates rates = rates_of_slip(direction);
    return rates.normal > 0.0 && direction * rates.slip_acceleration > 0.0;
  }

  /// Whether a block in full contact stays at rest.
  [[nodiscard]] bool full_contact_holds() {
    const BaseMotion base = base_motion();
    const double mu_s = coefficients_.static_friction();
    return mu_s <= setting_.block.tangent ? std::abs(base.horizontal) <= mu_s * base.weight
                                          : edges_hold(base, setting_.block);
  }

  [[nodiscard]] bool friction_is_above_tangent() { return friction_tips(kinetic_friction_now(), setting_.block); }

  /// Whether kinetic friction turns a sliding block over its leading edge. It has no torque where N = (4/3)(1 +
  /// alpha_v) <= 0.
  [[nodiscard]] bool kinetic_friction_tips() { return friction_is_above_tangent() && weight() > 0.0; }

  /// w' of rocking, without and with slip.
  [[nodiscard]] double rocking_acceleration() { return sticking_forces().acceleration; }
  [[nodiscard]] double slipping_acceleration() { return rates_of_slip(state_.slip_direction).tilt_acceleration; }

  [[nodiscard]] double weight() const { return excitation_.weight(clock_); }

  /// Goes on under other circumstances.
  void replace(const Setting& setting, const Clock& clock, const Coefficients& coefficients) {
    setting_ = setting;
    clock_ = clock;
    coefficients_ = coefficients;
    accelerated_at_.reset();
  }

  Setting setting_;
  Clock clock_;
  Coefficients coefficients_;
  Excitation excitation_;
  State state_;

 private:
  /// Rates of slip in `direction`.
  [[nodiscard]] SlippingRates rates_of_slip(double direction) {
    State slipping = state_;
    slipping.slip_direction = direction;
    return slipping_rates(slipping, base_motion(), kinetic_friction_now(), equation_constants(setting_));
  }

  std::optional<Instant> accelerated_at_;  ///< instant of the base acceleration below
  double base_acceleration_ = 0.0;
};

}  // namespace rocking::dynamics
