#pragma once

#include <optional>
#include <string_view>

#include "rocking/input/line_problems.hpp"

namespace rocking {

/// What the last line of a header in PEER's format gives, as written.
struct PeerCounts {
  std::string_view count;         ///< of samples
  std::string_view step;          ///< the time step
  double units_per_second = 1.0;  ///< of its unit: 1 for s, 1000 for ms
};

/// Reads both forms of the line: `NPTS=  4000, DT=   .0100 SEC` and `4000  0.0050  NPTS, DT`. Absent, and reported,
/// where a number is missing, a key stands twice, or the unit of the time step is not known.
[[nodiscard]] std::optional<PeerCounts> peer_counts(std::string_view line, LineProblems& problems);

}  // namespace rocking
