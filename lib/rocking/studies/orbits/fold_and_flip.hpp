#pragma once

#include "rocking/studies/orbits/map_family.hpp"
#include "rocking/studies/orbits/orbit.hpp"

/// Orbits at a fold, a period doubling or a loss of symmetry.
namespace rocking {

/// The matrix M of the map has the eigenvalue `sign`: 1 at a fold, -1 at a doubling or a loss of symmetry.
enum class CriticalMultiplier : int { plus_one = 1, minus_one = -1 };

/// Orbits, and the multiplier that they have at a bifurcation.
struct CriticalOrbits {
  OrbitFamily orbits;
  CriticalMultiplier multiplier = CriticalMultiplier::plus_one;
};

/// What a bifurcation on a branch may be one of. A doubling that was located on the doubled orbits is one of orbits of
/// half their period, a loss of symmetry on orbits that are not symmetric is one of symmetric orbits. None for grazings
/// and changes of contact.
[[nodiscard]] std::vector<CriticalOrbits> critical_orbits(BifurcationKind kind, const OrbitFamily& of_branch);

/// An orbit with the critical multiplier.
struct CriticalPoint {
  Unknowns at{};
  double error = 0.0;  ///< of the parameter's share: residuals times condition
};

/// The orbit of the family with the critical multiplier next to `at`, by Newton's method for
///
///     H(z, q) = z,   g(z, q) = 0,
///
/// where g is the last entry of the solution of the bordered system [M - sign I, left; right^T, 0] (v, g) = (0, 1)
/// (Govaerts 2000, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 4), with the singular vectors of
/// M - sign I at `at`. Derivatives of g, and those of H by the parameter, are differences of exact values; they slow
/// Newton's method down but move no result. Absent where the residual stays above 1e-13 times the largest entry of M (if
/// above 1), or the smallest singular value of M - sign I above 1e-11 times it; also farther than 1e-3 of the range from
/// `at`, or 1e-2 in all unknowns. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<CriticalPoint> critical_near(const MapFamily& family, CriticalMultiplier multiplier,
                                                         const Unknowns& at, base::StopRequest stop);

}  // namespace rocking
