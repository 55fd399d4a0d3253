// What the terminal says of settling, of rates of leaving, and of horizons that are too short.

#include "rocking/output/settling_table.hpp"

#include "rocking/output/long_run_table.hpp"

#include <gmock/gmock.h>

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr section::ResponseMode harmonic{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 1};

SettlingRow row_with(std::uint64_t censored) {
  SettlingRow row;
  row.parameters = {{.pointer = "/excitation/amplitude", .value = 6.0}};
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

// Nothing left in 24000 periods: at most -ln(0.025)/24 in 1000. A watch of two windows does not see what happens later.
TEST(SettlingText, BoundsTheRateWhereNoResponseWasLeftAndSaysWhatItDoesNotSee) {
  std::vector<SettlingRow> rows{row_with(0), row_with(0)};
  for (SettlingRow& row : rows) {
    row.leaving = {{.mode = harmonic, .left = 0, .watched_periods = 12000, .per_1000_periods = {.high = 0.31}}};
  }
  EXPECT_THAT(settling_text(rows, 200),
              AllOf(HasSubstr("no settled response was left in 24000 watched periods: on average fewer than 0.15 in "
                              "1000 periods"),
                    HasSubstr("keeps its label"), HasSubstr("may differ from long-run shares")));
}

TEST(SettlingText, NamesTheModeThatIsLeftMostOften) {
  std::vector<SettlingRow> rows{row_with(0), row_with(0)};
  rows[0].leaving = {{.mode = harmonic, .left = 0, .watched_periods = 100, .per_1000_periods = {.high = 37.0}}};
  rows[1].parameters[0].value = 7.0;
  EXPECT_THAT(settling_text(rows, 200), HasSubstr("most often (1,1) at amplitude 7: 0.25 [0.0063, 1.4]"));
}

TEST(SettlingText, OmitsColumnsForWhichThereIsNoRoom) {
  const std::vector<SettlingRow> rows{row_with(26)};
  EXPECT_THAT(settling_text(rows, 60), AllOf(HasSubstr("unresolved at 80"), Not(HasSubstr("differ in the end"))));
}

// The headline's table: friction and amplitude are swept, and 120 letters are the width of a pipe.
TEST(SettlingText, HasBothDifferencesInTheUsualWidth) {
  SettlingRow row = row_with(0);
  row.parameters.insert(row.parameters.begin(),
                        {.pointer = "/friction", .value = WrittenPart{R"({"static": 0.40, "kinetic": 0.35})"}});
  row.realisations = 200;
  row.unresolved_at_horizon = 119;
  row.fixed_horizon = 560;
  row.median = {.level = 0.5, .value = 920.0, .low = 740.0, .high = 1040.0};
  row.all_but_one_per_cent =
      stats::TimeToShare{.is_observed = true, .time = 4280, .low = 3680, .high = {}, .events = 0};
  EXPECT_THAT(settling_text(std::vector{row}, 120), HasSubstr("differ at 560  differ in the end\n"));
}

TEST(SettlingText, BoundsWhatDidNotOccur) {
  const std::vector<SettlingRow> rows{row_with(0)};
  EXPECT_THAT(settling_text(rows, 200), HasSubstr("0 (< 3.6 %)"));
}

// The limit that is proposed holds the last response for all its windows: 7760 + 60, rounded up.
LongRunRow long_runs_of(std::vector<LongRunShare> shares) {
  return {.realisations = 50, .windows = 8, .shares = std::move(shares)};
}

TEST(LongRunText, HasTheSharesBoundsThoseOfNoWindowAndCountsConditionsOfOneMode) {
  constexpr section::ResponseMode third{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 3};
  std::vector<SettlingRow> rows{row_with(0), row_with(0), row_with(0)};
  rows[0].long_runs = long_runs_of({{.mode = harmonic, .share = 0.64, .interval = {.low = 0.521, .high = 0.748}},
                                    {.mode = third, .share = 0.36, .interval = {.low = 0.252, .high = 0.479}}});
  rows[1].long_runs = long_runs_of({{.mode = harmonic, .share = 0.9, .interval = {.low = 0.8, .high = 0.97}},
                                    {.mode = {}, .share = 0.1, .interval = {.low = 0.03, .high = 0.2}}});
  rows[2].long_runs = long_runs_of({{.mode = third, .share = 1.0, .interval = {.low = 0.93, .high = 1.0}}});
  const std::string text = long_run_text(rows, 200);
  EXPECT_THAT(text, AllOf(HasSubstr("the last 8 windows"), HasSubstr("64.0 [52.1, 74.8]"),
                          HasSubstr("36.0 [25.2, 47.9]"), HasSubstr("90.0 [80.0, 97.0]"), HasSubstr("< 7.1"),
                          HasSubstr("label of a window"), HasSubstr("in 1 condition every window")));
  EXPECT_THAT(long_run_text(rows, 60), AllOf(HasSubstr("others"), Not(HasSubstr("unresolved"))));
  EXPECT_THAT(settling_text(rows, 200), HasSubstr(text));
  rows.erase(rows.begin(), rows.begin() + 2);
  EXPECT_THAT(long_run_text(rows, 200), Not(HasSubstr("shares of time")));
  rows[0].long_runs.reset();
  EXPECT_EQ(long_run_text(rows, 200), "");
}

TEST(EndProviso, IsNeededWhereOneWindowWasHeld) {
  std::vector<SettlingRow> rows{row_with(0), row_with(0)};
  rows[0].held_windows = 2;
  EXPECT_THAT(end_proviso(rows), HasSubstr("may be left again later"));
  rows[1].held_windows = 2;
  EXPECT_EQ(end_proviso(rows), "");
}

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

TEST(PeriodText, SaysBeyond) {
  EXPECT_EQ(plain_text(period_cell({.level = 0.5, .value = {}, .low = 740.0, .high = {}}, 1000)), "> 1000 [740, -]");
}

TEST(HorizonText, TellsWhatIsExtrapolated) {
  EXPECT_EQ(horizon_text({.is_observed = true, .time = 320, .low = 260, .high = {}, .events = 0}), "320 [260, -]");
  EXPECT_EQ(horizon_text({.is_observed = false, .time = 900, .low = 700, .high = 1300, .events = 9}),
            "about 900 [700, 1300]");
  EXPECT_EQ(horizon_text({}), "unknown");
}

}  // namespace
}  // namespace rocking
