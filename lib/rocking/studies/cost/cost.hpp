#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"
#include "rocking/store/realisation_key.hpp"

/// Cost of accuracy: error, changed response modes and time by tolerance; half-width and time by number of
/// realisations.
namespace rocking {

/// Half-widths of a condition's widest interval at some number of realisations, if modes keep their shares.
struct HalfWidths {
  double mean = 0.0;           ///< over the conditions, of the simultaneous interval
  double widest = 0.0;         ///< of all conditions, of the simultaneous interval
  double widest_wilson = 0.0;  ///< of all conditions, of Wilson's
};

/// Number of realisations that a condition needs for a half-width.
struct RealisationsNeeded {
  std::uint64_t by_shares = 0;  ///< in the condition with the widest interval, if modes keep their shares
  std::uint64_t at_most = 0;    ///< for any shares
};

struct MeasuredRealisation;

/// Excitation periods from the start over which the error of a motion is measured. Later, motions diverge
/// exponentially, and a difference does not depend on the accuracy of the steps.
inline constexpr std::int64_t cost_error_periods = 10;

/// A realisation whose response mode a tolerance changes.
struct Flip {
  RealisationKey key;
  section::ResponseMode mode;
  section::ResponseMode reference;  ///< its mode at the tightest tolerance
};

/// Differences between a tolerance and the tightest one, the reference, with common random numbers.
struct Departure {
  std::uint64_t moving = 0;             ///< realisations that have an error
  std::optional<double> median_error;   ///< absent if none moves; of two middle values the lower one
  std::optional<double> largest_error;  ///< the same
  std::uint64_t diverged = 0;           ///< realisations that diverged from the reference before the horizon
  stats::Proportion flips;              ///< response modes that differ
  stats::Interval flips_interval;       ///< Clopper-Pearson
  /// Flips here and at the floor, the second tightest tolerance: `first_only` flip only here. Flips at the floor are
  /// attributed to rounding. Absent at the floor.
  std::optional<stats::PairedCounts> beside_tolerance_sensitivity;
  std::optional<stats::Interval>
      beyond_floor;               ///< exact, of the excess over the flips at the floor; absent at the floor
  std::vector<Flip> first_flips;  ///< at most `flips_kept`
};
inline constexpr std::size_t flips_kept = 5;

/// Cost and effect of a tolerance.
struct ToleranceCost {
  double tolerance = 0.0;
  std::uint64_t periods = 0;           ///< of all realisations
  std::uint64_t steps = 0;             ///< the same
  std::optional<Departure> departure;  ///< absent: the reference

  /// 0 where no period was reached.
  [[nodiscard]] double steps_per_period() const;
};

/// One entry for each tolerance.
[[nodiscard]] std::vector<ToleranceCost> cost_curve(std::span<const double> tolerances,
                                                    std::span<const MeasuredRealisation> measured, double confidence);

/// Evidence that a tolerance is sufficient.
enum class Assurance : std::uint8_t {
  shown,           ///< so few response modes flip that it does not matter, at the confidence of the intervals
  not_told_apart,  ///< no more flip than at the floor; the sample is too small to show more
  none,            ///< neither holds for any tolerance
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> assurance_names{"shown", "not_told_apart", "none"};
[[nodiscard]] constexpr std::string_view to_string(Assurance assurance) {
  return assurance_names[static_cast<std::size_t>(assurance)];
}

/// What a share of flipped modes is compared with.
struct Yardstick {
  std::optional<double> half_width;  ///< that the experiment's intervals will have; absent if nothing is random
  bool is_everything = false;        ///< the sample is the entire experiment, so that shares are exact
};

/// Largest share of flips relative to the half-width. As bias it reduces the coverage of a 95 % interval to 94.9 %.
inline constexpr double bearable_share = 0.05;
/// Largest median error: a hundredth of the distance at which two runs count as diverged.
inline constexpr double bearable_error = 1e-4;

/// A tighter tolerance is recommended if it takes at most this many times the steps.
inline constexpr double cheap_steps = 1.1;

struct Recommendation {
  Assurance assurance = Assurance::none;
  std::optional<std::size_t> place;     ///< of the tolerance in the curve; absent with `none`
  std::optional<std::size_t> coarsest;  ///< of the coarsest that suffices; likewise
  double bearable = 0.0;                ///< share of flipped modes that is too small to matter
  double at_most = 0.0;  ///< upper bound of the share caused by the tolerance, at `place`; see share_at_most
  /// Realisations that would show it if the share of flips at the tolerance (with `none` at the floor) stays the same;
  /// absent if it is shown already, or if no number would, because that share is too large.
  std::optional<std::uint64_t> sample_needed;
};

/// Upper bound of the share of response modes that a tolerance changes: of all that flip or, if that is less, of the
/// excess over the flips at the floor. If the sample is the entire experiment, the share itself.
[[nodiscard]] double share_at_most(const Departure& departure, const Yardstick& yardstick);

/// A tolerance is shown to suffice if for it and for every tighter one the median error is at most `bearable_error` and
/// share_at_most is at most `bearable_share` of the half-width (0 if the sample is the entire experiment). If none is
/// shown to suffice, it is sufficient that for it and for every tighter one the median error is at most
/// `bearable_error`, no more modes flip than at the floor, and share_at_most is at most the half-width. Among the
/// coarsest sufficient tolerance and the tighter ones that pass and take at most `cheap_steps` times its steps, the
/// tightest is recommended.
///
/// `curve` is sorted by falling tolerance and has at least three entries; `confidence` is that of its intervals.
[[nodiscard]] Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick,
                                       double confidence);

struct RunOptions;

/// Processor time of realisations that run together in lanes, as in a run: with classification, without storage, reruns
/// and checks of labels.
struct CostTiming {
  std::vector<double> seconds_per_period;  ///< processor time, by tolerance [s]; 0 where no period was reached
  std::uint64_t realisations = 0;          ///< per round and thread
  int periods = 0;                         ///< of the longest horizon of a round
};

/// Clocks of a measurement.
struct TimingPlan {
  std::function<double()> processor_seconds;  ///< used by the calling thread so far [s]
  std::function<double()> seconds_left;       ///< wall-clock time left [s]; the first round may take longer
};

/// Measures rounds of realisations of `CostSample` on each thread, each round at all tolerances one after the other.
/// The first rounds have shortened horizons of a few periods, and as many realisations as fill the lanes, if a thread
/// of the run has as many. Rounds grow as long as there is time for some of the next size, first to full horizons. The
/// result is the median over the rounds of the last size. If it is asked to stop, the times are meaningless.
[[nodiscard]] CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances,
                                   const TimingPlan& plan, const RunOptions& options);

