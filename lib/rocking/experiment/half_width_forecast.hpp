#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/experiment/cost_measurement.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/mode_family.hpp"

namespace rocking::experiment {

/// Half-widths of a condition's widest interval at some number of realisations, if modes keep their shares.
struct HalfWidths {
  double mean = 0.0;           ///< over the conditions, of the simultaneous interval
  double widest = 0.0;         ///< of all conditions, of the simultaneous interval
  double widest_wilson = 0.0;  ///< of all conditions, of Wilson's
};

/// How many realisations a condition needs for a half-width.
struct RealisationsNeeded {
  std::uint64_t by_shares = 0;  ///< in the condition with the widest interval, if modes keep their shares
  std::uint64_t at_most = 0;    ///< whatever the shares are
};

/// What intervals of an experiment will be like, from the response modes of a sample of it at its reference tolerance.
/// Conditions in which nothing is drawn have no say, nor have those that the sample did not reach.
class HalfWidthForecast {
 public:
  /// The experiment has to outlive it.
  HalfWidthForecast(const Experiment& experiment, std::span<const MeasuredRealisation> measured);
  HalfWidthForecast(Experiment&&, std::span<const MeasuredRealisation>) = delete;

  /// Whether there is anything to forecast.
  [[nodiscard]] bool is_empty() const { return tallies_.empty(); }

  /// With `factor` times as many realisations in every condition as the experiment asks for; not empty.
  [[nodiscard]] HalfWidths at(std::uint64_t factor) const;

  /// Mean over the conditions of what the experiment is after: the half-width that `until` names, otherwise that at its
  /// number of realisations. Absent where empty.
  [[nodiscard]] std::optional<double> aim() const;

  /// Of simultaneous intervals; not empty. At most `most_needed`.
  [[nodiscard]] RealisationsNeeded needed(double half_width) const;
  static constexpr std::uint64_t most_needed = 1'000'000'000;

 private:
  struct SampledCondition {
    const Condition* condition;
    ModeTally modes;
    std::uint64_t trials = 0;
  };

  std::vector<SampledCondition> tallies_;
  double confidence_ = 0.95;
};

}  // namespace rocking::experiment
