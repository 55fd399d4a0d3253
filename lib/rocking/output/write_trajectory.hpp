#pragma once

#include <string>
#include <string_view>

#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Value of `format` in a trajectory.
inline constexpr std::string_view trajectory_format = "rocking.trajectory/1";

/// A trajectory as JSON text: a line for each strobe point and each event.
[[nodiscard]] std::string trajectory_text(const RealisationKey& key, const Trajectory& trajectory);

}  // namespace rocking
