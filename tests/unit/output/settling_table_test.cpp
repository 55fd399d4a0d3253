// What the terminal says of settling, of rates of leaving, and of horizons that are too short.

#include "rocking/output/settling_table.hpp"

#include <gmock/gmock.h>

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr section::ResponseMode harmonic{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 1};

SettlingRow row_with(std::uint64_t censored) {
  SettlingRow row;
  row.parameters = {{.pointer = "/excitation/amplitude", .value = "6.0"}};
  row.realisations = 100;
  row.unresolved_at_horizon = 64;
  row.censored = censored;
  row.fixed_horizon = 80;
  row.limit = 1000;
  row.confirmation = 60;
  row.median = {.level = 0.5, .value = 320.0, .low = 200.0, .high = {}};
  row.all_but_one_per_cent =
      stats::TimeToShare{.is_observed = false, .time = 4070, .low = 2480, .high = 7760, .events = 15};
  row.differ_at_horizon = 0.537;
  row.differ_in_the_end = 0.755;
  row.leaving.push_back(
      {.mode = harmonic, .left = 1, .watched_periods = 4000, .per_1000_periods = {.low = 0.0063, .high = 1.4}});
  return row;
}

TEST(SettlingText, TellsTheEndTheMedianAndBothDifferences) {
  const std::vector<SettlingRow> rows{row_with(26)};
  EXPECT_THAT(settling_text(rows, 200),
              AllOf(HasSubstr("shares are those in the end"), HasSubstr("up to 1000 periods"),
                    HasSubstr("26 of 100 realisations were not classified"), HasSubstr("64 (64.0 %)"),
                    HasSubstr("320 [200, -]"), HasSubstr("53.7"), HasSubstr("75.5"),
                    HasSubstr("(1,1) at amplitude 6: 0.25 [0.0063, 1.4] per 1000 periods"),
                    HasSubstr("label is that of a window")));
  EXPECT_EQ(settling_text({}, 200), "");
}

TEST(SettlingText, OmitsColumnsForWhichThereIsNoRoom) {
  const std::vector<SettlingRow> rows{row_with(26)};
  EXPECT_THAT(settling_text(rows, 60), AllOf(HasSubstr("unresolved at 80"), Not(HasSubstr("differ in the end"))));
}

TEST(SettlingText, BoundsWhatDidNotOccur) {
  const std::vector<SettlingRow> rows{row_with(0)};
  EXPECT_THAT(settling_text(rows, 200), HasSubstr("0 (< 3.6 %)"));
}

// The limit that is proposed holds the last response for all its windows: 7760 + 60, rounded up.
TEST(LimitRemedy, ProposesTheLimitThatWouldDo) {
  EXPECT_THAT(limit_remedy(row_with(26), "amplitude 6"),
              AllOf(HasSubstr("amplitude 6: 26.0 %"), HasSubstr("about 4100 periods [2480, 7760]"),
                    HasSubstr("at_most_periods to 7900")));
  EXPECT_EQ(limit_remedy(row_with(1), ""), "");
}

TEST(LimitRemedy, SaysSoWhereItCannotBeTold) {
  SettlingRow row = row_with(26);
  row.all_but_one_per_cent = stats::TimeToShare{.is_observed = false, .time = {}, .low = 2000, .high = {}, .events = 0};
  EXPECT_THAT(limit_remedy(row, ""), HasSubstr("cannot be told"));
}

TEST(UnresolvedRemedy, ProposesUntilClassifiedAboveFivePerCent) {
  EXPECT_THAT(unresolved_remedy(0.56, 40, 60),
              AllOf(HasSubstr("56.0 %"), HasSubstr("\"until_classified\": {\"at_most_periods\": 2000}")));
  EXPECT_EQ(unresolved_remedy(0.05, 40, 60), "");
}

TEST(PeriodText, SaysBeyond) {
  EXPECT_EQ(period_text({.level = 0.5, .value = {}, .low = 740.0, .high = {}}, 1000), "> 1000 [740, -]");
}

TEST(HorizonText, TellsWhatIsExtrapolated) {
  EXPECT_EQ(horizon_text({.is_observed = true, .time = 320, .low = 260, .high = {}, .events = 0}), "320 [260, -]");
  EXPECT_EQ(horizon_text({.is_observed = false, .time = 900, .low = 700, .high = 1300, .events = 9}),
            "about 900 [700, 1300]");
  EXPECT_EQ(horizon_text({}), "unknown");
}

}  // namespace
}  // namespace rocking
