#pragma once

#include <optional>
#include <string_view>

#include "rocking/input/read_ground_motion.hpp"

namespace rocking {

/// The format `esm_asc` of the European strong-motion database: a header of lines `KEY: value`, of which
/// SAMPLING_INTERVAL_S and UNITS are needed and NDATA is checked, and evenly spaced accelerations. As
/// read_ground_motion.
[[nodiscard]] std::optional<GroundMotion> read_esm_asc(std::string_view text, const GroundMotionReading& how,
                                                       Problems& problems);

}  // namespace rocking
