#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"

/// One realisation in full.
namespace rocking {

/// One realisation of an experiment, and how long it is followed.
struct TrajectoryRequest {
  std::uint64_t condition = 0;                         ///< from 0
  std::uint64_t realisation = 0;                       ///< from 0
  std::optional<std::int64_t> periods = std::nullopt;  ///< excitation periods, at least 1; absent: all of the horizon
  int samples_per_period = 0;                          ///< of the history; 0: none
};

/// The trajectory of one realisation: strobe points, events, history, peaks, energy; over its horizon, also the label that
/// a run gives it. Throws base::InputError if the
/// experiment has no such condition or a number is out of range, and base::Stopped if the `stop` of the execution, the
/// only field that is used, asks for it.
[[nodiscard]] ROCKING_API Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request = {},
                                                const Execution& execution = {});

/// Time and state of a row of a trajectory, for its block.
struct StateInSi {
  double time_s = 0.0;
  double tilt_rad = 0.0;
  double tilt_rate_rad_s = 0.0;
  double slip_m = 0.0;
  double slip_rate_m_s = 0.0;
};

/// By row of the trajectory.
struct TrajectoryInSi {
  std::vector<StateInSi> strobe;
  std::vector<StateInSi> events;
  std::vector<StateInSi> history;
};

/// The rows of a trajectory as `trajectory_csv` writes them in SI units.
[[nodiscard]] ROCKING_API TrajectoryInSi in_si(const Trajectory& trajectory);

/// A trajectory as JSON text (`rocking.trajectory/1`), in normalised or SI units.
[[nodiscard]] ROCKING_API std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                      TrajectoryUnits units = TrajectoryUnits::normalised);

/// The same as a table (CSV).
[[nodiscard]] ROCKING_API std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                     TrajectoryUnits units = TrajectoryUnits::normalised);

}  // namespace rocking
