#pragma once

#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/formulation.hpp"

namespace rocking::dynamics {

/// What an impact depends on, all in force just before it. Kinetic friction matters only if it slips and is asked for then.
struct ImpactConditions {
  double tilt_rate;    ///< w1 [rad]
  double slip_rate;    ///< V1
  double restitution;  ///< e, vertical, at the landing edge [-]
  double static_friction;
};

enum class ImpactKind : unsigned char { stick, slip, painleve };

struct ImpactOutcome {
  double tilt_rate;  ///< w2 [rad]; its sign is the side on which the block goes on
  double slip_rate;  ///< V2; 0 exactly where it sticks
  ImpactKind kind;   ///< `painleve`: 1 + 3q <= 0, the model has no answer; the rates are those from before
};

/// Impulsive change of the rates when the other edge lands, if it sticks.
///
/// With L = lambda w1 cos(psi) = V1 - w1 cos(psi), which is well conditioned where lambda = V1/(w1 cos(psi)) - 1 is not,
/// w2 = w1 - (3/4) V1 cos(psi) - (3/2)(1 + e) sin^2(psi) w1, and the impulses over m R p are P_x = -(cos(psi) w2 + L),
/// P_y = sin(psi) ((1 + 2e) abs(w1) + sign(w1) w2). Absent where it slips: abs(P_x) > mu_s P_y.
/// Source: Shenton & Jones (1991); Jeong & Yang (2012) Eqs. 20-26, with the signs as in lib/docs/model.md. The inertia is
/// m R^2/3 for both readings of the slip equations.
[[nodiscard]] std::optional<ImpactOutcome> sticking_impact(const ImpactConditions& before, const Geometry& block,
                                                           ImpactSlipRule rule);

/// The same where it slips. An impact that ends its slip inside the impact has V2 = 0 exactly.
/// Source: Jeong & Yang (2012) Eqs. 27-30.
[[nodiscard]] ImpactOutcome slipping_impact(const ImpactConditions& before, double kinetic_friction,
                                            const Geometry& block);

/// Share of the tilt rate that a sticking impact takes where the block did not slip before.
[[nodiscard]] double impact_loss(double restitution, const Geometry& block);

/// w2 where no friction is given: the block cannot slip.
[[nodiscard]] double sticking_tilt_rate(double tilt_rate, double slip_rate, double restitution, const Geometry& block);

}  // namespace rocking::dynamics
