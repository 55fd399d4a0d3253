#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/mode_family.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/experiment/stopping.hpp"
#include "rocking/experiment/summary.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::experiment {

/// Collects when pairs of runs parted.
class PartingTally {
 public:
  void add(const std::optional<std::int64_t>& parted);
  [[nodiscard]] PartingTimes times() const;

 private:
  std::uint64_t pairs_ = 0;
  std::map<std::int64_t, std::uint64_t> times_;  ///< pairs that parted in each period
};

/// Counts, probabilities, non-recurrence and validity of one condition, from its realisations in their order. Its memory
/// grows with the horizon, not with the number of realisations.
class Reduction {
 public:
  explicit Reduction(const Condition& condition) : condition_(&condition), target_(first_target(condition)) {}

  /// Takes the next realisation. One that comes when it is complete is left out.
  void add(const Summary& summary);
  [[nodiscard]] std::uint64_t realisations() const { return realisations_; }
  /// Whether these are all realisations that the condition is to have.
  [[nodiscard]] bool is_complete() const { return target_.is_final && realisations_ == target_.realisations; }

  [[nodiscard]] ConditionResult result() const;
  /// Digest over the digests of the records in their order. Once only.
  [[nodiscard]] base::Sha256 digest() { return digest_.finish(); }

 private:
  void add_to_validity(const Summary& summary);
  void add_to_pairs(const Summary& summary);
  [[nodiscard]] ModeTally listed_modes() const;
  [[nodiscard]] NonRecurrence non_recurrence() const;
  void add_corrected(std::vector<ModeEstimate>& modes) const;
  void add_anytime_intervals(std::vector<ModeEstimate>& modes) const;

  const Condition* condition_;
  Target target_;
  std::uint64_t realisations_ = 0;
  ModeTally modes_;
  Validity validity_;
  Effort effort_;
  base::Sha256Builder digest_;
  Summary first_of_pair_;
  stats::Proportion differing_pairs_;
  PartingTally by_friction_;
  stats::Proportion flips_;
  PartingTally by_arithmetic_;
  std::map<std::pair<section::ResponseMode, section::ResponseMode>, std::uint64_t>
      checked_;  ///< by mode, and long mode
};

}  // namespace rocking::experiment
