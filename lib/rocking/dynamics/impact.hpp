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
/// L), P_y = sin(psi) ((1 + 2e) abs(w1) + sign(w1) w2). Absent where it slips: abs(P_x) > mu_s P_y.
/// Source: Shenton & Jones (1991); Jeong & Yang (2012) Eqs. 20-26, with the signs as in lib/docs/model.md. The inertia
/// is m R^2/3 for both readings of the slip equations.
[[nodiscard]] std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                                           ImpactSlipRule rule);

/// The same if it slips. Where slip ends during the impact, V2 = 0 exactly.
/// Source: Jeong & Yang (2012) Eqs. 27-30.
[[nodiscard]] ImpactOutcome slipping_impact(const ImpactConditions& before, double kinetic_friction,
                                            const Geometry& block);

/// Ratio of the tilt rates across an impact that sticks, w2/w1, where the block did not slip before [-].
///
///     delta = 1 - (3/2)(1 + e) sin^2(psi)
///
/// With e = 0 it is Housner's ratio, which Jeong & Yang (2012) put in the place of the restitution (Eq. 25): `jy25`.
/// Negative for squat blocks: the block swings back over the same edge. Valid for -1 < e <= 1.
/// Source: Housner (1963), BSSA 53(2) 403-417; Jeong & Yang (2012) Eq. 25.
[[nodiscard]] double inelastic_rate_ratio(const Geometry& block, double restitution = 0.0);

/// The restitution e with which inelastic_rate_ratio is `rate_ratio`, its inverse:
///
///     e = (1 - delta)/((3/2) sin^2(psi)) - 1
///
/// Below -1 for a ratio above 1, and above 1 for one below 1 - 3 sin^2(psi).
[[nodiscard]] double restitution_of_rate_ratio(const Geometry& block, double rate_ratio);

/// Share of the tilt rate that a sticking impact takes where the block did not slip before.
[[nodiscard]] double impact_loss(double restitution, const Geometry& block);

/// w2 of a sticking impact.
[[nodiscard]] double sticking_tilt_rate(const LandingRates<double>& before, double restitution, const Geometry& block);

/// Smallest kinetic friction coefficient for which the equations of sliding have no valid solution at some tilt or in
/// an impact (Painleve's paradox) [-].
///
///     mu = min(sqrt((2J + 1)^2 - 1), (1/3 + sin^2 psi)/(sin psi cos psi))
///
/// The first limit is that of a motion: D = J + sin^2(phi) - mu sin(phi) cos(phi) has its least value over phi at
/// J + (1 - sqrt(1 + mu^2))/2, which is 0 at this mu. The second is that of an impact: 1 + 3 q = 0 with
/// q = sin^2(psi) - mu sin(psi) cos(psi). Valid for 0 < psi < pi/2.
/// Source: derived in lib/docs/model.md, section 7; the impact that slips, with q, is that of Jeong & Yang (2012) Eqs.
/// 27-30.
[[nodiscard]] double painleve_friction(const Geometry& block, SlideInertia inertia);

}  // namespace rocking::dynamics
