#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"

namespace rocking::experiment {

/// How to work through an experiment. Nothing here changes a result.
struct RunOptions {
  unsigned threads = 1;
  /// Called now and then, from one thread at a time, with the realisations done so far of all.
  std::function<void(std::uint64_t done, std::uint64_t all)> on_progress;
  /// Set from outside (a signal handler, a clock) to stop between realisations.
  const std::atomic<bool>* stop_requested = nullptr;
};

/// Runs every realisation of every condition and reduces them in their order, whatever order they were computed in.
/// Absent if it was asked to stop before the end.
[[nodiscard]] std::optional<ExperimentResult> run(const Experiment& experiment, const RunOptions& options);

/// How many realisations a condition will really run: one, where nothing is drawn at random.
[[nodiscard]] std::uint64_t effective_realisations(const Condition& condition);

}  // namespace rocking::experiment
