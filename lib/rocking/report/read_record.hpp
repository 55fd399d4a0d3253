#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/experiment/experiment.hpp"
#include "rocking/report/object_reader.hpp"

namespace rocking::report {

/// Most samples that a record may have, and most bytes.
inline constexpr std::size_t most_samples = 1'000'000;
inline constexpr std::size_t most_record_bytes = 64'000'000;

/// What must be known beside a record's text to make a base motion of it.
struct RecordReading {
  std::string name;                 ///< of the file, for messages
  std::optional<double> time_step;  ///< [s]; absent: the first column is the time
  double gravity;                   ///< [m/s^2], over which accelerations are kept
};

/// Reads a recorded base motion: lines of numbers, `#` before comments; with a time step `horizontal[, vertical]`, without
/// one `time, horizontal[, vertical]`, in s and m/s^2 (lib/docs/formats.md). Two equal times are a jump.
///
/// Absent where anything is wrong. Every bad line is a problem with file and line, up to twenty of them.
[[nodiscard]] std::optional<experiment::GroundMotion> read_record(std::string_view text, const RecordReading& how,
                                                                  Problems& problems);

}  // namespace rocking::report
