#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile.hpp"

namespace rocking {

/// Why a condition has this number of realisations. Reports use the names of the enumerators.
enum class StoppedBecause : std::uint8_t {
  deterministic,          ///< nothing is random: one realisation suffices
  all_realisations_done,  ///< the requested number
  half_width_reached,     ///< all intervals, or that of the requested mode, are as narrow as requested
  at_most_reached,        ///< they are not, but the largest allowed number was reached
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> stop_cause_names{"deterministic", "all_realisations_done",
                                                                  "half_width_reached", "at_most_reached"};
[[nodiscard]] constexpr std::string_view to_string(StoppedBecause cause) {
  return stop_cause_names[static_cast<std::size_t>(cause)];
}

/// Levels of the reported quantiles.
inline constexpr std::array quantile_levels{0.05, 0.16, 0.5, 0.84, 0.95};

/// Quantiles of a number over the realisations of a condition, each with its own interval.
struct Quantiles {
  std::uint64_t realisations = 0;  ///< on which they are based
  std::uint64_t beyond = 0;        ///< of these, the ones that count as above every value
  std::vector<stats::QuantileEstimate> levels;
};

/// Quantiles of PeakValues. A realisation that ended before its horizon, overturned or not, counts as above every peak:
/// what is known of it is a lower bound. The final slip is that of the realisations that reached their horizon.
struct PeakQuantiles {
  Quantiles tilt;
  Quantiles tilt_rate;
  struct Slip {
    Quantiles over_half_diagonal;
    std::vector<stats::QuantileEstimate> metres;  ///< of the same realisations
  };
  std::optional<Slip> slip;        ///< absent without friction
  std::optional<Slip> final_slip;  ///< absent without friction
};

/// Largest Lyapunov exponents of the realisations whose classification needed one [1/period]. The others are periodic by
/// their strobe points, rest or overturned, so that these numbers are about what is left.
struct Exponents {
  double mean = 0.0;
  std::optional<double> standard_error;  ///< of the mean, from the scatter of realisations; absent of one
  double error_of_one = 0.0;             ///< root mean square of the standard errors of the single exponents
  Quantiles quantiles;                   ///< `realisations`: those with an exponent; `beyond`: none
};

struct ConditionResult;

/// Numerical error of the probabilities, compared with their sampling error.
enum class NumericalError : std::uint8_t {
  small,      ///< shown to change no probability by more than a fifth of the half-width of its interval
  not_small,  ///< shown to be able to
  undecided,  ///< too few realisations were rerun to decide
};

inline constexpr std::array<std::string_view, 3> numerical_error_names{"small", "not_small", "undecided"};
[[nodiscard]] constexpr std::string_view to_string(NumericalError noise) {
  return numerical_error_names[static_cast<std::size_t>(noise)];
}

/// Sensitivity to tolerance of all conditions together: realisations that were rerun at a tighter tolerance with common
/// random numbers. If a share f of them changes its response mode, no probability changes by more than f.
struct ToleranceSensitivity {
  stats::Proportion flips;   ///< reruns whose response mode changed
  stats::Interval interval;  ///< Clopper-Pearson interval of the share that changes
  double half_width = 0.0;   ///< half of the widest simultaneous interval of the condition in which this is smallest
  NumericalError noise = NumericalError::undecided;
};

/// Absent if nothing was rerun.
[[nodiscard]] std::optional<ToleranceSensitivity> tolerance_sensitivity(std::span<const ConditionResult> conditions,
                                                                        double confidence);

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
  /// Of these, the ones that reached it before their final fall (dynamics::BlockMotion::losses_before_fall).
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
  std::map<section::Backing, Cases> backed_by;  ///< periodic ones, by what backs the label
  Clamps clamps;                                ///< clamped draws of all realisations

  /// Of so many unresolved realisations those that ended before their horizon without an answer
  /// (Summary::has_no_answer). They may have any response mode.
  [[nodiscard]] std::uint64_t without_answer(std::uint64_t unresolved_realisations) const {
    return std::min(painleve.count + stopped.count, unresolved_realisations);
  }
};

/// Probability of a mode: counts, estimate and intervals. Realisations without an answer count as unresolved, and the
/// intervals cover every mode that they may have.
struct Estimate {
  stats::Proportion counts;
  double estimate = 0.0;
  stats::IntervalsByMethod alone{};  ///< for this mode alone
  stats::Interval simultaneous;      ///< Bonferroni-Clopper-Pearson over all possible modes
  /// With `until`: covers for all modes at once, also if the data determined when to stop.
  std::optional<stats::Interval> anytime = std::nullopt;

