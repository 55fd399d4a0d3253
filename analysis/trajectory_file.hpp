#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "rocking/report/json.hpp"

namespace rocking::analysis {

struct StrobeRow {
  double period, tilt, tilt_rate;
};

/// A state of a time history; events stand among its samples.
struct HistoryRow {
  double time;  ///< in excitation periods
  double tilt, tilt_rate, slip;
};

struct EventRow {
  double time;  ///< in excitation periods
  std::string kind;
};

/// A stretch of one state of contact.
struct ContactSpan {
  double from, to;  ///< in excitation periods
  std::string contact;
};

/// What `rocking trajectory` printed.
struct TrajectoryFile {
  std::string name;  ///< to tell it from others: of its file
  std::uint64_t condition = 0, realisation = 0;
  std::vector<StrobeRow> strobe;
  /// The following only with `--samples`.
  std::vector<HistoryRow> history;
  std::vector<EventRow> events;
  std::vector<ContactSpan> contacts;
};

/// Throws base::InputError where it is no trajectory.
[[nodiscard]] TrajectoryFile read_trajectory(const report::Json& output, const std::string& name);

/// The part of the time that is shown, in excitation periods.
struct Window {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

}  // namespace rocking::analysis
