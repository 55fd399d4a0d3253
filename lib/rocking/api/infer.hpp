#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/experiment.hpp"
#include "rocking/api/run.hpp"
#include "rocking/scene/counted_tests.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/infer/inference.hpp"

/// From counted tests back to the numbers that explain them.
namespace rocking {

/// Counted tests of an experiment's block, and how its unknowns are inferred from them.
struct InferRequest {
  CountedTests tests;
  std::uint64_t next_tests = 5;        ///< tests of a candidate condition; 1 to 1000
  std::filesystem::path folder = ".";  ///< from which the files of the experiment are seen
  /// Time [s] on the clock of `elapsed_seconds`, after which no points are added. Absent: no limit.
  std::optional<double> seconds = {};
  std::function<double()> elapsed_seconds = {};
  std::vector<infer::DesignPoint> earlier = {};  ///< of an earlier answer to the same question; not simulated again
  /// When it is asked to stop, it returns the finished points without an answer. Else it throws.
  bool keeps_when_stopped = false;
  /// Called with the design so far when some of its points have been simulated.
  std::function<void(const std::vector<infer::DesignPoint>& design)> keep = {};
};

/// Reads a file of counted tests and one of candidate conditions (lib/docs/formats.md). Files of the experiment are
/// seen from `folder`. Throws base::InputError with the line of each fault, and std::system_error where a file cannot
/// be read.
[[nodiscard]] ROCKING_API CountedTests counted_tests(const Experiment& experiment, const std::filesystem::path& tests,
                                                     const std::optional<std::filesystem::path>& candidates = {},
                                                     const std::filesystem::path& folder = ".");

/// Throws base::InputError if the experiment has no text, no unknowns, no fixed number of realisations, a suite, or a prior
/// without weight in the range of its unknown.
ROCKING_API void check_infer(const Experiment& experiment);

/// Throws as check_infer, and base::InputError with every number of the request that is out of range, every list of
/// another length, and every parameter that is not in the experiment.
ROCKING_API void check_request(const Experiment& experiment, const InferRequest& request);

/// Estimates the unknowns of an experiment from counted tests, with intervals and a joint region. Uses `threads`,
/// `on_progress` and `stop` of the execution; progress counts realisations, whose number grows until the intervals
/// settle, and the data sets that are made up for the answer. Throws as check_request, and base::Stopped if it is asked to stop.
/// Source: lib/docs/infer.md.
[[nodiscard]] ROCKING_API Inference infer_unknowns(const Experiment& experiment, const InferRequest& request,
                                                   const Execution& execution = {});

/// The same as JSON text (`rocking.infer/1`).
[[nodiscard]] ROCKING_API std::string infer_unknowns_text(const Experiment& experiment, const InferRequest& request,
                                                          const Inference& found);

}  // namespace rocking
