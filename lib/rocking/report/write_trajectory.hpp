#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "rocking/experiment/trajectory.hpp"

namespace rocking::report {

/// Value of `format` in a trajectory.
inline constexpr std::string_view trajectory_format = "rocking.trajectory/1";

/// Which realisation a trajectory is of; counted from 0.
struct RealisationKey {
  std::size_t condition = 0;
  std::uint64_t realisation = 0;
};

/// A trajectory as JSON text: a line for each strobe point and each event.
[[nodiscard]] std::string trajectory_text(const RealisationKey& key, const experiment::Trajectory& trajectory);

}  // namespace rocking::report
