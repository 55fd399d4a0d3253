#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/rare/estimate.hpp"

/// Probabilities of rare overturning, by multilevel splitting (lib/docs/rare.md).
namespace rocking {

struct RareSettings {
  std::size_t particles = 500;  ///< of a repetition; 20 to 100000
  rare::Score score = rare::Score::tilt;
  unsigned threads = 1;
  base::StopRequest stop = {};
  /// Asked before each repetition that is not yet needed for an interval. Empty: never.
  std::function<bool(std::size_t condition)> time_is_up = {};
  /// Called by one thread at a time with the number of finished repetitions and that of those planned so far.
  std::function<void(std::size_t condition, std::size_t done, std::size_t planned)> on_progress = {};
};

/// Throws base::InputError if a condition is not valid or nothing in it is random.
void check_rare(const Experiment& experiment);

/// The estimates for all conditions, in their order. Without a time limit they depend on the experiment, the question
/// and the number of particles alone. Throws as check_rare, and base::Stopped if it is asked to stop.
[[nodiscard]] std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                                           const RareSettings& settings);

}  // namespace rocking
