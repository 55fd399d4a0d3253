// What a run says where its intervals are wider than `until` asked for.

#include "rocking/output/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocking {
namespace {

using section::ResponseKind;
using section::ResponseMode;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr ResponseMode overturning{.kind = ResponseKind::overturned};

/// Conditions of amplitude 0, 1, 2, ... of whose 100 realisations k overturned, with an interval of half-width 0.05.
struct Made {
  Experiment experiment;
  ExperimentResult result;

  void add(const Until& until, StoppedBecause cause, std::uint64_t k) {
    Condition condition;
    condition.parameters = {{"/excitation/amplitude", static_cast<std::int64_t>(experiment.conditions.size())}};
    condition.until = until;
    experiment.conditions.push_back(condition);
    ConditionResult found;
    found.stopped_because = cause;
    Estimate estimate{.counts = {.successes = k, .trials = 100},
                      .estimate = static_cast<double>(k) / 100.0,
                      .alone = {},
                      .simultaneous = {0.0, 1.0},
                      .anytime = stats::Interval{0.25, 0.375}};
    found.modes.push_back({.mode = overturning, .probability = estimate});
    estimate.anytime = stats::Interval{0.5, 0.6};
    found.modes.push_back({.mode = {.kind = ResponseKind::rest}, .probability = estimate});
    result.conditions.push_back(found);
  }

  [[nodiscard]] std::string text() const {
    return warning_lines({precision_findings(report_of(experiment, result, {})).back()});
  }
};

TEST(UnreachedPrecision, IsNotMentionedWhereItWasReached) {
  Made made;
  made.add({.half_width = 0.07}, StoppedBecause::half_width_reached, 25);
  made.add({.half_width = 0.07}, StoppedBecause::deterministic, 25);
  EXPECT_EQ(made.text(), "");
}

TEST(UnreachedPrecision, NamesTheConditionTheModeAndBothHalfWidths) {
  Made made;
  made.add({.half_width = 0.02}, StoppedBecause::half_width_reached, 25);
  made.add({.half_width = 0.02}, StoppedBecause::at_most_reached, 25);
  made.add({.half_width = 0.02, .mode = ResponseMode{.kind = ResponseKind::rest}}, StoppedBecause::at_most_reached, 25);
  EXPECT_THAT(
      made.text(),
      AllOf(HasSubstr("in 2 of 3 conditions"), HasSubstr("amplitude 1, overturned: 6.25 % instead of 2 %"),
            HasSubstr("amplitude 2, rest: 5 % instead of 2 %"), HasSubstr("at_most"), Not(HasSubstr("amplitude 0,"))));
}

TEST(UnreachedPrecision, IsRelativeToTheEstimateWhereThatWasWanted) {
  Made made;
  made.add({.relative_half_width = 0.1, .mode = overturning}, StoppedBecause::at_most_reached, 25);
  made.add({.relative_half_width = 0.1, .mode = overturning}, StoppedBecause::at_most_reached, 0);
  made.add({.relative_half_width = 0.1, .mode = section::periodic(2, 5)}, StoppedBecause::at_most_reached, 25);
  EXPECT_THAT(made.text(), AllOf(HasSubstr("amplitude 0, overturned: 25 % of the estimate instead of 10 %"),
                                 HasSubstr("amplitude 1, overturned: did not occur"),
                                 HasSubstr("amplitude 2, (2,5): did not occur")));
}

TEST(UnreachedPrecision, ListsTheFirstFewConditions) {
  Made made;
  for (int i = 0; i < 9; ++i) made.add({.half_width = 0.02}, StoppedBecause::at_most_reached, 25);
  EXPECT_THAT(made.text(), AllOf(HasSubstr("in 9 of 9 conditions"), HasSubstr("amplitude 4,"), HasSubstr("and 4 more"),
                                 Not(HasSubstr("amplitude 5,"))));
}

TEST(UnresolvedResponses, AreRemediedByUntilClassifiedAboveFivePerCent) {
  Made made;
  made.add({}, StoppedBecause::all_realisations_done, 25);
  made.experiment.conditions[0].horizon = {.transient_periods = 40, .sampled_periods = 60};
  made.experiment.conditions[0].scene.excitation = Harmonic{};
  ConditionResult& result = made.result.conditions[0];
  result.realisations = 100;
  const auto found = [&](std::uint64_t unresolved) {
    result.modes = {{}};
    result.modes[0].probability.counts = {.successes = unresolved, .trials = 100};
    result.modes[0].probability.estimate = 0.01 * static_cast<double>(unresolved);
    Report report = report_of(made.experiment, made.result, {});
    report.conditions[0].states_horizon = true;
    return precision_findings(report)[1];
  };
  EXPECT_EQ(found(5).rating, Rating::note);
  EXPECT_EQ(found(5).remedy, "");
  EXPECT_EQ(found(56).rating, Rating::look);
  EXPECT_THAT(found(56).remedy, HasSubstr("\"until_classified\": {\"at_most_periods\": 2000}"));
}

}  // namespace
}  // namespace rocking
