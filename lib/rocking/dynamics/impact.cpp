#include "rocking/dynamics/impact.hpp"

#include <cmath>

namespace rocking::dynamics {

double impact_loss(double restitution, const Geometry& block) {
  return 1.5 * (1.0 + restitution) * (block.sine * block.sine);
}

double sticking_tilt_rate(double tilt_rate, double slip_rate, double restitution, const Geometry& block) {
  return (tilt_rate - 0.75 * block.cosine * slip_rate) - impact_loss(restitution, block) * tilt_rate;
}

namespace {

/// Impulses over m R p of an impact taken to stick.
struct Impulse {
  double tilt_rate;   ///< w2
  double horizontal;  ///< P_x
  double vertical;    ///< P_y
};

double direction_of(double tilt_rate) { return tilt_rate < 0.0 ? -1.0 : 1.0; }

/// L = V1 - w1 cos(psi).
double lambda_term(const ImpactConditions& before, const Geometry& block) {
  return before.slip_rate - before.tilt_rate * block.cosine;
}

Impulse sticking_impulse(const ImpactConditions& before, const Geometry& block) {
  const double w1 = before.tilt_rate;
  const double w2 = sticking_tilt_rate(w1, before.slip_rate, before.restitution, block);
  return {.tilt_rate = w2,
          .horizontal = -(block.cosine * w2 + lambda_term(before, block)),
          .vertical = block.sine * ((1.0 + 2.0 * before.restitution) * std::abs(w1) + direction_of(w1) * w2)};
}

}  // namespace

std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                             ImpactSlipRule rule) {
  const Impulse impulse = sticking_impulse(before, block);
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
  const double slip_rate = lambda_term(before, block) - friction * vertical + block.cosine * w2;
  return {w2, slip_direction * slip_rate > 0.0 ? slip_rate : 0.0, ImpactKind::slip};
}

}  // namespace rocking::dynamics
