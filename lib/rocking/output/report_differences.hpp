#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Differences of two reports in `input`, `result` and `internal`, which are the same for equal input, each as `/place
/// is this, not that`; the first ten. `right` is the reference.
[[nodiscard]] std::vector<std::string> report_differences(std::string_view claimed, std::string_view right);

/// Differences of two experiments, likewise.
[[nodiscard]] std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right);

/// A report beside a new run of its experiment.
struct ReportRerun {
  bool was_stopped = false;              ///< then the other fields say nothing
  std::uint64_t checked = 0;             ///< realisations that were run
  std::vector<std::string> differences;  ///< as report_differences
};

/// Runs the experiment of a report, in memory, and compares what the report says with what follows from it.
[[nodiscard]] ReportRerun rerun_report(std::string_view report, const Experiment& experiment,
                                       const RunOptions& options);

}  // namespace rocking
