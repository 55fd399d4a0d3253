// The table that a run prints.

#include "rocking/report/mode_table.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/report/share_bar.hpp"
#include "rocking/report/text_table.hpp"

namespace {

using namespace rocking;
using section::ResponseMode;

/// A result with one condition an entry of `counts`: realisations of each mode, all others none.
struct Made {
  experiment::Experiment experiment;
  experiment::ExperimentResult result;

  void add(std::vector<experiment::Parameter> parameters,
           const std::vector<std::pair<ResponseMode, std::uint64_t>>& counts) {
    experiment::Condition condition;
    condition.parameters = std::move(parameters);
    experiment.conditions.push_back(condition);
    experiment::ConditionResult made;
    for (const auto& [mode, count] : counts) made.realisations += count;
    for (const auto& [mode, count] : counts) {
      const double p = static_cast<double>(count) / static_cast<double>(made.realisations);
      made.modes.push_back({mode,
                            {.counts = {count, made.realisations},
                             .estimate = p,
                             .wilson = {},
                             .jeffreys = {},
                             .clopper_pearson = {},
                             .simultaneous = {0.5 * p, p},
                             .goodman = {},
                             .sison_glaz = {}}});
    }
    result.conditions.push_back(made);
  }

  [[nodiscard]] std::vector<std::string> lines(const report::TableLook& look = {}) const {
    std::istringstream table(report::mode_table(experiment, result, look));
    std::vector<std::string> all;
    for (std::string line; std::getline(table, line);) all.push_back(line);
    return all;
  }
};

TEST(ModeTable, HasARowForEachConditionAndAColumnForEachModeThatOccurs) {
  Made made;
  made.add({{"/friction", R"({"static":0.35,"kinetic":0.3})"}, {"/excitation/amplitude", "3.3000000000000003"}},
           {{section::periodic(1, 1), 150}, {section::periodic(1, 3), 50}, {{section::ResponseKind::chaotic}, 0}});
  made.add({{"/friction", R"({"static":0.4,"kinetic":0.35})"}, {"/excitation/amplitude", "10.0"}},
           {{section::periodic(1, 1), 200}, {section::periodic(1, 3), 0}, {{section::ResponseKind::chaotic}, 0}});
  EXPECT_THAT(made.lines(), ::testing::ElementsAre("friction  amplitude    n                (1,1)              (1,3)",
                                                   "0.35/0.3        3.3  200    75.0 [37.5, 75.0]  25.0 [12.5, 25.0]",
                                                   "0.4/0.35         10  200  100.0 [50.0, 100.0]                  ."));
}

TEST(ModeTable, WithoutASweepHasOneRow) {
  Made made;
  made.add({}, {{section::periodic(1, 1), 1}});
  EXPECT_THAT(made.lines(), ::testing::ElementsAre("n                (1,1)", "1  100.0 [50.0, 100.0]"));
}

TEST(ModeTable, AddsUpWhatDoesNotFitIn120Columns) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 12; ++n) counts.emplace_back(section::periodic(1, n), 10);
  counts[7].second = 90;  // (1,8): the most frequent one is shown, wherever it stands
  made.add({{"/excitation/amplitude", "1.0"}}, counts);
  const auto lines = made.lines();
  for (const std::string& line : lines) EXPECT_LE(line.size(), 120U);
  EXPECT_THAT(lines[0], ::testing::HasSubstr("(1,8)"));
  EXPECT_THAT(lines[0], ::testing::EndsWith("others"));
  const auto shown = std::count(lines[0].begin(), lines[0].end(), '(');
  EXPECT_THAT(lines[1], ::testing::EndsWith(shown == 4 ? "40.0" : "")) << "200 less 90 and three times 10, of 200";
}

TEST(ModeTable, ShowsTheIntervalThatHoldsWheneverTheRunStopped) {
  Made made;
  made.add({}, {{section::periodic(1, 1), 1}});
  made.result.conditions[0].modes[0].probability.anytime = {.low = 0.25, .high = 1.0};
  EXPECT_THAT(made.lines()[1], ::testing::EndsWith("100.0 [25.0, 100.0]"));
}

/// Three modes: one alone, two alike, and one that is rare.
Made of_three_modes() {
  Made made;
  made.add({{"/excitation/amplitude", "3.0"}},
           {{section::periodic(1, 1), 200}, {section::periodic(1, 3), 0}, {{section::ResponseKind::overturned}, 0}});
  made.add({{"/excitation/amplitude", "4.5"}},
           {{section::periodic(1, 1), 100}, {section::periodic(1, 3), 99}, {{section::ResponseKind::overturned}, 1}});
  return made;
}

TEST(ModeTable, DrawsItsSharesWhereBarsAreWanted) {
  EXPECT_THAT(
      of_three_modes().lines({.width = 104, .bars = report::Letters::ascii}),
      ::testing::ElementsAre("amplitude    n              # (1,1)            - (1,3)    % overturned        shares",
                             "        3  200  100.0 [50.0, 100.0]                  .               .  ############",
                             "      4.5  200    50.0 [25.0, 50.0]  49.5 [24.8, 49.5]  0.5 [0.2, 0.5]  ######-----%"));
  const auto lines = of_three_modes().lines({.width = 107, .bars = report::Letters::unicode});
  EXPECT_THAT(lines[0], ::testing::HasSubstr("█ (1,1)"));
  EXPECT_THAT(lines[2], ::testing::EndsWith("  ███████░░░░░░░▓")) << "a longer bar, as there is room";
}

TEST(ModeTable, DrawsNoBarsWithoutRoomOrNeed) {
  const auto bars = report::Letters::ascii;
  EXPECT_EQ(of_three_modes().lines({.width = 103, .bars = bars}), of_three_modes().lines({.width = 103, .bars = {}}));
  EXPECT_EQ(of_three_modes().lines({.width = 1, .bars = bars}), of_three_modes().lines({.width = 1, .bars = {}}));
  Made alone;
  alone.add({}, {{section::periodic(1, 1), 7}, {section::periodic(1, 3), 0}});
  EXPECT_EQ(alone.lines({.width = 200, .bars = bars}), alone.lines());
}

TEST(ModeTable, KeepsToTheWidthThatThereIs) {
  Made made;
  std::vector<std::pair<ResponseMode, std::uint64_t>> counts;
  for (int n = 1; n <= 12; ++n) counts.emplace_back(section::periodic(1, n), 10);
  made.add({{"/excitation/amplitude", "1.0"}}, counts);
  for (std::size_t width = 48; width < 220; ++width) {
    for (const auto bars : {std::optional<report::Letters>(), std::optional(report::Letters::unicode)}) {
      for (const std::string& line : made.lines({.width = width, .bars = bars}))
        EXPECT_LE(report::letters_in(line), width) << line;
    }
  }
  EXPECT_THAT(made.lines({.width = 300, .bars = report::Letters::ascii})[1],
              ::testing::EndsWith("  ##--%%==oo.............."));
}

TEST(ShareBar, HasALetterForWhatIsThereAtAllAndIsNoLongerForIt) {
  const report::BarLook look{.length = 12, .letters = report::Letters::ascii};
  EXPECT_EQ(report::share_bar({1'000'000, 1, 0, 1}, look), "##########-=");
  EXPECT_EQ(report::share_bar({0, 1, 0, 1}, look), "------======");
  EXPECT_EQ(report::share_bar({0, 0, 3}, look), "%%%%%%%%%%%%");
  EXPECT_EQ(report::share_bar({2, 1}, look), "########----");
}

}  // namespace
