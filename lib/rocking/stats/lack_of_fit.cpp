#include "rocking/stats/lack_of_fit.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
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

/// p ln(p/q), 0 for p = 0.
double information(double p, double log_q) { return p > 0.0 ? p * (std::log(p) - log_q) : 0.0; }

/// The number of events in independent trials whose distribution function first reaches `place`, in [0, 1).
std::uint64_t binomial_quantile(std::uint64_t trials, double probability, double place) {
  if (!(probability > 0.0)) return 0;
  if (!(probability < 1.0)) return trials;
  // The sum of the probabilities of 0, 1, ... events, unless the first one is too small for it.
  double share = std::exp(static_cast<double>(trials) * std::log1p(-probability));
  if (share > 1e-280) {
    std::uint64_t events = 0;
    double sum = share;
    for (; sum < place && events < trials; sum += share) {
      share *=
          static_cast<double>(trials - events) / static_cast<double>(events + 1) * (probability / (1.0 - probability));
      ++events;
    }
    return events;
  }
  namespace policies = boost::math::policies;
  using Upwards = policies::policy<policies::discrete_quantile<policies::integer_round_up>>;
  const boost::math::binomial_distribution<double, Upwards> law(static_cast<double>(trials), probability);
  return static_cast<std::uint64_t>(quantile(law, place));
}

/// The suite with outcomes by the law.
SuiteLevels drawn(const SuiteLevels& suite, const SuiteLaw& law, const RecordDraws& draws, std::uint64_t sample) {
  const boost::math::normal_distribution<double> normal;
  SuiteLevels made = suite;
  std::uint64_t number = 0;
  for (auto& record : made) {
    const double place = std::max(draws(sample, number++), 1e-300);
    const double capacity = std::log(law.median) + law.between_records * quantile(normal, place);
    for (RecordLevel& level : record) {
      const double beyond = std::log(level.intensity) - capacity;
      const double certain = beyond > 0.0 ? 1.0 : 0.0;
      const double probability = law.within_record > 0.0 ? normal_cdf(beyond / law.within_record) : certain;
      level.happened.successes = binomial_quantile(level.happened.trials, probability, draws(sample, number++));
    }
  }
  return made;
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

double suite_deviance(const SuiteLevels& suite, const SuiteLaw& law) {
  struct Level {
    double records = 0.0, shares = 0.0;
  };
  std::map<double, Level> levels;
  for (const auto& record : suite) {
    for (const RecordLevel& level : record) {
      Level& sum = levels[level.intensity];
      sum.records += 1.0;
      sum.shares += static_cast<double>(level.happened.successes) / static_cast<double>(level.happened.trials);
    }
  }
  double deviance = 0.0;
  for (const auto& [intensity, level] : levels) {
    const double share = level.shares / level.records;
    const double z = std::log(intensity / law.median) / law.dispersion();
    deviance += 2.0 * level.records *
                (information(share, log_normal_probability(z).value) +
                 information(1.0 - share, log_normal_probability(-z).value));
  }
  return std::max(0.0, deviance);
}

std::optional<LackOfFit> suite_lack_of_fit(const SuiteLevels& suite, const SuiteLaw& law, std::uint64_t samples,
                                           const RecordDraws& draws, const base::ManyParts& how) {
  std::vector<std::optional<double>> deviances(samples);
  base::for_each_part(how, samples, [&](std::size_t sample) {
    const SuiteLevels made = drawn(suite, law, draws, sample);
    if (const auto fitted = fit_suite_near(made, law).law) deviances[sample] = suite_deviance(made, *fitted);
  });
  LackOfFit test{.deviance = suite_deviance(suite, law)};
  // Deviances that are equal in exact arithmetic differ by their rounding.
  const double least = test.deviance - 1e-9 * (1.0 + test.deviance);
  for (const auto& deviance : deviances) {
    if (!deviance) continue;
    ++test.samples;
    if (*deviance >= least) ++test.as_large;
  }
  if (static_cast<double>(test.samples) < least_share_with_law * static_cast<double>(samples)) return std::nullopt;
  test.p_value = static_cast<double>(test.as_large + 1) / static_cast<double>(test.samples + 1);
  return test;
}

}  // namespace rocking::stats
