// The table that a run prints.

#include "rocking/output/mode_table.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/look/text_table.hpp"

namespace {

using namespace rocking;
using section::ResponseMode;

/// A table with one row for each call of `add`: realisations of each mode, all others none.
struct Made {
  Report report;

  void add(std::vector<Parameter> parameters, const std::vector<std::pair<ResponseMode, std::uint64_t>>& counts) {
    report.swept.clear();
    for (const Parameter& parameter : parameters) report.swept.push_back(parameter.pointer);
    ReportedCondition& condition = report.conditions.emplace_back();
    condition.asked.parameters = std::move(parameters);
    std::uint64_t& all = condition.result.realisations;
    for (const auto& [mode, count] : counts) all += count;
    for (const auto& [mode, count] : counts) {
      Estimate found;
      found.counts = {.successes = count, .trials = all};
      found.estimate = static_cast<double>(count) / static_cast<double>(all);
      found.simultaneous = {.low = 0.5 * found.estimate, .high = count > 0 ? found.estimate : 0.028};
      condition.result.modes.push_back({.mode = mode, .probability = found});
    }
  }

  [[nodiscard]] ConditionResult& result(std::size_t i) { return report.conditions.at(i).result; }
  [[nodiscard]] stats::Interval& interval(std::size_t i, std::size_t mode) {
    return result(i).modes.at(mode).probability.simultaneous;
  }

  [[nodiscard]] std::vector<std::string> lines(const TableLook& look = {}) const {
    std::istringstream table(mode_table(report, look));
    std::vector<std::string> all;
    for (std::string line; std::getline(table, line);) all.push_back(line);
    return all;
  }
};

TEST(ModeTable, HasARowForEachConditionAndAColumnForEachModeThatOccurs) {
  Made made;
  made.add(
      {{"/friction", WrittenPart{R"({"static":0.35,"kinetic":0.3})"}}, {"/excitation/amplitude", 3.3000000000000003}},
      {{section::periodic(1, 1), 150}, {section::periodic(1, 3), 50}, {{section::ResponseKind::chaotic}, 0}});
  made.add({{"/friction", WrittenPart{R"({"static":0.4,"kinetic":0.35})"}}, {"/excitation/amplitude", 10.0}},
           {{section::periodic(1, 1), 200}, {section::periodic(1, 3), 0}, {{section::ResponseKind::chaotic}, 0}});
  EXPECT_THAT(made.lines(), ::testing::ElementsAre("friction  amplitude    n                (1,1)              (1,3)",
                                                   "0.35/0.3        3.3  200    75.0 [37.5, 75.0]  25.0 [12.5, 25.0]",
                                                   "0.4/0.35         10  200  100.0 [50.0, 100.0]              < 2.8"));
}

TEST(ModeTable, RoundsNoRareModeAwayAndCountsIt) {
  Made made;
  made.add({{"/excitation/amplitude", 4.2}},
           {{section::periodic(1, 1), 299952}, {{section::ResponseKind::overturned}, 48}});
  made.interval(0, 0) = {0.99979, 0.99988};
  made.interval(0, 1) = {1.18e-4, 2.12e-4};
  EXPECT_EQ(made.lines()[1], "      4.2  300000  99.984 [99.979, 99.988] (299952)  0.016 [0.012, 0.021] (48)");
  EXPECT_EQ(overturning_line(made.report), "overturning: 0.016 [0.012, 0.021] %, 48 of 300000\n");
  EXPECT_EQ(response_line(made.report),
            "most likely the block rocks once in every period (1,1): 99.984 [99.979, 99.988] %, 299952 of 300000\n");
}

TEST(ModeTable, StaysWithinItsWidthWithCounts) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 6; ++n) counts.emplace_back(section::periodic(1, n), 16666 * n + 1);
  made.add({{"/excitation/amplitude", 4.2}}, counts);
  for (const std::size_t width : {60U, 80U, 100U, 120U, 200U}) {
    for (const std::string& line : made.lines({.width = width, .bars = Letters::ascii})) {
      EXPECT_LE(letters_in(line), width) << line;
    }
  }
}

