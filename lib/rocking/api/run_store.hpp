#pragma once

#include <stdexcept>

#include "rocking/api/run.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// The realisations of a run. Throws std::invalid_argument if it has none: a RunResult that no call has returned.
[[nodiscard]] inline const Store& store_of(const RunResult& run) {
  if (!run.store) throw std::invalid_argument("the run has no realisations: run() or open_run() has not returned it");
  return *run.store;
}

/// The result of a complete run. Throws std::invalid_argument if it is not complete.
[[nodiscard]] inline const ExperimentResult& complete_result(const RunResult& run) {
  if (!run.result) throw std::invalid_argument("the run is not complete: it was stopped before its end");
  return *run.result;
}

/// The same of a run of this experiment.
[[nodiscard]] inline const ExperimentResult& complete_result(const Experiment& experiment, const RunResult& run) {
  const ExperimentResult& result = complete_result(run);
  if (result.conditions.size() == experiment.conditions.size()) return result;
  throw std::invalid_argument("the run is of another experiment: it has another number of conditions");
}

/// The run of a store, with its result if it is complete.
[[nodiscard]] StoredRun stored_run(Store store);

}  // namespace rocking
