#pragma once

#include "rocking/base/stop_request.hpp"
#include "rocking/studies/rare/question.hpp"

/// Probabilities of rare overturning, by particle runs or importance sampling (lib/docs/rare.md).
namespace rocking {

/// Called by one thread at a time after each repetition; `so_far` gives what would be returned if the study had been asked to
/// stop after it.
using KeepRare = std::function<void(const std::function<std::vector<RareEstimate>()>& so_far)>;

/// How estimates are computed.
struct RareSettings {
  unsigned threads = 1;
  base::StopRequest stop = {};
  /// Called by one thread at a time with the simulated time of a condition so far, pilot runs with it, and the time that
  /// is expected in all, in realisations to the horizon; 0: not known yet.
  std::function<void(std::size_t condition, double done, double expected)> on_progress = {};
  std::function<double()> elapsed_seconds = {};  ///< clock of a question with a time
  KeepRare keep = {};
};

/// Throws base::InputError if a condition is not valid or nothing in it is random.
void check_rare(const Experiment& experiment);

/// The estimates for all conditions, in their order. Without a time limit they depend on the experiment, the question
/// and the number of particles alone. With one, a condition gets its share of the time, but at least 8 repetitions;
/// what is not finished at the end of the time, or when it is asked to stop, is left out. Throws as check_rare.
[[nodiscard]] std::vector<RareEstimate> rare_estimates(const Experiment& experiment, const RareQuestion& question,
                                                       const RareSettings& settings);

/// An earlier study, of which a part is made again.
struct RareRerun {
  std::vector<RareEstimate> estimates;  ///< of the conditions; equal to the earlier ones if nothing has changed
  std::size_t repetitions = 0;          ///< that were made again
};

/// What follows from the repetitions of an earlier study, `question.earlier`, with the same experiment, question and
/// particles, of which about `sample` are made again, the same number in each condition, evenly spaced. The pilot runs are
/// made again, too. A condition without finished repetitions stays as it is. Throws as check_rare, and base::Stopped.
[[nodiscard]] RareRerun rare_estimates_again(const Experiment& experiment, const RareQuestion& question,
                                             const RareSettings& settings, std::size_t sample);

}  // namespace rocking
