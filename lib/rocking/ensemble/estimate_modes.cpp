#include "rocking/ensemble/estimate_modes.hpp"

#include <numeric>

#include "rocking/stats/interval.hpp"

namespace rocking {

stats::CountBounds bounds_of(const section::ResponseMode& mode, const stats::Proportion& counted,
                             std::uint64_t without_answer) {
  if (mode != section::ResponseMode{}) return stats::bounds_of(counted, without_answer);
  return {.least = {.successes = counted.successes - without_answer, .trials = counted.trials}, .most = counted};
}

std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence, std::uint64_t without_answer) {
  std::vector<std::uint64_t> all_counts;
  for (const auto& [mode, count] : listed) all_counts.push_back(count);
  const std::uint64_t trials = std::accumulate(all_counts.begin(), all_counts.end(), std::uint64_t{0});
  const auto of_sison_and_glaz = without_answer == 0 ? stats::sison_glaz(all_counts, confidence) : std::nullopt;
  std::vector<ModeEstimate> modes;
  for (const auto& [mode, count] : listed) {
    const stats::Proportion counts{.successes = count, .trials = trials};
    Estimate estimate;
    estimate.counts = counts;
    estimate.estimate = static_cast<double>(count) / static_cast<double>(trials);
    const auto covering = [bounds = bounds_of(mode, counts, without_answer)](auto&& interval_of) {
      return stats::covering(bounds, interval_of);
    };
    estimate.wilson = covering([&](const stats::Proportion& each) { return stats::wilson(each, confidence); });
    estimate.jeffreys = covering([&](const stats::Proportion& each) { return stats::jeffreys(each, confidence); });
    estimate.clopper_pearson =
        covering([&](const stats::Proportion& each) { return stats::clopper_pearson(each, confidence); });
    estimate.simultaneous = covering(
        [&, &mode = mode](const stats::Proportion& each) { return simultaneous_interval(mode, each, confidence); });
    estimate.goodman =
        covering([&](const stats::Proportion& each) { return stats::goodman(each, confidence, listed.size()); });
    if (of_sison_and_glaz) estimate.sison_glaz = of_sison_and_glaz->at(modes.size());
    modes.push_back({.mode = mode, .probability = estimate});
  }
  return modes;
}

}  // namespace rocking
