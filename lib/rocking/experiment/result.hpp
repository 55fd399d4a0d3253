#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::experiment {

/// What was computed for a realisation, a condition or a run, effect by effect. A scene that has no use for an effect
/// leaves its counters at 0.
struct Effort {
  std::uint64_t steps = 0;             ///< Taylor steps
  std::uint64_t slip_steps = 0;        ///< of them, steps of the slip equations (slide, rock_slide)
  std::uint64_t root_isolations = 0;   ///< guards that the cheap bound did not clear
  std::uint64_t companion_periods = 0; ///< periods run a second time to tell chaos from noise
  std::uint64_t static_friction_draws = 0;
  std::uint64_t kinetic_friction_draws = 0;
  std::uint64_t restitution_draws = 0;
  std::uint64_t amplitude_draws = 0;
  std::uint64_t initial_draws = 0;     ///< phase and initial state
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

/// Where realisations left the model or the classification was unsure. In realisations, but for the clamped draws.
struct Validity {
  std::uint64_t left_ground = 0;         ///< met N <= 0
  std::uint64_t painleve = 0;            ///< ended at D <= 0 or 1 + 3q <= 0
  std::uint64_t stopped = 0;             ///< ended by the event budget or a vanishing step
  std::uint64_t in_transient = 0;        ///< still drifting at the horizon
  std::uint64_t past_balance = 0;        ///< met abs(Theta) = 1
  std::uint64_t clamped = 0;             ///< had a draw clamped
  Clamps clamps;                         ///< draws clamped, all realisations together
};

/// A probability: counts, value, intervals.
struct Estimate {
  stats::Proportion counts;
  double estimate = 0.0;
  stats::Interval wilson;
  stats::Interval clopper_pearson;
  stats::Interval simultaneous;  ///< Bonferroni-Clopper-Pearson over the condition's modes
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
  double differ = 0.0;                       ///< probability that two runs differ in response mode, unbiased
  stats::Interval differ_interval;           ///< Clopper-Pearson on disjoint pairs (1,2), (3,4), ...
  double entropy = 0.0;                      ///< of the modes [nat]
  PartingTimes friction;                     ///< runs (1,2), (3,4), ...: other draws
  PartingTimes arithmetic;                   ///< the same draws at another tolerance
  double arithmetic_tolerance = 0.0;         ///< that tolerance
  stats::Proportion arithmetic_flips;        ///< response modes that differ at that tolerance
};

struct ConditionResult {
  std::uint64_t realisations = 0;
  std::vector<ModeEstimate> modes;  ///< ordered; (1,1), (1,3), chaotic and overturned always there
  std::optional<NonRecurrence> non_recurrence;  ///< absent with fewer than two realisations
  Validity validity;
  Effort effort;
  std::string stopped_because;  ///< `all_realisations_done` or `deterministic`
};

struct ExperimentResult {
  std::vector<ConditionResult> conditions;
  base::Sha256 digest{};  ///< over the realisations' records in order
};

}  // namespace rocking::experiment
