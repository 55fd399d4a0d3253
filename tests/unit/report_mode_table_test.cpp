// The table that a run prints.

#include "rocking/report/mode_table.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

  [[nodiscard]] std::vector<std::string> lines() const {
    std::istringstream table(report::mode_table(experiment, result));
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

}  // namespace
