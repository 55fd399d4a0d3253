#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "rocking/input/object_reader.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/ground_motion_reading.hpp"

namespace rocking {

/// Most bytes that the file of a ground motion may have.
inline constexpr std::size_t most_ground_motion_bytes = 64'000'000;

/// Reads a recorded base motion in one of the formats of lib/docs/ground-motions.md. `columns`: lines of numbers, `#`
/// before comments; with a time step `horizontal[, vertical]`, without one `time, horizontal[, vertical]`. Two equal
/// times are a jump. `vertical_name` is not read here.
///
/// Absent where anything is wrong. Every bad line is a problem with file, line and value, up to five of them.
[[nodiscard]] std::optional<GroundMotion> read_ground_motion(std::string_view text, const GroundMotionReading& how,
                                                             Problems& problems);

/// Adds the horizontal component of another file as the vertical one. The times of the two must agree; where one has
/// fewer samples, it is at rest from its end on, and the motion has a warning. False where anything is wrong.
[[nodiscard]] bool add_vertical(const GroundMotion& vertical, GroundMotion& motion, Problems& problems);

}  // namespace rocking
