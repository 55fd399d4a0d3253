#include "rocking/stats/lack_of_fit.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/probit.hpp"

namespace rocking::stats {
namespace {

/// A level and the law there. The event happens in a sample where the second random number of the trial is below the
/// limit that belongs to its outcome in the data.
struct NullLevel {
  double u = 0.0;
  double limit_if_happened = 0.0;
  double limit_if_not = 0.0;
  const std::vector<bool>* happened = nullptr;
};

std::vector<NullLevel> null_levels(const std::vector<IntensityLevel>& levels, const LognormalFragility& law) {
  std::vector<NullLevel> null;
  for (const IntensityLevel& level : levels) {
    const Proportion found = proportion_at(level);
    const double share = static_cast<double>(found.successes) / static_cast<double>(found.trials);
    const double probability = law.probability(level.intensity);
    null.push_back({.u = std::log(level.intensity) - law.centre,
                    .limit_if_happened = share > 0.0 ? probability / share : 1.0,
                    .limit_if_not = share < 1.0 ? (probability - share) / (1.0 - share) : 0.0,
                    .happened = &level.happened});
  }
  return null;
}

std::vector<ProbitCounts> counts_of(const std::vector<NullLevel>& null) {
  std::vector<ProbitCounts> counts;
  for (const NullLevel& level : null) {
    const auto happened = static_cast<double>(std::count(level.happened->begin(), level.happened->end(), true));
    counts.push_back(
        {.u = level.u, .happened = happened, .did_not = static_cast<double>(level.happened->size()) - happened});
  }
  return counts;
}

}  // namespace

LackOfFit lack_of_fit(const std::vector<IntensityLevel>& levels, const LognormalFragility& law, std::uint64_t samples,
                      const BootstrapNumbers& numbers, const base::ManyParts& how) {
  ROCKING_EXPECT(!levels.empty());
  const ProbitLine line{.a = law.intercept, .b = law.slope};
  const std::vector<NullLevel> null = null_levels(levels, law);
  const std::vector<ProbitCounts> observed = counts_of(null);
  LackOfFit test{.deviance = probit_deviance(observed, line), .samples = samples};
  // Deviances that are equal in exact arithmetic, such as 0 for two levels, differ by their rounding.
  const double least = test.deviance - 1e-9 * (1.0 + test.deviance);
  const std::size_t trials = trial_numbers(levels);
  std::atomic<std::uint64_t> as_large{0};
  base::for_each_part(how, samples, [&](std::size_t sample) {
    std::vector<ProbitCounts> counts = observed;
    for (ProbitCounts& level : counts) level.happened = level.did_not = 0.0;
    for (std::size_t i = 0; i < trials; ++i) {
      const auto [which, place] = numbers(sample, i);
      const auto drawn = static_cast<std::size_t>(which * static_cast<double>(trials));
      for (std::size_t k = 0; k < null.size(); ++k) {
        if (drawn >= null[k].happened->size()) continue;
        const bool did = (*null[k].happened)[drawn];
        const bool happens = place < (did ? null[k].limit_if_happened : null[k].limit_if_not);
        (happens ? counts[k].happened : counts[k].did_not) += 1.0;
      }
    }
    if (probit_deviance(counts, line) >= least) ++as_large;
  });
  test.as_large = as_large;
  test.p_value = static_cast<double>(test.as_large + 1) / static_cast<double>(samples + 1);
  return test;
}

}  // namespace rocking::stats
