#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/studies/rare/block_model.hpp"
#include "rocking/studies/rare/splitting.hpp"

/// Probabilities of rare overturning, by multilevel splitting (lib/docs/rare.md).
namespace rocking {

/// What is asked for each condition.
struct RareQuestion {
  rare::Event event;
  double relative_error = 0.1;  ///< standard error over the probability that is aimed at; > 0
};

struct RareSettings {
  std::size_t particles = 500;  ///< of a repetition; 20 to 100000
  rare::Score score = rare::Score::tilt;
  unsigned threads = 1;
  base::StopRequest stop = {};
  /// Asked before each repetition that is not yet needed for an interval. Empty: never.
  std::function<bool(std::size_t condition)> time_is_up = {};
  /// Called by one thread at a time with the number of finished repetitions and that of those planned so far.
  std::function<void(std::size_t condition, std::size_t done, std::size_t planned)> on_progress = {};
};

/// Why no more repetitions were made.
enum class RareEnd : std::uint8_t {
  precise,  ///< the relative error is as small as was asked
  out_of_time,
  never_seen,  ///< the first repetitions have not seen the event
  most_repetitions,
};
[[nodiscard]] std::string_view to_string(RareEnd end);

/// What stands in the way of trusting an interval.
enum class RareDiagnosis : std::uint8_t {
  none,
  no_levels,      ///< the pilot run found no way to the event: the probability is far below what was reached, or 0
  few_ancestors,  ///< the median repetition's estimate descends from fewer than 10 first trajectories
  uneven,         ///< repetitions without the event, or one that has more than a third of the sum
};
[[nodiscard]] std::string_view to_string(RareDiagnosis diagnosis);

/// How the random numbers of a condition are changed.
enum class RareMethod : std::uint8_t {
  markov_chain,  ///< of numbers drawn once
  both,          ///< a Markov chain of all numbers, then a branch of those drawn along the way
};
[[nodiscard]] std::string_view to_string(RareMethod method);

/// The probability of the event for one condition.
struct RareEstimate {
  double probability = 0.0;
  std::optional<double> relative_error;  ///< standard error over the probability; absent for 0
  stats::Interval interval;              ///< for a probability 0: from 0 to the upper end for the highest level
  RareMethod method = RareMethod::markov_chain;
  std::vector<double> levels;   ///< of the score, rising
  std::vector<double> reached;  ///< mean shares of the particles at each level, and the event last
  std::vector<rare::Repetition> repetitions;
  double pilot_work = 0.0;
  double work = 0.0;                 ///< simulated time with the pilot run, in realisations to the horizon
  std::optional<double> crude_work;  ///< realisations for the same relative error by plain sampling
  std::size_t least_ancestors = 0;   ///< of a repetition that has seen the event
  double median_ancestors = 0.0;     ///< likewise
  RareEnd end = RareEnd::precise;
  RareDiagnosis diagnosis = RareDiagnosis::none;
};

/// Throws base::InputError if a condition is not valid or nothing in it is random.
void check_rare(const Experiment& experiment);

/// The estimates for all conditions, in their order. Without a time limit they depend on the experiment, the question
/// and the number of particles alone. Throws as check_rare, and base::Stopped if it is asked to stop.
[[nodiscard]] std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                                           const RareSettings& settings);

}  // namespace rocking
