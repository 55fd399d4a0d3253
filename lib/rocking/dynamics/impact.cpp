#include "rocking/dynamics/impact.hpp"

#include <cmath>

namespace rocking::dynamics {

double sticking_tilt_rate(double tilt_rate, double slip_rate, double restitution, const Geometry& block) {
  const double loss = 1.5 * (1.0 + restitution) * (block.sine * block.sine);
  return (tilt_rate - 0.75 * block.cosine * slip_rate) - loss * tilt_rate;
}

ImpactOutcome resolve_impact(const ImpactConditions& before, const Geometry& block, ImpactSlipRule rule) {
  const double w1 = before.tilt_rate;
  const double lambda_term = before.slip_rate - w1 * block.cosine;
  const double direction = w1 < 0.0 ? -1.0 : 1.0;

  const double w_stick = sticking_tilt_rate(w1, before.slip_rate, before.restitution, block);
  const double p_x = -(block.cosine * w_stick + lambda_term);
  const double p_y = block.sine * ((1.0 + 2.0 * before.restitution) * std::abs(w1) + direction * w_stick);
  const double demand = rule == ImpactSlipRule::absolute ? std::abs(p_x) : -direction * p_x;
  const bool sticks = demand <= before.static_friction * p_y || (rule == ImpactSlipRule::signed_ratio && p_y <= 0.0);
  if (sticks) return {w_stick, 0.0, ImpactKind::stick};

  const double slip_direction = p_x > 0.0 ? -1.0 : 1.0;
  const double q = block.sine * block.sine +
                   direction * slip_direction * before.kinetic_friction * block.sine * block.cosine;
  if (1.0 + 3.0 * q <= 0.0) return {w1, before.slip_rate, ImpactKind::painleve};
  const double rebound = 1.0 + 2.0 * before.restitution;
  const double ratio = (1.0 - 3.0 * rebound * q) / (1.0 + 3.0 * q);
  const double w2 = ratio * w1;
  const double vertical = block.sine * (rebound + ratio) * std::abs(w1);
  const double slip_rate =
      lambda_term - slip_direction * before.kinetic_friction * vertical + block.cosine * w2;
  return {w2, slip_direction * slip_rate > 0.0 ? slip_rate : 0.0, ImpactKind::slip};
}

}  // namespace rocking::dynamics
