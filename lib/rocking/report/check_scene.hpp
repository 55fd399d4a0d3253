#pragma once

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/object_reader.hpp"

namespace rocking::report {

/// What the values of a scene demand of each other: static friction not below kinetic, no Painleve paradox at the means,
/// a tilt short of overturned, a slip rate only where sliding is possible. A check is left out where `problems` already
/// tells of one of its values.
///
/// `document` is the experiment file, from which the values in messages are taken.
void check_scene(const experiment::Scene& scene, const Json& document, Problems& problems);

/// Smallest kinetic friction coefficient for which the equations of sliding lose their meaning (Painleve): D <= 0 at some
/// tilt, or an impact with 1 + 3q <= 0. With D = J + sin^2(phi) - mu sin(phi) cos(phi), whose least value over phi is
/// J + (1 - sqrt(1 + mu^2))/2:
///
///     mu = min(sqrt((2J + 1)^2 - 1), (1/3 + sin^2 psi)/(sin psi cos psi))
[[nodiscard]] double painleve_friction(const dynamics::Geometry& geometry, dynamics::SlideInertia inertia);

}  // namespace rocking::report
