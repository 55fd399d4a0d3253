#pragma once

#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/sticking_impulse.hpp"

namespace rocking::dynamics {

/// What an impact depends on, just before it. Kinetic friction is a parameter of slipping_impact, because a source of
/// random coefficients is asked for it only if the impact slips.
struct ImpactConditions {
  double tilt_rate;        ///< w1 [rad]
  double slip_rate;        ///< V1
  double restitution;      ///< e, vertical, at the landing edge [-]
  double static_friction;  ///< mu_s
};

enum class ImpactKind : unsigned char { stick, slip, painleve };

struct ImpactOutcome {
  double tilt_rate;  ///< w2 [rad]; its sign is the side on which the block goes on
  double slip_rate;  ///< V2; 0 exactly where it sticks
  ImpactKind kind;   ///< `painleve`: 1 + 3q <= 0, the model has no solution; the rates are those before the impact
};

/// Impulsive change of the rates when the other edge lands, if it sticks.
///
/// With L = lambda w1 cos(psi) = V1 - w1 cos(psi), which is well conditioned where lambda = V1/(w1 cos(psi)) - 1 is
/// not, w2 = w1 - (3/4) V1 cos(psi) - (3/2)(1 + e) sin^2(psi) w1, and the impulses over m R p are P_x = -(cos(psi) w2 +
/// L), P_y = sin(psi) ((1 + 2e) abs(w1) + sign(w1) w2): so for a rectangle. The edge that lands is that of side sign(w1).
/// Absent where it slips: abs(P_x) > mu_s P_y.
/// Source: Shenton & Jones (1991); Jeong & Yang (2012) Eqs. 20-26, with the signs as in lib/docs/model.md. The inertia
/// is that about the centre of mass for both readings of the slip equations.
[[nodiscard]] std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                                           ImpactSlipRule rule);

/// The same if it slips. Where slip ends during the impact, V2 = 0 exactly.
/// Source: Jeong & Yang (2012) Eqs. 27-30.
[[nodiscard]] ImpactOutcome slipping_impact(const ImpactConditions& before, double kinetic_friction,
                                            const Geometry& block);

/// delta of the same: w2/w1 where the landing edge slips with mu_k times the sign of slip and of w1. Absent where the model
/// has no solution.
[[nodiscard]] std::optional<double> slipping_rate_ratio(const LandingEdge<double, BlockForm::general>& edge,
                                                        double friction, const Geometry& block);

/// Ratio of the tilt rates across an impact that sticks, w2/w1, where the block did not slip before [-].
///
///     delta = 1 - (1 + e) b_S (b_1 + b_-1)/(I/m + R_S^2)     = 1 - (3/2)(1 + e) sin^2(psi) for a rectangle
///
/// With e = 0 it is Housner's ratio, from the angular momentum about the landing edge, which Jeong & Yang (2012) put in
/// the place of the restitution (Eq. 25): `jy25`. Negative for squat blocks: the block swings back over the same edge.
/// Valid for -1 < e <= 1.
/// Source: Housner (1963), BSSA 53(2) 403-417; Jeong & Yang (2012) Eq. 25.
[[nodiscard]] double inelastic_rate_ratio(const Edge& landing, double restitution = 0.0);

/// The restitution e with which inelastic_rate_ratio is `rate_ratio`, its inverse; for a rectangle
///
///     e = (1 - delta)/((3/2) sin^2(psi)) - 1
///
/// Below -1 for a ratio above 1, and above 1 for one below 1 - 3 sin^2(psi).
[[nodiscard]] double restitution_of_rate_ratio(const Edge& landing, double rate_ratio);

/// Share of the tilt rate that a sticking impact takes where the block did not slip before.
[[nodiscard]] inline double impact_loss(double restitution, const Edge& landing) {
  return landing.impact_gain * (1.0 + restitution) * (landing.sine * landing.half_base);
}

// Of a rectangle, whose edges are alike.
[[nodiscard]] inline double inelastic_rate_ratio(const Geometry& block, double restitution = 0.0) {
  return inelastic_rate_ratio(block.edges[0], restitution);
}
[[nodiscard]] inline double restitution_of_rate_ratio(const Geometry& block, double rate_ratio) {
  return restitution_of_rate_ratio(block.edges[0], rate_ratio);
}
[[nodiscard]] inline double impact_loss(double restitution, const Geometry& block) {
  return impact_loss(restitution, block.edges[0]);
}

/// What a sticking impact of this edge depends on. The numbers of a rectangle give the bits of its LandingEdge.
[[nodiscard]] LandingEdge<double, BlockForm::general> landing_edge(double restitution, const Edge& landing);

/// w2 of a sticking impact.
[[nodiscard]] double sticking_tilt_rate(const LandingRates<double>& before, double restitution, const Geometry& block);

/// J of the slip equations.
[[nodiscard]] inline double slip_inertia(const Geometry& block, SlideInertia inertia) {
  return block.is_rectangle() ? inertia_ratio(inertia) : block.inertia;
}

/// Smallest kinetic friction coefficient for which the equations of sliding have no valid solution at some tilt or in
/// an impact (Painleve's paradox) [-].
///
///     mu = min(sqrt((2J/r^2 + 1)^2 - 1), (J + s^2)/(s c))     s = sin(psi), c = cos(psi), r = 1 for a rectangle
///
/// The first limit is that of a motion: D = J + sin^2(phi) - mu sin(phi) cos(phi) has its least value over phi at
/// J + (1 - sqrt(1 + mu^2))/2, which is 0 at this mu for r = 1. The second is that of an impact:
/// 1 + q/J = 0 with q = s^2 - mu s c. The smaller one of both edges. Valid for 0 < psi < pi/2.
/// Source: derived in lib/docs/model.md, section 7; the impact that slips, with q, is that of Jeong & Yang (2012) Eqs.
/// 27-30.
[[nodiscard]] double painleve_friction(const Geometry& block, SlideInertia inertia);

}  // namespace rocking::dynamics
