#pragma once

#include <boost/numeric/odeint.hpp>

#include "differential/peer/flow.hpp"

namespace rocking::benchmarks {

/// Boost.odeint: Dormand and Prince's method of order 5; guards are looked at after each step, and the instant at which
/// one fell is found by bisection on the dense output.
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
  /// The dense output is of a lower order than the method. A step to the instant found, one of Newton's for the instant and
  /// another step to it cost little and give what the method can; without them errors are
  /// about a hundred times as large.
  static void polish(peer::Stretch& found, Stepper& stepper, const peer::Equations& equations);

  peer::FlowAccuracy accuracy_;
  double last_step_;  ///< the stepper's choice: where the next stretch starts from
};

}  // namespace rocking::benchmarks