  /// The interval to state: the simultaneous one; with `until` the one that is valid whenever the run stops.
  [[nodiscard]] const stats::Interval& quoted() const { return anytime ? *anytime : simultaneous; }
};

struct ModeEstimate {
  section::ResponseMode mode;
  Estimate probability;
};

/// Overturning to one side: a part of the mode `overturned`. Its simultaneous interval holds at once with that of the other
/// side and those of all other modes, since both sides divide the significance of the mode.
struct SideEstimate {
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

/// Number of realisations of a condition, by response mode.
using ModeTally = std::map<section::ResponseMode, std::uint64_t>;

/// When the realisations of a condition with UntilClassified have settled, in whatever mode, and when pairs diverged.
struct ResponseTimes {
  static constexpr std::size_t most_times = 200;
  static constexpr double tolerable_share = 0.01;  ///< of unsettled realisations

  std::vector<stats::Incidence> any_mode;          ///< probability of having settled, thinned to `most_times` times
  std::vector<stats::QuantileEstimate> quartiles;  ///< of the settling period
  stats::TimeToShare nearly_all;                   ///< by which period all but `tolerable_share` have settled
  std::vector<stats::QuantileEstimate> divergence_quartiles;  ///< of the divergence time of pairs
};

/// How often settled responses of one mode were left while they were watched.
struct Leaving {
  std::uint64_t watched_periods = 0;  ///< of all of them, from the end of the last held window until they were left
  std::uint64_t left = 0;
  stats::Interval per_1000_periods;  ///< exact interval of the rate, if it is constant
};

/// Windows of the long runs of a condition.
struct LongRuns {
  std::uint64_t windows = 0;  ///< counted in each of them
  std::uint64_t count = 0;    ///< number of long runs
  struct Share {
    double share = 0.0;  ///< of these windows
    stats::Interval interval;
  };
  std::map<section::ResponseMode, Share> shares;
};

/// Which response, and by when, of the realisations of a condition with UntilClassified.
struct SettlingResult {
  static constexpr std::size_t most_times = 200;

  ModeTally at_horizon;          ///< modes at the fixed horizon
  std::optional<double> differ;  ///< probability that two runs differ there; absent for fewer than two
  std::optional<stats::Interval> differ_interval;  ///< Clopper-Pearson on disjoint pairs; likewise
  std::uint64_t censored = 0;                      ///< realisations that were not classified
  /// By mode, thinned to `most_times` times.
  std::map<section::ResponseMode, std::vector<stats::Incidence>> incidence;
  std::map<section::ResponseMode, Leaving> leaving;  ///< empty unless settled responses are watched
  std::vector<stats::Incidence> divergence;          ///< of pairs, censored at the fixed horizon
  std::optional<LongRuns> long_runs;                 ///< absent unless asked for
  ResponseTimes times;
};

struct ConditionResult {
  std::uint64_t realisations = 0;
  std::vector<ModeEstimate> modes;               ///< in order; (1,1), (1,3), chaotic and overturned are always present
  std::optional<SideEstimate> overturned_left;   ///< absent only in a report of an earlier version
  std::optional<SideEstimate> overturned_right;  ///< likewise
  std::optional<NonRecurrence> non_recurrence;   ///< absent for fewer than two realisations
  PeakQuantiles peaks;
  std::optional<Exponents> exponents = std::nullopt;      ///< absent where no classification needed one
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
  /// Validity::without_answer of these realisations.
  [[nodiscard]] std::uint64_t without_answer() const {
    const Estimate* unresolved = estimate_of({});
    return unresolved == nullptr ? 0 : validity.without_answer(unresolved->counts.successes);
  }
};

struct ExperimentResult {
  std::vector<ConditionResult> conditions;
  base::Sha256 digest{};  ///< over the results of the realisations in order
  std::optional<ToleranceSensitivity> tolerance_sensitivity = std::nullopt;  ///< absent where nothing was rerun
};

}  // namespace rocking
