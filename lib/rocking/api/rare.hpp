#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/studies/rare/estimate.hpp"

/// Probabilities of rare overturning.
namespace rocking {

/// What is asked of each condition, and with how much work.
struct RareRequest {
  RareQuestion question = {};
  std::size_t particles = 500;            ///< trajectories of a repetition at each level; 20 to 100000
  rare::Score score = rare::Score::tilt;  ///< what measures how near a motion is to the event
  /// Time for all conditions together [s], on the clock of `elapsed_seconds`, which several threads call. What is not
  /// finished then is left out. Absent: no limit, so that the same is estimated again.
  std::optional<double> seconds = {};
  std::function<double()> elapsed_seconds = {};
};

/// Throws base::InputError if nothing in a condition is random or a number is out of range.
ROCKING_API void check_request(const Experiment& experiment, const RareRequest& request);

/// Estimates the probability of overturning, or of a large tilt, by multilevel splitting: one entry for each condition.
/// Uses `threads`, `on_progress` and `stop` of the execution; progress counts repetitions, and their number grows while
/// the precision is not reached. Throws as check_request, and base::Stopped if it is asked to stop. Source: lib/docs/rare.md.
[[nodiscard]] ROCKING_API std::vector<RareEstimate> rare_probabilities(const Experiment& experiment,
                                                                       const RareRequest& request,
                                                                       const Execution& execution = {});

/// The same as JSON text (`rocking.rare/1`).
[[nodiscard]] ROCKING_API std::string rare_text(const Experiment& experiment, const RareRequest& request,
                                                const std::vector<RareEstimate>& found);

}  // namespace rocking
