// The slender-block limit under harmonic excitation: phase, amplitude, range and stability of symmetric (1,n) orbits in
// closed form. Derived in reports/evidence/closed-forms.md, whose symbols are used here.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/tangent_motion.hpp"
#include "rocking/studies/orbits/fixed_point.hpp"
#include "rocking/studies/orbits/orbit.hpp"
#include "rocking/studies/orbits/orbits.hpp"
#include "support/event_log.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

/// Orbits with a period of n excitation periods and the rate ratio r of each impact.
struct Family {
  double r;
  double omega;
  int n;

  [[nodiscard]] double h() const { return n * pi / omega; }
  [[nodiscard]] double t() const { return std::tanh(0.5 * h()); }
  [[nodiscard]] double rho() const { return (1.0 + r) / (1.0 - r); }
  [[nodiscard]] double x_fold() const { return rho() / (omega * omega + rho() * rho() / (t() * t())); }
  [[nodiscard]] double x_symmetry() const { return rho() / (rho() * rho() + omega * omega + 1.0 - 1.0 / (t() * t())); }
  [[nodiscard]] double amplitude(double x) const {
    return (1.0 + omega * omega) * std::hypot(x, (t() - rho() * x / t()) / omega);
  }
};

struct State {
  double tilt;
  double rate;
};

/// The orbit of the family with Gamma sin(phi) = x.
struct Orbit {
  Family family;
  double x;

  [[nodiscard]] double y() const { return family.t() - family.rho() * x / family.t(); }
  [[nodiscard]] double v() const { return (family.rho() - 1.0) * x / family.t(); }
  [[nodiscard]] double phase() const { return std::atan2(x, y() / family.omega); }

  /// State at a time u in [0, h] after the impact that put the block on its left edge.
  [[nodiscard]] State at(double u) const {
    const double c = x - 1.0;
    const double d = v() + y();
    const double gamma = std::hypot(x, y() / family.omega);
    const double angle = family.omega * u + phase();
    return {1.0 + c * std::cosh(u) + d * std::sinh(u) - gamma * std::sin(angle),
            c * std::sinh(u) + d * std::cosh(u) - gamma * family.omega * std::cos(angle)};
  }

  /// State at any time: the second half of the orbit mirrors the first.
  [[nodiscard]] State later(double u) const {
    const double within = std::fmod(u, 2.0 * family.h());
    if (within <= family.h()) return at(within);
    const State mirrored = at(within - family.h());
    return {-mirrored.tilt, -mirrored.rate};
  }

  /// Time of the largest Theta: the best of many instants, refined by bisection of the slope.
  [[nodiscard]] double peak() const {
    double best = 0.5 * family.h();
    for (int i = 1; i < 200; ++i) {
      const double u = family.h() * i / 200.0;
      if (at(u).tilt > at(best).tilt) best = u;
    }
    double low = best - family.h() / 200.0;
    double high = best + family.h() / 200.0;
    while (high - low > 1e-15) {
      const double middle = 0.5 * (low + high);
      (at(middle).rate > 0.0 ? low : high) = middle;
    }
    return low;
  }

  /// Trace of the linearised map from one impact to the next; the determinant is r^2.
  [[nodiscard]] double trace() const {
    const double r = family.r;
    return 1.0 + r * r + 0.5 * (1.0 - r * r) * (std::cosh(family.h()) - 1.0) * (1.0 / x - 1.0 / family.x_fold());
  }
};

/// The orbit at this share of the range between the fold and the loss of symmetry.
Orbit stable(const Family& family, double share) {
  return {family, family.x_fold() * (1.0 - share) + family.x_symmetry() * share};
}

std::vector<Orbit> stable_orbits() {
  return {stable({.r = 0.5, .omega = 5.0, .n = 1}, 0.4),     stable({.r = 0.912, .omega = 10.0, .n = 1}, 0.1),
          stable({.r = 0.7, .omega = 4.0, .n = 1}, 0.6),     stable({.r = 0.7, .omega = 5.0, .n = 3}, 0.5),
          stable({.r = 0.912, .omega = 10.0, .n = 3}, 0.25), stable({.r = 0.9, .omega = 10.0, .n = 5}, 0.4)};
}

