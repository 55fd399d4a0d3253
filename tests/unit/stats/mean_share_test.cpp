// Mean share of clusters: its interval where the law of the clusters is known.

#include "rocking/stats/mean_share.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace rocking::stats {
namespace {

/// Two modes that alternate for ever (a semi-Markov process). A stay lasts 1, 2, ..., 2 mean - 1 windows, each equally
/// often, or has the geometric law with this mean.
struct Alternation {
  double mean_stay = 1.0;        ///< in the mode whose share is asked for, in windows
  double mean_stay_other = 1.0;  ///< in the other
  bool is_geometric = false;

  [[nodiscard]] double share() const { return mean_stay / (mean_stay + mean_stay_other); }
};

int whole_number_up_to(double largest, support::SplitMix& random) {
  return 1 + static_cast<int>(largest * random.uniform());
}

int stay(double mean, bool is_geometric, support::SplitMix& random) {
  if (!is_geometric) return whole_number_up_to(2.0 * mean - 1.0, random);
  int length = 1;
  while (random.uniform() * mean > 1.0) ++length;
  return length;
}

/// The rest of the stay that is under way at an instant chosen without regard to it: of length r with probability
/// P(stay >= r)/mean. For the geometric law it is a stay; for the uniform one the place in a stay chosen with
/// probability proportional to its length.
int rest_of_stay(double mean, bool is_geometric, support::SplitMix& random) {
  if (is_geometric) return stay(mean, true, random);
  const double longest = 2.0 * mean - 1.0;
  for (;;) {
    const int length = whole_number_up_to(longest, random);
    if (random.uniform() * longest < length) return whole_number_up_to(length, random);
  }
}

/// Windows in the mode, of `windows` successive ones of the process in equilibrium.
std::uint64_t windows_in_mode(const Alternation& law, int windows, support::SplitMix& random) {
  bool is_in = random.uniform() < law.share();
  int left = rest_of_stay(is_in ? law.mean_stay : law.mean_stay_other, law.is_geometric, random);
  std::uint64_t count = 0;
  for (int i = 0; i < windows; ++i, --left) {
    if (left == 0) {
      is_in = !is_in;
      left = stay(is_in ? law.mean_stay : law.mean_stay_other, law.is_geometric, random);
    }
    count += is_in ? 1 : 0;
  }
  return count;
}

double coverage(const Alternation& law, int clusters, int windows, int experiments, support::SplitMix& random) {
  int covered = 0;
  for (int i = 0; i < experiments; ++i) {
    ClusteredProportion sample{.trials_each = static_cast<std::uint64_t>(windows)};
    for (int j = 0; j < clusters; ++j) sample.add(windows_in_mode(law, windows, random));
    const Interval interval = korn_graubard(sample, 0.95);
    covered += interval.low <= law.share() && law.share() <= interval.high ? 1 : 0;
  }
  return static_cast<double>(covered) / experiments;
}

TEST(MeanShare, IsThatOfClopperAndPearsonIfClustersAreWhole) {
  ClusteredProportion sample{.trials_each = 80};
  for (int i = 0; i < 12; ++i) sample.add(0);
  const Interval none = korn_graubard(sample, 0.95);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, clopper_pearson({0, 12}, 0.95).high, 1e-12);
  for (int i = 0; i < 8; ++i) sample.add(80);
  const Interval some = korn_graubard(sample, 0.95);
  EXPECT_NEAR(some.low, clopper_pearson({8, 20}, 0.95).low, 1e-12);
  EXPECT_NEAR(some.high, clopper_pearson({8, 20}, 0.95).high, 1e-12);
}

TEST(MeanShare, HasANarrowerIntervalIfClustersAreAlike) {
  ClusteredProportion alike{.trials_each = 100};
  ClusteredProportion whole{.trials_each = 100};
  for (int i = 0; i < 20; ++i) {
    alike.add(i % 2 == 0 ? 45 : 55);
    whole.add(i % 2 == 0 ? 0 : 100);
  }
  const Interval of_alike = korn_graubard(alike, 0.95);
  const Interval of_whole = korn_graubard(whole, 0.95);
  EXPECT_LT(5.0 * (of_alike.high - of_alike.low), of_whole.high - of_whole.low);
}

TEST(MeanShare, KnowsNothingWithoutClusters) {
  const Interval interval = korn_graubard({}, 0.95);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_EQ(interval.high, 1.0);
}

// reports/evidence/intervals.md has the table. The least coverages that it promises are a little below the measured ones.
TEST(MeanShare, CoversTheShareOfSemiMarkovProcessesAsOftenAsTheDocumentsSay) {
  support::FalseAlarms alarms;
  support::SplitMix random(0x5a4e);
  constexpr int experiments = 4000;
  const auto expect_at_least = [&](double least, const Alternation& law, int clusters) {
    const double allowed = alarms.score() * std::sqrt(least * (1.0 - least) / experiments);
    EXPECT_GT(coverage(law, clusters, 80, experiments, random), least - allowed)
        << law.mean_stay << ' ' << law.mean_stay_other << ' ' << clusters;
  };
  expect_at_least(0.95, {.mean_stay = 10.0, .mean_stay_other = 10.0}, 10);
  expect_at_least(0.95, {.mean_stay = 10.0, .mean_stay_other = 30.0, .is_geometric = true}, 40);
  expect_at_least(0.95, {.mean_stay = 500.0, .mean_stay_other = 500.0}, 10);
}

}  // namespace
}  // namespace rocking::stats
