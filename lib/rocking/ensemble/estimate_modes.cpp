#include "rocking/ensemble/estimate_modes.hpp"

#include <numeric>

#include "rocking/stats/sison_glaz.hpp"

namespace rocking {

std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence) {
  std::vector<std::uint64_t> all_counts;
  for (const auto& [mode, count] : listed) all_counts.push_back(count);
  const std::uint64_t trials = std::accumulate(all_counts.begin(), all_counts.end(), std::uint64_t{0});
  const auto of_sison_and_glaz = stats::sison_glaz(all_counts, confidence);
  std::vector<ModeEstimate> modes;
  for (const auto& [mode, count] : listed) {
    const stats::Proportion counts{.successes = count, .trials = trials};
    Estimate estimate;
    estimate.counts = counts;
    estimate.estimate = static_cast<double>(count) / static_cast<double>(trials);
    estimate.wilson = stats::wilson(counts, confidence);
    estimate.jeffreys = stats::jeffreys(counts, confidence);
    estimate.clopper_pearson = stats::clopper_pearson(counts, confidence);
    estimate.simultaneous = simultaneous_interval(mode, counts, confidence);
    estimate.goodman = stats::goodman(counts, confidence, listed.size());
    if (of_sison_and_glaz) estimate.sison_glaz = of_sison_and_glaz->at(modes.size());
    modes.push_back({.mode = mode, .probability = estimate});
  }
  return modes;
}

}  // namespace rocking
