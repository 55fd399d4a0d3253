#pragma once

#include "rocking/dynamics/guards.hpp"
#include "rocking/lanes/lane_access.hpp"

namespace rocking::lanes {
namespace {

/// In place of the lanes where a first coefficient is known to be 0: none.
struct NeverZero {};
/// In place of the lanes where a guard is out of reach: none.
struct InReach {};

/// The guards that are armed in an ordinary step (dynamics::ArmedGuards::is_ordinary), for
/// dynamics::for_each_rocking_guard. What is the same in all lanes is a compile-time constant. `zeros` are truth
/// values: where true, the first coefficient is known to be 0.
template <Kind kind, class Shaking, class Real>
class OrdinaryGuards {
  using Access = LaneAccess<kind, Shaking, Real>;
  using Truth = TruthOf<Real>;

 public:
  OrdinaryGuards(const LaneState& state, const Access& lanes, const dynamics::MotionSeries<Real>& motion,
                 const dynamics::OutOfReach<Truth>& reach)
      : state_(state), lanes_(lanes), m_(motion), out_of_reach_(reach) {}

  static constexpr std::size_t count = Access::slips ? 4 : Access::tests_friction ? 5 : 3;

  static constexpr bool was_past_balance() { return false; }
  static constexpr bool slips() { return Access::slips; }
  static constexpr bool tests_friction() { return Access::tests_friction; }
  static constexpr bool determinant_may_vanish() { return false; }
  static constexpr InReach in_reach() { return {}; }
  auto past_balance_out_of_reach() const {
    if constexpr (Access::knows_reach) {
      return out_of_reach_.past_balance;
    } else {
      return InReach{};
    }
  }
  auto normal_out_of_reach() const {
    if constexpr (Access::knows_reach) {
      return out_of_reach_.normal;
    } else {
      return InReach{};
    }
  }
  static constexpr NeverZero no_zeros() { return {}; }
  static constexpr NeverZero normal_zeros() { return {}; }
  static constexpr NeverZero inward_zeros() { return {}; }
  static constexpr NeverZero outward_zeros() { return {}; }
  Truth tilt_zeros() const { return m_.tilt[0] == Real(0.0); }
  Truth slip_zeros() const { return m_.slip_rate[0] == Real(0.0); }
  dynamics::EquationConstants<Real> constants() const { return lanes_.constants(); }
  Real slip_sign() const { return lanes_.load(state_.slip_sign); }
  Real static_friction() const { return lanes_.load(state_.static_friction); }
  static const Real& seen_from_ground(const Real& normal) { return normal; }

 private:
  const LaneState& state_;
  const Access& lanes_;
  const dynamics::MotionSeries<Real>& m_;
  const dynamics::OutOfReach<Truth>& out_of_reach_;
};

}  // namespace
}  // namespace rocking::lanes
