#pragma once

#include <string>
#include <string_view>

#include "rocking/experiment/summary.hpp"
#include "rocking/experiment/trajectory.hpp"

namespace rocking::report {

/// Value of `format` in a trajectory.
inline constexpr std::string_view trajectory_format = "rocking.trajectory/1";

/// A trajectory as JSON text: a line for each strobe point and each event.
[[nodiscard]] std::string trajectory_text(const experiment::RealisationKey& key, const experiment::Trajectory& trajectory);

}  // namespace rocking::report
