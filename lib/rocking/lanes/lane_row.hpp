#pragma once

#include <array>

namespace rocking::lanes {

inline constexpr int most_lanes = 16;

/// One number for each lane.
using LaneRow = std::array<double, most_lanes>;

}  // namespace rocking::lanes
