#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/input/object_reader.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Most bytes that the file of a ground motion may have.
inline constexpr std::size_t most_ground_motion_bytes = 64'000'000;

/// What must be known beside a record's text to make a base motion of it.
struct GroundMotionReading {
  std::string name;                 ///< of the file, for messages
  std::optional<double> time_step;  ///< [s]; absent: the first column is the time
  double gravity;                   ///< [m/s^2], over which accelerations are kept
};

/// Reads a recorded base motion: lines of numbers, `#` before comments; with a time step `horizontal[, vertical]`,
/// without one `time, horizontal[, vertical]`, in s and m/s^2 (lib/docs/formats.md). Two equal times are a jump.
///
/// Absent where anything is wrong. Every bad line is a problem with file and line, up to twenty of them.
[[nodiscard]] std::optional<GroundMotion> read_ground_motion(std::string_view text, const GroundMotionReading& how,
                                                             Problems& problems);

}  // namespace rocking
