#pragma once

#include <atomic>
#include <cstdint>
#include <stdexcept>

#include "rocking/api/question_check.hpp"
#include "rocking/api/run.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// What an execution asks for, as options of a run. Must outlive the run, which looks at its flag. Throws base::InputError
/// for a number out of range.
class OptionsOfExecution {
 public:
  explicit OptionsOfExecution(const Execution& execution)
      : stop_(execution.stop != nullptr ? execution.stop : &own_flag_) {
    check_fields(execution);
    options_.threads = execution.threads;
    options_.stop_requested = stop_;
    if (!execution.on_progress) return;
    options_.on_progress = [stop = stop_, &execution](std::uint64_t done, std::uint64_t all) {
      if (execution.on_progress(done, all) == Decision::stop) *stop = true;
    };
  }
  OptionsOfExecution(const OptionsOfExecution&) = delete;
  OptionsOfExecution& operator=(const OptionsOfExecution&) = delete;

  [[nodiscard]] const RunOptions& options() const { return options_; }
  [[nodiscard]] base::StopRequest stop() const { return stop_; }

 private:
  std::atomic<bool> own_flag_{false};
  std::atomic<bool>* stop_;
  RunOptions options_;
};

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
[[nodiscard]] StoredRun stored_run(Store store, unsigned threads = 1);

}  // namespace rocking
