// Branches of periodic orbits: folds, doublings, broken symmetry, and changes of contact at the parameter where other
// computations find them.

#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/realisation/fixed_point.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/orbits/bracket.hpp"
#include "support/branches.hpp"

namespace rocking {
namespace {

using support::amplitudes;
using support::find;
using support::orbits_at;
using support::shaken;

TEST(Bracket, ContainsTheRootOfSmoothAndOfSteepFunctions) {
  const auto cubic = [](double x) { return std::optional((x - 0.3) * (x * x + 1.0)); };
  const auto step = [](double x) { return std::optional(x < 0.7 ? -1.0 : 1e6); };
  const auto ninth = [](double x) { return std::optional(std::pow(x - 0.2, 9.0)); };
  const auto root_of = [](const auto& function, int& evaluations) {
    const auto counted = [&](double x) {
      ++evaluations;
      return function(x);
    };
    return shorten({.low = 0.0, .high = 1.0, .at_low = *function(0.0), .at_high = *function(1.0)}, counted,
                   [](const Bracket& bracket) { return bracket.high - bracket.low < 1e-12; });
  };
  int smooth = 0;
  const Bracket of_cubic = root_of(cubic, smooth);
  EXPECT_LE(of_cubic.low, 0.3);
  EXPECT_GE(of_cubic.high, 0.3 - 1e-15);
  EXPECT_LT(smooth, 25);
  int steep = 0;
  const Bracket of_step = root_of(step, steep);
  EXPECT_NEAR(of_step.low, 0.7, 1e-12);
  EXPECT_NEAR(of_step.high, 0.7, 1e-12);
  int flat = 0;
  const Bracket of_ninth = root_of(ninth, flat);
  EXPECT_LE(of_ninth.low, 0.2 + 1e-15);
  EXPECT_GE(of_ninth.high, 0.2 - 1e-15);
  EXPECT_LT(std::max(steep, flat), 100);
}

TEST(MirroredHalf, AppliedTwiceIsTheMapOverThePeriods) {
  for (const std::optional<Friction>& friction :
       {std::optional<Friction>(), std::optional(Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.30})}) {
    Condition condition = shaken(4.5);
    condition.scene.friction = friction;
    const PoincareMap map(condition);
    for (const int periods : {1, 3, 5}) {
      const section::StrobePoint start{.tilt = 0.1, .tilt_rate = -0.3, .slip_rate = 0.0};
      const auto first = map.mirrored_half(start, periods);
      ASSERT_TRUE(first);
      const auto second = map.mirrored_half(first->end(), periods);
      const auto whole = map.image(start, periods);
      ASSERT_TRUE(second && whole);
      EXPECT_LT(distance(second->end(), whole->end()), 1e-9);
      EXPECT_EQ(first->impacts + second->impacts, whole->impacts);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
          double product = 0.0;
          for (std::size_t k = 0; k < 3; ++k) product += second->derivative[row][k] * first->derivative[k][column];
          EXPECT_NEAR(product, whole->derivative[row][column], 1e-6 * std::max(1.0, std::abs(product)));
        }
      }
    }
  }
}

TEST(MirroredHalf, IsOfNoBlockWhoseEdgesAreUnlike) {
  Condition condition = shaken(4.2);
  condition.scene.block.mass = GivenEdges{.edges = {0.5, 0.45}, .centre_height = 2.0, .radius_of_gyration = 1.1};
  const OrbitsOfCondition found = orbits_of(condition, 3);
  EXPECT_FALSE(found.orbits.empty());
  for (const Orbit& orbit : found.orbits) {
    EXPECT_FALSE(orbit.is_symmetric);
    EXPECT_FALSE(orbit.mirror);
  }
  EXPECT_FALSE(PoincareMap(condition).mirrored_half({.tilt = 0.1, .tilt_rate = -0.3, .slip_rate = 0.0}, 1));
}

TEST(ContactSequence, DoesNotDependOnWhereTheCycleBegins) {
  EXPECT_TRUE(is_same_sequence({1, 2, 3}, {3, 1, 2}));
  EXPECT_FALSE(is_same_sequence({1, 2, 3}, {3, 2, 1}));
  EXPECT_FALSE(is_same_sequence({1, 2}, {1, 2, 1, 2}));
  EXPECT_TRUE(is_same_sequence({}, {}));
  const ContactSequence some{0, 9, 17, 40};
  EXPECT_NE(mirrored(some), some);
  EXPECT_EQ(mirrored(mirrored(some)), some);
}

