#pragma once

#include <boost/numeric/odeint.hpp>

#include "differential/peer/flow.hpp"

namespace rocking::benchmarks {

/// Boost.odeint: Dormand and Prince's method of order 5. Guards are tested after each step, and the instant of a fall
/// is found by bisection on the dense output.
class OdeintFlow final : public peer::Flow {
 public:
  explicit OdeintFlow(const peer::FlowAccuracy& accuracy) : accuracy_(accuracy), last_step_(accuracy.longest_step) {}

  [[nodiscard]] peer::Stretch follow(const peer::Vector& start, double duration, double smallness,
                                     const peer::Equations& equations) override;

 private:
  using Method = boost::numeric::odeint::runge_kutta_dopri5<peer::Vector>;
  using Stepper = boost::numeric::odeint::result_of::make_dense_output<Method>::type;

  [[nodiscard]] static peer::Stretch bisect(Stepper& stepper, const peer::Guards& before,
                                            const peer::Equations& equations);
  /// The dense output has a lower order than the method. A step to the instant found, one Newton step for the instant
  /// and another step to it cost little and give the accuracy of the method; without them errors are about a hundred
  /// times as large.
  static void polish(peer::Stretch& found, Stepper& stepper, const peer::Equations& equations);

  peer::FlowAccuracy accuracy_;
  double last_step_;  ///< chosen by the stepper: the next stretch starts with it
};

}  // namespace rocking::benchmarks
