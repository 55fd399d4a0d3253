#include "rocking/dynamics/impact.hpp"

#include <cmath>

#include "rocking/dynamics/sticking_impulse.hpp"

namespace rocking::dynamics {

double impact_loss(double restitution, const Geometry& block) {
  return 1.5 * (1.0 + restitution) * (block.sine * block.sine);
}

double sticking_tilt_rate(double tilt_rate, double slip_rate, double restitution, const Geometry& block) {
  return sticking_rate<double>({tilt_rate, slip_rate}, impact_loss(restitution, block), block.cosine);
}

namespace {

double direction_of(double tilt_rate) { return tilt_rate < 0.0 ? -1.0 : 1.0; }

StickingImpulse<double> sticking_impulse(const ImpactConditions& before, const Geometry& block) {
  return dynamics::sticking_impulse<double>({before.tilt_rate, before.slip_rate},
                                            {.restitution = before.restitution,
                                             .loss = impact_loss(before.restitution, block),
                                             .sine = block.sine,
                                             .cosine = block.cosine});
}

}  // namespace

std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                             ImpactSlipRule rule) {
  const StickingImpulse<double> impulse = sticking_impulse(before, block);
  const bool is_signed = rule == ImpactSlipRule::signed_ratio;
  const double demand = is_signed ? -direction_of(before.tilt_rate) * impulse.horizontal : std::abs(impulse.horizontal);
  const bool sticks = demand <= before.static_friction * impulse.vertical || (is_signed && impulse.vertical <= 0.0);
  if (!sticks) return std::nullopt;
  return ImpactOutcome{impulse.tilt_rate, 0.0, ImpactKind::stick};
}

ImpactOutcome slipping_impact(const ImpactConditions& before, double kinetic_friction, const Geometry& block) {
  const double w1 = before.tilt_rate;
  const double slip_direction = sticking_impulse(before, block).horizontal > 0.0 ? -1.0 : 1.0;
  const double friction = slip_direction * kinetic_friction;
  const double q = block.sine * block.sine + direction_of(w1) * friction * block.sine * block.cosine;
  if (1.0 + 3.0 * q <= 0.0) return {w1, before.slip_rate, ImpactKind::painleve};
  const double rebound = 1.0 + 2.0 * before.restitution;
  const double ratio = (1.0 - 3.0 * rebound * q) / (1.0 + 3.0 * q);
  const double w2 = ratio * w1;
  const double vertical = block.sine * (rebound + ratio) * std::abs(w1);
  const double slip_rate =
      lambda_term<double>({before.tilt_rate, before.slip_rate}, block.cosine) - friction * vertical + block.cosine * w2;
  return {w2, slip_direction * slip_rate > 0.0 ? slip_rate : 0.0, ImpactKind::slip};
}

}  // namespace rocking::dynamics
