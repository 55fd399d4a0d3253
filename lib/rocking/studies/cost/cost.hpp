#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/cost/curve.hpp"
#include "rocking/studies/cost/half_widths.hpp"
#include "rocking/studies/cost/recommendation.hpp"
#include "rocking/studies/cost/timing.hpp"

/// Cost of accuracy: error, changed response modes and time by tolerance; half-width and time by number of
/// realisations.
namespace rocking {

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
