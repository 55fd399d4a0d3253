#include "rocking/ensemble/pair_in_progress.hpp"

#include <algorithm>
#include <utility>

namespace rocking {
namespace {

/// Realisations differ in their random numbers only, so that every N-th one is as good as a random selection.
bool is_rerun(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.rerun_every > 0 && number % condition.rerun_every == 0;
}

}  // namespace

PairInProgress::PairInProgress(const Experiment& experiment, const Pair& pair, std::uint64_t count)
    : pair_(pair), tighter_(experiment.conditions[pair.condition]) {
  const Condition& condition = experiment.conditions[pair.condition];
  tighter_.tolerance = rerun_tolerance(condition.tolerance);
  if (tighter_.horizon.until_classified) tighter_.horizon.until_classified->long_run_every = 0;
  for (std::uint64_t number = pair.first; number < std::min(pair.first + 2, count); ++number) {
    add(Purpose::itself, condition, number);
    if (is_rerun(condition, number)) add(Purpose::rerun, tighter_, number);
  }
}

void PairInProgress::add(Purpose purpose, const Condition& condition, std::uint64_t realisation) {
  runs_.push_back({.condition = &condition, .realisation = realisation});
  purposes_.push_back(purpose);
  results_.emplace_back();
  ++open_;
}

bool PairInProgress::accept(std::size_t run, RealisationResult result) {
  results_[run] = std::move(result);
  return --open_ == 0;
}

std::vector<Summary> PairInProgress::summaries() const {
  std::vector<Summary> summaries;
  std::vector<const RealisationResult*> results;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const RealisationResult& result = *results_[run];
    switch (purposes_[run]) {
      case Purpose::itself:
        results.push_back(&result);
        summaries.push_back(summarise(result, runs_[run].realisation));
        break;
      case Purpose::rerun:
        summaries.back().rerun_mode = result.classification.mode;
        summaries.back().rerun_diverged = divergence_period(*results.back(), result);
        break;
    }
  }
  if (results.size() == 2) summaries[0].diverged_from_next = divergence_period(*results[0], *results[1]);
  return summaries;
}

}  // namespace rocking
