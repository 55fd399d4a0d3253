#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking {

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

}  // namespace rocking
