// experiments/basins: a small version of the run whose table its README gives.

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "rocking/stats/interval.hpp"

namespace {

using rocking::report::Json;

class Basins : public rocking::support::ProgramTest {};

/// The fraction that the README's table gives for A_h = 4.5 in a column, counted from 0 after n.
double published_fraction(int column) {
  std::ifstream readme(ROCKING_SOURCE_DIR "/experiments/basins/README.md");
  std::string line;
  while (std::getline(readme, line) && line.find("      4.5  2000") == std::string::npos) {
  }
  std::istringstream cells(line);
  std::string amplitude;
  std::string n;
  std::string low;
  std::string high;
  double per_cent = -1.0;
  cells >> amplitude >> n;
  for (int i = 0; i <= column; ++i) cells >> per_cent >> low >> high;
  return per_cent / 100.0;
}

// With another seed the intervals would miss a fraction once in five thousand runs.
TEST_F(Basins, OfTwoResponsesCoexistInThePublishedFractions) {
  const auto run = rocking("run '" ROCKING_SOURCE_DIR
                           "/experiments/basins/no_sliding.json' -q --json -o out --realisations 60 --seed 77");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Json conditions = Json::parse(run.output)["result"]["conditions"];
  int seen = 0;
  for (const Json& condition : conditions) {
    if (condition["parameters"]["/excitation/amplitude"] != 4.5) continue;
    ++seen;
    int column = 0;
    for (const char* mode : {"(1,1)", "(1,3)"}) {
      const rocking::stats::Proportion counts{.successes = condition["counts"][mode].get<std::uint64_t>(),
                                              .trials = 60};
      const auto interval = rocking::stats::clopper_pearson(counts, 0.9999);
      const double fraction = published_fraction(column++);
      EXPECT_GT(counts.successes, 0U) << mode;
      EXPECT_LT(interval.low, fraction) << mode;
      EXPECT_GT(interval.high, fraction) << mode;
    }
  }
  EXPECT_EQ(seen, 1);
}

}  // namespace
