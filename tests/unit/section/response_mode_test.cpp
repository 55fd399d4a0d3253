#include "rocking/section/response_mode.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classification.hpp"

namespace rocking::section {
namespace {

TEST(ResponseMode, IsSpelledAsInReports) {
  EXPECT_EQ(to_string(periodic(1, 3)), "(1,3)");
  EXPECT_EQ(to_string(periodic(0, 12)), "(0,12)");
  EXPECT_EQ(to_string(ResponseMode{ResponseKind::chaotic, 0, 0}), "chaotic");
  EXPECT_EQ(to_string(ResponseMode{ResponseKind::overturned, 0, 0}), "overturned");
  EXPECT_EQ(to_string(ResponseMode{ResponseKind::rest, 0, 0}), "rest");
  EXPECT_EQ(to_string(ResponseMode{ResponseKind::slide, 0, 0}), "slide");
  EXPECT_EQ(to_string(ResponseMode{}), "unresolved");
}

TEST(ResponseMode, SortsByPeriodsThenRocksThenKind) {
  const std::vector<ResponseMode> sorted{periodic(1, 1),
                                         periodic(2, 2),
                                         periodic(1, 3),
                                         periodic(3, 3),
                                         {ResponseKind::chaotic, 0, 0},
                                         {ResponseKind::slide, 0, 0},
                                         {ResponseKind::rest, 0, 0},
                                         {}};
  std::vector<ResponseMode> shuffled(sorted.rbegin(), sorted.rend());
  std::ranges::sort(shuffled);
  EXPECT_EQ(shuffled, sorted);
}

TEST(Reason, HasANameForEachEnumerator) {
  for (int k = 0; k <= static_cast<int>(Reason::impacts_irregular); ++k) {
    EXPECT_FALSE(to_string(static_cast<Reason>(k)).empty()) << k;
  }
}

}  // namespace
}  // namespace rocking::section
