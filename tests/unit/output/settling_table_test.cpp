// What the terminal says of settling, of rates of leaving, and of horizons that are too short.

#include "rocking/output/settling_table.hpp"

#include <gmock/gmock.h>

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr section::ResponseMode harmonic{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 1};

/// At amplitude 6: 100 realisations, of which 64 were unresolved after 80 periods and so many in the end.
ReportedCondition condition_with(std::uint64_t censored) {
  ReportedCondition condition;
  condition.asked.parameters = {{.pointer = "/excitation/amplitude", .value = 6.0}};
  condition.asked.horizon = {.transient_periods = 20, .sampled_periods = 60};
  condition.asked.horizon.until_classified = {.at_most_periods = 1000, .held_windows = 2};
  condition.result.realisations = 100;
  condition.result.non_recurrence.emplace().differ = 0.755;
  SettlingResult& settling = condition.result.settling.emplace();
  settling.at_horizon[{}] = 64;
  settling.censored = censored;
  settling.differ = 0.537;
  settling.leaving[harmonic] = {.watched_periods = 4000, .left = 1, .per_1000_periods = {.low = 0.0063, .high = 1.4}};
  settling.times.quartiles = {{.level = 0.5, .value = 320.0, .low = 200.0, .high = {}}};
  settling.times.nearly_all = {.is_observed = false, .time = 4070, .low = 2480, .high = 7760, .events = 15};
  return condition;
}

SettlingResult& settling_in(Report& report, std::size_t i) { return *report.conditions.at(i).result.settling; }

Report report_with(std::uint64_t censored, std::size_t conditions = 1) {
  Report report;
  report.swept = {"/excitation/amplitude"};
  report.conditions.assign(conditions, condition_with(censored));
  return report;
}

TEST(SettlingText, TellsTheEndTheMedianAndBothDifferences) {
  const Report report = report_with(26);
  EXPECT_THAT(settling_text(report, 200),
              AllOf(HasSubstr("shares are those in the end"), HasSubstr("up to 1000 periods"),
                    HasSubstr("26 of 100 realisations were not classified"), HasSubstr("  64.0  "),
                    HasSubstr("320 [200, -]"), HasSubstr("53.7"), HasSubstr("75.5"),
                    HasSubstr("(1,1) at amplitude 6: 0.25 [0.0063, 1.4] per 1000 periods"),
                    HasSubstr("label is that of a window")));
}

// Nothing left in 24000 periods: at most -ln(0.025)/24 in 1000. A watch of two windows does not see what happens later.
TEST(SettlingText, BoundsTheRateWhereNoResponseWasLeftAndSaysWhatItDoesNotSee) {
  Report report = report_with(0, 2);
  for (const std::size_t i : {0U, 1U}) {
    settling_in(report, i).leaving[harmonic] = {.watched_periods = 12000, .per_1000_periods = {.high = 0.31}};
  }
  EXPECT_THAT(settling_text(report, 200),
              AllOf(HasSubstr("no settled response was left in 24000 watched periods: on average fewer than 0.15 in "
                              "1000 periods"),
                    HasSubstr("keeps its label"), HasSubstr("may differ from long-run shares")));
}

TEST(SettlingText, NamesTheModeThatIsLeftMostOften) {
  Report report = report_with(0, 2);
  settling_in(report, 0).leaving[harmonic] = {.watched_periods = 100, .per_1000_periods = {.high = 37.0}};
  report.conditions[1].asked.parameters[0].value = 7.0;
  EXPECT_THAT(settling_text(report, 200), HasSubstr("most often (1,1) at amplitude 7: 0.25 [0.0063, 1.4]"));
}

TEST(SettlingText, OmitsColumnsForWhichThereIsNoRoom) {
  const Report report = report_with(26);
  EXPECT_THAT(settling_text(report, 60), AllOf(HasSubstr("unresolved at 80"), Not(HasSubstr("differ in the end"))));
}