TEST(ModeTable, WithoutASweepHasOneRow) {
  Made made;
  made.add({}, {{section::periodic(1, 1), 1}});
  EXPECT_THAT(made.lines(), ::testing::ElementsAre("n                (1,1)", "1  100.0 [50.0, 100.0]"));
}

TEST(ModeTable, HasADotWhereAModeHasNoBound) {
  Made made;
  made.add({{"/excitation/amplitude", 1.0}}, {{section::periodic(1, 1), 3}, {section::periodic(1, 5), 1}});
  made.add({{"/excitation/amplitude", 2.0}}, {{section::periodic(1, 1), 4}});
  made.result(1).modes.front().probability.anytime = stats::Interval{};
  EXPECT_THAT(made.lines()[2], ::testing::EndsWith(" ."));
}

TEST(ModeTable, ShowsNoIntervalWhereNothingIsRandom) {
  Made made;
  made.add({{"/excitation/amplitude", 1.0}},
           {{{section::ResponseKind::overturned}, 0}, {{section::ResponseKind::rest}, 1}});
  made.add({{"/excitation/amplitude", 10.0}}, {{{section::ResponseKind::overturned}, 1}});
  for (const std::size_t i : {0U, 1U}) made.result(i).stopped_because = StoppedBecause::deterministic;
  EXPECT_THAT(made.lines(),
              ::testing::ElementsAre("amplitude    response", "        1        rest", "       10  overturned"));
  made.result(0).stopped_because = StoppedBecause::all_realisations_done;  // a sweep of a standard deviation from 0 on
  EXPECT_THAT(made.lines()[2], ::testing::HasSubstr("100.0"));
  EXPECT_THAT(made.lines()[2], ::testing::Not(::testing::HasSubstr("[")));
}

TEST(ModeTable, HasAlwaysAColumnForOverturning) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 12; ++n) counts.emplace_back(section::periodic(1, n), 10);
  counts.push_back({{section::ResponseKind::overturned}, 1});
  made.add({{"/excitation/amplitude", 1.0}}, counts);
  EXPECT_THAT(made.lines()[0], ::testing::HasSubstr("overturned"));
  EXPECT_EQ(modes_to_show({{section::periodic(1, 1), 5}, {{section::ResponseKind::overturned}, 0}}, 1),
            std::vector{section::periodic(1, 1)});
}

TEST(ModeTable, HasAColumnForTheMostFrequentResponseOfEachConditionHoweverNarrow) {
  Made made;
  const ResponseMode rest{section::ResponseKind::rest}, overturned{section::ResponseKind::overturned};
  const auto add = [&](double amplitude, std::uint64_t at_rest, std::uint64_t periodic, std::uint64_t third) {
    made.add({{"/excitation/amplitude_g", amplitude}}, {{section::periodic(1, 1), periodic},
                                                        {section::periodic(1, 3), third},
                                                        {overturned, 200 - at_rest - periodic - third},
                                                        {rest, at_rest}});
  };
  add(0.15, 200, 0, 0);
  add(0.25, 0, 200, 0);
  add(0.45, 0, 139, 9);
  EXPECT_THAT(made.lines({.width = 58}),
              ::testing::ElementsAre("amplitude_g    n  (1,1)  (1,3)         overturned   rest",
                                     "       0.15  200  < 2.8  < 2.8              < 2.8  100.0",
                                     "       0.25  200  100.0  < 2.8              < 2.8  < 2.8",
                                     "       0.45  200   69.5    4.5  26.0 [13.0, 26.0]  < 2.8",
                                     "where there is no room for an interval: report.json has it"));
  for (std::size_t width = 49; width < 130; ++width) {
    const auto lines = made.lines({.width = width, .bars = Letters::ascii});
    for (const char* mode : {"(1,1)", "rest", "overturned"}) EXPECT_THAT(lines[0], ::testing::HasSubstr(mode)) << width;
    EXPECT_LE(letters_in(lines[1]), width);
  }
}

