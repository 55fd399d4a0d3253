#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/ensemble/work_list.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// A pair of realisations in progress: the runs that it needs and the parts of their results that are kept. A pure
/// function of its arguments, whatever the order in which the runs end. Its runs point into it, so that it cannot be
/// moved.
class PairInProgress {
 public:
  /// `count`: number of realisations of the condition. The last pair of an odd number has one realisation only.
  PairInProgress(const Experiment& experiment, const Pair& pair, std::uint64_t count);
  PairInProgress(const PairInProgress&) = delete;
  PairInProgress& operator=(const PairInProgress&) = delete;

  [[nodiscard]] const Pair& pair() const { return pair_; }
  [[nodiscard]] std::span<const RequestedRun> runs() const { return runs_; }

  /// Takes the result of a run; true if it was the last one.
  bool accept(std::size_t run, RealisationResult result);

  /// Summaries of the realisations in order, after all results have been accepted.
  [[nodiscard]] std::vector<Summary> summaries() const;

 private:
  enum class Purpose : std::uint8_t { itself, rerun };

  void add(Purpose purpose, const Condition& condition, std::uint64_t realisation);

  Pair pair_;
  Condition tighter_;  ///< for reruns
  std::vector<RequestedRun> runs_;
  std::vector<Purpose> purposes_;
  std::vector<std::optional<RealisationResult>> results_;  ///< by run
  std::size_t open_ = 0;
};

}  // namespace rocking
