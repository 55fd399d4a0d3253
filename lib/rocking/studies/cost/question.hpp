#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/api/run.hpp"
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

/// Processor time of realisations that run together in lanes, as in a run: with classification, without storage, reruns
/// and checks of labels.
struct CostTiming {
  std::vector<double> seconds_per_period;  ///< processor time, by tolerance [s]; 0 where no period was reached
  std::uint64_t realisations = 0;          ///< per round and thread
  int periods = 0;                         ///< of the longest horizon of a round
};

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

/// How the cost of an experiment's accuracy is measured.
struct CostQuestion {
  /// Wall-clock time to spend [s]. With `sample`, for measuring the speed alone.
  double seconds = 60.0;
  /// Realisations to measure, from 1 to 100000: gives the same numbers again, except times. Absent: as many as the time
  /// allows.
  std::optional<std::uint64_t> sample = {};
  /// From 1e-16 to 1e-2; the experiment's own are added, and together they are at least three. Empty: 1e-4, 1e-5, ...,
  /// 1e-14.
  std::vector<double> tolerances = {};
};

/// Runs a sample of the realisations at several tolerances with common random numbers: error, changed response modes
/// and processor time by tolerance, half-widths and time by number of realisations, and a recommended tolerance. Uses
/// `threads`, `on_progress`, `stop` and both clocks of the execution; progress counts realisations of the sample. Throws
/// base::InputError for a number out of range or too few tolerances, std::invalid_argument without clocks, and
/// base::Stopped if it is asked to stop.
[[nodiscard]] ROCKING_API Cost cost(const Experiment& experiment, const CostQuestion& question,
                                    const Execution& execution);

}  // namespace rocking