TEST(OverturningLine, TellsWhereItIsMostLikelyOrHowLikelyItCanBe) {
  Made made;
  const ResponseMode overturned{.kind = section::ResponseKind::overturned};
  made.add({{"/excitation/amplitude", 1.0}}, {{section::periodic(1, 1), 40}, {overturned, 0}});
  made.add({{"/excitation/amplitude", 2.0}}, {{section::periodic(1, 1), 40}, {overturned, 0}});
  made.interval(1, 1).high = 0.05;
  EXPECT_EQ(response_line(made.report), "") << "of several conditions";
  EXPECT_EQ(overturning_line(made.report), "overturning: none in 80 realisations; at most 5.0 % in each condition\n");
  made.add({{"/excitation/amplitude", 3.0}}, {{section::periodic(1, 1), 30}, {overturned, 10}});
  EXPECT_EQ(overturning_line(made.report),
            "overturning: in 1 of 3 conditions; most likely at amplitude 3: 25.0 [12.5, 25.0] %, 10 of 40\n");
  made.add({{"/excitation/amplitude", 4.0}}, {{section::periodic(1, 1), 30}, {overturned, 10}});
  made.add({{"/excitation/amplitude", 5.0}}, {{section::periodic(1, 1), 31}, {overturned, 9}});
  EXPECT_EQ(overturning_line(made.report),
            "overturning: in 3 of 5 conditions; most likely in 2 conditions, first at amplitude 3: 25.0 [12.5, 25.0] "
            "%, 10 of "
            "40\n");
}

TEST(ModeTable, AddsUpWhatDoesNotFitIn120Columns) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 12; ++n) counts.emplace_back(section::periodic(1, n), 10);
  counts[7].second = 90;  // (1,8): the most frequent mode is shown, whatever its place
  made.add({{"/excitation/amplitude", 1.0}}, counts);
  const auto lines = made.lines();
  for (const std::string& line : lines) EXPECT_LE(line.size(), 120U);
  EXPECT_THAT(lines[0], ::testing::HasSubstr("(1,8)"));
  EXPECT_THAT(lines[0], ::testing::EndsWith("others"));
  const auto shown = std::count(lines[0].begin(), lines[0].end(), '(');
  EXPECT_THAT(lines[1], ::testing::EndsWith(shown == 4 ? "40.0" : "")) << "200 less 90 and three times 10, of 200";
}

std::vector<stats::QuantileEstimate> levels(double median, double upper) {
  return {{.level = 0.5, .value = median, .low = {}, .high = {}},
          {.level = 0.95, .value = upper, .low = {}, .high = {}}};
}

TEST(ModeTable, EndsWithThePeakTiltWhereThereIsRoom) {
  Made made;
  made.add({}, {{section::periodic(1, 1), 1}});
  made.result(0).peaks.tilt.levels = levels(0.41, 0.53);
  EXPECT_THAT(made.lines(),
              ::testing::ElementsAre("n                (1,1)  peak tilt", "1  100.0 [50.0, 100.0]  0.41 0.53"));
  EXPECT_THAT(made.lines({.width = 33})[0], ::testing::EndsWith("peak tilt"));
  EXPECT_THAT(made.lines({.width = 32})[0], ::testing::EndsWith("(1,1)"));
}

TEST(ModeTable, ShowsTheSlipOfABlockThatSlidWithoutRocking) {
  Made made;
  made.add({}, {{{section::ResponseKind::rest}, 1}});
  made.result(0).peaks.tilt.levels = levels(0.0, 0.0);
  made.result(0).peaks.slip.emplace().metres = levels(0.6, 0.61);
  EXPECT_THAT(made.lines()[0], ::testing::EndsWith("rest  peak tilt"));
  made.result(0).modes.front().mode = {section::ResponseKind::slide};
  EXPECT_THAT(made.lines(), ::testing::ElementsAre("n                slide  peak tilt  peak slip",
                                                   "1  100.0 [50.0, 100.0]        0 0   0.6 0.61"));
}

TEST(PeakTiltCell, HasADashWhereOverturningLeavesNoValue) {
  using Quantiles = std::vector<stats::QuantileEstimate>;
  const stats::QuantileEstimate median{.level = 0.5, .value = 0.412, .low = {}, .high = {}};
  const stats::QuantileEstimate upper{.level = 0.95, .value = {}, .low = 0.5, .high = {}};
  EXPECT_EQ(peak_cell(Quantiles{median, upper}), "0.41 -");
  EXPECT_EQ(peak_cell(Quantiles{}), "- -");
}

