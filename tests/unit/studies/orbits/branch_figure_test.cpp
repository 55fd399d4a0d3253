// The figure of branches: the range of its axis, and the modes that it names.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/studies/orbits/study.hpp"

namespace {

using rocking::OrbitBranch;
using rocking::OrbitKind;
using rocking::OrbitsReport;
using rocking::analysis::branch_figure;
using rocking::analysis::Figure;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::Lt;

/// Orbits (m, 1) at this tilt over the range 1 to 2, at so many values.
OrbitBranch branch_at(double tilt, OrbitKind kind, int cycles, int points) {
  OrbitBranch branch;
  for (int i = 0; i < points; ++i) {
    rocking::Orbit orbit{.period = 1, .cycles = cycles, .points = {{}}, .stability = {}};
    orbit.points[0].point.tilt = tilt;
    orbit.stability.kind = kind;
    branch.points.push_back({.value = 1.0 + i / (points - 1.0), .orbit = orbit});
  }
  return branch;
}

Figure figure_of_branches(std::vector<OrbitBranch> branches) {
  OrbitsReport report;
  report.study.branches = rocking::FoundBranches{.pointer = "/excitation/amplitude",
                                                 .range = {.low = 1.0, .high = 2.0},
                                                 .study = {.branches = std::move(branches), .bifurcations = {}}};
  return branch_figure(report);
}

std::vector<std::string> entries_of(const Figure& figure) {
  std::vector<std::string> entries;
  for (const auto& layer : figure.panels.front().layers) entries.push_back(layer.legend);
  return entries;
}

TEST(BranchFigure, HasTheRangeOfTheAttractors) {
  const Figure figure =
      figure_of_branches({branch_at(0.1, OrbitKind::focus, 1, 5), branch_at(-0.1, OrbitKind::node, 1, 5),
                          branch_at(0.14, OrbitKind::saddle, 1, 5), branch_at(-1.0, OrbitKind::saddle, 0, 5)});
  const auto& axis = figure.panels.front().y;
  EXPECT_THAT(axis.high.value(), AllOf(Gt(0.14), Lt(0.2))) << "with the unstable orbit near them";
  EXPECT_THAT(axis.low.value(), AllOf(Lt(-0.1), Gt(-0.2))) << "without the balance";
  EXPECT_EQ(figure.tables.at(0).rows.front().at(1), rocking::analysis::Cell(0.14)) << "unstable";
  EXPECT_EQ(figure.tables.at(0).rows.size(), 12U) << "the data have all orbits";
}

TEST(BranchFigure, WithoutAttractorsHasTheRangeOfAllOrbitsNearTheBalance) {
  const Figure figure =
      figure_of_branches({branch_at(-1.0, OrbitKind::saddle, 0, 5), branch_at(7.0, OrbitKind::saddle, 0, 5)});
  const auto& axis = figure.panels.front().y;
  EXPECT_THAT(axis.low.value(), Lt(-1.0));
  EXPECT_THAT(axis.high.value(), Lt(2.0));
}

TEST(BranchFigure, NamesAtMostEightModesAndSaysHowManyOthersThereAre) {
  std::vector<OrbitBranch> branches;
  for (int cycles = 0; cycles < 10; ++cycles) branches.push_back(branch_at(0.1, OrbitKind::node, cycles, 30 - cycles));
  for (int period = 2; period < 6; ++period) {  // (1,2) to (1,5) have looks of their own
    OrbitBranch branch = branch_at(0.1, OrbitKind::node, 1, 20);
    for (auto& point : branch.points) point.orbit.period = period;
    branches.push_back(branch);
  }
  const std::vector<std::string> entries = entries_of(figure_of_branches(branches));
  EXPECT_EQ(std::ranges::count_if(entries, [](const std::string& e) { return e.starts_with("stable ("); }), 8);
  EXPECT_THAT(entries, Contains("stable, 6 other modes"));
  EXPECT_THAT(entries, Contains("stable (0,1)")) << "the one with the most points";
  EXPECT_THAT(entries_of(figure_of_branches({branches.front()})), ElementsAre("stable (0,1)"));
}

}  // namespace
