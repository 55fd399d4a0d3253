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
TableRow row(std::vector<Parameter> parameters, std::uint64_t overturned) {
  const auto entry = [](section::ResponseMode mode, std::uint64_t count) {
    return TableEntry{.mode = mode, .count = count, .estimate = 0.1 * static_cast<double>(count), .interval = {}};
  };
  return {.parameters = std::move(parameters),
          .realisations = 10,
          .modes = {entry(resting, 10 - overturned), entry(fallen, overturned)}};
}

/// Records at levels 1 to 6; record r overturns from level r + 2 on, with one realisation less at level 6.
std::vector<TableRow> suite(std::size_t records) {
  std::vector<TableRow> rows;
  for (std::size_t r = 0; r < records; ++r) {
    for (int level = 1; level <= 6; ++level) {
      const bool falls = level >= static_cast<int>(r) + 2;
      rows.push_back(row({{"/excitation/file", "a/r" + std::to_string(r) + ".at2"}, {"/excitation/pga_g", level}},
                         falls ? (level == 6 ? 9 : 10) : 0));
    }
  }
  return rows;
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
  std::vector<TableRow> rows;
  for (int i = 0; i < 100; ++i) rows.push_back(row({{"/excitation/amplitude", i}}, i % 2 == 0 ? 10 : 0));
  const std::string text = run_summary(rows, 10);
  EXPECT_EQ(lines_in(text), 11);
  EXPECT_THAT(text, AllOf(HasSubstr("0 to 9"), HasSubstr("90 to 99"), HasSubstr("0.0 to 100.0")));
}

TEST(PooledSummary, IsTheMeanOverTheRecords) {
  const std::string text = pooled_summary(suite(2));
  EXPECT_EQ(lines_in(text), 7);
  EXPECT_THAT(text, AllOf(HasSubstr("1        2  20         0.0           0.0"),
                          HasSubstr("2        2  20        50.0  0.0 to 100.0"), HasSubstr("90.0          90.0")));
  EXPECT_EQ(pooled_summary({}), "");
  EXPECT_EQ(pooled_summary(std::vector<TableRow>{row({{"/excitation/amplitude", 1}}, 3)}), "") << "no suite";
  EXPECT_EQ(pooled_summary(suite(2), 5), "") << "more rows than are allowed";
}

}  // namespace
}  // namespace rocking
