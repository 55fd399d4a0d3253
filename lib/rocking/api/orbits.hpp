#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/export.hpp"
#include "rocking/api/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/orbit_study.hpp"

/// Periodic orbits, stable and unstable, of an experiment in which nothing is random.
namespace rocking {

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

/// Periodic orbits, their branches and the curves of their bifurcations. Throws as check_request, and base::Stopped if it
/// is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts conditions.
[[nodiscard]] ROCKING_API OrbitStudy orbit_study(const Experiment& experiment, const OrbitsRequest& request = {},
                                                 const Execution& execution = {});

/// The study as JSON text (`rocking.orbits/1`), the same bytes as `orbits.json` of the program.
[[nodiscard]] ROCKING_API std::string orbits_text(const Experiment& experiment, const OrbitStudy& study);

/// The study as the program prints it: orbits, branches, bifurcations, curves, and which response modes an orbit backs.
[[nodiscard]] ROCKING_API std::string orbits_table(const OrbitStudy& study);

}  // namespace rocking