TEST(Share, IsBoundedWhereAModeOccursInOtherConditionsOnly) {
  ReportedCondition without;
  without.result.realisations = 200;
  without.result.modes.push_back({.mode = {section::ResponseKind::rest}, .probability = {}});
  const AnyShare share = share_of(without, section::periodic(1, 5));
  EXPECT_EQ(share.count, 0U);
  EXPECT_EQ(share.interval.value().high,
            simultaneous_interval(section::periodic(1, 5), {.successes = 0, .trials = 200}, 0.95).high);
  without.result.modes.front().probability.anytime = stats::Interval{.low = 0.25, .high = 1.0};
  EXPECT_FALSE(share_of(without, section::periodic(1, 5)).interval)
      << "the number of realisations depends on their results";
  EXPECT_EQ(share_of(without, {section::ResponseKind::rest}).interval.value().low, 0.25);
}

/// Three modes: one alone, two equally frequent, and one rare.
Made of_three_modes() {
  Made made;
  made.add({{"/excitation/amplitude", 3.0}},
           {{section::periodic(1, 1), 200}, {section::periodic(1, 3), 0}, {{section::ResponseKind::overturned}, 0}});
  made.add({{"/excitation/amplitude", 4.5}},
           {{section::periodic(1, 1), 100}, {section::periodic(1, 3), 99}, {{section::ResponseKind::overturned}, 1}});
  return made;
}

TEST(ModeTable, DrawsItsSharesWhereBarsAreWanted) {
  EXPECT_THAT(of_three_modes().lines({.width = 101, .bars = Letters::ascii}),
              ::testing::ElementsAre(
                  "amplitude    n              # (1,1)            - (1,3)       % overturned        shares",
                  "        3  200  100.0 [50.0, 100.0]              < 2.8              < 2.8  ############",
                  "      4.5  200    50.0 [25.0, 50.0]  49.5 [24.8, 49.5]  0.50 [0.25, 0.50]  ######-----%"));
  const auto lines = of_three_modes().lines({.width = 104, .bars = Letters::unicode});
  EXPECT_THAT(lines[0], ::testing::HasSubstr("█ (1,1)"));
  EXPECT_THAT(lines[2], ::testing::EndsWith("  ███████░░░░░░░▓")) << "a longer bar, as there is room";
}

TEST(ModeTable, DrawsNoBarsWithoutRoomOrNeed) {
  const auto bars = Letters::ascii;
  EXPECT_EQ(of_three_modes().lines({.width = 100, .bars = bars}), of_three_modes().lines({.width = 100, .bars = {}}));
  EXPECT_EQ(of_three_modes().lines({.width = 1, .bars = bars}), of_three_modes().lines({.width = 1, .bars = {}}));
  Made alone;
  alone.add({}, {{section::periodic(1, 1), 7}, {section::periodic(1, 3), 0}});
  EXPECT_EQ(alone.lines({.width = 200, .bars = bars}), alone.lines());
}

TEST(ModeTable, KeepsToTheWidthThatThereIs) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 12; ++n) counts.emplace_back(section::periodic(1, n), 10);
  made.add({{"/excitation/amplitude", 1.0}}, counts);
  for (std::size_t width = 48; width < 220; ++width) {
    for (const auto bars : {std::optional<Letters>(), std::optional(Letters::unicode)}) {
      for (const std::string& line : made.lines({.width = width, .bars = bars}))
        EXPECT_LE(letters_in(line), width) << line;
    }
  }
  EXPECT_THAT(made.lines({.width = 300, .bars = Letters::ascii})[1], ::testing::EndsWith("  ##--%%==oo.............."));
}

TEST(ShareBar, HasALetterForWhatIsThereAtAllAndIsNoLongerForIt) {
  const BarLook look{.length = 12, .letters = Letters::ascii};
  EXPECT_EQ(share_bar({1'000'000, 1, 0, 1}, look), "##########-=");
  EXPECT_EQ(share_bar({0, 1, 0, 1}, look), "------======");
  EXPECT_EQ(share_bar({0, 0, 3}, look), "%%%%%%%%%%%%");
  EXPECT_EQ(share_bar({2, 1}, look), "########----");
}

}  // namespace
