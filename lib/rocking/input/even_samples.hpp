#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/input/record_unit.hpp"

namespace rocking {

/// The largest acceleration as a header states it, by which another peak is a warning.
struct HeaderPeak {
  double m_s2 = 0.0;      ///< without its sign
  double rounding = 0.0;  ///< half a unit of its last digit [m/s^2]
};

/// What the header of a file says of the values behind it.
struct EvenHeader {
  double time_step = 0.0;                              ///< [s]
  std::optional<std::size_t> declared = std::nullopt;  ///< number of samples
  RecordUnit unit = RecordUnit::g;
  double factor = 1.0;          ///< of the numbers, which gives accelerations in this unit
  bool has_offset = false;      ///< of the sensor: the mean is removed, with a warning
  std::size_t field_width = 0;  ///< of fields that may touch; 0: something stands between them
  std::size_t columns = 1;      ///< numbers that belong to one sample
  std::size_t column = 0;       ///< which of them is its acceleration
  bool has_times = false;       ///< the first of them is its time; there is no time step
  std::optional<HeaderPeak> peak = std::nullopt;
};

/// The peak that a header gives as `field`, in `unit`; absent if it is no number, 0, or the 1E38 of what is absent.
[[nodiscard]] std::optional<HeaderPeak> header_peak(std::string_view field, RecordUnit unit, double gravity);

/// Reads horizontal accelerations, any number of them in a line. One sample more or fewer than declared
/// is a warning, a larger difference a problem. Text that is no number ends the data, with a warning, if the declared
/// number of samples stands before it; otherwise it is a problem. Absent where anything is wrong.
[[nodiscard]] std::optional<GroundMotion> read_even_samples(std::string_view text, const EvenHeader& header,
                                                            double gravity, LineProblems& problems);

/// Reports, at the present line, a unit of the file that is not the one that was asked for.
void expect_asked_unit(RecordUnit stated, std::optional<RecordUnit> asked, LineProblems& problems);

/// Reports, at the present line, a time step that is not the one that was asked for.
void expect_asked_step(double step, std::optional<double> asked, LineProblems& problems);

/// Reports a time step that was asked for of a file that has times.
void expect_no_step(std::optional<double> asked, LineProblems& problems);

/// The time step [s] of a header, given as `field` in a unit of which a second holds `units_per_second`. Checks it alone
/// and against one that was asked for. Absent, and reported, if it is none.
[[nodiscard]] std::optional<double> checked_time_step(std::string_view field, double units_per_second,
                                                      std::optional<double> asked, LineProblems& problems);

/// The number of samples that a header declares as `field`. Absent, and reported, if it is none.
[[nodiscard]] std::optional<std::size_t> checked_count(std::string_view field, LineProblems& problems);

}  // namespace rocking
