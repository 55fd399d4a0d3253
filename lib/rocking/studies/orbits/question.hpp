#pragma once

#include <string>

#include "rocking/api/run.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/studies/orbits/orbit.hpp"

/// Periodic orbits of an experiment.
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

/// What a search for periodic orbits has found.
struct OrbitStudy {
  int longest = 0;                                       ///< largest period searched from the grid
  std::vector<OrbitsOfCondition> conditions;             ///< of the experiment
  std::optional<FoundBranches> branches = std::nullopt;  ///< absent where none were asked for, or nothing is swept
};

/// The runs with a response (m,n), and how many of them an orbit backs.
struct OrbitLabels {
  std::size_t periodic = 0;
  std::size_t certified = 0;               ///< those that ended on a stable orbit of this m and n
  std::vector<std::size_t> not_certified;  ///< places of the other conditions
};

[[nodiscard]] OrbitLabels labels_of(const OrbitStudy& study);

/// Which periodic orbits are searched.
struct OrbitsQuestion {
  int longest = 5;  ///< largest period, in excitation periods; at most 12
  /// Follow the orbits over the swept parameter, where the experiment sweeps one number on which the motion depends
  /// continuously, with several values.
  bool branches = true;
  std::optional<double> from = {};   ///< smallest value of the parameter for branches; absent: of the sweep
  std::optional<double> to = {};     ///< largest value
  std::uint64_t most_points = 1000;  ///< of a branch
  std::uint64_t most_branches = 50;
};

/// Periodic orbits and their branches. Throws base::InputError if a condition is random or not harmonic, if a number of the
/// question is out of range, or if a range of branches is asked for and nothing can be followed, and base::Stopped if it is
/// asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts conditions, then points of
/// branches, of which `all` is 0: how many there will be is not known.
[[nodiscard]] ROCKING_API OrbitStudy orbits(const Experiment& experiment, const OrbitsQuestion& question = {},
                                            const Execution& execution = {});

}  // namespace rocking
