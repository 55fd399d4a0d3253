#pragma once

#include <optional>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The least intensity at which the excitation of a scene lifts a block that is at rest: abs(alpha) reaches
/// tan(psi) (1 + alpha_v) at some instant, for the most slender block that the scene may draw. `intensity`: that of the
/// scene, > 0, a multiple of its accelerations.
///
/// Friction does not lower it: a block that slides because the static coefficient is below tan(psi) does not tip, since
/// kinetic friction is limited to the static friction in force. Infinite where no intensity lifts the block. Absent where
/// none is known: the block does not start at rest, or the amplitude is random.
[[nodiscard]] std::optional<double> least_uplift(const Scene& scene, double intensity);

}  // namespace rocking
