// Hazard curves: what is read, and every fault with its line.

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_hazard.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(read_hazard(text, "h.csv"));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Hazard, IsReadWithHeaderCommentsAndAnySeparator) {
  const HazardCurve found = read_hazard("# PSHA\npga_g, rate\r\n0.1 , 1e-2\n\n0.2;2e-3 # far\n+0.4\t5e-4\n", "h.csv");
  EXPECT_EQ(found.intensity, "pga_g");
  ASSERT_EQ(found.points.size(), 3U);
  EXPECT_EQ(found.points[1].intensity, 0.2);
  EXPECT_EQ(found.points[2].rate, 5e-4);
  EXPECT_EQ(read_hazard("0.1,1e-2\n0.2,1e-3", "h.csv").intensity, "");
}

TEST(Hazard, HeaderMayBeQuotedAndFollowComments) {
  const HazardCurve found = read_hazard("# one\n\n\"sa_g\",\"rate\"\n0.1,1e-2\n0.2,1e-3\n", "h.csv");
  EXPECT_EQ(found.intensity, "sa_g");
  EXPECT_EQ(found.header_line, 3U);
}

TEST(Hazard, HasABoundOnItsPointsThatIsTold) {
  std::string text = "pga_g,rate\n";
  for (std::size_t i = 1; i <= most_hazard_points; ++i)
    text += std::to_string(i) + ',' + std::to_string(20000 - i) + '\n';
  EXPECT_EQ(read_hazard(text, "h.csv").points.size(), most_hazard_points);
  text += std::to_string(most_hazard_points + 1) + ",1\n";
  EXPECT_THAT(complaint(text), ::testing::AllOf(HasSubstr("more than 10000 points"), HasSubstr("is too large"),
                                                HasSubstr("at most 10000 points")));
}

TEST(Hazard, OfTooManyBytesIsTooLargeWhateverItHolds) {
  const std::string line = "# no point, but a long comment\n";
  std::string text;
  while (text.size() <= most_hazard_bytes) text += line;
  EXPECT_THAT(complaint(text), ::testing::AllOf(HasSubstr("more than 10 MB"), HasSubstr("is too large")));
}

TEST(Hazard, IsRefusedWithLineValueAndRemedy) {
  EXPECT_THAT(complaint("0.1,1e-2\n"), HasSubstr("at least two points"));
  EXPECT_THAT(complaint("a,b\nc,d\n"), HasSubstr("line 2 = c: is not a number"));
  EXPECT_THAT(complaint("0.1,1e-2\n0.1,1e-3\n"), HasSubstr("line 2 = 0.1: is not above"));
  EXPECT_THAT(complaint("0.1,1e-2\n0.2,1e-2\n"), HasSubstr("line 2 = 1e-2: is not below the rate before it"));
  EXPECT_THAT(complaint("0.1,1e-2\n0.2,0\n"), HasSubstr("must be positive"));
  EXPECT_THAT(complaint("-0.1,1e-2\n0.2,1e-3\n"), HasSubstr("line 1 = -0.1: must be positive"));
  EXPECT_THAT(complaint("0.1,1e-2\n0.2,1e-3,7\n"), HasSubstr("two columns"));
  EXPECT_THAT(complaint("0.1,1e-2\n0.2,nan\n"), HasSubstr("not a number"));
}

}  // namespace
}  // namespace rocking
