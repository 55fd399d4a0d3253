#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "rocking/ensemble/run.hpp"

namespace rocking {

/// Progress by condition as progress of all. A condition that has not told how much it expects is expected to take as
/// much as the mean of those before it; likewise those to come.
class TotalProgress {
 public:
  TotalProgress(const RunOptions& options, std::size_t conditions) : options_(&options), conditions_(conditions) {}

  void tell(std::size_t condition, double done, double expected) {
    if (condition != condition_) earlier_ += last_;
    condition_ = condition;
    last_ = done;
    if (!options_->on_progress) return;
    double begun = earlier_ + expected;
    if (expected == 0.0 && condition > 0) {
      begun = earlier_ + std::max(done, earlier_ / static_cast<double>(condition));
    }
    const double all = begun * static_cast<double>(conditions_) / static_cast<double>(condition + 1);
    const auto whole = static_cast<std::uint64_t>(earlier_ + done);
    options_->on_progress(whole, all > 0.0 ? std::max(whole, static_cast<std::uint64_t>(all)) : 0);
  }

 private:
  const RunOptions* options_;
  std::size_t conditions_;
  std::size_t condition_ = 0;
  double last_ = 0.0;
  double earlier_ = 0.0;
};

}  // namespace rocking
