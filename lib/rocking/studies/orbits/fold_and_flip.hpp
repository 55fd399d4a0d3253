#pragma once

#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/map_family.hpp"

/// Orbits at a fold, a period doubling or a loss of symmetry, over two parameters.
namespace rocking {

/// A condition for each pair of values of two parameters; absent where they are not allowed.
using ConditionPlane = std::function<std::optional<Condition>(double first, double second)>;

/// Theta, Theta', V, and the shares of the ranges of the first and the second parameter.
using PlaneUnknowns = std::array<double, 5>;

/// The matrix M of the map has the eigenvalue `sign`: 1 at a fold, -1 at a doubling or a loss of symmetry.
enum class CriticalMultiplier : int { plus_one = 1, minus_one = -1 };

/// Orbits of a family over two parameters, and which of them are sought.
struct CriticalFamily {
  const ConditionPlane* conditions = nullptr;
  std::array<ParameterRange, 2> ranges{};
  OrbitFamily orbits;
  CriticalMultiplier multiplier = CriticalMultiplier::plus_one;
};

/// Vectors that border M - sign I; they must not be orthogonal to its left and right null vectors.
struct CriticalBorder {
  std::array<double, 3> left{};
  std::array<double, 3> right{};
};

/// An orbit with the critical multiplier.
struct CriticalPoint {
  PlaneUnknowns at{};
  PlaneUnknowns tangent{};  ///< of norm 1
  PoincareImage image;      ///< of the map of the family
  CriticalBorder border{};  ///< the singular vectors of M - sign I that belong to its smallest singular value
  double residual = 0.0;    ///< of the orbit
  double test = 0.0;        ///< the smallest singular value of M - sign I
  double error = 0.0;       ///< of the first parameter's share: residuals times condition
  int steps = 0;            ///< of Newton's method
};

/// Largest singular value left at a point of a curve: the entries of M are known to about 1e-13 times the largest one,
/// which is taken as 100 at most.
inline constexpr double largest_test = 1e-11;

/// A hyperplane: normal . (u - through) = 0.
struct PlaneSection {
  PlaneUnknowns normal{};
  PlaneUnknowns through{};
};

/// The map of the family at a state and two shares; absent where the motion ends before.
[[nodiscard]] std::optional<PoincareImage> image_of(const CriticalFamily& family, const PlaneUnknowns& at);

/// The orbit with the critical multiplier on a hyperplane, by Newton's method from `through` for
///
///     H(z, p) = z,   g(z, p) = 0,   normal . (u - through) = 0,
///
/// where g is the last entry of the solution of the bordered system [M - sign I, left; right^T, 0] (v, g) = (0, 1)
/// (Govaerts 2000, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 4). Derivatives of g, and those
/// of H by the parameters, are differences of exact values; they slow Newton's method down but move no result. The
/// tangent has a positive product with the normal. Absent where the residual stays above 1e-13 times the largest entry
/// of M (if above 1) or the test above `largest_test`. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<CriticalPoint> correct(const CriticalFamily& family, const CriticalBorder& border,
                                                   const PlaneSection& section, base::StopRequest stop);

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
