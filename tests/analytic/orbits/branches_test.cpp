// Branches of periodic orbits whose tests follow long runs: folds, broken symmetry, branches of several conditions.

#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/fixed_point.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "support/branches.hpp"

namespace rocking {
namespace {

using support::amplitudes;
using support::find;
using support::orbits_at;
using support::shaken;

/// Response mode of a block that starts on an orbit, after a long transient.
section::ResponseMode mode_from(const section::StrobePoint& start, double amplitude) {
  Condition condition = shaken(amplitude);
  condition.scene.initial = {.tilt = start.tilt, .tilt_rate = start.tilt_rate, .slip_rate = start.slip_rate};
  condition.horizon = {.transient_periods = 6000, .sampled_periods = 120};
  return realise(condition, 0, 0).classification.mode;
}

// The stable branch of (1,5) ends in a fold. A run that starts on its last orbit stays on (1,5) a little above the
// fold, and leaves it a little below.
TEST(Branches, FoldWhereRunsFallOff) {
  const std::vector<double> values{3.0};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 5);
  const BranchStudy study = branches_of(amplitudes(values, {.low = 1.8, .high = 3.0}), found, {});
  const Bifurcation* fold = nullptr;
  for (const Bifurcation& one : study.bifurcations) {
    if (one.kind == BifurcationKind::fold && one.orbit->period == 5) fold = &one;
  }
  ASSERT_NE(fold, nullptr);
  EXPECT_LE(fold->error, 1e-8);
  const section::StrobePoint start = fold->orbit->points.front().point;
  EXPECT_EQ(mode_from(start, fold->value + 1e-4), section::periodic(1, 5));
  EXPECT_NE(mode_from(start, fold->value - 1e-4), section::periodic(1, 5));
  // On one side of the fold the orbits are stable, on the other they are not.
  const OrbitBranch& branch = study.branches.at(fold->branch);
  const bool has_stable =
      std::ranges::any_of(branch.points, [](const BranchPoint& point) { return point.orbit.stability.is_stable(); });
  const bool has_unstable =
      std::ranges::any_of(branch.points, [](const BranchPoint& point) { return !point.orbit.stability.is_stable(); });
  EXPECT_TRUE(has_stable && has_unstable);
}

// (1,5) loses its symmetry near A_h = 7.93. The two asymmetric orbits that begin there are stable, and a run above it
// ends on one of them.
TEST(Branches, BranchOffWhereSymmetryBreaks) {
  const std::vector<double> values{7.5, 8.0};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 5);
  const BranchStudy study = branches_of(amplitudes(values, {.low = 7.5, .high = 8.0}), found, {});
  const Bifurcation* breaking = find(study, BifurcationKind::symmetry_breaking);
  ASSERT_NE(breaking, nullptr);
  EXPECT_LE(breaking->error, 1e-8);
  // The multiplier of the period is the square of that of the half, which is -1.
  EXPECT_NEAR(breaking->orbit->stability.multipliers.at(0).real(), 1.0, 1e-6);
  const auto place = static_cast<std::size_t>(breaking - study.bifurcations.data());
  const auto child = std::ranges::find_if(study.branches, [&](const OrbitBranch& one) { return one.from == place; });
  ASSERT_NE(child, study.branches.end());
  EXPECT_FALSE(child->is_symmetric);
  EXPECT_TRUE(child->points.front().orbit.stability.is_stable());
  EXPECT_EQ(child->ends[0], BranchEnd::joins);
  EXPECT_EQ(mode_from(child->points.back().orbit.points.front().point, child->points.back().value),
            section::periodic(1, 5));
}

/// Friction 0.35/0.30, with the inertia about the edge and signed slip at impacts.
Condition as_plotted(double amplitude) {
  Condition condition = shaken(amplitude, Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.30});
  condition.scene.slide_inertia = dynamics::SlideInertia::edge;
  condition.scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  return condition;
}

// The symmetric (1,3) attracts up to A_h = 6.58. A run that starts on it below that stays (1,3); above, it moves away to
// three closed curves.
TEST(Branches, GiveWayToATorusWhereAPairOfMultipliersPassesTheUnitCircle) {
  std::vector<OrbitsOfCondition> found{orbits_of(as_plotted(6.6), 3)};
  const BranchStudy study = branches_of({.conditions = [](double value) { return std::optional(as_plotted(value)); },
                                         .values = {6.6},
                                         .range = {.low = 6.5, .high = 6.65},
                                         .most_points = 1000,
                                         .most_branches = 20},
                                        found, {});
  const Bifurcation* torus = find(study, BifurcationKind::neimark_sacker);
  ASSERT_NE(torus, nullptr);
  EXPECT_LE(torus->error, 1e-8);
  EXPECT_EQ(torus->orbit->period, 3);
  const auto& multipliers = torus->orbit->stability.multipliers;
  EXPECT_NE(multipliers.at(0).imag(), 0.0);
  EXPECT_NEAR(std::abs(multipliers.at(0)), 1.0, 1e-6);
  // The branch has saddles beside these orbits, up to a fold.
  for (const BranchPoint& point : study.branches.at(torus->branch).points) {
    const Stability& stability = point.orbit.stability;
    if (point.value == torus->value || stability.multipliers.front().imag() == 0.0) continue;
    EXPECT_EQ(stability.is_stable(), point.value < torus->value) << point.value;
  }
  const auto mode_at = [&](double amplitude) {
    Condition condition = as_plotted(amplitude);
    const section::StrobePoint& start = torus->orbit->points.front().point;
    condition.scene.initial = {.tilt = start.tilt, .tilt_rate = start.tilt_rate, .slip_rate = start.slip_rate};
    condition.horizon = {.transient_periods = 6000, .sampled_periods = 120};
    return realise(condition, 0, 0).classification.mode;
  };
  EXPECT_EQ(mode_at(torus->value - 0.005), section::periodic(1, 3));
  EXPECT_EQ(mode_at(torus->value + 0.02).kind, section::ResponseKind::quasi_periodic);
}

TEST(Branches, AreNotTracedTwiceAndFindTheOrbitsOfOtherConditions) {
  const std::vector<double> values{4.5, 4.75, 5.0};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 3);
  const std::size_t of_first = found[0].orbits.size();
  found[1].orbits.clear();  // the branches find them again
  const BranchStudy study = branches_of(amplitudes(values, {.low = 4.5, .high = 5.0}), found, {});
  EXPECT_TRUE(study.is_complete);
  EXPECT_GE(found[1].orbits.size(), 4U);
  EXPECT_LE(study.branches.size(), of_first);
  for (const Orbit& orbit : found[1].orbits) EXPECT_EQ(orbit.found_by, FoundBy::continuation);
  for (std::size_t i = 0; i < study.branches.size(); ++i) {
    for (const double value : values) {
      const auto at = [value](const BranchPoint& point) { return point.value == value; };
      const auto mine = std::ranges::find_if(study.branches[i].points, at);
      if (mine == study.branches[i].points.end()) continue;
      for (std::size_t j = i + 1; j < study.branches.size(); ++j) {
        for (const BranchPoint& other : study.branches[j].points) {
          if (!at(other)) continue;
          EXPECT_FALSE(is_same_cycle(mine->orbit.points, other.orbit.points)) << i << ' ' << j;
        }
      }
    }
  }
}

}  // namespace
}  // namespace rocking
