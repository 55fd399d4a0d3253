#pragma once

#include <optional>
#include <string_view>

#include "rocking/input/read_ground_motion.hpp"

namespace rocking {

/// The format `columns` of a ground motion: a line of numbers for each sample. As read_ground_motion.
[[nodiscard]] std::optional<GroundMotion> read_columns(std::string_view text, const GroundMotionReading& how,
                                                       Problems& problems);

}  // namespace rocking
