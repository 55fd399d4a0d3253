#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Value of `format` in a trajectory.
inline constexpr std::string_view trajectory_format = "rocking.trajectory/1";

/// Units of the states and times of a written trajectory: Theta, Theta', X, V and tau; or rad, rad/s, m, m/s and s, for
/// the block of the realisation.
enum class TrajectoryUnits : std::uint8_t { normalised, si };

/// `normalised`, `si`.
[[nodiscard]] std::string_view to_string(TrajectoryUnits units);

/// A trajectory as JSON text: a line for each strobe point and each event. Energies are normalised in either unit, for
/// the mass is not known.
[[nodiscard]] std::string trajectory_text(const RealisationKey& key, const Trajectory& trajectory,
                                          TrajectoryUnits units = TrajectoryUnits::normalised);

/// The same as a table for spreadsheets: lines of metadata that start with `#`, a line of column names, and a row for
/// each strobe point, event and sample of the history, by time. Of rows with equal times, events come first, because
/// the other states are those after the events.
[[nodiscard]] std::string trajectory_csv(const RealisationKey& key, const Trajectory& trajectory,
                                         TrajectoryUnits units = TrajectoryUnits::normalised);

}  // namespace rocking
