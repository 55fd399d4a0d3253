// experiments/basins: a small version of the run whose table is in its README.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/text/number_text.hpp"
#include "support/false_alarms.hpp"

namespace {

using rocking::Json;
using rocking::stats::Proportion;

class Basins : public rocking::support::ProgramTest {};

/// The fraction that the README's table gives for A_h = 4.5 in a column, counted from 0 after n.
Proportion published_fraction(int column) {
  std::ifstream readme(ROCKING_SOURCE_DIR "/experiments/basins/README.md");
  std::string line;
  while (std::getline(readme, line) && line.find("      4.5  ") == std::string::npos) {
  }
  std::istringstream cells(line);
  std::string amplitude;
  std::string amplitude_g;
  std::string low;
  std::string high;
  std::string count;
  std::uint64_t n = 0;
  double per_cent = -1.0;
  cells >> amplitude >> amplitude_g >> n;
  for (int i = 0; i <= column; ++i) cells >> per_cent >> low >> high >> count;
  const double successes = std::round(0.01 * per_cent * static_cast<double>(n));
  return {.successes = static_cast<std::uint64_t>(successes), .trials = n};
}

/// The published run at A_h = 4.5 with independent random numbers.
Json small_version() {
  std::ifstream file(ROCKING_SOURCE_DIR "/experiments/basins/no_sliding.json");
  Json experiment = Json::parse(file);
  experiment["sweep"] = Json::array({{{"parameter", "/excitation/amplitude"}, {"values", {4.5}}}});
  experiment["realisations"] = 540;
  experiment["seed"] = "0x77";
  return experiment;
}

// Two exact intervals of the same probability, each at half the significance, are disjoint with at most that
// significance.
TEST_F(Basins, OfTwoResponsesCoexistInThePublishedFractions) {
  rocking::support::FalseAlarms alarms;
  write("small.json", small_version().dump());
  const auto run = rocking("run small.json -q --json -o out");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Json condition = Json::parse(run.output)["result"]["conditions"].at(0);
  ASSERT_EQ(condition["parameters"]["/excitation/amplitude"], 4.5);
  int column = 0;
  for (const char* mode : {"(1,1)", "(1,3)"}) {
    const double confidence = 1.0 - 0.5 * alarms.level();
    const Proportion found{.successes = condition["counts"][mode].get<std::uint64_t>(),
                           .trials = condition["realisations"].get<std::uint64_t>()};
    const Proportion published = published_fraction(column++);
    ASSERT_EQ(published.trials, 2000U);
    const auto here = rocking::stats::clopper_pearson(found, confidence);
    const auto there = rocking::stats::clopper_pearson(published, confidence);
    EXPECT_LE(here.low, there.high) << mode << ": " << found.successes << " of " << found.trials;
    EXPECT_GE(here.high, there.low) << mode << ": " << found.successes << " of " << found.trials;
  }
}

TEST_F(Basins, AreDrawnWithTheirSaddlesAndUnstableManifolds) {
  if (python_with_module().empty()) GTEST_SKIP() << "skipped: needs the Python module";
  if (shell("command -v gnuplot").exit_code != 0) GTEST_SKIP() << "skipped: needs gnuplot (Debian: gnuplot-nox)";
  const auto drawn =
      shell("exec " + python_with_module() + " -B '" ROCKING_SOURCE_DIR "/experiments/basins/draw.py' out 6 40");
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_THAT(drawn.output, ::testing::HasSubstr("(3,3) saddle"));
  EXPECT_TRUE(exists("out/basins.png") && exists("out/basins.svg"));
  const std::string map = read("out/basins.csv");
  EXPECT_EQ(std::ranges::count(map, '\n'), 1 + 6 * 6);
  EXPECT_THAT(map, ::testing::HasSubstr("overturned to the left\n"));
  std::istringstream sizes(read("out/sizes.csv"));
  int all = 0;
  for (std::string row; std::getline(sizes, row);) {
    const auto name_end = row.find(',', row.front() == '"' ? row.find('"', 1) : 0);
    all += std::atoi(row.c_str() + name_end + 1);  // 0 of the heading
  }
  EXPECT_EQ(all, 40) << "each initial state has a response";
  const std::string table = read("out/basins.tsv");
  std::istringstream lines(table.substr(table.find("# unstable manifolds")));
  double nearest_to_one = 1.0;
  double nearest_to_three = 1.0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    double tilt = 0.0;
    double rate = 0.0;
    if (!(cells >> tilt >> rate)) continue;
    nearest_to_one = std::min(nearest_to_one, std::hypot(tilt + 0.005410, rate + 0.551138));
    nearest_to_three = std::min(nearest_to_three, std::hypot(tilt + 0.032693, rate + 0.792673));
  }
  EXPECT_LT(nearest_to_one, 1e-2) << "one side leads to (1,1)";
  EXPECT_LT(nearest_to_three, 1e-2) << "the other to (1,3)";
}

TEST_F(Basins, OfOrbitsThatMirrorEachOtherAreToldApart) {
  if (python_with_module().empty()) GTEST_SKIP() << "skipped: needs the Python module";
  write("mirror.py", R"py(import sys, types
sys.path.insert(0, ")py" ROCKING_SOURCE_DIR R"py(/experiments/basins")
import draw
def orbit(*points):
    return types.SimpleNamespace(points=points, stable=True, symmetric=False, cycles=1, period=1, mirror=1)
reached, other = orbit((-0.005410, -0.551138)), orbit((0.005410, 0.551138))
assert list(draw.mirror_pairs([reached, other])) == ["(1,1)"]
for pair in ((reached, other), (other, reached)):
    mode = draw.on_mirror("(1,1)", (0.0, -0.55), {"(1,1)": pair})
    print(mode, draw.colour(mode))
)py");
  const auto outcome = shell("exec " + python_with_module() + " -B mirror.py");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "(1,1) #0072b2\n(1,1) mirrored #7fb8d8\n");
}

}  // namespace
