#pragma once

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/store/summary.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {

/// Plan of a measurement.
struct CostPlan {
  std::vector<double> tolerances;  ///< falling, at least three; the last is the reference
  std::uint64_t sample = 0;        ///< realisations at most
  /// Whether there are enough, including those in progress; called often and on all threads. Empty: `sample` are
  /// enough.
  std::function<bool()> is_enough = {};
};

/// One realisation at one tolerance.
struct ToleranceRun {
  section::ResponseMode mode;
  std::uint64_t periods = 0;  ///< of the excitation that it reached
  std::uint64_t steps = 0;
  std::optional<double> error;  ///< see error_beside; absent for the reference
  bool diverged = false;        ///< from the reference, before the horizon; see divergence_period
};

/// One realisation at all tolerances, with common random numbers.
struct MeasuredRealisation {
  RealisationKey key;
  std::vector<ToleranceRun> runs;  ///< in the order of the tolerances
};

/// Largest difference in Theta, Theta' and V at the ends of the first `cost_error_periods` periods that both runs
/// reached. Absent if they have no period in common, or if the reference did not move.
[[nodiscard]] std::optional<double> error_beside(const RealisationResult& result, const RealisationResult& reference);

/// Runs the first realisations of `CostSample`, each at all tolerances, until there are as many as planned, or enough;
/// at least one. The result depends on the experiment, the tolerances and the number of realisations, not on the
/// threads. Empty if it is asked to stop.
[[nodiscard]] std::vector<MeasuredRealisation> measure_cost(const Experiment& experiment, const CostPlan& plan,
                                                            const RunOptions& options);

/// Realisations with which the cost of an experiment is measured, in an order whose every initial part covers the
/// conditions evenly: rounds of all conditions, each in the order of their reversed bits (0, 1/2, 1/4, 3/4, ... of the
/// way along the grid).
///
/// Each has a different number, so that they use independent random numbers and are independent trials. A condition in
/// which nothing is random takes part in the first round only, because all its realisations are equal.
class CostSample {
 public:
  explicit CostSample(const Experiment& experiment);

  /// Number of realisations; absent: infinite.
  [[nodiscard]] std::optional<std::uint64_t> size() const;

  /// `index` below size().
  [[nodiscard]] RealisationKey at(std::uint64_t index) const;

 private:
  std::vector<std::size_t> all_;     ///< conditions in the order of a round
  std::vector<std::size_t> random_;  ///< those of them in which something is random
};

struct MeasuredRealisation;

/// Forecast of the widths of an experiment's intervals, from the response modes of a sample at the reference tolerance.
/// Each condition has its own confidence. Conditions in which nothing is random do not count, nor do those that the
/// sample did not reach.
class HalfWidthForecast {
 public:
  /// The experiment must outlive it.
  HalfWidthForecast(const Experiment& experiment, std::span<const MeasuredRealisation> measured);
  HalfWidthForecast(Experiment&&, std::span<const MeasuredRealisation>) = delete;

  /// Whether there is anything to forecast.
  [[nodiscard]] bool is_empty() const { return tallies_.empty(); }

  /// With `factor` times the requested realisations in every condition; not empty.
  [[nodiscard]] HalfWidths at(std::uint64_t factor) const;

  /// Mean over the conditions of the intended half-width: that of `until`, otherwise that at the requested number of
  /// realisations. Absent if empty.
  [[nodiscard]] std::optional<double> aim() const;

  /// Of simultaneous intervals, each at the confidence of its condition; `at_most` at the highest of these. Not empty.
  /// At most `most_needed`.
  [[nodiscard]] RealisationsNeeded needed(double half_width) const;
  static constexpr std::uint64_t most_needed = 1'000'000'000;

 private:
  struct SampledCondition {
    const Condition* condition;
    ModeTally modes;
    std::uint64_t trials = 0;
  };

  std::vector<SampledCondition> tallies_;
};

}  // namespace rocking
