#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/ensemble/peak_quantiles.hpp"
#include "rocking/ensemble/settling.hpp"
#include "rocking/ensemble/stop_cause.hpp"
#include "rocking/ensemble/tolerance_sensitivity.hpp"
#include "rocking/realisation/operation_counts.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/double_sampling.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking {

/// Realisations with some property: their number, and the first ones, for inspection with `rocking trajectory`.
struct Cases {
  static constexpr std::size_t kept = 5;
  std::uint64_t count = 0;
  std::vector<std::uint64_t> first;  ///< realisation numbers, ascending, at most `kept`

  void add(std::uint64_t realisation) {
    ++count;
    if (first.size() < kept) first.push_back(realisation);
  }
};

/// Realisations that left the range of the model or whose classification is uncertain.
struct Validity {
  Cases left_ground;  ///< reached N <= 0
  /// Of these, the ones that reached it before their final fall (Automaton::losses_before_fall).
  Cases left_ground_before_fall;
  Cases painleve;           ///< ended because D <= 0 or 1 + 3q <= 0
  Cases stopped;            ///< ended because the budget of events or steps was exhausted
  Cases in_transient;       ///< not settled at the end of the sampled periods
  Cases settled_late;       ///< classified by the last part of the sampled periods
  double least_held = 1.0;  ///< smallest `held` of the classified realisations
  Cases past_balance;       ///< reached abs(Theta) = 1
  Cases contradictions;     ///< had an instant at which neither sticking nor slipping is consistent; it sticks there
  Cases clamped;            ///< had at least one draw clamped
  std::map<section::Reason, Cases> unresolved;  ///< by the reason why the response is unresolved
  Clamps clamps;                                ///< clamped draws of all realisations
};

/// Corrected probability of a mode: estimated from all realisations and from those that were run for longer.
struct Corrected {
  stats::CheckedCounts counts;
  double estimate = 0.0;
  stats::Interval interval;  ///< covers at least as often as promised, for this mode alone
};

/// Probability of a mode: counts, estimate and intervals.
struct Estimate {
  stats::Proportion counts;
  double estimate = 0.0;
  stats::Interval wilson;
  stats::Interval jeffreys;
  stats::Interval clopper_pearson;
  stats::Interval simultaneous;               ///< Bonferroni-Clopper-Pearson over all possible modes
  stats::Interval goodman;                    ///< simultaneous over the listed modes
  std::optional<stats::Interval> sison_glaz;  ///< as goodman; absent if one mode has nearly all realisations
  /// With `until`: covers for all modes at once, also if the data determined when to stop.
  std::optional<stats::Interval> anytime = std::nullopt;
  std::optional<Corrected> corrected = std::nullopt;  ///< present if labels were checked

  /// The interval to state: the simultaneous one; with `until` the one that is valid whenever the run stops.
  [[nodiscard]] const stats::Interval& quoted() const { return anytime ? *anytime : simultaneous; }
};

struct ModeEstimate {
  section::ResponseMode mode;
  Estimate probability;
};

/// Divergence times in excitation periods over pairs of runs. Pairs that had not diverged by the horizon count as later
/// than all others.
struct DivergenceTimes {
  std::uint64_t pairs = 0;
  std::uint64_t diverged = 0;
  std::optional<double> lower_quartile, median, upper_quartile;  ///< absent: not reached by the horizon
};

/// Non-recurrence: different responses under equal conditions.
struct NonRecurrence {
  double differ = 0.0;                        ///< probability that two runs differ in response mode; unbiased estimate
  stats::Interval differ_interval;            ///< Clopper-Pearson on disjoint pairs (1,2), (3,4), ...
  double entropy = 0.0;                       ///< entropy of the modes [nat]
  DivergenceTimes friction;                   ///< runs (1,2), (3,4), ... with independent random numbers
  DivergenceTimes arithmetic;                 ///< a run and its rerun, with common random numbers
  double arithmetic_tolerance = 0.0;          ///< tolerance of the reruns
  stats::Proportion arithmetic_flips;         ///< reruns whose response mode differs
  stats::Interval arithmetic_flips_interval;  ///< Clopper-Pearson
};

struct ConditionResult {
  std::uint64_t realisations = 0;
  std::vector<ModeEstimate> modes;              ///< in order; (1,1), (1,3), chaotic and overturned are always present
  std::optional<NonRecurrence> non_recurrence;  ///< absent for fewer than two realisations
  PeakQuantiles peaks;
  std::optional<SettlingResult> settling = std::nullopt;  ///< absent at a fixed horizon
  Validity validity;
  OperationCounts operations;
  StoppedBecause stopped_because = StoppedBecause::all_realisations_done;

  /// Otherwise the single realisation is the response, and intervals have no meaning.
  [[nodiscard]] bool is_random() const { return stopped_because != StoppedBecause::deterministic; }
  /// Whether the number of realisations depends on their results (`until`).
  [[nodiscard]] bool is_stopped_by_data() const {
    return std::ranges::any_of(modes, [](const ModeEstimate& each) { return each.probability.anytime.has_value(); });
  }
  /// Of a listed mode; otherwise null.
  [[nodiscard]] const Estimate* estimate_of(const section::ResponseMode& mode) const {
    const auto found = std::ranges::find(modes, mode, &ModeEstimate::mode);
    return found == modes.end() ? nullptr : &found->probability;
  }
};

struct ExperimentResult {
  std::vector<ConditionResult> conditions;
  base::Sha256 digest{};  ///< over the results of the realisations in order
  std::optional<ToleranceSensitivity> tolerance_sensitivity = std::nullopt;  ///< absent where nothing was rerun
};

}  // namespace rocking
