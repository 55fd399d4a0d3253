#pragma once

#include <cmath>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>

#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/setting.hpp"
#include "rocking/realisation/trajectory.hpp"

namespace rocking {

/// Kinetic energy relative to the base plus the potential energy of the weight, over m R^2 p^2. By Koenig's theorem
/// with the inertia 1/3 about the centre of mass: (2/3) w^2 + V^2/2 - V w cos(phi) + (4/3) cos(phi).
[[nodiscard]] inline double energy_of(const dynamics::State& state,
                                      const dynamics::EquationConstants<double>& constants) {
  const double cosine = edge_angle(state, constants).cosine;
  const double w = state.tilt_rate;
  const double v = state.slip_rate;
  return 2.0 / 3.0 * w * w + 0.5 * v * v - v * w * cosine + 4.0 / 3.0 * cosine;
}

/// A motion with the same bits as `Motion` that also keeps its energy balance. The work of each step is integrated by
/// Gauss's rule with 15 points, from the polynomials of the step.
template <class Motion>
class AccountedMotion : public Motion {
 public:
  AccountedMotion(Motion motion, const dynamics::Setting& setting)
      : Motion(std::move(motion)), constants_(equation_constants(setting)) {
    account_.at_start = account_.at_end = energy_of(this->state(), constants_);
  }

  [[nodiscard]] const EnergyAccount& account() const { return account_; }

  void strobe(double x) {
    Motion::strobe(x);
    if (this->ended()) end_step(x);  // at the horizon: the rest of the step is not executed
  }

  void move(double x) {
    end_step(x);
    Motion::move(x);
  }

  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    Motion::reset(fired, at_breakpoint);
    const double after = energy_of(this->state(), constants_);
    (after < account_.at_end ? account_.lost_in_impacts : account_.gained_in_impacts) +=
        std::abs(after - account_.at_end);
    account_.at_end = after;
  }

 private:
  void end_step(double x) {
    using Quadrature = boost::math::quadrature::gauss<double, 15>;
    if (x > 0.0) {
      account_.base_work += Quadrature::integrate([this](double t) { return base_power(t); }, 0.0, x);
      if (this->slips())
        account_.friction_work += Quadrature::integrate([this](double t) { return friction_power(t); }, 0.0, x);
    }
    account_.at_end = energy_of(this->state_at(x), constants_);
  }

  [[nodiscard]] double base_power(double x) const {
    const dynamics::State state = this->state_at(x);
    const auto [alpha, weight] = this->base_at(x);
    const auto [sine, cosine] = edge_angle(state, constants_);
    const double along = state.slip_rate - state.tilt_rate * cosine;
    const double upwards = state.side * state.tilt_rate * sine;
    return -4.0 / 3.0 * (alpha * along + (weight - 1.0) * upwards);
  }

  [[nodiscard]] double friction_power(double x) const {
    const dynamics::State state = this->state_at(x);
    const dynamics::BaseMotion base = this->base_at(x);
    double normal = 4.0 / 3.0 * base.weight;
    if (state.contact == dynamics::ContactState::rock_slide) {
      const auto [sine, cosine] = edge_angle(state, constants_);
      const auto rates = slipping_rates(state, base, this->kinetic_friction(), constants_);
      normal += state.side * rates.tilt_acceleration * sine - state.tilt_rate * state.tilt_rate * cosine;
    }
    return -state.slip_direction * this->kinetic_friction() * normal * state.slip_rate;
  }

  dynamics::EquationConstants<double> constants_;
  EnergyAccount account_;
};

}  // namespace rocking
