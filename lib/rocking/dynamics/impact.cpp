#include "rocking/dynamics/impact.hpp"

#include <algorithm>
#include <cmath>

namespace rocking::dynamics {

double impact_loss(double restitution, const Geometry& block) {
  return 1.5 * (1.0 + restitution) * (block.sine * block.sine);
}

double inelastic_rate_ratio(const Geometry& block, double restitution) {
  return 1.0 - 1.5 * (1.0 + restitution) * block.sine * block.sine;
}

double restitution_of_rate_ratio(const Geometry& block, double rate_ratio) {
  return (1.0 - rate_ratio) / (1.5 * block.sine * block.sine) - 1.0;
}

namespace {

LandingEdge<double> landing_edge(double restitution, const Geometry& block) {
  return {
      .restitution = restitution, .loss = impact_loss(restitution, block), .sine = block.sine, .cosine = block.cosine};
}

LandingRates<double> rates_of(const ImpactConditions& before) {
  return {.tilt_rate = before.tilt_rate, .slip_rate = before.slip_rate};
}

StickingImpulse<double> sticking_impulse_of(const ImpactConditions& before, const Geometry& block) {
  return sticking_impulse<double>(rates_of(before), landing_edge(before.restitution, block));
}

double direction_of(double tilt_rate) { return tilt_rate < 0.0 ? -1.0 : 1.0; }

}  // namespace

double sticking_tilt_rate(const LandingRates<double>& before, double restitution, const Geometry& block) {
  return sticking_rate<double>(before, landing_edge(restitution, block));
}

std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                             ImpactSlipRule rule) {
  const StickingImpulse<double> impulse = sticking_impulse_of(before, block);
  const bool is_signed = rule == ImpactSlipRule::signed_ratio;
  const double demand = is_signed ? -direction_of(before.tilt_rate) * impulse.horizontal : std::abs(impulse.horizontal);
  const bool sticks = demand <= before.static_friction * impulse.vertical || (is_signed && impulse.vertical <= 0.0);
  if (!sticks) return std::nullopt;
  return ImpactOutcome{.tilt_rate = impulse.tilt_rate, .slip_rate = 0.0, .kind = ImpactKind::stick};
}

ImpactOutcome slipping_impact(const ImpactConditions& before, double kinetic_friction, const Geometry& block) {
  const double w1 = before.tilt_rate;
  const double slip_direction = sticking_impulse_of(before, block).horizontal > 0.0 ? -1.0 : 1.0;
  const double friction = slip_direction * kinetic_friction;
  const double q = block.sine * block.sine + direction_of(w1) * friction * block.sine * block.cosine;
  if (1.0 + 3.0 * q <= 0.0) {
    return {.tilt_rate = w1, .slip_rate = before.slip_rate, .kind = ImpactKind::painleve};
  }
  const double rebound = 1.0 + 2.0 * before.restitution;
  const double ratio = (1.0 - 3.0 * rebound * q) / (1.0 + 3.0 * q);
  const double w2 = ratio * w1;
  const double vertical = block.sine * (rebound + ratio) * std::abs(w1);
  const double slip_rate =
      lambda_term<double>(rates_of(before), block.cosine) - friction * vertical + block.cosine * w2;
  const bool slip_ends = !(slip_direction * slip_rate > 0.0);
  return {.tilt_rate = w2, .slip_rate = slip_ends ? 0.0 : slip_rate, .kind = ImpactKind::slip};
}

double painleve_friction(const Geometry& block, SlideInertia inertia) {
  const double twice = 2.0 * inertia_ratio(inertia) + 1.0;
  const double in_motion = std::sqrt(twice * twice - 1.0);
  const double in_impact = (1.0 / 3.0 + block.sine * block.sine) / (block.sine * block.cosine);
  return std::min(in_motion, in_impact);
}

}  // namespace rocking::dynamics
