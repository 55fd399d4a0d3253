#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {

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
