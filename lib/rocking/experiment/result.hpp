#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/experiment/stopping.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/section/verdict.hpp"
#include "rocking/stats/double_sampling.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::experiment {

/// What was computed for a realisation, a condition or a run, effect by effect. A scene that has no use for an effect
/// leaves its counters at 0.
struct Effort {
  std::uint64_t steps = 0;              ///< Taylor steps
  std::uint64_t slip_steps = 0;         ///< of them, steps of the slip equations (slide, rock_slide)
  std::uint64_t root_isolations = 0;    ///< guards that the cheap bound did not clear
  std::uint64_t record_segments = 0;    ///< pieces of a recorded motion that were looked up
  std::uint64_t companion_periods = 0;  ///< periods run a second time to tell chaos from noise
  std::uint64_t static_friction_draws = 0;
  std::uint64_t kinetic_friction_draws = 0;
  std::uint64_t restitution_draws = 0;
  std::uint64_t amplitude_draws = 0;
  std::uint64_t initial_draws = 0;                                 ///< phase and initial state
  std::array<std::uint64_t, dynamics::event_kind_count> events{};  ///< by EventKind

  Effort& operator+=(const Effort& other);
};

/// How often a draw was clamped where its value was used.
struct Clamps {
  std::uint64_t kinetic_at_zero = 0;
  std::uint64_t kinetic_at_static = 0;  ///< mu_k held at the mu_s in force
  std::uint64_t static_at_zero = 0;
  std::uint64_t restitution = 0;
  std::uint64_t amplitude_at_zero = 0;

  Clamps& operator+=(const Clamps& other);
};

/// Realisations of which something holds: how many, and the first of them, to look at with `rocking trajectory`.
struct Cases {
  static constexpr std::size_t kept = 5;
  std::uint64_t count = 0;
  std::vector<std::uint64_t> first;  ///< their numbers, rising, at most `kept`

  void add(std::uint64_t realisation) {
    ++count;
    if (first.size() < kept) first.push_back(realisation);
  }
};

/// Where realisations left the model or the classification was unsure.
struct Validity {
  Cases left_ground;   ///< met N <= 0
  Cases painleve;      ///< ended at D <= 0 or 1 + 3q <= 0
  Cases stopped;       ///< ended by the budget of steps
  Cases in_transient;  ///< still drifting at the horizon
  Cases settled_late;  ///< named by the last part of the sampled periods
  double least_held =
      1.0;               ///< of those that are named: the smallest share of the sampled periods that bears a name out
  Cases past_balance;    ///< met abs(Theta) = 1
  Cases contradictions;  ///< met an instant at which neither sticking nor slipping agrees with the equations; it stuck
  Cases clamped;         ///< had a draw clamped
  std::map<section::Reason, Cases> unresolved;  ///< why no response mode was named
  Clamps clamps;                                ///< draws clamped, all realisations together
};

/// The probability of a mode in the long run, from the modes of all realisations and of those that were run for longer.
struct Corrected {
  stats::CheckedCounts counts;
  double estimate = 0.0;
  stats::Interval interval;  ///< covers for sure, for this mode alone
};

/// A probability: counts, value, intervals.
struct Estimate {
  stats::Proportion counts;
  double estimate = 0.0;
  stats::Interval wilson;
  stats::Interval jeffreys;
  stats::Interval clopper_pearson;
  stats::Interval simultaneous;               ///< Bonferroni-Clopper-Pearson over all modes there can be
  stats::Interval goodman;                    ///< simultaneous over the modes listed
  std::optional<stats::Interval> sison_glaz;  ///< the same; absent where one mode took all but a few
  /// With `until`: covers over all modes at once although the data said when to stop.
  std::optional<stats::Interval> anytime = std::nullopt;
  std::optional<Corrected> corrected = std::nullopt;  ///< where labels were checked
};

struct ModeEstimate {
  section::ResponseMode mode;
  Estimate probability;
};

/// Times in periods after which two runs have parted, over pairs. Pairs that had not parted count as later than any.
struct PartingTimes {
  std::uint64_t pairs = 0;
  std::uint64_t parted = 0;
  std::optional<double> lower_quartile, median, upper_quartile;  ///< absent: more had not parted by the horizon
};

/// How far equal conditions fail to give equal responses.
struct NonRecurrence {
  double differ = 0.0;                        ///< probability that two runs differ in response mode, unbiased
  stats::Interval differ_interval;            ///< Clopper-Pearson on disjoint pairs (1,2), (3,4), ...
  double entropy = 0.0;                       ///< of the modes [nat]
  PartingTimes friction;                      ///< runs (1,2), (3,4), ...: other draws
  PartingTimes arithmetic;                    ///< the same draws at another tolerance
  double arithmetic_tolerance = 0.0;          ///< that tolerance
  stats::Proportion arithmetic_flips;         ///< response modes that differ at that tolerance
  stats::Interval arithmetic_flips_interval;  ///< Clopper-Pearson
};

struct ConditionResult {
  std::uint64_t realisations = 0;
  std::vector<ModeEstimate> modes;              ///< ordered; (1,1), (1,3), chaotic and overturned always there
  std::optional<NonRecurrence> non_recurrence;  ///< absent with fewer than two realisations
  Validity validity;
  Effort effort;
  StoppedBecause stopped_because = StoppedBecause::all_realisations_done;
};

struct ExperimentResult {
  std::vector<ConditionResult> conditions;
  base::Sha256 digest{};  ///< over the realisations' records in order
};

}  // namespace rocking::experiment