/// A block of height `height` times its width with the initial state `start` and impacts of ratio r. e is chosen such
/// that delta = r; it may lie outside the range allowed in experiments.
Condition slender(const Orbit& orbit, double height, const State& start, double phase) {
  Condition condition;
  Scene& scene = condition.scene;
  scene.block.height = height;
  const double sine = dynamics::geometry_of(mean_block(scene)).sine;
  scene.restitution = (1.0 - orbit.family.r) / (1.5 * sine * sine) - 1.0;
  support::harmonic(scene).amplitude = orbit.family.amplitude(orbit.x);
  support::harmonic(scene).frequency_ratio = orbit.family.omega;
  support::harmonic(scene).phase = phase;
  scene.initial = {.tilt = start.tilt, .tilt_rate = start.rate, .slip_rate = 0.0};
  return condition;
}

/// Largest difference between the full block and the orbit on which it starts, over 8 n periods: states at the strobe
/// points, times of impacts and the rates after them.
double departure(const Orbit& orbit, double height, double start) {
  const Family& family = orbit.family;
  const Condition condition = slender(orbit, height, orbit.at(start), orbit.phase() + family.omega * start);
  const Trajectory trajectory = trajectory_of_unchecked(condition, 0, 0, 8 * family.n);
  double largest = 0.0;
  for (const TrajectorySample& sample : trajectory.strobe) {
    if (start != 0.5 * family.h() && sample.period % family.n != 0) continue;  // may lie next to an impact
    const State exact = orbit.later(start + 2.0 * pi / family.omega * static_cast<double>(sample.period));
    largest = std::max({largest, std::abs(sample.tilt - exact.tilt), std::abs(sample.tilt_rate - exact.rate)});
  }
  double impact = family.h() - start;
  double rate = -orbit.v();
  for (const TrajectoryEvent& event : trajectory.events) {
    if (event.kind == dynamics::EventKind::past_balance) continue;
    largest = std::max({largest, std::abs(event.tau - impact), std::abs(event.tilt_rate - rate)});
    impact += family.h();
    rate = -rate;
  }
  return trajectory.events.size() < 15 ? 1e9 : largest;
}

std::string name_of(const Orbit& orbit) {
  return "r = " + std::to_string(orbit.family.r) + ", Omega = " + std::to_string(orbit.family.omega) +
         ", n = " + std::to_string(orbit.family.n);
}

// The full equations differ from the limit by terms of relative size psi^2, psi^4, ..., and so does their orbit. The
// difference over psi^2 is therefore of order one and independent of H/B, except for a relative change of order psi^2.
TEST(SlenderOrbit, IsKeptByTheFullBlockUpToTheSquareOfTheShapeAngle) {
  for (const Orbit& orbit : stable_orbits()) {
    for (const double start : {0.5 * orbit.family.h(), orbit.peak()}) {
      double last = 0.0;
      double last_square = 0.0;
      for (const double height : {10.0, 20.0, 50.0, 100.0, 1000.0}) {
        const double square = 1.0 / (height * height);
        const double share = departure(orbit, height, start) / square;
        EXPECT_LT(share, 2.0) << name_of(orbit) << ", H/B = " << height;
        if (last > 0.0) {
          EXPECT_NEAR(last / share, 1.0, last_square) << name_of(orbit) << ", H/B = " << height;
        }
        last = share;
        last_square = square;
      }
    }
  }
}

/// Result of a small change of phase (1, 0) or rate (0, 1) after a number of impacts.
struct Change {
  double phase;
  double rate;

  [[nodiscard]] double size() const { return std::hypot(phase, rate); }
};

