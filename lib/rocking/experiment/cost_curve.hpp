#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/experiment/cost_measurement.hpp"
#include "rocking/section/response_mode.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/paired.hpp"

namespace rocking::experiment {

/// A realisation whose response mode a tolerance changes.
struct Flip {
  RealisationKey key;
  section::ResponseMode mode;
  section::ResponseMode reference;  ///< its mode at the tightest tolerance
};

/// How far a tolerance is from the reference, the tightest one, with the same draws.
struct Departure {
  std::uint64_t moving = 0;             ///< realisations of which there is an error
  std::optional<double> median_error;   ///< absent where none moves; of an even number the lower one
  std::optional<double> largest_error;  ///< the same
  std::uint64_t parted = 0;             ///< realisations that parted from the reference before the horizon
  stats::Proportion flips;              ///< response modes that differ
  stats::Interval flips_interval;       ///< Clopper-Pearson
  /// Flips beside those of the floor, the second tightest tolerance: `first_only` flip here alone. What even the two
  /// tightest disagree on, rounding decides. Absent at the floor.
  std::optional<stats::PairedCounts> beside_floor;
  std::optional<stats::Interval> beyond_floor;  ///< exact, of how many more flip here; absent at the floor
  std::vector<Flip> first_flips;                ///< at most `flips_kept`
};
inline constexpr std::size_t flips_kept = 5;

/// What a tolerance costs and does.
struct ToleranceCost {
  double tolerance = 0.0;
  std::uint64_t periods = 0;           ///< of all realisations
  std::uint64_t steps = 0;             ///< the same
  std::optional<Departure> departure;  ///< absent: the reference
};

/// One entry for each tolerance.
[[nodiscard]] std::vector<ToleranceCost> cost_curve(std::span<const double> tolerances,
                                                    std::span<const MeasuredRealisation> measured, double confidence);

}  // namespace rocking::experiment
