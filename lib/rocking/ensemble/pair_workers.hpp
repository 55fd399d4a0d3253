#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/ensemble/work_list.hpp"

namespace rocking {

/// Source of pairs and destination of their results. Each function is called by one thread at a time. If `next` returns
/// nothing, that holds until another pair is accepted.
struct PairFlow {
  std::function<std::optional<Pair>()> next;
  std::function<void(const Pair&, const std::vector<Summary>&)> accept;
  /// Number of pairs that are known to be needed and not accepted, including those in progress.
  std::function<std::uint64_t()> left;
};

/// Runs pairs of an experiment whose conditions are valid (check_experiment) on `options.threads` threads until there
/// are none left, a stop is requested, or something throws; an exception is rethrown after all threads have ended. No
/// thread takes more than its share of what is left, so that all threads end at about the same time. The order in which
/// pairs are accepted is not specified.
void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow);

}  // namespace rocking