/// The closed form: the linearised map from one impact to the next, in a frame that is mirrored at each impact.
Change next_in_the_limit(const Orbit& orbit, const Change& change) {
  const Family& family = orbit.family;
  const double c = std::cosh(family.h());
  const double s = std::sinh(family.h());
  const double x = orbit.x;
  const double share = orbit.y() / family.omega;
  const double tilt = (share * (c + 1.0) - family.omega * x * s) * change.phase + s * change.rate;
  const double rate = (share * s - family.omega * x * (c + 1.0)) * change.phase + c * change.rate;
  const double delay = family.r / orbit.v() * tilt;
  const double pull = 1.0 + (1.0 + family.omega * family.omega) * x;
  return {change.phase + family.omega * delay, family.r * (pull * delay - rate)};
}

/// The same for the full block: central differences of two runs that start just after an impact, changed by `step`
/// times `change`.
std::vector<Change> changes_of_the_block(const Orbit& orbit, double height, const Change& change, int impacts) {
  constexpr double step = 1e-6;
  std::array<std::vector<Change>, 2> found;
  for (std::size_t i = 0; i < 2; ++i) {
    const double size = i == 0 ? step : -step;
    const double start = orbit.phase() + size * change.phase;
    const Condition condition = slender(orbit, height, {0.0, orbit.v() + size * change.rate}, start);
    for (const TrajectoryEvent& event :
         trajectory_of_unchecked(condition, 0, 0, (impacts + 1) * orbit.family.n).events) {
      if (event.kind != dynamics::EventKind::impact_stick) continue;
      found[i].push_back({orbit.family.omega * event.tau + start, std::abs(event.tilt_rate)});
    }
  }
  std::vector<Change> changes;
  for (std::size_t k = 0; k < std::min(found[0].size(), found[1].size()); ++k) {
    changes.push_back(
        {(found[0][k].phase - found[1][k].phase) / (2.0 * step), (found[0][k].rate - found[1][k].rate) / (2.0 * step)});
  }
  return changes;
}

/// Largest difference between the two over the first five impacts, relative to the largest change.
double error_of_the_map(const Orbit& orbit, double height) {
  double largest = 0.0;
  for (const Change& start : {Change{1.0, 0.0}, Change{0.0, 1.0}}) {
    const std::vector<Change> changes = changes_of_the_block(orbit, height, start, 5);
    Change exact = start;
    for (std::size_t k = 0; k < 5; ++k) {
      exact = next_in_the_limit(orbit, exact);
      const double error = Change{changes.at(k).phase - exact.phase, changes[k].rate - exact.rate}.size();
      largest = std::max(largest, error / exact.size());
    }
  }
  return largest;
}

// Over psi^2 the error is constant, except for terms of order psi^2 (about ten times 4e-4) and the rounding of the
// differences (1e-13/1e-6, which is 1e-3 of an error of 1e-4).
TEST(SlenderOrbit, HasTheReturnMapOfTheClosedFormUpToTheSquareOfTheShapeAngle) {
  for (const Orbit& orbit : stable_orbits()) {
    const double coarse = error_of_the_map(orbit, 50.0) * 50.0 * 50.0;
    const double fine = error_of_the_map(orbit, 200.0) * 200.0 * 200.0;
    EXPECT_LT(coarse, 100.0) << name_of(orbit);
    EXPECT_NEAR(coarse / fine, 1.0, 0.01) << name_of(orbit);
  }
}

TEST(SlenderOrbit, HasTheDeterminantAndTraceOfTheDerivation) {
  for (const Orbit& orbit : stable_orbits()) {
    const Change phase = next_in_the_limit(orbit, {1.0, 0.0});
    const Change rate = next_in_the_limit(orbit, {0.0, 1.0});
    const double scale = 1e-14 * (1.0 + std::abs(phase.phase * rate.rate) + std::abs(phase.rate * rate.phase));
    EXPECT_NEAR(phase.phase * rate.rate - phase.rate * rate.phase, orbit.family.r * orbit.family.r, scale);
    EXPECT_NEAR(phase.phase + rate.rate, orbit.trace(), scale) << name_of(orbit);
  }
}

