#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rocking/studies/orbits/branch.hpp"

namespace rocking {

/// An orbit at its bifurcation.
struct BifurcationPoint {
  double value = 0.0;         ///< of the swept parameter
  double second_value = 0.0;  ///< of the second one
  Orbit orbit;
  double test =
      0.0;  ///< smallest singular value of M - I (fold) or M + I, with M the derivative of the map of the family
};

/// Orbits at one kind of bifurcation, connected over two parameters.
struct BifurcationCurve {
  std::size_t bifurcation = 0;  ///< place of the one from which it was followed
  BifurcationKind kind = BifurcationKind::fold;
  OrbitFamily orbits;
  std::vector<BifurcationPoint> points = {};  ///< by arclength
  std::array<BranchEnd, 2> ends{};            ///< before the first point and behind the last one
};

}  // namespace rocking
