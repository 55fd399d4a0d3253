#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "rocking/experiment/run.hpp"
#include "rocking/experiment/work.hpp"

namespace rocking::experiment {

/// Where pairs come from and where what became of them goes. Both are called from one thread at a time. That there is no
/// next pair holds until one more is accepted.
struct PairFlow {
  std::function<std::optional<Pair>()> next;
  std::function<void(const Pair&, const std::vector<Summary>&)> accept;
};

/// Runs pairs on `options.threads` threads until none is left, it is asked to stop, or something throws; that is passed
/// on when all threads are done. The order in which pairs are accepted is open.
void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow);

}  // namespace rocking::experiment
