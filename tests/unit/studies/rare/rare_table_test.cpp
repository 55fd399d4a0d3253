// Rare estimates of many conditions as a table.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/studies/rare/study.hpp"

namespace {

using namespace rocking;
using ::testing::HasSubstr;
using ::testing::Not;

RareReport sixty_conditions() {
  RareReport report;
  for (int i = 0; i < 60; ++i) {
    auto& condition = report.conditions.emplace_back();
    condition.parameters = {{"/excitation/amplitude", 1.0 + i}};
    condition.estimate.method = RareMethod::plain_sampling;
    condition.estimate.end = i % 2 == 0 ? RareEnd::out_of_time : RareEnd::precise;
  }
  return report;
}

std::ptrdiff_t times(const std::string& text, const std::string& part) {
  std::ptrdiff_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(RareTable, SaysEachRemarkOnceWithALetterInItsRows) {
  const std::string text = rare_table(sixty_conditions());
  EXPECT_EQ(times(text, "sampled plainly"), 1);
  EXPECT_EQ(times(text, "the time was up"), 1);
  EXPECT_EQ(times(text, " ab\n"), 30);
  EXPECT_EQ(times(text, " a\n"), 30);
  EXPECT_LE(std::ranges::count(text, '\n'), 60 + 10);
  EXPECT_THAT(text, Not(HasSubstr("unresolved")));
}

TEST(RareTable, HasAColumnForWhatEndedWithoutAnAnswer) {
  RareReport report = sixty_conditions();
  report.conditions[7].estimate.unresolved = 0.00125;
  const std::string text = rare_table(report);
  EXPECT_THAT(text, HasSubstr("0.00125"));
  EXPECT_EQ(times(text, "ended before their horizon"), 1);
}

TEST(RareTable, OfOneConditionHasNoLetters) {
  RareReport report = sixty_conditions();
  report.conditions.resize(1);
  EXPECT_THAT(rare_table(report), HasSubstr("\nthe time was up"));
}

}  // namespace
