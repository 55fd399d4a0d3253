#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/checks.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"

/// What is asked about a rare event, and what is estimated (lib/docs/rare.md).
namespace rocking {

namespace rare {

/// One unbiased estimate.
struct Repetition {
  double estimate = 0.0;
  std::size_t ancestors = 0;  ///< first trajectories from which those that had the event descend
  double work = 0.0;          ///< simulated time, in realisations to the horizon
  /// Estimate of the probability that a motion ends before its horizon without an answer: by a budget of steps, or by
  /// Painleve's paradox.
  double unresolved = 0.0;
};

/// A point of the Poincare section of a path.
struct StrobeState {
  double tilt = 0.0;       ///< Theta [-]
  double tilt_rate = 0.0;  ///< Theta' [-]
};

/// A trajectory that has the event, and the random numbers that make it again (lib/docs/draws.md).
struct Path {
  /// In place of a draw of a source, by the name of the source.
  struct Given {
    std::string source;
    double number = 0.0;
    std::uint64_t index = 0;
  };
  /// From these indices on, by the number of the source, the normal draws along the way are those of this number.
  struct Branch {
    std::uint64_t number = 0;
    std::vector<std::uint64_t> from;
  };
  std::uint64_t number = 0;  ///< realisation number of its draws
  std::vector<Given> given;
  std::vector<Branch> branches;  ///< in the order in which they were made
  int samples_per_period = 0;
  std::vector<std::vector<double>> tilts;  ///< Theta from the start to the event, by periods
  std::vector<StrobeState> strobe;         ///< from strobe point 1 on
};

/// The probability of the event from points of the Poincare section with all of the horizon ahead, and V = 0.
struct CommittorMap {
  double tilt = 0.0;                      ///< columns are at even distances from -tilt to tilt
  double tilt_rate = 0.0;                 ///< rows, likewise
  std::vector<std::vector<double>> rows;  ///< by rising Theta'
};

}  // namespace rare

/// Why no more repetitions were made.
enum class RareEnd : std::uint8_t {
  precise,  ///< the relative error is as small as was asked
  out_of_time,
  stopped,     ///< it was asked to stop
  never_seen,  ///< the first repetitions have not seen the event
  most_repetitions,
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 5> rare_end_names{"precise", "out_of_time", "stopped", "never_seen",
                                                                "most_repetitions"};
[[nodiscard]] constexpr std::string_view to_string(RareEnd end) {
  return rare_end_names[static_cast<std::size_t>(end)];
}

/// What stands in the way of trusting an interval.
enum class RareDiagnosis : std::uint8_t {
  none,
  not_found,        ///< the last pilot run has not seen the event
  few_repetitions,  ///< fewer than 8 were finished: the interval is [0, 1]
  uneven,           ///< a tenth of the repetitions or more missed the event, or one has more than a third of the sum
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> rare_diagnosis_names{"none", "not_found", "few_repetitions", "uneven"};
[[nodiscard]] constexpr std::string_view to_string(RareDiagnosis diagnosis) {
  return rare_diagnosis_names[static_cast<std::size_t>(diagnosis)];
}

/// How the probability of a condition is estimated.
enum class RareMethod : std::uint8_t {
  twisted_run,          ///< a particle run that the committor steers; numbers are drawn along the way
  importance_sampling,  ///< of numbers that are all drawn once
  plain_sampling,       ///< numbers are drawn along the way, and the pilot runs expect no gain from a twisted run
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> rare_method_names{"twisted_run", "importance_sampling",
                                                                   "plain_sampling"};
[[nodiscard]] constexpr std::string_view to_string(RareMethod method) {
  return rare_method_names[static_cast<std::size_t>(method)];
}

/// The probability of the event for one condition.
struct RareEstimate {
  std::optional<double> probability;     ///< absent if no repetition was finished when the time was up
  std::optional<double> relative_error;  ///< standard error over the probability; absent for 0, and of few repetitions
  /// For a probability 0: see rare.md. Its upper end is that of the probability with `unresolved`.
  stats::Interval interval;
  double unresolved = 0.0;  ///< mean of Repetition::unresolved
  RareMethod method = RareMethod::twisted_run;
  std::vector<double> levels;   ///< of the search for the event, rising; empty for a twisted run
  std::vector<double> reached;  ///< share of its particles at each level, and the event last
  std::vector<rare::Repetition> repetitions;
  std::size_t ancestors = 0;  ///< median of Repetition::ancestors, the lower one; 0 without repetitions
  double pilot_work = 0.0;
  double work = 0.0;  ///< simulated time of what was finished, with the pilot runs, in realisations to the horizon
  std::optional<double> crude_work;             ///< realisations for the same relative error by plain sampling
  std::optional<rare::CommittorMap> committor;  ///< of a twisted run
  std::vector<rare::Path> paths;  ///< drawn from those with the event, by their weights; none if the time was up
  RareEnd end = RareEnd::precise;
  RareDiagnosis diagnosis = RareDiagnosis::none;
};

/// What is asked of each condition, and with how much work.
struct RareQuestion {
  ResponseEvent event = {};      ///< within the horizon; of slip where all numbers are drawn once
  double relative_error = 0.1;   ///< standard error over the probability that is aimed at; > 0
  std::size_t particles = 1000;  ///< trajectories of a repetition; 20 to 100000
  /// Time for all conditions together [s], on a clock of the execution. What is not finished then is left out. Absent: no
  /// limit, so that the same is estimated again.
  std::optional<double> seconds = {};
  /// Of an earlier study with the same experiment, event and particles, by condition: their repetitions are not made again.
  std::vector<RareEstimate> earlier = {};
};

/// Estimates the probability of an event, one entry for each condition, by a particle run that
/// the committor steers or by importance sampling. Uses `threads`, `on_progress`, `stop` and `elapsed_seconds` of the
/// execution; progress counts simulated time in realisations to the horizon. Their number is estimated; it is 0, not known,
/// up to the end of the pilot runs of the first condition. Throws base::InputError if nothing in a condition is random, if a
/// number is out of range, if there is a time and no clock, or if slip is asked of a block without friction or with numbers
/// drawn along the way, and base::Stopped if it is asked to stop. Source: lib/docs/rare.md.
[[nodiscard]] ROCKING_API std::vector<RareEstimate> rare_probabilities(const Experiment& experiment,
                                                                       const RareQuestion& question,
                                                                       const Execution& execution = {});

}  // namespace rocking
