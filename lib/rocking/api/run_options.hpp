#pragma once

#include <atomic>
#include <cstdint>

#include "rocking/api/question_check.hpp"
#include "rocking/api/run.hpp"
#include "rocking/ensemble/run.hpp"

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

}  // namespace rocking
