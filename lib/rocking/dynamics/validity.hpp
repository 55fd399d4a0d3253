#pragma once

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

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
