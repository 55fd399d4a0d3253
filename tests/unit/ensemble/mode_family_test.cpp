// Response modes as a family: their statements, and the most frequent ones.

#include "rocking/ensemble/mode_family.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocking {
namespace {

using section::periodic;
using ::testing::ElementsAre;

TEST(ModeFamily, RanksModesByCountAndKeepsTheirOrder) {
  const ModeTally tally{{periodic(1, 1), 5}, {periodic(1, 2), 7}, {periodic(1, 3), 5}, {periodic(1, 4), 9}};
  EXPECT_THAT(most_frequent(tally, 3), ElementsAre(periodic(1, 1), periodic(1, 2), periodic(1, 4)))
      << "of equal counts the first";
  EXPECT_EQ(most_frequent(tally, 9).size(), 4U);
  EXPECT_TRUE(most_frequent(tally, 0).empty());
}

TEST(ModeFamily, GivesOtherModesASignificanceInProportionToTheirProbability) {
  const double share = (1.0 - 0.9) / 7.0;  // six prespecified modes, and all others together
  EXPECT_DOUBLE_EQ(significance_of(periodic(1, 3), 0.9).at(0.25), share);
  EXPECT_DOUBLE_EQ(significance_of(periodic(2, 5), 0.9).at(0.25), 0.25 * share);
  EXPECT_EQ(simultaneous_interval(periodic(2, 5), {.successes = 1, .trials = 50}, 0.9).low, 0.0);
  EXPECT_GT(simultaneous_interval(periodic(1, 3), {.successes = 1, .trials = 50}, 0.9).low, 0.0);
}

}  // namespace
}  // namespace rocking
