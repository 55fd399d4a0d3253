// Ends of branches of periodic orbits: the same over any range of the parameter, and where computations that are singular
// nowhere find them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/studies/orbits/orbits.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

/// Where branches begin.
struct BranchStart {
  double amplitude;
  int longest = 3;  ///< periods of the orbits there
  std::size_t most_branches = 6;
};

BranchStudy first_branches(const BranchStart& start, const ParameterRange& range,
                           std::optional<Friction> friction = {}) {
  const ConditionFamily conditions = [friction](double amplitude) {
    Condition condition;
    support::harmonic(condition.scene) = {.amplitude = amplitude, .frequency_ratio = 10.0, .phase = 0.0};
    condition.scene.friction = friction;
    return std::optional(condition);
  };
  std::vector<OrbitsOfCondition> found{orbits_of(*conditions(start.amplitude), start.longest)};
  return branches_of({.conditions = conditions,
                      .values = {start.amplitude},
                      .range = range,
                      .most_points = 1000,
                      .most_branches = start.most_branches},
                     found, {});
}

/// Each bifurcation of a kind next to a value has it within its error, which is small, and there is one.
void expect_at(const BranchStudy& study, BifurcationKind kind, double value, double largest_error) {
  int near = 0;
  for (const Bifurcation& one : study.bifurcations) {
    if (one.kind != kind || std::abs(one.value - value) > 1e-4) continue;
    EXPECT_LE(std::abs(one.value - value), one.error) << value;
    EXPECT_LE(one.error, largest_error) << value;
    ++near;
  }
  EXPECT_GE(near, 1) << to_string(kind) << " at " << value;
}

/// Branches without sliding over three ranges; they are followed once for all tests.
const std::vector<BranchStudy>& over_three_ranges() {
  static const std::vector<BranchStudy> studies{first_branches({3.8}, {.low = 3.5, .high = 4.55}),
                                                first_branches({3.8}, {.low = 3.5, .high = 6.0}),
                                                first_branches({3.8}, {.low = 0.5, .high = 12.0})};
  return studies;
}

// The values: orbits that start and end at the instant at which theta and its rate are 0, by Newton's method for that
// instant and the amplitude, with Taylor steps in long double. Nothing is singular there. The branches stop before them:
// that of (3,3) at 4.46413 to 4.46415, where rates are below 2e-4 and multipliers up to 1e8.
TEST(EndsOfBranches, GrazeWhereOrbitsFromTheGrazingInstantOnDo) {
  for (const BranchStudy& study : over_three_ranges()) {
    expect_at(study, BifurcationKind::grazing, 4.464526827450001, 1e-10);  // (1,3)
    expect_at(study, BifurcationKind::grazing, 4.464151721776603, 1e-10);  // (3,3)
    expect_at(study, BifurcationKind::grazing, 4.157677811037453, 1e-10);  // (3,3) that is not symmetric
  }
}

// Where a friction limit is grazed, the map jumps, and the orbit that slips must be approached from its own side.
TEST(EndsOfBranches, GrazeAFrictionLimitAtTheSameValueOverAnyRange) {
  const Friction friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  for (const ParameterRange& range :
       {ParameterRange{.low = 3.5, .high = 5.0}, {.low = 3.8, .high = 6.5}, {.low = 1.0, .high = 10.0}}) {
    expect_at(first_branches({4.5}, range, friction), BifurcationKind::grazing, 4.00118528474068, 1e-10);
  }
}

// Runs over three ranges stopped at 4.10, 4.13 and 4.15, at rates of 5e-3 and multipliers of 1e7: rounding, no grazing.
TEST(EndsOfBranches, EndAtTheirLastPointWhereNothingIsLocated) {
  for (const BranchStudy& study : over_three_ranges()) {
    for (const Bifurcation& one : study.bifurcations) {
      EXPECT_FALSE(one.kind == BifurcationKind::grazing && one.orbit->period == 6) << one.value;
    }
    for (std::size_t i = 0; i < study.branches.size(); ++i) {
      const OrbitBranch& branch = study.branches[i];
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (branch.ends[end] != BranchEnd::grazing) continue;
        const double last = (end == 0 ? branch.points.front() : branch.points.back()).value;
        const bool is_located = std::ranges::any_of(study.bifurcations, [&](const Bifurcation& one) {
          return one.kind == BifurcationKind::grazing && one.branch == i && std::abs(one.value - last) < 1e-3;
        });
        EXPECT_TRUE(is_located) << i << ' ' << last;
      }
    }
  }
}

// The value: the orbit from impact to impact whose map has the multiplier -1, in 34 digits. The branches that begin there
// are nearly singular next to it.
TEST(EndsOfBranches, LoseTheirSymmetryAtTheSameValueOverAnyRange) {
  for (const ParameterRange& range :
       {ParameterRange{.low = 7.5, .high = 8.0}, {.low = 7.0, .high = 9.0}, {.low = 0.5, .high = 12.0}}) {
    const BranchStart start{.amplitude = 8.0, .longest = 5, .most_branches = 4};
    expect_at(first_branches(start, range), BifurcationKind::symmetry_breaking, 7.931804354155346, 1e-10);
  }
}

}  // namespace
}  // namespace rocking