// The headline's table: friction and amplitude are swept, and 120 letters are the width of a pipe.
TEST(SettlingText, HasBothDifferencesInTheUsualWidth) {
  Report report = report_with(0);
  report.swept.insert(report.swept.begin(), "/friction");
  ReportedCondition& condition = report.conditions.front();
  condition.asked.parameters.insert(
      condition.asked.parameters.begin(),
      {.pointer = "/friction", .value = WrittenPart{R"({"static": 0.40, "kinetic": 0.35})"}});
  condition.asked.horizon.transient_periods = 500;
  condition.result.realisations = 200;
  SettlingResult& settling = settling_in(report, 0);
  settling.at_horizon[{}] = 119;
  settling.times.quartiles = {{.level = 0.5, .value = 920.0, .low = 740.0, .high = 1040.0}};
  settling.times.nearly_all = {.is_observed = true, .time = 4280, .low = 3680, .high = {}, .events = 0};
  EXPECT_THAT(settling_text(report, 120), HasSubstr("differ at 560  differ in the end\n"));
}

TEST(SettlingText, BoundsWhatDidNotOccur) {
  const Report report = report_with(0);
  EXPECT_THAT(settling_text(report, 200), HasSubstr("< 3.6"));
}

// The limit that is proposed holds the last response for all its windows: 7760 + 60, rounded up.
LongRuns long_runs_of(std::map<section::ResponseMode, LongRuns::Share> shares) {
  return {.windows = 8, .count = 50, .shares = std::move(shares)};
}

TEST(LongRunText, HasTheSharesBoundsThoseOfNoWindowAndCountsConditionsOfOneMode) {
  constexpr section::ResponseMode third{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 3};
  Report report = report_with(0, 3);
  settling_in(report, 0).long_runs =
      long_runs_of({{harmonic, {.share = 0.64, .interval = {.low = 0.521, .high = 0.748}}},
                    {third, {.share = 0.36, .interval = {.low = 0.252, .high = 0.479}}}});
  settling_in(report, 1).long_runs = long_runs_of({{harmonic, {.share = 0.9, .interval = {.low = 0.8, .high = 0.97}}},
                                                   {{}, {.share = 0.1, .interval = {.low = 0.03, .high = 0.2}}}});
  settling_in(report, 2).long_runs = long_runs_of({{third, {.share = 1.0, .interval = {.low = 0.93, .high = 1.0}}}});
  const std::string text = long_run_text(report, 200);
  EXPECT_THAT(text, AllOf(HasSubstr("the last 8 windows"), HasSubstr("64.0 [52.1, 74.8]"),
                          HasSubstr("36.0 [25.2, 47.9]"), HasSubstr("90.0 [80.0, 97.0]"), HasSubstr("< 7.1"),
                          HasSubstr("label of a window"), HasSubstr("in 1 condition every window")));
  EXPECT_THAT(long_run_text(report, 60), AllOf(HasSubstr("others"), Not(HasSubstr("unresolved"))));
  EXPECT_THAT(settling_text(report, 200), HasSubstr(text));
  report.conditions.erase(report.conditions.begin(), report.conditions.begin() + 2);
  EXPECT_THAT(long_run_text(report, 200), Not(HasSubstr("shares of time")));
  settling_in(report, 0).long_runs.reset();
  EXPECT_EQ(long_run_text(report, 200), "");
}

TEST(EndProviso, IsNeededWhereOneWindowWasHeld) {
  Report report = report_with(0, 2);
  report.conditions[0].asked.horizon.until_classified->held_windows = 1;
  EXPECT_THAT(end_proviso(report), HasSubstr("may be left again later"));
  report.conditions[0].asked.horizon.until_classified->held_windows = 2;
  EXPECT_EQ(end_proviso(report), "");
}

TEST(LimitRemedy, ProposesTheLimitThatWouldDo) {
  EXPECT_THAT(limit_remedy(condition_with(26), "amplitude 6"),
              AllOf(HasSubstr("amplitude 6: 26.0 %"), HasSubstr("about 4100 periods [2480, 7760]"),
                    HasSubstr("at_most_periods to 7900")));
  EXPECT_EQ(limit_remedy(condition_with(1), ""), "");
}

TEST(LimitRemedy, SaysSoWhereItCannotBeTold) {
  ReportedCondition condition = condition_with(26);
  condition.result.settling->times.nearly_all = {
      .is_observed = false, .time = {}, .low = 2000, .high = {}, .events = 0};
  EXPECT_THAT(limit_remedy(condition, ""), HasSubstr("cannot be told"));
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