// A block at rest is set off where the base acceleration reaches tan(psi), A_h = tan(psi)/psi. There the branch of the
// block at rest changes its contacts.
TEST(Branches, OfTheBlockAtRestChangeWhereTheBaseOvercomesItsWeight) {
  const std::vector<double> values{0.9};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 1);
  const BranchStudy study = branches_of(amplitudes(values, {.low = 0.9, .high = 1.03}), found, {});
  const auto is_at_rest = [](const OrbitBranch& branch) {
    return std::ranges::any_of(branch.points, [](const BranchPoint& point) {
      return point.orbit.points.front().contact == dynamics::ContactState::rest;
    });
  };
  const auto rest = std::ranges::find_if(study.branches, is_at_rest);
  ASSERT_NE(rest, study.branches.end());
  const double threshold = 0.25 / std::atan(0.25);
  int at_threshold = 0;
  for (const Bifurcation& one : study.bifurcations) {
    if (std::abs(one.value - threshold) > 1e-3) continue;
    EXPECT_NEAR(one.value, threshold, 1e-8);
    EXPECT_LE(one.error, 1e-8);
    ++at_threshold;
  }
  EXPECT_EQ(at_threshold, 1);
}

// A branch of (1,3) ends at a grazing. Its orbit is followed there by bisection, with Newton's method for the map over
// three periods at fixed amplitudes alone.
TEST(Branches, GrazeWhereABisectionHasTheLastOrbit) {
  const std::vector<double> values{4.4};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 3);
  const BranchStudy study = branches_of(amplitudes(values, {.low = 4.35, .high = 4.55}), found, {});
  std::vector<const Bifurcation*> grazings;
  for (const Bifurcation& one : study.bifurcations) {
    if (one.kind == BifurcationKind::grazing && std::abs(one.value - 4.4645268) < 1e-5) grazings.push_back(&one);
  }
  ASSERT_FALSE(grazings.empty());
  const section::StrobePoint start = grazings.front()->orbit->points.front().point;
  double below = grazings.front()->value - 1e-6;
  double above = grazings.front()->value + 1e-6;
  const auto first = find_fixed_point(PoincareMap(shaken(below)), start, 3, {});
  ASSERT_TRUE(first);
  section::StrobePoint last = first->point;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (below + above);
    const auto fixed = find_fixed_point(PoincareMap(shaken(middle)), last, 3, {});
    const bool exists =
        fixed && is_same_sequence(fixed->image.sequence, first->image.sequence) && distance(fixed->point, last) < 1e-3;
    if (exists) last = fixed->point;
    (exists ? below : above) = middle;
  }
  for (const Bifurcation* one : grazings) {
    EXPECT_NEAR(one->value, below, 2e-10);
    EXPECT_LE(one->error, 1e-8);
  }
}

TEST(Branches, AreOrbitsAtEachOfTheirPoints) {
  const std::vector<double> values{4.5};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 3);
  const BranchStudy study = branches_of(amplitudes(values, {.low = 4.0, .high = 5.0}), found, {});
  ASSERT_FALSE(study.branches.empty());
  for (const OrbitBranch& branch : study.branches) {
    for (std::size_t i = 0; i < branch.points.size(); i += 5) {
      const BranchPoint& point = branch.points[i];
      const section::StrobePoint& start = point.orbit.points.front().point;
      const auto image = PoincareMap(shaken(point.value)).image(start, branch.period);
      ASSERT_TRUE(image);
      EXPECT_LT(distance(image->end(), start), 1e-9) << point.value;
    }
  }
}

TEST(Branches, AreLimitedAsAsked) {
  const std::vector<double> values{4.5};
  std::vector<OrbitsOfCondition> found = orbits_at(values, 3);
  BranchQuestion question = amplitudes(values, {.low = 4.0, .high = 5.0});
  question.most_branches = 1;
  question.most_points = 3;
  const BranchStudy study = branches_of(question, found, {});
  EXPECT_EQ(study.branches.size(), 1U);
  EXPECT_FALSE(study.is_complete);
  EXPECT_EQ(study.branches[0].ends[1], BranchEnd::points);
  EXPECT_LE(study.branches[0].points.size(), 12U);
}

TEST(Branches, AreFollowedOverNumbersOfTheMotionOnly) {
  EXPECT_TRUE(can_be_continued("/excitation/amplitude"));
  EXPECT_TRUE(can_be_continued("/friction/static"));
  EXPECT_FALSE(can_be_continued("/initial/tilt"));
  EXPECT_FALSE(can_be_continued("/horizon/sampled_periods"));
}

}  // namespace
}  // namespace rocking
