#include "rocking/section/recurrence.hpp"

#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

namespace rocking::section {
namespace {

std::vector<Period> with_impacts(std::initializer_list<int> counts) {
  std::vector<Period> periods;
  for (const int count : counts) periods.push_back({{}, static_cast<std::uint16_t>(count), true});
  return periods;
}

TEST(CountRocks, CountsPairsOfImpactsInACycle) {
  const Rocks rocks = count_rocks(with_impacts({0, 1, 1, 0, 1, 1, 0, 1, 1}), 3);
  EXPECT_EQ(rocks.rocks, 1);
  EXPECT_EQ(rocks.regular_share, 1.0);
}

TEST(CountRocks, CountsAPairBegun) { EXPECT_EQ(count_rocks(with_impacts({3, 3, 3, 3}), 1).rocks, 2); }

TEST(CountRocks, LeavesOutWhatComesBeforeTheFirstFullCycle) {
  const Rocks rocks = count_rocks(with_impacts({9, 2, 2, 2, 2}), 2);
  EXPECT_EQ(rocks.rocks, 2);
  EXPECT_EQ(rocks.regular_share, 1.0);
}

TEST(CountRocks, DoesNotMindOnWhichSideOfTheStrobeAnImpactFalls) {
  EXPECT_EQ(count_rocks(with_impacts({2, 1, 3, 2, 1, 3, 2, 1, 2, 3}), 1).regular_share, 1.0);
  EXPECT_EQ(count_rocks(with_impacts({2, 3, 1, 2, 3, 1, 2, 3, 2, 1}), 1).regular_share, 1.0);
}

TEST(CountRocks, MindsImpactsThatAreNotGivenBack) {
  EXPECT_EQ(count_rocks(with_impacts({2, 2, 2, 4, 2, 2, 2, 2, 2, 2}), 1).regular_share, 0.9);
  EXPECT_EQ(count_rocks(with_impacts({2, 2, 0, 2, 2, 2, 0, 2, 2, 2}), 1).regular_share, 0.8);
  // One additional impact may be due to an impact near a strobe; a second one in the same direction is irregular.
  EXPECT_EQ(count_rocks(with_impacts({2, 3, 2, 3, 2, 2, 2, 2, 2, 2}), 1).regular_share, 0.9);
}

TEST(CountRocks, CallsACycleThatOnlySlidesRegularIfItMoved) {
  std::vector<Period> periods = with_impacts({0, 0, 0, 0});
  EXPECT_EQ(count_rocks(periods, 1).regular_share, 1.0);
  EXPECT_EQ(count_rocks(periods, 1).rocks, 0);
  periods[2].moved = false;
  EXPECT_EQ(count_rocks(periods, 1).regular_share, 0.75);
  EXPECT_EQ(count_rocks(periods, 2).regular_share, 1.0);
}

}  // namespace
}  // namespace rocking::section
