#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {

struct RunOptions;

/// Realisations that a measurement of cost keeps at most: some hundred bytes each per tolerance until all are measured.
inline constexpr std::uint64_t largest_cost_sample = 100'000;

/// How much is measured.
struct CostBudget {
  /// Wall-clock time to spend [s]. With `sample`, for measuring the speed alone, which takes at most a few seconds or a
  /// third of the time of the sample.
  double seconds = 60.0;
  /// Realisations to measure, at most `largest_cost_sample`: gives the same numbers again, except times. Absent: as many
  /// as the time allows.
  std::optional<std::uint64_t> sample = {};
};

/// The clocks of whoever asks for a measurement: the library reads none itself.
struct CostClocks {
  std::function<double()> elapsed_seconds;  ///< wall-clock time since the measurement began [s]; called on all threads
  std::function<double()> processor_seconds;  ///< processor time of the calling thread [s]
};

/// `asked` and those of all conditions, falling; the usual ones (tolerance_ladder) if none are asked for. A measurement
/// needs at least three: the last is the reference, the one before it the floor.
[[nodiscard]] std::vector<double> cost_tolerances(const Experiment& experiment, std::span<const double> asked);

/// Measures the cost of accuracy at the given tolerances (see cost_tolerances), first on a sample, then the speed.
/// Absent if it was asked to stop. `options.on_progress` counts the realisations of the sample and those that
/// it will reach in its time.
[[nodiscard]] std::optional<Cost> cost_within(const Experiment& experiment, std::span<const double> tolerances,
                                              const CostBudget& budget, const CostClocks& clocks,
                                              const RunOptions& options);

}  // namespace rocking
