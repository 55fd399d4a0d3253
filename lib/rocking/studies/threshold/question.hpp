#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"

/// Thresholds: where in a range of one number, such as the amplitude of a pulse, a block overturns or has another event.
namespace rocking {

/// How the motion ended at one value of the number.
struct ThresholdPoint {
  double value = 0.0;
  bool happens = false;       ///< the event
  std::uint64_t impacts = 0;  ///< until the fall or the horizon
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
};

/// The two values that a bisection has left, between which the event begins or ceases to happen.
struct ThresholdEdge {
  ThresholdPoint stands;   ///< the event does not happen
  ThresholdPoint happens;  ///< it does

  [[nodiscard]] bool begins_band() const { return stands.value < happens.value; }
};

/// Where in the range the event happens.
struct ThresholdBands {
  std::vector<std::array<double, 2>> bands;  ///< smallest and largest value at which it happens, by rising value
  std::vector<ThresholdEdge> edges;    ///< by rising value; a band that begins or ends with the range has none there
  std::vector<double> without_answer;  ///< values of the scan at which the motion had no end; counted as standing

  /// Whether the range begins, or ends, within a band.
  [[nodiscard]] bool begins_inside() const { return !bands.empty() && (edges.empty() || !edges.front().begins_band()); }
  [[nodiscard]] bool ends_inside() const { return !bands.empty() && (edges.empty() || edges.back().begins_band()); }
  /// Between two bands, from the first to the last value at which the block stands again.
  [[nodiscard]] std::vector<std::array<double, 2>> gaps() const;
};

/// The bands of one combination of the other swept values.
struct ThresholdOfCondition {
  std::vector<Parameter> parameters;  ///< the other swept values
  ThresholdBands found;
};

/// What is asked of an experiment in which nothing is random.
struct ThresholdQuestion {
  std::string of;                      ///< JSON pointer to the number
  std::optional<double> from = {};     ///< range of the number; absent: that of its sweep in the experiment
  std::optional<double> to = {};       ///< above `from`
  ResponseEvent event = {};            ///< within the horizon
  std::uint64_t steps = 200;           ///< equal ones, at whose ends the event is looked for; at least 1
  double accuracy = 1e-9;              ///< of an edge over its value; 0: to neighbouring doubles
  std::filesystem::path folder = ".";  ///< from which the files of the experiment are seen
};

/// The bands of each combination of the other swept values.
struct ThresholdStudy {
  ThresholdQuestion question;  ///< with its range
  std::vector<ThresholdOfCondition> conditions;
};

/// Throws base::InputError if the experiment has no text, if the place is not that of a number, if there is no range, if a
/// condition is random or not allowed at an end of the range, or if the event is of slip and the block has no friction.
ROCKING_API void check_request(const Experiment& experiment, const ThresholdQuestion& question);

/// The bands of a number in which the event happens, for each combination of the other values of the sweep. The range is
/// scanned in equal steps, and each change between two neighbours is bisected with whole motions until its interval is
/// within the accuracy. A band or a gap narrower than a step may be missed. Throws as check_request, base::InputError where
/// a value of the range is not allowed, and base::Stopped if it is asked to stop. Uses `threads`, `on_progress` and `stop`
/// of the execution; progress counts motions of the scan, then edges.
[[nodiscard]] ROCKING_API ThresholdStudy thresholds(const Experiment& experiment, const ThresholdQuestion& question,
                                                    const Execution& execution = {});

}  // namespace rocking
