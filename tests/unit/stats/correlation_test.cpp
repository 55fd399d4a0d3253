#include "rocking/stats/moments.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;
using Sample = std::vector<double>;

TEST(LagCorrelation, IsTheMeanProductOfScores) {
  const Sample sample{3, 1, 5, 1, 3};  // scores 1, 0, 2, 0, 1 under N(1, 2^2)
  const NormalLaw law{1.0, 2.0};
  EXPECT_DOUBLE_EQ(lag_correlation(sample, law, 1).value, 0.0);
  EXPECT_DOUBLE_EQ(lag_correlation(sample, law, 2).value, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(lag_correlation(sample, law, 2).standard_error, 1.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(lag_correlation(sample, law, 2).z, 4.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(lag_correlation(sample, law, 4).value, 1.0);
}

TEST(PairCorrelation, LooksWithinPairsOnly) {
  // Equal within the pairs, opposite between them; the seventh number has no partner.
  const Sample sample{1, 1, -1, -1, 1, 1, -1000};
  EXPECT_DOUBLE_EQ(pair_correlation(sample, {}).value, 1.0);
  EXPECT_DOUBLE_EQ(pair_correlation(sample, {}).standard_error, 1.0 / std::sqrt(3.0));
}

// Scores 1, 3 and 3, -1: excesses of the squares 0, 8 and 8, 0, so no product; then 3, 3: (9 - 1)^2/2 = 32.
TEST(PairCorrelationOfSquares, IsTheMeanProductOfScaledExcesses) {
  EXPECT_DOUBLE_EQ(pair_correlation_of_squares(Sample{1, 3, 3, -1}, {}).value, 0.0);
  EXPECT_DOUBLE_EQ(pair_correlation_of_squares(Sample{1, 3, 3, -3}, {}).value, 16.0);
  EXPECT_DOUBLE_EQ(pair_correlation_of_squares(Sample{3, 7, 7, -5}, {1.0, 2.0}).value, 16.0);
  EXPECT_DOUBLE_EQ(pair_correlation_of_squares(Sample{1, 3, 3, -3}, {}).standard_error, 1.0 / std::sqrt(2.0));
}

TEST(CrossCorrelation, PairsEqualPlaces) {
  const Moment moment = cross_correlation(Sample{3, 5, 1}, Sample{1, 3, 9}, {1.0, 2.0});  // scores 1, 2, 0 and 0, 1, 4
  EXPECT_DOUBLE_EQ(moment.value, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(moment.standard_error, 1.0 / std::sqrt(3.0));
}

}  // namespace
