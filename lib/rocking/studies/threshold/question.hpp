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
#include "rocking/scene/shaking.hpp"
#include "rocking/stats/interval.hpp"

/// Thresholds: where in a range of one number, such as the amplitude of a pulse, a block overturns or has another event; or,
/// where something is random, has it with more than a given probability.
namespace rocking {

/// How the motion ended at one value of the number.
struct ThresholdPoint {
  double value = 0.0;
  bool happens = false;       ///< the event; of a random scene: with more than the given probability
  std::uint64_t impacts = 0;  ///< until the fall or the horizon; 0 of a random scene
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  stats::Proportion counts = {};  ///< realisations with the event, of those at this value; one where nothing is random
};

/// The two values that a bisection has left, between which the event begins or ceases to happen. Of a random scene they are
/// the ends of a confidence interval for that value.
struct ThresholdEdge {
  ThresholdPoint stands;   ///< the event does not happen
  ThresholdPoint happens;  ///< it does

  [[nodiscard]] bool begins_band() const { return stands.value < happens.value; }
};

/// Where in the range the event happens.
struct ThresholdBands {
  std::vector<std::array<double, 2>> bands;  ///< smallest and largest value at which it happens, by rising value
  std::vector<ThresholdEdge> edges;  ///< by rising value; a band that begins or ends with the range has none there
  std::vector<double>
      without_answer;  ///< values of the scan at which the motion had no end, counted as standing; of a random
                       ///< scene those that were not told from the given probability

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

/// What is asked of an experiment.
struct ThresholdQuestion {
  std::string of;                   ///< JSON pointer to the number
  std::optional<double> from = {};  ///< range of the number; absent: that of its sweep in the experiment
  std::optional<double> to = {};    ///< above `from`
  ResponseEvent event = {};         ///< within the horizon
  /// Where something is random: the probability that the event has at the edges; within (0, 1). Absent: nothing is.
  std::optional<double> probability = {};
  /// Equal ones, at whose ends the event is looked for; at least 1. Absent: 200, or 20 with a probability.
  std::optional<std::uint64_t> steps = {};
  /// Of an edge over its value; 0: to neighbouring doubles. Absent: 1e-9, or 0.02 with a probability.
  std::optional<double> accuracy = {};
  std::uint64_t realisations = 4000;   ///< with a probability: at most at one value; at least 1
  std::filesystem::path folder = ".";  ///< from which the files of the experiment are seen
};

/// The bands of each combination of the other swept values.
struct ThresholdStudy {
  ThresholdQuestion question;  ///< with its range, steps and accuracy
  std::vector<ThresholdOfCondition> conditions;
  std::optional<BalanceAngles> balance = {};  ///< of the blocks at both ends of the range
};

/// The bands of a number in which the event happens, for each combination of the other values of the sweep. The range is
/// scanned in equal steps, and each change between two neighbours is bisected with whole motions until its interval is
/// within the accuracy. A band or a gap narrower than a step may be missed. Uses `threads`, `on_progress` and `stop` of the
/// execution; progress counts values of the scan, then edges. Throws base::Stopped if it is asked to stop, and
/// base::InputError if the experiment has no text, if the place is not that of a number, if there is no range or a value of
/// it is not allowed, if something is random and no probability is given or the other way round, or if the event is of slip
/// and the block has no friction.
///
/// With a probability, realisations are added at each value of the scan, and at two values within each change, until a
/// confidence sequence tells the share of the event from the probability. Those of one combination hold all at once with
/// 95 %: with this probability the share passes the given one in each interval of an edge, whatever its shape there. The
/// same seed gives a realisation the same draws at every value.
[[nodiscard]] ROCKING_API ThresholdStudy thresholds(const Experiment& experiment, const ThresholdQuestion& question,
                                                    const Execution& execution = {});

}  // namespace rocking
