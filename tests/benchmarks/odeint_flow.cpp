#include "benchmarks/odeint_flow.hpp"

#include <algorithm>
#include <cstddef>

namespace rocking::benchmarks {

using peer::Equations;
using peer::Guards;
using peer::Stretch;
using peer::Vector;

namespace {

/// Guards that were above 0 and no longer are.
std::array<bool, peer::guard_count> fallen(const Guards& before, const Guards& after) {
  std::array<bool, peer::guard_count> did{};
  for (std::size_t i = 0; i < did.size(); ++i) did[i] = before[i] > 0.0 && after[i] <= 0.0;
  return did;
}

bool any(const std::array<bool, peer::guard_count>& fired) {
  return std::any_of(fired.begin(), fired.end(), [](bool did) { return did; });
}

auto system_of(const Equations& equations) {
  return [&equations](const Vector& state, Vector& rates, double time) { rates = equations.rates(time, state); };
}

}  // namespace

Stretch OdeintFlow::bisect(Stepper& stepper, const Guards& before, const Equations& equations) {
  constexpr double resolution = 1e-15;  // tau: of the order of a rounding of the instant
  double low = stepper.previous_time();
  double high = stepper.current_time();
  Vector state{};
  while (high - low > resolution) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    stepper.calc_state(middle, state);
    (any(fallen(before, equations.guards(middle, state))) ? high : low) = middle;
  }
  stepper.calc_state(high, state);
  return {high, state, fallen(before, equations.guards(high, state))};
}

void OdeintFlow::polish(Stretch& found, Stepper& stepper, const Equations& equations) {
  const auto system = system_of(equations);
  const double start = stepper.previous_time();
  const auto guard =
      static_cast<std::size_t>(std::find(found.fired.begin(), found.fired.end(), true) - found.fired.begin());
  const auto step_to_instant = [&] {
    Method method;  // afresh: it would start from the rates at the end of its last step
    method.do_step(system, stepper.previous_state(), start, found.state, found.duration - start);
  };
  step_to_instant();
  constexpr double while_later = 1e-7;
  const Vector rates = equations.rates(found.duration, found.state);
  Vector later = found.state;
  for (std::size_t i = 0; i < later.size(); ++i) later[i] += while_later * rates[i];
  const double value = equations.guards(found.duration, found.state)[guard];
  const double slope = (equations.guards(found.duration + while_later, later)[guard] - value) / while_later;
  const double root = found.duration - value / slope;
  if (!(slope < 0.0 && start < root && root <= stepper.current_time())) return;
  found.duration = root;
  step_to_instant();
}

Stretch OdeintFlow::follow(const Vector& start, double duration, double smallness, const Equations& equations) {
  const auto system = system_of(equations);
  Stepper stepper = boost::numeric::odeint::make_dense_output(accuracy_.absolute * smallness, accuracy_.relative,
                                                              accuracy_.longest_step, Method());
  stepper.initialize(start, 0.0, std::min(last_step_, duration));
  Guards before = equations.guards(0.0, start);
  while (true) {
    stepper.do_step(system);
    const Guards after = equations.guards(stepper.current_time(), stepper.current_state());
    if (any(fallen(before, after))) {
      Stretch found = bisect(stepper, before, equations);
      polish(found, stepper, equations);
      return found;
    }
    if (stepper.current_time() >= duration) return {duration, stepper.current_state(), {}};
    before = after;
    last_step_ = stepper.current_time_step();
    // The last step ends where the equations change.
    const double rest = duration - stepper.current_time();
    if (last_step_ > rest) stepper.initialize(Vector(stepper.current_state()), stepper.current_time(), rest);
  }
}

}  // namespace rocking::benchmarks
