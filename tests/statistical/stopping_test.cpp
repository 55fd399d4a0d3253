// Effect of repeated looks on an interval: exactly, from the sum of the probabilities of all paths of counts, and by
// simulation of whole runs that stop by the rule, for every aim that a run can have.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/stopping_rule.hpp"
#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking;
using namespace rocking::stats;

using Misses = std::function<bool(const Proportion&)>;

/// Probability that an interval misses p at any number of trials in first ... last. Of all paths of counts, those that
/// have not yet reached a missing count are continued. Counts with a probability below 1e-18 are taken as missing,
/// 1e-15 in total.
double probability_of_ever_missing(double p, std::uint64_t first, std::uint64_t last, const Misses& misses) {
  std::vector<double> alive{1.0};  // by count
  for (std::uint64_t n = 1; n <= last; ++n) {
    alive.push_back(0.0);
    for (std::uint64_t k = n; k > 0; --k) alive[k] = alive[k] * (1.0 - p) + alive[k - 1] * p;
    alive[0] *= 1.0 - p;
    if (n < first) continue;
    for (std::uint64_t k = 0; k <= n; ++k) {
      if (alive[k] > 0.0 && (alive[k] < 1e-18 || misses({k, n}))) alive[k] = 0.0;
    }
  }
  double sum = 0.0;
  for (const double probability : alive) sum += probability;
  return 1.0 - sum;
}

double probability_that_a_sequence_misses(double p, double concentration, double significance) {
  const ConfidenceSequence sequence(concentration);
  return probability_of_ever_missing(p, 1, 2000, [&](const Proportion& counts) {
    return sequence.log_martingale(counts, p) >= -std::log(significance);
  });
}

TEST(ConfidenceSequence, MissesNoMoreOftenThanItsSignificanceLevelHoweverOftenOneLooks) {
  for (const double p : {0.01, 0.1, 0.5, 0.7}) {
    const double missed = probability_that_a_sequence_misses(p, 20.0, 0.05);
    EXPECT_LE(missed, 0.05) << p;
    EXPECT_GT(missed, 0.01) << p << ": it gives away most of what it may";
  }
  EXPECT_LE(probability_that_a_sequence_misses(0.5, 687.0, 0.05 / 7.0), 0.05 / 7.0);
}

// The naive rule, the sabotaged twin: an interval for a fixed n, used after every trial.
TEST(PeekingAtWilson, MissesTheTruthInTwoRunsOfFive) {
  const auto misses = [](const Proportion& counts) {
    const Interval interval = wilson(counts, 0.95);
    return 0.5 < interval.low || interval.high < 0.5;
  };
  EXPECT_NEAR(probability_of_ever_missing(0.5, 50, 2000, misses), 0.42496, 1e-5);
  EXPECT_LT(probability_of_ever_missing(0.5, 2000, 2000, misses), 0.06) << "once, it keeps its promise";
}

/// Three prespecified categories, the last of which never occurs, and twelve others.
const std::vector<double> prespecified{0.55, 0.02, 0.0};
const std::vector<double> others = [] {
  std::vector<double> probabilities(12, 0.02);
  probabilities[0] = 0.21;
  return probabilities;
}();

constexpr Family family{.prespecified = 3, .confidence = 0.95};
constexpr StoppingGoal absolute{.half_width = 0.1, .at_most = 1000, .family = family};
constexpr StoppingGoal relative{
    .half_width = 0.2, .scale = HalfWidthScale::relative, .at_most = 1000, .family = family};

/// What ends a run.
struct Aim {
  std::string name;
  StoppingGoal goal;
  std::function<bool(const StoppingRule&, const CategoryCounts&)> is_reached;
};

bool is_reached_by_prespecified(const StoppingRule& rule, const CategoryCounts& counts, std::size_t place) {
  const Proportion of_one{counts.prespecified[place], counts.trials};
  return rule.narrow_enough(of_one, rule.interval_of_prespecified(of_one));
}

bool is_reached_by_other(const StoppingRule& rule, const CategoryCounts& counts, std::size_t place) {
  const Proportion of_one{counts.others[place], counts.trials};
  return rule.narrow_enough(of_one, rule.interval_of_others(of_one));
}

const std::vector<Aim> aims{
    {"every interval", absolute,
     [](const StoppingRule& rule, const CategoryCounts& counts) { return rule.narrow_enough(counts); }},
    {"one interval", absolute,
     [](const StoppingRule& rule, const CategoryCounts& counts) {
       return is_reached_by_prespecified(rule, counts, 1);
     }},
    {"one interval, relative", relative,
     [](const StoppingRule& rule, const CategoryCounts& counts) {
       return is_reached_by_prespecified(rule, counts, 0);
     }},
    {"that of another category, relative", relative,
     [](const StoppingRule& rule, const CategoryCounts& counts) { return is_reached_by_other(rule, counts, 0); }}};

struct Draws {
  CategoryCounts counts{
      .trials = 0, .prespecified = std::vector<std::uint64_t>(3), .others = std::vector<std::uint64_t>(12)};
  support::SplitMix random;

  void draw_up_to(std::uint64_t trials) {
    for (; counts.trials < trials; ++counts.trials) {
      double left = random.uniform();
      const auto falls_in = [&left](double probability) { return (left -= probability) < 0.0; };
      const auto known = std::find_if(prespecified.begin(), prespecified.end(), falls_in);
      if (known != prespecified.end()) {
        ++counts.prespecified[static_cast<std::size_t>(known - prespecified.begin())];
      } else {
        const auto other = std::find_if(others.begin(), others.end() - 1, falls_in);
        ++counts.others[static_cast<std::size_t>(other - others.begin())];
      }
    }
  }
};

