#include "rocking/experiment/result.hpp"

namespace rocking::experiment {

Effort& Effort::operator+=(const Effort& other) {
  steps += other.steps;
  slip_steps += other.slip_steps;
  root_isolations += other.root_isolations;
  record_segments += other.record_segments;
  companion_periods += other.companion_periods;
  static_friction_draws += other.static_friction_draws;
  kinetic_friction_draws += other.kinetic_friction_draws;
  restitution_draws += other.restitution_draws;
  amplitude_draws += other.amplitude_draws;
  initial_draws += other.initial_draws;
  for (std::size_t kind = 0; kind < events.size(); ++kind) events[kind] += other.events[kind];
  return *this;
}

Clamps& Clamps::operator+=(const Clamps& other) {
  kinetic_at_zero += other.kinetic_at_zero;
  kinetic_at_static += other.kinetic_at_static;
  static_at_zero += other.static_at_zero;
  restitution += other.restitution;
  amplitude_at_zero += other.amplitude_at_zero;
  return *this;
}

}  // namespace rocking::experiment
