#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/bifurcation_curve.hpp"
#include "rocking/studies/orbits/branches.hpp"
#include "rocking/studies/orbits/orbits_of_condition.hpp"

namespace rocking {

inline constexpr std::string_view orbits_format = "rocking.orbits/1";

/// The branches of an experiment that sweeps one number.
struct FoundBranches {
  std::string pointer;  ///< of the parameter
  ParameterRange range;
  std::size_t most_points;
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

/// The orbits of an experiment.
struct FoundOrbits {
  const Experiment* experiment;
  int longest;                                           ///< largest period searched from the grid
  std::vector<OrbitsOfCondition> conditions;             ///< of the experiment
  std::optional<FoundBranches> branches = std::nullopt;  ///< absent where none were asked for, or nothing is swept
  std::optional<FoundCurves> curves = std::nullopt;      ///< absent where none were asked for
};

/// `rocking.orbits/1` (lib/docs/formats.md): a line for each orbit.
[[nodiscard]] std::string orbits_text(const FoundOrbits& found);

/// The orbits as text: a row for each orbit; the branches and their bifurcations; which response modes of runs are
/// backed by an orbit.
[[nodiscard]] std::string orbits_table(const FoundOrbits& found);

}  // namespace rocking
