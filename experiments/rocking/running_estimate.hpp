#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking::program {

/// Estimate for the current condition of a run in progress, for display only: it counts the realisations of this
/// session, in the order in which threads finish.
class RunningEstimate {
 public:
  explicit RunningEstimate(const Experiment& experiment) : experiment_(&experiment) {}

  void add(std::size_t condition, const std::vector<Summary>& summaries);

  /// The condition of the last add(), its most frequent response and Wilson's 95 % interval: `amplitude 4.2: (1,3) 69 %
  /// [60, 77] of 100`. Empty before the first add().
  [[nodiscard]] std::string text() const;

 private:
  const Experiment* experiment_;
  std::size_t condition_ = 0;  ///< of the last add()
  std::map<std::size_t, std::map<section::ResponseMode, std::uint64_t>> counts_;
};

}  // namespace rocking::program
