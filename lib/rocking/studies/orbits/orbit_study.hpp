#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rocking/studies/orbits/bifurcation_curve.hpp"
#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/orbits_of_condition.hpp"
#include "rocking/studies/orbits/parameter_range.hpp"

namespace rocking {

/// The branches of an experiment that sweeps one number.
struct FoundBranches {
  std::string pointer;  ///< JSON pointer of the parameter
  ParameterRange range;
  std::size_t most_points = 0;
  BranchStudy study;
};

/// The curves of bifurcations over the swept number and a second one.
struct FoundCurves {
  std::vector<std::string> pointers;  ///< of the second parameter; the numbers at the others keep their ratio
  double value = 0.0;                 ///< of the second parameter, on the branches
  ParameterRange range;               ///< of the second parameter
  std::size_t most_points = 0;
  std::vector<BifurcationCurve> curves;
};

/// What a search for periodic orbits has found.
struct OrbitStudy {
  int longest = 0;                                       ///< largest period searched from the grid
  std::vector<OrbitsOfCondition> conditions;             ///< of the experiment
  std::optional<FoundBranches> branches = std::nullopt;  ///< absent where none were asked for, or nothing is swept
  std::optional<FoundCurves> curves = std::nullopt;      ///< absent where none were asked for
};

/// The runs with a response (m,n), and how many of them an orbit backs.
struct OrbitLabels {
  std::size_t periodic = 0;
  std::size_t certified = 0;               ///< those that ended on a stable orbit of this m and n
  std::vector<std::size_t> not_certified;  ///< places of the other conditions
};

[[nodiscard]] OrbitLabels labels_of(const OrbitStudy& study);

}  // namespace rocking
