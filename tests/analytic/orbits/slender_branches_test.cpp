// Orbits, branches and bifurcations that are found, beside those of the slender-block limit, and the classes of orbits.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/orbits/slender_orbit.hpp"
#include "rocking/realisation/fixed_point.hpp"
#include "rocking/studies/orbits/orbit.hpp"
#include "rocking/studies/orbits/orbits.hpp"

namespace rocking::slender_limit {
namespace {

// Newton's method finds stable and unstable orbits alike. At H/B = 1e5 the map of the block differs by psi^2 = 1e-10
// times some tens. The trace contains 1/x, with x of about 0.01, and the multipliers are close to each other, so that
// they differ by up to 1e4 times more.
TEST(SlenderOrbit, IsFoundWithTheMultipliersOfTheClosedForm) {
  for (const Family& family : {Family{.r = 0.5, .omega = 5.0, .n = 1}, Family{.r = 0.7, .omega = 5.0, .n = 3},
                               Family{.r = 0.9, .omega = 10.0, .n = 5}}) {
    for (const double multiplier : {0.85, 1.1, -0.85, -1.1}) {
      const Orbit orbit = with_multiplier(family, multiplier);
      Condition condition = slender(orbit, 1e5, {}, 0.0);
      const auto found = find_fixed_point(PoincareMap(condition), on_section(orbit), family.n);
      ASSERT_TRUE(found) << name_of(orbit) << ", " << multiplier;
      EXPECT_LT(section::distance(found->point, on_section(orbit)), 1e-6);
      const Stability stability = stability_of(found->image);
      ASSERT_EQ(stability.multipliers.size(), 2U);
      const double other = family.r * family.r / multiplier;
      const double largest = std::max(multiplier * multiplier, other * other);
      EXPECT_NEAR(stability.multipliers[0].real(), largest, 1e-5) << name_of(orbit) << ", " << multiplier;
      EXPECT_EQ(stability.is_stable(), largest < 1.0);
      EXPECT_EQ(stability.kind, largest < 1.0 ? OrbitKind::node : OrbitKind::saddle);
    }
  }
}

/// The branch of the family over the amplitude, followed from its orbit with the multiplier 0.85 of the half.
BranchStudy branch_of(const Family& family) {
  const Orbit start = with_multiplier(family, 0.85);
  const double amplitude = family.amplitude(start.x);
  const BranchQuestion question{
      .conditions =
          [start](double value) {
            Condition condition = slender(start, 1e5, {}, 0.0);
            support::harmonic(condition.scene).amplitude = value;
            return std::optional(condition);
          },
      .values = {amplitude},
      .range = {.low = 0.9 * family.amplitude(family.x_fold()), .high = 1.1 * family.amplitude(family.x_symmetry())},
      .most_points = 400,
      .most_branches = 1};
  const PoincareMap map(*question.conditions(amplitude));
  std::vector<OrbitsOfCondition> found(1);
  const auto fixed = find_fixed_point(map, on_section(start), family.n);
  if (!fixed) return {};
  add_orbit(found[0], map, orbit_through(fixed->point, fixed->image, fixed->residual, FoundBy::grid), {});
  return branches_of(question, found, {});
}

// Bifurcations are located to 1e-8. At H/B = 1e5 the amplitudes of the block differ from those of the limit by
// psi^2 = 1e-10 times some tens.
TEST(SlenderOrbit, HasItsFoldAndItsLossOfSymmetryWhereTheClosedFormHasThem) {
  for (const Family& family : {Family{.r = 0.5, .omega = 5.0, .n = 1}, Family{.r = 0.7, .omega = 5.0, .n = 3},
                               Family{.r = 0.9, .omega = 10.0, .n = 5}}) {
    const BranchStudy study = branch_of(family);
    ASSERT_EQ(study.branches.size(), 1U) << family.omega;
    EXPECT_TRUE(study.branches[0].is_symmetric);
    int folds = 0;
    int losses = 0;
    for (const Bifurcation& one : study.bifurcations) {
      EXPECT_LE(one.error, 1e-8);
      if (one.kind == BifurcationKind::fold) {
        EXPECT_NEAR(one.value, family.amplitude(family.x_fold()), 2e-8) << family.omega;
        ++folds;
      } else if (one.kind == BifurcationKind::symmetry_breaking) {
        EXPECT_NEAR(one.value, family.amplitude(family.x_symmetry()), 2e-8) << family.omega;
        ++losses;
      }
    }
    EXPECT_EQ(folds, 1) << family.omega;
    EXPECT_EQ(losses, 1) << family.omega;
    for (const BranchPoint& point : study.branches[0].points) {
      if (!point.orbit.stability.is_stable()) continue;
      EXPECT_GT(point.value, family.amplitude(family.x_fold()) - 1e-7);
      EXPECT_LT(point.value, family.amplitude(family.x_symmetry()) + 1e-7);
    }
  }
}

/// Whether there is no impact in between: Theta > 0 throughout a half cycle.
bool stays_on_its_side(const Orbit& orbit) {
  for (int i = 1; i < 200; ++i) {
    if (orbit.at(orbit.family.h() * i / 200.0).tilt <= 0.0) return false;
  }
  return orbit.x > 0.0 && orbit.v() > 0.0;
}

/// Classification of the response of a block that starts on an orbit.
section::Classification classification_on(const Orbit& orbit) {
  const State start = orbit.at(0.5 * orbit.family.h());
  const double phase = orbit.phase() + 0.5 * orbit.family.omega * orbit.family.h();
  return realise_unchecked(slender(orbit, 1e4, start, phase), 0, 0).classification;
}

// A truth set without noise: (1,n) wherever the closed form has a stable orbit, over its whole range. The start differs
// from the orbit of the block by about psi^2 = 1e-8, far inside the basin, which for long flights is as small as 1 %.
// Near the fold (eigenvalue 0.99) the basin and the tolerance of the classification shrink together; there the response
// may be unresolved, but not wrong.
TEST(SlenderOrbit, IsClassifiedByItsPeriodAllOverItsStableRange) {
  int inside = 0;
  int near_an_end = 0;
  int open_near_an_end = 0;
  for (const double r : {0.5, 0.6, 0.7, 0.8, 0.9, 0.912}) {
    for (const double omega : {4.0, 5.0, 7.0, 10.0, 15.0}) {
      for (const int n : {1, 3, 5}) {
        for (const double multiplier : {0.99, 0.9, 0.8, -0.8, -0.9, -0.99}) {
          const Family family{.r = r, .omega = omega, .n = n};
          const Orbit orbit = with_multiplier(family, multiplier);
          if (std::abs(multiplier) < r * r || !stays_on_its_side(orbit)) continue;
          const section::Classification classification = classification_on(orbit);
          const std::string where = name_of(orbit) + ", multiplier " + std::to_string(multiplier) + ": " +
                                    to_string(classification.mode) + ' ' +
                                    (classification.reason ? std::string(to_string(*classification.reason)) : "");
          const bool right = classification.mode == section::periodic(1, n);
          if (std::abs(multiplier) < 0.95) {
            EXPECT_TRUE(right) << where;
            ++inside;
          } else {
            EXPECT_TRUE(right || classification.mode.kind == section::ResponseKind::unresolved) << where;
            ++near_an_end;
            open_near_an_end += right ? 0 : 1;
          }
        }
      }
    }
  }
  std::printf("inside %d, near an end %d, of which unresolved %d\n", inside, near_an_end, open_near_an_end);
  EXPECT_GT(inside, 100);
  EXPECT_GT(near_an_end, 50);
}

/// Largest difference between h and the time from one impact to the next, over the last 20 of 400 periods; h if the
/// block no longer rocks.
double irregularity(const Family& family, double amplitude) {
  const Orbit fold{family, family.x_fold()};
  Condition condition =
      slender(fold, 1000.0, fold.at(0.5 * family.h()), fold.phase() + 0.5 * family.omega * family.h());
  support::harmonic(condition.scene).amplitude = amplitude;
  const Trajectory trajectory = trajectory_of_unchecked(condition, 0, 0, 400 * family.n);
  const double late = 380.0 * 2.0 * family.h();
  double last = late;
  double largest = 0.0;
  for (const TrajectoryEvent& event : trajectory.events) {
    if (event.tau < late || event.kind != dynamics::EventKind::impact_stick) continue;
    if (last > late) largest = std::max(largest, std::abs(event.tau - last - family.h()));
    last = event.tau;
  }
  return last > late ? largest : family.h();
}

// Above the fold the block settles on the orbit, to order psi^2. Below it there is no such orbit and the block moves
// otherwise.
TEST(SlenderOrbit, ExistsFromTheFoldOn) {
  for (const Family& family : {Family{.r = 0.5, .omega = 5.0, .n = 1}, Family{.r = 0.7, .omega = 10.0, .n = 1},
                               Family{.r = 0.7, .omega = 10.0, .n = 3}, Family{.r = 0.9, .omega = 10.0, .n = 5}}) {
    const double fold = family.amplitude(family.x_fold());
    EXPECT_LT(irregularity(family, 1.02 * fold), 1e-9) << family.omega << " " << family.n;
    EXPECT_GT(irregularity(family, 0.98 * fold), 0.01) << family.omega << " " << family.n;
  }
}

}  // namespace
}  // namespace rocking::slender_limit
