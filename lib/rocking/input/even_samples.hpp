#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/input/line_problems.hpp"
#include "rocking/input/read_ground_motion.hpp"

namespace rocking {

/// What the header of a file says of the values behind it.
struct EvenHeader {
  double time_step = 0.0;                              ///< [s]
  std::optional<std::size_t> declared = std::nullopt;  ///< number of samples
  RecordUnit unit = RecordUnit::g;
};

/// Reads evenly spaced horizontal accelerations, any number of them in a line. One sample more or fewer than declared
/// is a warning, a larger difference a problem. Absent where anything is wrong.
[[nodiscard]] std::optional<GroundMotion> read_even_samples(std::string_view text, const EvenHeader& header,
                                                            double gravity, LineProblems& problems);

/// The unit of a file whose header states `stated`, or none, for a request of `asked`, or none; `standard`: of the
/// format. A contradiction is a problem of the present line.
[[nodiscard]] RecordUnit agreed_unit(std::optional<RecordUnit> stated, std::optional<RecordUnit> asked,
                                     RecordUnit standard, LineProblems& problems);

/// Checks the time step of a header, given as `field`, alone and against one that was asked for. Absent, and reported,
/// if it is none.
[[nodiscard]] std::optional<double> checked_time_step(std::string_view field, std::optional<double> asked,
                                                      LineProblems& problems);

/// The number of samples that a header declares as `field`. Absent, and reported, if it is none.
[[nodiscard]] std::optional<std::size_t> checked_count(std::string_view field, LineProblems& problems);

}  // namespace rocking
