// Confidence limits of a mean over records, with one more record than there are.

#include "rocking/stats/unseen_record.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/stats/interval.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;

RecordDraws draws() {
  return [](std::uint64_t sample, std::uint64_t number) {
    return rocking::support::SplitMix(1000 * sample + number).uniform();
  };
}

// Of numbers that are 0 or 1 the shares of the ones are beta numbers, whose quantiles are the limits of Clopper and
// Pearson. 0.015 is five standard errors of their quantiles, sqrt(0.025 0.975/20000) over the density, at least 0.37 there.
TEST(UnseenRecord, GivesTheLimitsOfClopperAndPearson) {
  constexpr std::uint64_t samples = 20000;
  for (const std::uint64_t events : {0U, 1U, 4U, 9U, 10U}) {
    std::vector<double> lows, highs;
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
      const std::vector<double> shares = shares_with_unseen(10, sample, draws());
      double mean = 0.0, sum = 0.0;
      for (std::size_t r = 0; r < 10; ++r) {
        sum += shares[r];
        if (r < events) mean += shares[r];
      }
      const std::vector<double> seen{mean / sum};
      lows.push_back(mean_with_unseen(seen, shares.back(), std::array{0.0}).front());
      highs.push_back(mean_with_unseen(seen, shares.back(), std::array{1.0}).front());
    }
    const Interval expected = clopper_pearson({.successes = events, .trials = 10}, 0.95);
    EXPECT_NEAR(percentile_interval(lows, samples, 0.95)->low, expected.low, 0.015) << events;
    EXPECT_NEAR(percentile_interval(highs, samples, 0.95)->high, expected.high, 0.015) << events;
  }
}

TEST(UnseenRecord, SharesAddUpToOne) {
  const std::vector<double> shares = shares_with_unseen(3, 7, draws());
  ASSERT_EQ(shares.size(), 4U);
  double sum = 0.0;
  for (const double share : shares) {
    EXPECT_GT(share, 0.0);
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  const std::vector<double> mean = mean_with_unseen({0.5, 0.0}, 0.2, std::array{1.0, 1.0});
  EXPECT_THAT(mean, testing::ElementsAre(testing::DoubleEq(0.6), testing::DoubleEq(0.2)));
}

}  // namespace
