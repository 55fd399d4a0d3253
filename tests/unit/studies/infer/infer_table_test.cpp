// The answer of counted tests as text.

#include <gmock/gmock.h>

#include "rocking/studies/infer/study.hpp"

namespace {

using namespace rocking;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two conditions, a design of two points.
InferReport answered() {
  const auto tests = [](double amplitude, std::vector<std::uint64_t> counts) {
    return ReportedTests{.parameters = {{"/excitation/amplitude", amplitude}},
                         .counts = std::move(counts),
                         .predicted = {0.5, 0.2, 0.3},
                         .intervals = std::vector<stats::Interval>(3)};
  };
  return {.input = {},
          .unknowns = {{.parameter = "/friction/static",
                        .from = 0.3,
                        .to = 0.4,
                        .estimate = 0.35,
                        .interval = stats::Interval{.low = 0.32, .high = 0.38},
                        .reaches = ReachedBound::none}},
          .fit = InferenceFit{},
          .groups = {"(1,1)", "chaotic", "other"},
          .tests = {tests(4.5, {9, 1, 0}), tests(6.0, {7, 2, 1})},
          .design = {{.at = {0.3}, .counts = {{40, 0, 0}, {30, 10, 0}}},
                     {.at = {0.4}, .counts = {{39, 1, 0}, {40, 0, 0}}}}};
}

TEST(InferTable, AnswersInTheFirstLineAndTakesAnEndOfTheRangeForNoLimit) {
  InferReport report = answered();
  report.unknowns.front().parameter = "/excitation/pga_g";
  const auto first_line = [&](ReachedBound reaches) {
    report.unknowns.front().reaches = reaches;
    const std::string table = infer_table(report);
    return table.substr(0, table.find('\n'));
  };
  const std::string quantity = "peak ground acceleration PGA [g]: ";
  EXPECT_EQ(first_line(ReachedBound::none), quantity + "0.35 [0.32, 0.38], with 95 % confidence");
  EXPECT_EQ(first_line(ReachedBound::from), quantity + "at most 0.38, with 95 % confidence");
  EXPECT_EQ(first_line(ReachedBound::to), quantity + "at least 0.32, with 95 % confidence");
  EXPECT_EQ(first_line(ReachedBound::both), quantity + "any value from 0.32 to 0.38, with 95 % confidence");
  report.fit->p_value = 0.01;
  EXPECT_THAT(first_line(ReachedBound::none), HasSubstr("no value of the unknowns explains the counts"));
}

TEST(InferTable, NamesWhatWasCountedButNeverSimulated) {
  InferReport report = answered();
  const std::string table = infer_table(report);
  EXPECT_THAT(table, HasSubstr("\nother with amplitude 6 was counted 1 time, but never simulated at any value of the "
                               "unknowns\n"));
  EXPECT_THAT(table, Not(HasSubstr("chaotic with"))) << "one point of the design has it";
  EXPECT_THAT(table, Not(HasSubstr("other with amplitude 4.5"))) << "it was not counted";
  report.design[1].counts[0] = {40, 0, 0};
  EXPECT_THAT(infer_table(report), HasSubstr("chaotic with amplitude 4.5 was counted 1 time, but never simulated"));
  for (ReportedTests& tests : report.tests) tests.parameters.clear();
  EXPECT_THAT(infer_table(report), HasSubstr("\nother was counted 1 time, but never simulated"));
}

}  // namespace
