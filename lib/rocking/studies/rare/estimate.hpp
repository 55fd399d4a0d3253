#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/stats/interval.hpp"

/// What multilevel splitting is asked, and what it estimates (lib/docs/rare.md).
namespace rocking {
namespace rare {

/// What measures how near a motion is to the event.
enum class Score : std::uint8_t {
  tilt,    ///< largest abs(Theta) so far
  energy,  ///< largest energy of rocking so far, over that at the unstable equilibrium; 0 at rest
};

[[nodiscard]] std::string_view to_string(Score score);

/// The event: the block overturns, or abs(Theta) exceeds `peak_tilt` (also if it overturns).
struct Event {
  std::optional<double> peak_tilt;  ///< [-]
};

/// One repetition: product of the shares of particles that reached each level in turn, and the event. Unbiased.
struct Repetition {
  double estimate = 0.0;
  std::vector<double> reached;  ///< share of the particles at each level, the event last; ends at the first 0
  std::size_t ancestors = 0;    ///< first trajectories from which those that had the event descend
  double work = 0.0;
};

}  // namespace rare

/// What is asked for each condition.
struct RareQuestion {
  rare::Event event;
  double relative_error = 0.1;  ///< standard error over the probability that is aimed at; > 0
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
  no_levels,        ///< the pilot run found no way to the event: the probability is far below what was reached, or 0
  few_repetitions,  ///< the time was up before 8 were finished: the interval is [0, 1]
  few_ancestors,    ///< the median repetition's estimate descends from fewer than 10 first trajectories
  uneven,           ///< repetitions without the event, or one that has more than a third of the sum
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
  std::optional<double> probability;     ///< absent if no repetition was finished when the time was up
  std::optional<double> relative_error;  ///< standard error over the probability; absent for 0, and of few repetitions
  stats::Interval interval;              ///< for a probability 0: from 0 to the upper end for the highest level
  RareMethod method = RareMethod::markov_chain;
  std::vector<double> levels;   ///< of the score, rising
  std::vector<double> reached;  ///< mean shares of the particles at each level, and the event last
  std::vector<rare::Repetition> repetitions;
  double pilot_work = 0.0;
  double work = 0.0;  ///< simulated time of what was finished, with the pilot run, in realisations to the horizon
  /// Realisations for the same relative error by plain sampling, which are cheaper than those of `work`: they have lanes.
  std::optional<double> crude_work;
  std::size_t least_ancestors = 0;  ///< of a repetition that has seen the event
  double median_ancestors = 0.0;    ///< likewise
  RareEnd end = RareEnd::precise;
  RareDiagnosis diagnosis = RareDiagnosis::none;
};

}  // namespace rocking
