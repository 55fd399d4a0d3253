#pragma once

#include <cstddef>

#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/sticking_impulse.hpp"
#include "rocking/lanes/crossings.hpp"

namespace rocking::lanes {
namespace {

/// Which lanes end the coming step with an impact that can be computed here: it sticks, ends no chatter, and is the
/// only event.
template <Kind kind, class Shaking, class Real>
class Rebounds : public Crossings<kind, Shaking, Real> {
  using Base = Crossings<kind, Shaking, Real>;

 protected:
  using Base::state_, Base::crossings_, Base::duration_, Base::end_, Base::load, Base::m_, Base::time_;
  using typename Base::Truth;
  static constexpr bool may_land = !Base::slips && Shaking::bounds_acceleration && !Shaking::has_vertical;

 public:
  using Base::Base;

 protected:
  /// Of the lanes `fits`, those with such an impact, as in dynamics::Landing::land.
  Truth find_rebounds(const Truth& fits) {
    rebound_ = -dynamics::sticking_rate<Real>(landing_rates(), landing_edge());
    Truth lands = fits && this->is_first(0) && time_ < time_ + duration_ && end_.tilt_rate < Real(0.0) &&
                  load(state_.least_rebound) < rebound_;
    for (std::size_t i = 1; i < Base::guards; ++i) lands = lands && !this->is_first(i);
    if constexpr (Base::tests_friction) lands = lands && sticks();
    return lands;
  }

  Real rebound_;  ///< tilt rate after the impact, in the frame of the new side

 private:
  [[nodiscard]] dynamics::LandingRates<Real> landing_rates() const {
    return {.tilt_rate = end_.tilt_rate, .slip_rate = Real(0.0)};
  }
  [[nodiscard]] dynamics::LandingEdge<Real> landing_edge() const {
    const auto constants = this->constants();
    return {.restitution = load(state_.restitution),
            .loss = load(state_.impact_loss),
            .sine = constants.sine,
            .cosine = constants.cosine};
  }

  /// Whether friction holds the block during the impact and after it. False within 1 % of the limit: there the motion
  /// decides, so that the rounding of the expressions below has no influence on results.
  [[nodiscard]] Truth sticks() const {
    using base::fused, base::magnitude;
    const Real closest = Real(0.99) * load(state_.static_friction);
    const auto edge = landing_edge();
    const auto impulse = dynamics::sticking_impulse<Real>(landing_rates(), edge);
    Real base = m_.base[Base::order];
#pragma GCC unroll 20
    for (std::size_t k = Base::order; k > 0; --k) base = fused(base, duration_, m_.base[k - 1]);
    // In the frame of the new side.
    const auto forces = dynamics::forces_without_slip<Real>(
        {.edge = {edge.sine, edge.cosine}, .omega = rebound_, .beta = -base, .weight = Real(1.0)});
    return base::at_most(magnitude(impulse.horizontal), closest * impulse.vertical) && Real(0.0) < forces.normal &&
           dynamics::friction_is_enough(forces, closest);
  }
};

}  // namespace
}  // namespace rocking::lanes