/// Trace and determinant of the map over the whole orbit, from the tangent flow of the full block.
struct WholeMap {
  double trace;
  double determinant;
};

WholeMap map_of_the_block(const Orbit& orbit, double height) {
  const double start = 0.5 * orbit.family.h();
  const Condition condition = slender(orbit, height, orbit.at(start), orbit.phase() + orbit.family.omega * start);
  const random::Draws draws(0, 0);
  const Beginning beginning =
      begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::start, orbit.family.n);
  support::EventLog log;
  TangentMotion<Motion, 2> motion(motion_of(condition.scene, beginning, log), {{{.tilt = 1.0}, {.tilt_rate = 1.0}}});
  integrate::advance(motion);
  const auto& [by_tilt, by_rate] = motion.at_strobe();
  return {.trace = by_tilt.tilt + by_rate.tilt_rate,
          .determinant = by_tilt.tilt * by_rate.tilt_rate - by_tilt.tilt_rate * by_rate.tilt};
}

// The orbit consists of two halves that mirror each other, each with determinant r^2. The largest entry of the matrix
// is about cosh(2 h), and psi^2 is 1e-8.
TEST(SlenderOrbit, HasTheMonodromyMatrixOfTheClosedForm) {
  for (const Orbit& orbit : stable_orbits()) {
    const double square = orbit.family.r * orbit.family.r;
    const WholeMap found = map_of_the_block(orbit, 1e4);
    const double size = std::cosh(2.0 * orbit.family.h());
    EXPECT_NEAR(found.trace, orbit.trace() * orbit.trace() - 2.0 * square, 1e-5 * size) << name_of(orbit);
    EXPECT_NEAR(found.determinant, square * square, 1e-12 * size) << name_of(orbit);
  }
}

/// Factor by which a change grows or decays from one impact of the full block to the next: the mean from the 60th to
/// the 90th impact, when only the slower direction remains (the factor of the other one is r^2 over this one).
double multiplier_of_the_block(const Orbit& orbit) {
  const std::vector<Change> changes = changes_of_the_block(orbit, 1e5, {0.3, 1.0}, 90);
  return std::pow(changes.at(89).size() / changes.at(59).size(), 1.0 / 30.0);
}

/// The orbit of the family whose larger eigenvalue is `multiplier`.
Orbit with_multiplier(const Family& family, double multiplier) {
  const double square = family.r * family.r;
  const double trace = multiplier + square / multiplier;
  const double excess = 2.0 * (trace - 1.0 - square) / ((1.0 - square) * (std::cosh(family.h()) - 1.0));
  return {family, 1.0 / (excess + 1.0 / family.x_fold())};
}

// On both sides of each end of the stable range, where the eigenvalue of the closed form is 0.98 or 1.02 in magnitude:
// on the two branches that meet in the fold, where it passes 1, and near the loss of symmetry, where it passes -1. At
// H/B = 1e5 the map of the block differs by psi^2 = 1e-10 times some tens. Near the fold, at a distance of 1e-4 in x,
// its orbit differs by 1e-10/1e-4. This grows by 1.02 per impact and changes the eigenvalue's distance from 1 by about
// 1e-2 of it. The test allows a twentieth.
TEST(SlenderOrbit, GainsAndLosesStabilityAtTheClosedFormsEnds) {
  for (const Family& family : {Family{.r = 0.5, .omega = 5.0, .n = 1}, Family{.r = 0.7, .omega = 4.0, .n = 1},
                               Family{.r = 0.7, .omega = 5.0, .n = 3}, Family{.r = 0.7, .omega = 10.0, .n = 3},
                               Family{.r = 0.9, .omega = 10.0, .n = 5}}) {
    for (const double multiplier : {0.98, 1.02, -0.98, -1.02}) {
      const Orbit orbit = with_multiplier(family, multiplier);
      const bool is_inside = orbit.x > family.x_fold() && orbit.x < family.x_symmetry();
      EXPECT_EQ(std::abs(multiplier) < 1.0, is_inside) << name_of(orbit) << ", x = " << orbit.x;
      EXPECT_NEAR(multiplier_of_the_block(orbit), std::abs(multiplier), 1e-3) << name_of(orbit) << ", x = " << orbit.x;
    }
  }
}