/// The tolerances of all conditions, each once: falling. Several if a sweep varies it.
[[nodiscard]] std::vector<double> own_tolerances(const Experiment& experiment);

/// Every decade from 1e-4 to 1e-14, and the experiment's own tolerances: falling.
[[nodiscard]] std::vector<double> tolerance_ladder(const Experiment& experiment);

/// Forecast for `factor` times the requested realisations.
struct PlannedRealisations {
  std::uint64_t factor = 1;
  HalfWidths half_widths;
  std::uint64_t periods = 0;  ///< of all conditions together
  double seconds = 0.0;       ///< processor time for these, each condition at its own tolerance
};

/// Realisations per condition that a half-width needs.
struct HalfWidthGoal {
  double half_width = 0.0;
  RealisationsNeeded needed;
  std::uint64_t periods = 0;  ///< of all conditions together, with `needed.by_shares`
  double seconds = 0.0;       ///< processor time for these, each condition at its own tolerance
};

/// Results of a measurement of cost.
struct Cost {
  std::uint64_t sample = 0;              ///< realisations measured
  std::uint64_t sampled_conditions = 0;  ///< conditions to which these belong
  double confidence = 0.95;              ///< of the intervals of the curve: the highest of all conditions
  std::vector<ToleranceCost> curve;      ///< by falling tolerance
  std::vector<std::size_t> own;          ///< places of the experiment's own tolerances in it, ascending; at least one
  CostTiming timing;                     ///< of the tolerances of the curve
  Yardstick yardstick;
  Recommendation recommendation;
  std::vector<PlannedRealisations> planned;  ///< 1, 4 and 16 times; none if nothing is random
  std::vector<HalfWidthGoal> goals;          ///< 0.05, 0.02, 0.01; likewise

  /// Processor time per period at a place of the curve [s].
  [[nodiscard]] double seconds_per_period(std::size_t place) const { return timing.seconds_per_period[place]; }
  /// Whether the experiment has the tolerance at a place of the curve.
  [[nodiscard]] bool is_own(std::size_t place) const;
  /// Speed relative to the experiment's own tolerance, the tightest if there are several; 1 where the clock was too
  /// coarse to measure it.
  [[nodiscard]] double speed(std::size_t place) const;
  /// The second tightest tolerance: changes at a coarser one count only beyond those at this one.
  [[nodiscard]] const ToleranceCost& floor() const { return curve[curve.size() - 2]; }
};

/// `tolerances` are those of the measurements and include those of all conditions. All but the timing is a function
/// of the experiment, the tolerances and how many realisations are measured.
[[nodiscard]] Cost cost_of(const Experiment& experiment, std::span<const double> tolerances,
                           std::span<const MeasuredRealisation> measured, CostTiming timing);

}  // namespace rocking
