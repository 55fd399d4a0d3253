#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/summary.hpp"

namespace rocking::program {

/// What a run says of the condition that it is at, while it runs. For a look, never for a record: it knows the realisations
/// of this session only, and they come in the order in which threads finish.
class RunningEstimate {
 public:
  explicit RunningEstimate(const experiment::Experiment& experiment) : experiment_(&experiment) {}

  void add(std::size_t condition, const std::vector<experiment::Summary>& summaries);

  /// The condition that was last added to, its most frequent response and Wilson's 95 % interval: `amplitude 4.2: (1,3) 69 %
  /// [60, 77] of 100`. Empty before anything was added.
  [[nodiscard]] std::string text() const;

 private:
  const experiment::Experiment* experiment_;
  std::size_t condition_ = 0;  ///< that was last added to
  std::map<std::size_t, std::map<section::ResponseMode, std::uint64_t>> counts_;
};

}  // namespace rocking::program
