#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/experiment/cost_curve.hpp"
#include "rocking/experiment/cost_recommendation.hpp"
#include "rocking/experiment/cost_timing.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/half_width_forecast.hpp"

/// What accuracy costs: tolerance against error, flipped response modes and time; realisations against half-width and time.
namespace rocking::experiment {

/// Every decade from 1e-4 to 1e-14, and the tolerance of the experiment's first condition: falling.
[[nodiscard]] std::vector<double> tolerance_ladder(const Experiment& experiment);

/// So many times the realisations that the experiment asks for.
struct PlannedRealisations {
  std::uint64_t factor = 1;
  HalfWidths half_widths;
  std::uint64_t periods = 0;  ///< of all conditions together
};

/// Realisations of each condition for a half-width.
struct HalfWidthGoal {
  double half_width = 0.0;
  RealisationsNeeded needed;
  std::uint64_t periods = 0;  ///< of all conditions together, with `needed.by_shares`
};

/// All that was found.
struct Cost {
  std::uint64_t sample = 0;              ///< realisations measured
  std::uint64_t sampled_conditions = 0;  ///< that they are spread over
  std::vector<ToleranceCost> curve;      ///< by falling tolerance
  std::size_t own = 0;                   ///< place of the experiment's own tolerance in it
  CostTiming timing;                     ///< of the tolerances of the curve
  Yardstick yardstick;
  Recommendation recommendation;
  std::vector<PlannedRealisations> planned;  ///< 1, 4 and 16 times; none where nothing is drawn
  std::vector<HalfWidthGoal> goals;          ///< 0.05, 0.02, 0.01; likewise
};

/// `tolerances` are those of the measurements and hold that of the first condition. All but the timing is a function of the
/// experiment, the tolerances and how many realisations are measured.
[[nodiscard]] Cost cost_of(const Experiment& experiment, std::span<const double> tolerances,
                           std::span<const MeasuredRealisation> measured, CostTiming timing);

}  // namespace rocking::experiment
