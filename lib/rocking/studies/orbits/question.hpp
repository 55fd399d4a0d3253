#pragma once

#include <string>

#include "rocking/api/run.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/studies/orbits/branch.hpp"
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

/// Which periodic orbits are searched.
struct OrbitsRequest {
  int longest = 5;  ///< largest period, in excitation periods; at most 12
  /// Follow the orbits over the swept parameter, where the experiment sweeps one number on which the motion depends
  /// continuously.
  bool branches = false;
  std::optional<double> from = {};   ///< smallest value of the parameter for branches; absent: of the sweep
  std::optional<double> to = {};     ///< largest value
  std::uint64_t most_points = 1000;  ///< of a branch
  std::uint64_t most_branches = 50;
  /// JSON pointers of a second parameter, over which the folds, period doublings and losses of symmetry of the branches
  /// are followed too; the numbers at the others keep their ratio to the first. Empty: none.
  std::vector<std::string> second = {};
  std::optional<double> second_from = {};  ///< smallest value of it; needed with `second`, as the next one
  std::optional<double> second_to = {};    ///< largest value
  std::uint64_t most_curve_points = 400;   ///< of a curve in each direction
};

/// Whether an experiment sweeps one number of the motion, with several values, so that branches can be followed.
[[nodiscard]] ROCKING_API bool has_branches(const Experiment& experiment);

/// Throws base::InputError if a condition is random or not harmonic, if a number of the request is out of range, or if
/// branches or curves are asked for and nothing can be followed.
ROCKING_API void check_request(const Experiment& experiment, const OrbitsRequest& request);

/// Periodic orbits, their branches and the curves of their bifurcations. Throws as check_request, and base::Stopped if
/// it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts conditions, then points
/// of branches and curves, of which `all` is 0: how many there will be is not known.
[[nodiscard]] ROCKING_API OrbitStudy orbits(const Experiment& experiment, const OrbitsRequest& request = {},
                                            const Execution& execution = {});

/// The study as JSON text (`rocking.orbits/1`), the same bytes as `orbits.json` of the program.
[[nodiscard]] ROCKING_API std::string orbits_text(const Experiment& experiment, const OrbitStudy& study);

/// The study as the program prints it: orbits, branches, bifurcations, curves, and which response modes an orbit backs.
[[nodiscard]] ROCKING_API std::string orbits_table(const OrbitStudy& study);

}  // namespace rocking
