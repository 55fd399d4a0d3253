#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/input/record_unit.hpp"

namespace rocking {

/// What the header of a file says of the values behind it.
struct EvenHeader {
  double time_step = 0.0;                              ///< [s]
  std::optional<std::size_t> declared = std::nullopt;  ///< number of samples
  RecordUnit unit = RecordUnit::g;
  double factor = 1.0;                             ///< of the numbers, which gives accelerations in this unit
  bool has_offset = false;                         ///< of the sensor: the mean is removed, with a warning
  std::optional<double> peak_m_s2 = std::nullopt;  ///< of the header, by which another peak is a warning
};

/// Reads evenly spaced horizontal accelerations, any number of them in a line. One sample more or fewer than declared
/// is a warning, a larger difference a problem. Text that is no number ends the data, with a warning, if the declared
/// number of samples stands before it; otherwise it is a problem. Absent where anything is wrong.
[[nodiscard]] std::optional<GroundMotion> read_even_samples(std::string_view text, const EvenHeader& header,
                                                            double gravity, LineProblems& problems);

/// Reports, at the present line, a unit of the file that is not the one that was asked for.
void expect_asked_unit(RecordUnit stated, std::optional<RecordUnit> asked, LineProblems& problems);

/// The time step [s] of a header, given as `field` in a unit of which a second holds `units_per_second`. Checks it alone
/// and against one that was asked for. Absent, and reported, if it is none.
[[nodiscard]] std::optional<double> checked_time_step(std::string_view field, double units_per_second,
                                                      std::optional<double> asked, LineProblems& problems);

/// The number of samples that a header declares as `field`. Absent, and reported, if it is none.
[[nodiscard]] std::optional<std::size_t> checked_count(std::string_view field, LineProblems& problems);

}  // namespace rocking
