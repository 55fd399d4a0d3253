#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "rocking/output/trajectory_report.hpp"

namespace rocking::analysis {

struct StrobeRow {
  double period, tilt, tilt_rate;
};

/// A state of a time history: samples, and events between them.
struct HistoryRow {
  double time;  ///< in excitation periods
  double tilt, tilt_rate, slip;
};

struct EventRow {
  double time;  ///< in excitation periods
  dynamics::EventKind kind;
};

/// An interval of time with one contact state.
struct ContactSpan {
  double from, to;  ///< in excitation periods
  dynamics::ContactState contact;
};

/// The output of `rocking trajectory` as figures show it: normalised, in excitation periods.
struct TrajectoryFile {
  std::string name;  ///< name of its file, to distinguish it from others
  std::uint64_t condition = 0, realisation = 0;
  std::vector<StrobeRow> strobe;
  /// The following members are filled only with `--samples`.
  std::vector<HistoryRow> history;
  std::vector<EventRow> events;
  std::vector<ContactSpan> contacts;
};

/// Throws base::InputError if the history is shorter than a period.
[[nodiscard]] TrajectoryFile shown(const TrajectoryReport& report, const std::string& name);

/// The shown interval of time, in excitation periods.
struct Window {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
};

}  // namespace rocking::analysis
