#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/ensemble/stopping.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Quantiles at quantile_levels of some values and of `beyond` others above all of them.
[[nodiscard]] Quantiles quantiles_of(std::vector<double> values, std::uint64_t beyond, double confidence);

/// Collects the peaks of the realisations of a condition: 48 bytes for each.
class PeakTally {
 public:
  void add(const Summary& summary);

  [[nodiscard]] PeakQuantiles quantiles(const Condition& condition) const;

 private:
  std::vector<double> tilt_, tilt_rate_, slip_, slip_m_, final_slip_, final_slip_m_;
  std::uint64_t ended_before_ = 0;  ///< realisations that did not reach the horizon
};

/// Collects the Lyapunov exponents of the realisations of a condition: 16 bytes for each that has one.
class ExponentTally {
 public:
  void add(const Summary& summary);

  /// Absent where no realisation has one.
  [[nodiscard]] std::optional<Exponents> exponents(double confidence) const;

 private:
  std::vector<double> exponents_, errors_;
};

/// Counts in which period pairs of runs diverged.
class DivergenceTally {
 public:
  void add(const std::optional<std::int64_t>& diverged);
  [[nodiscard]] DivergenceTimes times() const;
  /// Number of pairs that diverged, by period.
  [[nodiscard]] const std::map<std::int64_t, std::uint64_t>& by_period() const { return times_; }

 private:
  std::uint64_t pairs_ = 0;
  std::map<std::int64_t, std::uint64_t> times_;  ///< number of pairs that diverged, by period
};

/// Counts, probabilities, non-recurrence and validity of one condition, from its realisations in order. Memory is
/// proportional to the horizon, plus 64 bytes for each realisation, until the condition is complete.
class Reduction {
 public:
  explicit Reduction(const Condition& condition) : condition_(&condition), target_(first_target(condition)) {}

  /// Takes the next realisation. If the condition is complete, it is ignored.
  void add(const Summary& summary);
  [[nodiscard]] std::uint64_t realisations() const { return realisations_; }
  /// Whether all realisations of the condition have been added.
  [[nodiscard]] bool is_complete() const { return target_.is_final && realisations_ == target_.realisations; }

  [[nodiscard]] ConditionResult result() const;
  /// Digest over the digests of the results in order. To be called once.
  [[nodiscard]] base::Sha256 digest() { return digest_.finish(); }

 private:
  void count(const Summary& summary);
  void add_to_validity(const Summary& summary);
  void add_to_pairs(const Summary& summary);
  [[nodiscard]] ModeTally listed_modes() const;
  [[nodiscard]] std::uint64_t without_answer() const;
  [[nodiscard]] NonRecurrence non_recurrence() const;
  [[nodiscard]] std::array<SideEstimate, 2> overturned_sides() const;
  void add_anytime_intervals(std::vector<ModeEstimate>& modes) const;

  const Condition* condition_;
  Target target_;
  std::optional<PeakQuantiles> peak_quantiles_;  ///< of a complete condition
  std::optional<Exponents> found_exponents_;     ///< likewise
  std::uint64_t realisations_ = 0;
  ModeTally modes_;
  SideCounts overturned_{};
  Validity validity_;
  PeakTally peaks_;
  ExponentTally exponents_;
  SettlingTally settling_;
  ResponseTimesTally response_times_;
  OperationCounts operations_;
  base::Sha256Builder digest_;
  Summary first_of_pair_;
  stats::Proportion differing_pairs_;
  DivergenceTally by_friction_;
  stats::Proportion flips_;
  DivergenceTally by_arithmetic_;
};

}  // namespace rocking
