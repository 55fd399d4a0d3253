#pragma once

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
};

/// Runs pairs of an experiment whose conditions are valid (check_experiment) on `options.threads` threads until there
/// are none left, a stop is requested, or something throws; an exception is rethrown after all threads have ended. The
/// order in which pairs are accepted is not specified.
void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow);

}  // namespace rocking
