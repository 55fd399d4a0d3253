// More conditions than a screen shows: ranges of conditions, and suites pooled over their records.

#include "rocking/output/run_table.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace rocking {
namespace {

using section::ResponseKind;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr section::ResponseMode fallen{.kind = ResponseKind::overturned};
constexpr section::ResponseMode resting{.kind = ResponseKind::rest};

/// Ten realisations, of which so many overturned and the others rest.
void add(std::vector<Parameter> parameters, std::uint64_t overturned, Report& report) {
  report.swept.clear();
  for (const Parameter& parameter : parameters) report.swept.push_back(parameter.pointer);
  ReportedCondition& condition = report.conditions.emplace_back();
  condition.asked.parameters = std::move(parameters);
  condition.result.realisations = 10;
  for (const auto& [mode, count] : {std::pair(resting, 10 - overturned), std::pair(fallen, overturned)}) {
    Estimate found;
    found.counts = {.successes = count, .trials = 10};
    found.estimate = 0.1 * static_cast<double>(count);
    condition.result.modes.push_back({.mode = mode, .probability = found});
  }
}

/// Records at levels 1 to 6; record r overturns from level r + 2 on, with one realisation less at level 6.
Report suite(std::size_t records) {
  Report report;
  for (std::size_t r = 0; r < records; ++r) {
    for (int level = 1; level <= 6; ++level) {
      const bool falls = level >= static_cast<int>(r) + 2;
      add({{"/excitation/file", "a/r" + std::to_string(r) + ".at2"}, {"/excitation/pga_g", level}},
          falls ? (level == 6 ? 9 : 10) : 0, report);
    }
  }
  return report;
}

std::ptrdiff_t lines_in(const std::string& text) { return std::ranges::count(text, '\n'); }

TEST(RunSummary, JoinsNeighboursWithOneResponse) {
  const std::string text = run_summary(suite(2));
  EXPECT_EQ(lines_in(text), 5);
  EXPECT_THAT(text, AllOf(HasSubstr("r0.at2       1"), HasSubstr("2 to 6           5  50"), HasSubstr("90.0 to 100.0"),
                          HasSubstr("r1.at2  1 to 2           2  20        rest")));
}

TEST(RunSummary, TakesRecordsTogetherWhereRangesAreTooMany) {
  const std::string text = run_summary(suite(4), 5);
  EXPECT_EQ(lines_in(text), 5);
  EXPECT_THAT(text, AllOf(HasSubstr("r3.at2  1 to 6           6  60  0.0 to 100.0"), Not(HasSubstr("rest"))));
}

TEST(RunSummary, DividesALongSweepOfOneEntry) {
  Report report;
  for (int i = 0; i < 100; ++i) add({{"/excitation/amplitude", i}}, i % 2 == 0 ? 10 : 0, report);
  const std::string text = run_summary(report, 10);
  EXPECT_EQ(lines_in(text), 11);
  EXPECT_THAT(text, AllOf(HasSubstr("0 to 9"), HasSubstr("90 to 99"), HasSubstr("0.0 to 100.0")));
}

TEST(PooledSummary, IsTheMeanOverTheRecords) {
  const std::string text = pooled_summary(suite(2));
  EXPECT_EQ(lines_in(text), 7);
  EXPECT_THAT(text, AllOf(HasSubstr("1        2  20         0.0           0.0"),
                          HasSubstr("2        2  20        50.0  0.0 to 100.0"), HasSubstr("90.0          90.0")));
  Report alone;
  add({{"/excitation/amplitude", 1}}, 3, alone);
  EXPECT_EQ(pooled_summary(alone), "") << "no suite";
  EXPECT_EQ(pooled_summary(suite(2), 5), "") << "more rows than are allowed";
}

}  // namespace
}  // namespace rocking
