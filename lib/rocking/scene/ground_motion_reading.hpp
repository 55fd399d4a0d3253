#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking {

/// Formats of files with recorded accelerations: input/record_formats.hpp.
enum class RecordFormat : std::uint8_t;

/// Unit of the accelerations in a file. `g` is the gravity of the experiment, as in `amplitude_g`; `mg` and `percent_g`
/// are a thousandth and a hundredth of it.
enum class RecordUnit : std::uint8_t { g, m_s2, cm_s2, mm_s2, mg, percent_g, ft_s2, in_s2 };

/// Their names in experiments, in the order of RecordUnit.
inline constexpr std::array<std::string_view, 8> record_unit_names{"g",  "m/s2", "cm/s2", "mm/s2",
                                                                   "mg", "%g",   "ft/s2", "in/s2"};

/// The names as a list in words, for messages.
[[nodiscard]] std::string record_units_in_words();

[[nodiscard]] constexpr std::string_view name_of(RecordUnit unit) {
  return record_unit_names[static_cast<std::size_t>(unit)];
}

/// What a column of a file of numbers contains; `other` is not used.
enum class RecordColumn : std::uint8_t { time, horizontal, vertical, other };

/// Their names in experiments, in the order of RecordColumn.
inline constexpr std::array<std::string_view, 4> record_column_names{"time", "horizontal", "vertical", "other"};

[[nodiscard]] constexpr std::string_view name_of(RecordColumn column) {
  return record_column_names[static_cast<std::size_t>(column)];
}

/// Of columns that cannot be read: `horizontal` must stand among them once, `time` where there is no time step and only
/// there, `vertical` at most once.
[[nodiscard]] std::optional<Refusal> refuse_columns(const std::vector<RecordColumn>& columns, bool has_time_step);

/// What must be known beside a record's text to make a base motion of it.
struct GroundMotionReading {
  std::string name = {};                              ///< of the file; empty: it is not read
  std::optional<double> time_step = std::nullopt;     ///< [s]; absent: the file gives it, or the time of each sample
  double gravity = 9.81;                              ///< [m/s^2], over which accelerations are kept
  std::optional<RecordFormat> format = std::nullopt;  ///< absent: recognised by the first lines
  std::optional<RecordUnit> unit = std::nullopt;      ///< absent: that of the file, of `columns` m/s^2
  std::string vertical_name = {};                     ///< of the file with the vertical component; empty: none
  std::vector<RecordColumn> columns = {};             ///< of format `columns`; empty: not given
  std::string component = {};                         ///< of a file that holds several, as its header names it
  bool takes_vertical = false;                        ///< in place of `component`: the vertical one

  friend auto operator<=>(const GroundMotionReading&, const GroundMotionReading&) = default;
};

// What the samples of a ground motion must be, for the reader of its file and for motions that come from C++.

/// `time` of a sample [s].
[[nodiscard]] std::optional<Refusal> refuse_sample_time(double time);

/// Of a sample that is earlier than the one before it, whose time is shown as `previous`.
[[nodiscard]] Refusal sample_falls_back(std::string_view previous);

/// `acceleration` in units of `unit` [m/s^2].
[[nodiscard]] std::optional<Refusal> refuse_acceleration(double acceleration, double unit = 1.0);

/// Of all samples together: their number, and the time that they take.
[[nodiscard]] std::optional<Refusal> refuse_samples(const std::vector<dynamics::GroundMotionSample>& samples);

/// Adds the first problem of samples whose accelerations are over `gravity` [m/s^2], at `/excitation/file`.
void check_ground_motion(const std::vector<dynamics::GroundMotionSample>& samples, double gravity, Problems& problems);

}  // namespace rocking
