#pragma once

#include <cstdint>
#include <optional>
#include <string>

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

/// The trajectory of one realisation: strobe points, events, history, peaks, energy. Throws base::InputError if the
/// experiment has no such condition or a number is out of range, and base::Stopped if the `stop` of the execution, the
/// only field that is used, asks for it.
[[nodiscard]] ROCKING_API Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request = {},
                                                const Execution& execution = {});

/// A trajectory as JSON text (`rocking.trajectory/1`), in normalised or SI units.
[[nodiscard]] ROCKING_API std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                      TrajectoryUnits units = TrajectoryUnits::normalised);

/// The same as a table (CSV).
[[nodiscard]] ROCKING_API std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                     TrajectoryUnits units = TrajectoryUnits::normalised);

}  // namespace rocking
