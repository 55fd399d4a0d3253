// Curves of bifurcations over two parameters: branches that are followed elsewhere cross them where they are.

#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/excitation.hpp"

namespace rocking {
namespace {

Condition shaken_at(double amplitude, double ratio) {
  Condition condition;
  support::harmonic(condition.scene) = {.amplitude = amplitude, .frequency_ratio = ratio, .phase = 0.0};
  return condition;
}

const ParameterRange amplitude_range{.low = 1.8, .high = 8.5};

/// From the orbits that are found at these amplitudes.
BranchStudy branches_at(double ratio, const std::vector<double>& amplitudes) {
  const BranchQuestion question{.conditions = [ratio](double value) { return std::optional(shaken_at(value, ratio)); },
                                .values = amplitudes,
                                .range = amplitude_range,
                                .most_points = 1000,
                                .most_branches = 40};
  std::vector<OrbitsOfCondition> found;
  for (const double amplitude : amplitudes) found.push_back(orbits_of(shaken_at(amplitude, ratio), 5));
  return branches_of(question, found, {});
}

CurveQuestion ratios(const ParameterRange& range, double ratio) {
  return {.conditions = [](double amplitude, double at) { return std::optional(shaken_at(amplitude, at)); },
          .ranges = {amplitude_range, range},
          .second = ratio,
          .most_points = 400};
}

// The ends of the curves are bifurcations at the ends of the range of the frequency ratio, which a study of branches
// there finds on its own.
TEST(BifurcationCurves, AreCrossedByTheBranchesOfOtherFrequencies) {
  const BranchStudy study = branches_at(10.0, {7.5});
  const auto curves = bifurcation_curves(ratios({.low = 10.0, .high = 10.3}, 10.0), study, {});
  const BranchStudy other = branches_at(10.3, {3.6, 7.5});  // the search finds (3,3) where it is stable
  int compared = 0;
  for (const BifurcationCurve& curve : curves) {
    for (const BifurcationPoint& point : curve.points) {
      EXPECT_LE(point.orbit.residual, 1e-10);
      EXPECT_LE(point.test, 1e-10);
      const auto one = std::ranges::min_element(point.orbit.stability.multipliers, {}, [&](const auto& multiplier) {
        return std::abs(multiplier - (curve.kind == BifurcationKind::period_doubling ? -1.0 : 1.0));
      });
      ASSERT_NE(one, point.orbit.stability.multipliers.end());
      EXPECT_NEAR(one->real(), curve.kind == BifurcationKind::period_doubling ? -1.0 : 1.0, 1e-6);
    }
    for (const BifurcationPoint* end : {&curve.points.front(), &curve.points.back()}) {
      if (end->second_value != 10.3) continue;
      double nearest = 1.0;
      for (const Bifurcation& one : other.bifurcations) {
        if (one.kind == curve.kind) nearest = std::min(nearest, std::abs(one.value - end->value));
      }
      EXPECT_LT(nearest, 1e-8) << to_string(curve.kind) << " at " << end->value;
      ++compared;
    }
  }
  EXPECT_GE(compared, 2);
}

TEST(BifurcationCurves, AreNotFollowedTwiceAndKeepTheKindOfTheirStart) {
  const BranchStudy study = branches_at(10.0, {7.5});
  const auto curves = bifurcation_curves(ratios({.low = 9.9, .high = 10.1}, 10.0), study, {});
  ASSERT_FALSE(curves.empty());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Bifurcation& from = study.bifurcations[curves[i].bifurcation];
    EXPECT_EQ(curves[i].kind, from.kind);
    double nearest = 1.0;
    for (const BifurcationPoint& point : curves[i].points) {
      if (point.second_value == 10.0) nearest = std::min(nearest, std::abs(point.value - from.value));
    }
    EXPECT_LT(nearest, 1e-8);
    for (std::size_t j = i + 1; j < curves.size(); ++j) EXPECT_NE(curves[i].bifurcation, curves[j].bifurcation);
  }
}

}  // namespace
}  // namespace rocking
