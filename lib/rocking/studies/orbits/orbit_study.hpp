#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/orbit.hpp"

namespace rocking {

/// The orbits of a condition, and the run from its initial state.
struct OrbitsOfCondition {
  std::vector<Parameter> parameters;                                           ///< of the condition
  dynamics::Termination termination = dynamics::Termination::reached_horizon;  ///< of the run
  section::ResponseMode mode;                                                  ///< of the run
  std::optional<std::size_t> run_on;  ///< the stable orbit on which the run ended
  std::vector<Orbit> orbits;          ///< in the order in which they were found
  std::uint64_t searches = 0;         ///< Newton iterations started
  std::uint64_t converged = 0;        ///< of these, to an orbit, new or not

  /// Whether the run ended on a stable orbit of the m and n of its response; absent if that is not (m,n).
  [[nodiscard]] std::optional<bool> is_certified() const;
};

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