/// The state of the orbit where the argument of its excitation is a multiple of 2 pi.
section::StrobePoint on_section(const Orbit& orbit) {
  double time = -orbit.phase() / orbit.family.omega;
  while (time < 0.0) time += 2.0 * pi / orbit.family.omega;
  const State state = orbit.later(time);
  return {.tilt = state.tilt, .tilt_rate = state.rate, .slip_rate = 0.0};
}

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
      EXPECT_LT(rocking::distance(found->point, on_section(orbit)), 1e-6);
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

/// Curves of the bifurcations of the family's branch over the frequency ratio, between 0.9 and 1.1 of its own. The block
/// and the rate ratio stay.
std::vector<BifurcationCurve> curves_of(const Family& family, const BranchStudy& study, const ParameterRange& first) {
  const Orbit start = with_multiplier(family, 0.85);
  const CurveQuestion question{.conditions =
                                   [start](double amplitude, double omega) {
                                     Condition condition = slender(start, 1e5, {}, 0.0);
                                     support::harmonic(condition.scene).amplitude = amplitude;
                                     support::harmonic(condition.scene).frequency_ratio = omega;
                                     return std::optional(condition);
                                   },
                               .ranges = {first, {.low = 0.9 * family.omega, .high = 1.1 * family.omega}},
                               .second = family.omega,
                               .most_points = 300};
  return bifurcation_curves(question, study, {});
}

// The curves of the block differ from those of the limit as the bifurcations of a branch do.
TEST(SlenderOrbit, HasItsCurvesOfFoldsAndLossesOfSymmetryWhereTheClosedFormHasThem) {
  for (const Family& family : {Family{.r = 0.5, .omega = 5.0, .n = 1}, Family{.r = 0.7, .omega = 5.0, .n = 3},
                               Family{.r = 0.9, .omega = 10.0, .n = 5}}) {
    const ParameterRange range{.low = 0.5 * family.amplitude(family.x_fold()),
                               .high = 2.0 * family.amplitude(family.x_symmetry())};
    const std::vector<BifurcationCurve> curves = curves_of(family, branch_of(family), range);
    ASSERT_EQ(curves.size(), 2U) << family.omega;
    for (const BifurcationCurve& curve : curves) {
      const bool is_fold = curve.kind == BifurcationKind::fold;
      EXPECT_TRUE(is_fold || curve.kind == BifurcationKind::symmetry_breaking);
      const std::string where = std::to_string(family.omega) + ' ' + std::string(to_string(curve.kind)) + " from " +
                                std::to_string(curve.points.front().second_value) + " to " +
                                std::to_string(curve.points.back().second_value);
      EXPECT_EQ(to_string(curve.ends[0]), "range") << where;
      EXPECT_EQ(to_string(curve.ends[1]), "range") << where;
      EXPECT_NEAR(std::abs(curve.points.back().second_value - curve.points.front().second_value), 0.2 * family.omega,
                  1e-12);
      double largest = 0.0;
      for (const BifurcationPoint& point : curve.points) {
        const Family here{.r = family.r, .omega = point.second_value, .n = family.n};
        const double exact = here.amplitude(is_fold ? here.x_fold() : here.x_symmetry());
        largest = std::max(largest, std::abs(point.value - exact));
        EXPECT_LE(point.orbit.residual, 1e-10);
        EXPECT_LE(point.test, 1e-10);
      }
      EXPECT_LT(largest, 2e-8) << where;
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
}  // namespace rocking