using IntervalOf = std::function<Interval(const Proportion&)>;

bool all_cover(const std::vector<std::uint64_t>& counts, std::uint64_t n, const std::vector<double>& truth,
               const IntervalOf& interval_of) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Interval interval = interval_of({counts[i], n});
    if (truth[i] < interval.low || interval.high < truth[i]) return false;
  }
  return true;
}

/// Whether any interval misses its true value at any look of a run that stops by the rule.
bool run_misses(std::uint64_t seed, const Aim& aim, const IntervalOf& known, const IntervalOf& other) {
  const StoppingRule rule(aim.goal);
  Draws draws{.random = support::SplitMix(seed)};
  bool stopped = false;
  while (!stopped) {
    draws.draw_up_to(rule.next_look(draws.counts.trials));
    const auto& [n, known_counts, other_counts] = draws.counts;
    if (!all_cover(known_counts, n, prespecified, known) || !all_cover(other_counts, n, others, other)) return true;
    stopped = n == aim.goal.at_most || aim.is_reached(rule, draws.counts);
  }
  return false;
}

constexpr std::uint64_t runs = 120;

std::uint64_t runs_that_miss(const Aim& aim, const IntervalOf& known, const IntervalOf& other) {
  std::uint64_t missed = 0;
  for (std::uint64_t seed = 0; seed < runs; ++seed) missed += run_misses(seed, aim, known, other) ? 1 : 0;
  return missed;
}

/// Probability of at least this number of missing runs, if each misses with probability 1 - confidence.
double p_value(std::uint64_t missed) {
  const boost::math::binomial_distribution<double> law(runs, 1.0 - family.confidence);
  return missed == 0 ? 1.0 : cdf(complement(law, static_cast<double>(missed - 1)));
}

TEST(StoppingRule, LeavesAllIntervalsAtAllLooksAsGoodAsItPromises) {
  support::FalseAlarms alarms;
  for (const Aim& aim : aims) {
    const StoppingRule rule(aim.goal);
    const auto missed = runs_that_miss(
        aim, [&](const Proportion& counts) { return rule.interval_of_prespecified(counts); },
        [&](const Proportion& counts) { return rule.interval_of_others(counts); });
    EXPECT_GT(p_value(missed), alarms.level()) << aim.name << ": " << missed;
  }
}

TEST(NaiveStopping, IsFoundOutByTheSameTest) {
  const auto naive = [](const Proportion& counts) { return wilson(counts, 0.95); };
  const auto exact_once = [](const Proportion& counts) { return clopper_pearson(counts, 0.95); };
  for (const Aim& aim : aims) {
    EXPECT_LT(p_value(runs_that_miss(aim, naive, naive)), support::false_alarm) << aim.name;
    EXPECT_LT(p_value(runs_that_miss(aim, exact_once, exact_once)), support::false_alarm) << aim.name;
  }
}

/// Probability that a run that aims at one category of probability p ends with an interval that misses p, summed over
/// all paths of its count. Counts with a probability below 1e-18 are taken as missing.
double probability_of_ending_with_a_miss(double p, const StoppingGoal& goal, const IntervalOf& interval_of) {
  const StoppingRule rule(goal);
  std::vector<double> alive{1.0};  // by count
  double missed = 0.0;
  for (std::uint64_t n = 1, look = rule.next_look(0); n <= goal.at_most; ++n) {
    alive.push_back(0.0);
    for (std::uint64_t k = n; k > 0; --k) alive[k] = alive[k] * (1.0 - p) + alive[k - 1] * p;
    alive[0] *= 1.0 - p;
    if (n != look) continue;
    look = rule.next_look(n);
    for (std::uint64_t k = 0; k <= n; ++k) {
      if (alive[k] == 0.0) continue;
      const Interval interval = alive[k] < 1e-18 ? Interval{1.0, 1.0} : interval_of({k, n});
      if (n < goal.at_most && !rule.narrow_enough({k, n}, interval)) continue;
      if (p < interval.low || interval.high < p) missed += alive[k];
      alive[k] = 0.0;
    }
  }
  return missed;
}

constexpr StoppingGoal relative_to_a_rare_one{.half_width = 0.3,
                                              .scale = HalfWidthScale::relative,
                                              .at_most = 1500,
                                              .family = {.prespecified = 6, .confidence = 0.95}};

TEST(AimAtOneCategory, EndsWithAMissNoMoreOftenThanItsShare) {
  for (const double p : {0.02, 0.1, 0.5, 0.9}) {
    for (const StoppingGoal& goal :
         {relative_to_a_rare_one, StoppingGoal{.half_width = 0.06, .at_most = 1500, .family = absolute.family}}) {
      const StoppingRule rule(goal);
      const double missed = probability_of_ending_with_a_miss(
          p, goal, [&](const Proportion& counts) { return rule.interval_of_prespecified(counts); });
      EXPECT_LE(missed, goal.family.share()) << p << ", to " << goal.half_width;
    }
  }
}

// The sabotaged twin: an interval for a fixed n, whose own width relative to the estimate ends the run.
TEST(AimAtOneCategory, WithAnIntervalForAFixedNumberEndsWithAMissMoreOftenThanPromised) {
  const double share = relative_to_a_rare_one.family.share();
  const double missed = probability_of_ending_with_a_miss(
      0.1, relative_to_a_rare_one, [&](const Proportion& counts) { return wilson(counts, 1.0 - share); });
  EXPECT_GT(missed, share);
}

}  // namespace
