#pragma once

#include <optional>
#include <vector>

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/fold_and_flip.hpp"

namespace rocking {

/// Orbits, and the multiplier that they have at a bifurcation.
struct CriticalOrbits {
  OrbitFamily orbits;
  CriticalMultiplier multiplier = CriticalMultiplier::plus_one;
};

/// What a bifurcation on a branch may be one of. A doubling that was located on the doubled orbits is one of orbits of
/// half their period, a loss of symmetry on orbits that are not symmetric is one of symmetric orbits. None for grazings
/// and changes of contact.
[[nodiscard]] std::vector<CriticalOrbits> critical_orbits(BifurcationKind kind, const OrbitFamily& of_branch);

/// The orbit with the critical multiplier next to `at`, with the second parameter held: within 1e-3 of the range of the
/// first one and 1e-2 in all unknowns. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<CriticalPoint> critical_near(const CriticalFamily& family, const PlaneUnknowns& at,
                                                         base::StopRequest stop);

}  // namespace rocking
