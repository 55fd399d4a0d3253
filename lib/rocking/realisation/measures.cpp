#include "rocking/realisation/measures.hpp"

namespace rocking {

OperationCounts& OperationCounts::operator+=(const OperationCounts& other) {
  steps += other.steps;
  slip_steps += other.slip_steps;
  root_isolations += other.root_isolations;
  ground_motion_segments += other.ground_motion_segments;
  exponent_periods += other.exponent_periods;
  static_friction_draws += other.static_friction_draws;
  kinetic_friction_draws += other.kinetic_friction_draws;
  restitution_draws += other.restitution_draws;
  amplitude_draws += other.amplitude_draws;
  initial_draws += other.initial_draws;
  for (std::size_t kind = 0; kind < events.size(); ++kind) events[kind] += other.events[kind];
  return *this;
}

std::uint64_t Clamps::all() const {
  std::uint64_t sum = 0;
  for (const ClampKind& kind : clamp_kinds) sum += this->*kind.count;
  return sum;
}

Clamps& Clamps::operator+=(const Clamps& other) {
  for (const ClampKind& kind : clamp_kinds) this->*kind.count += other.*kind.count;
  return *this;
}

}  // namespace rocking
