#include "rocking/dynamics/impact.hpp"

#include <algorithm>
#include <cmath>

namespace rocking::dynamics {

namespace {

double direction_of(double tilt_rate) { return tilt_rate < 0.0 ? -1.0 : 1.0; }

LandingRates<double> rates_of(const ImpactConditions& before) {
  return {.tilt_rate = before.tilt_rate, .slip_rate = before.slip_rate};
}

StickingImpulse<double> sticking_impulse_of(const ImpactConditions& before, const Geometry& block) {
  return sticking_impulse(rates_of(before), landing_edge(before.restitution, block.edge(before.tilt_rate)));
}

}  // namespace

double inelastic_rate_ratio(const Edge& landing, double restitution) {
  return 1.0 - landing.impact_gain * (1.0 + restitution) * landing.sine * landing.half_base;
}

double restitution_of_rate_ratio(const Edge& landing, double rate_ratio) {
  return (1.0 - rate_ratio) / (landing.impact_gain * landing.sine * landing.half_base) - 1.0;
}

LandingEdge<double, BlockForm::general> landing_edge(double restitution, const Edge& landing) {
  return {.restitution = restitution,
          .loss = impact_loss(restitution, landing),
          .sine = landing.sine,
          .cosine = landing.cosine,
          .gain = landing.impact_gain,
          .sideways = landing.sideways};
}

double sticking_tilt_rate(const LandingRates<double>& before, double restitution, const Geometry& block) {
  return sticking_rate(before, landing_edge(restitution, block.edge(before.tilt_rate)));
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
  const auto edge = landing_edge(before.restitution, block.edge(w1));
  const std::optional<double> ratio = slipping_rate_ratio(edge, direction_of(w1) * friction, block);
  if (!ratio) return {.tilt_rate = w1, .slip_rate = before.slip_rate, .kind = ImpactKind::painleve};
  const double w2 = *ratio * w1;
  const double vertical = edge.sine * (edge.rebound() + *ratio) * std::abs(w1);
  const double slip_rate = lambda_term(rates_of(before), edge.cosine) - friction * vertical + edge.cosine * w2;
  const bool slip_ends = !(slip_direction * slip_rate > 0.0);
  return {.tilt_rate = w2, .slip_rate = slip_ends ? 0.0 : slip_rate, .kind = ImpactKind::slip};
}

std::optional<double> slipping_rate_ratio(const LandingEdge<double, BlockForm::general>& edge, double friction,
                                          const Geometry& block) {
  const double q = edge.sine * edge.sine + friction * edge.sine * edge.cosine;
  if (1.0 + block.over_inertia * q <= 0.0) return std::nullopt;
  return (1.0 - block.over_inertia * edge.rebound() * q) / (1.0 + block.over_inertia * q);
}

namespace {

double painleve_friction(const Edge& edge, double inertia, double centroidal_inertia) {
  const double twice = 2.0 * inertia / (edge.radius * edge.radius) + 1.0;
  const double in_motion = std::sqrt(twice * twice - 1.0);
  const double in_impact = (centroidal_inertia + edge.sine * edge.sine) / (edge.sine * edge.cosine);
  return std::min(in_motion, in_impact);
}

}  // namespace

double painleve_friction(const Geometry& block, SlideInertia inertia) {
  const double in_slip = slip_inertia(block, inertia);
  const auto& [left, right] = block.edges;
  return std::min(painleve_friction(left, in_slip, block.inertia), painleve_friction(right, in_slip, block.inertia));
}

}  // namespace rocking::dynamics
