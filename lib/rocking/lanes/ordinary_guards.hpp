#pragma once

#include "rocking/dynamics/guards.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// In place of the lanes where a first coefficient is known to be 0: none.
struct NeverZero {};
/// In place of the lanes where a guard is out of reach: none.
struct InReach {};

/// The guards that are armed in an ordinary step (dynamics::ArmedGuards::is_ordinary), for
/// dynamics::for_each_rocking_guard. What is the same in all lanes is a compile-time constant. `zeros` are truth
/// values: where true, the first coefficient is known to be 0.
template <class Form>
class OrdinaryGuards {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

 public:
  OrdinaryGuards(const LaneAccess<Real>& lanes, const Step<Form>& step) : lanes_(lanes), step_(step) {}

  static constexpr bool was_past_balance() { return false; }
  static constexpr bool slips() { return Form::slips; }
  static constexpr bool tests_friction() { return Form::tests_friction; }
  static constexpr bool determinant_may_vanish() { return false; }
  static constexpr InReach in_reach() { return {}; }
  auto past_balance_out_of_reach() const {
    if constexpr (Form::knows_reach) {
      return step_.out_of_reach.past_balance;
    } else {
      return InReach{};
    }
  }
  auto normal_out_of_reach() const {
    if constexpr (Form::knows_reach) {
      return step_.out_of_reach.normal;
    } else {
      return InReach{};
    }
  }
  static constexpr NeverZero no_zeros() { return {}; }
  static constexpr NeverZero normal_zeros() { return {}; }
  static constexpr NeverZero inward_zeros() { return {}; }
  static constexpr NeverZero outward_zeros() { return {}; }
  Truth tilt_zeros() const { return step_.m.tilt[0] == Real(0.0); }
  Truth slip_zeros() const { return step_.m.slip_rate[0] == Real(0.0); }
  Real shape_angle() const { return lanes_.template constants<Form>().shape_angle; }
  Real inertia() const { return lanes_.template constants<Form>().inertia; }
  auto load() const { return lanes_.template constants<Form>().load; }
  Real slip_sign() const { return lanes_.load(lanes_.state.slip_sign); }
  Real static_friction() const { return lanes_.load(lanes_.state.static_friction); }
  static const Real& seen_from_ground(const Real& normal) { return normal; }

 private:
  const LaneAccess<Real>& lanes_;
  const Step<Form>& step_;
};

/// Calls visit(row, coefficient) for each guard of the step, as dynamics::for_each_rocking_guard.
template <class Form, class Real, class Visitor>
inline void for_each_guard(const LaneAccess<Real>& lanes, const Step<Form>& step, Visitor&& visit) {
  dynamics::for_each_rocking_guard(step.m, OrdinaryGuards<Form>(lanes, step), dynamics::Count<Form::order>{}, visit);
}

}  // namespace
}  // namespace rocking::lanes
