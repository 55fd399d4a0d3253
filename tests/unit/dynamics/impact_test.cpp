// The impact, compared with the laws of momentum and with its closed forms.

#include "rocking/dynamics/impact.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

/// An impact with both coefficients of friction given.
struct Landing {
  double tilt_rate;
  double slip_rate;
  double restitution;
  double static_friction;
  double kinetic_friction;
};

ImpactOutcome resolve_impact(const Landing& landing, const Geometry& block, ImpactSlipRule rule) {
  const ImpactConditions before{.tilt_rate = landing.tilt_rate,
                                .slip_rate = landing.slip_rate,
                                .restitution = landing.restitution,
                                .static_friction = landing.static_friction};
  const auto sticks = sticking_impact(before, block, rule);
  return sticks ? *sticks : slipping_impact(before, landing.kinetic_friction, block);
}

struct Impulse {
  double x;
  double y;
};

/// Change of the momentum of the centre of mass over m R p, from the velocities of lib/docs/model.md, section 4.
Impulse impulse_of(const Landing& before, const ImpactOutcome& after, const Geometry& block) {
  const double sigma = before.tilt_rate < 0.0 ? -1.0 : 1.0;
  const double size = std::abs(before.tilt_rate);
  return {
      .x = (after.slip_rate - after.tilt_rate * block.cosine) - (before.slip_rate - before.tilt_rate * block.cosine),
      .y = block.sine * (2.0 * before.restitution * size + sigma * after.tilt_rate + size)};
}

/// Kinetic energy over m R^2 p^2 in the frame of the base, for a block on one edge.
double energy_of(double tilt_rate, double slip_rate, const Geometry& block) {
  const double x = slip_rate - tilt_rate * block.cosine;
  const double y = tilt_rate * block.sine;
  return 0.5 * (x * x + y * y + tilt_rate * tilt_rate / 3.0);
}

struct RandomImpact {
  Geometry block;
  Landing before;
};

RandomImpact random_impact(support::SplitMix& draw) {
  const Geometry block = geometry_of({.width = 1.0, .height = std::exp2(draw.uniform(-1.0, 4.0))});
  const double mu_s = draw.uniform(0.0, 1.0);
  return {block,
          {.tilt_rate = draw.uniform(-1.0, 1.0),
           .slip_rate = draw.below(3) == 0 ? 0.0 : draw.uniform(-1.0, 1.0) * std::exp2(draw.uniform(-20.0, 1.0)),
           .restitution = draw.below(2) == 0 ? 0.0 : draw.uniform(-0.999, 1.0),
           .static_friction = mu_s,
           .kinetic_friction = draw.below(3) == 0 ? mu_s : mu_s * draw.uniform()}};
}

/// Impulses and rates here are of order one: a few dozen roundings.
constexpr double rounding = 64.0 * 0x1p-52;

TEST(Impact, WithoutSlipKeepsHousnersRatio) {
  for (const double height : {0.5, 1.0, 2.0, 4.0, 10.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height});
    const double ratio = 1.0 - 1.5 * block.sine * block.sine;
    const ImpactOutcome after = resolve_impact({-0.3, 0.0, 0.0, 10.0, 0.0}, block, ImpactSlipRule::absolute);
    EXPECT_EQ(after.kind, ImpactKind::stick);
    EXPECT_EQ(after.slip_rate, 0.0);
    EXPECT_NEAR(after.tilt_rate, -0.3 * ratio, rounding) << "H/B = " << height;
  }
}

TEST(Impact, OfTheReferenceBlockKeeps0p912) {
  const Geometry block = geometry_of({.width = 1.0, .height = 4.0});
  EXPECT_NEAR(sticking_tilt_rate({.tilt_rate = 1.0, .slip_rate = 0.0}, 0.0, block), 31.0 / 34.0, 1e-15)
      << "1 - (3/2)/17";
  EXPECT_NEAR(sticking_tilt_rate({.tilt_rate = 1.0, .slip_rate = 0.0}, 31.0 / 34.0, block), 0.831, 5e-4)
      << "the paper's e in the paper's equation";
}

TEST(Impact, ObeysTheLawsOfMomentum) {
  support::SplitMix draw(4);
  for (int i = 0; i < 200'000; ++i) {
    const auto [block, before] = random_impact(draw);
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::absolute);
    ASSERT_NE(after.kind, ImpactKind::painleve) << "impact " << i << ": mu_k is below 4/3";
    const Impulse impulse = impulse_of(before, after, block);
    const double sigma = before.tilt_rate < 0.0 ? -1.0 : 1.0;
    ASSERT_NEAR((after.tilt_rate - before.tilt_rate) / 3.0, block.cosine * impulse.x - sigma * block.sine * impulse.y,
                rounding)
        << "moment of momentum, impact " << i;
    if (after.kind == ImpactKind::stick) {
      ASSERT_EQ(after.slip_rate, 0.0);
      ASSERT_LE(std::abs(impulse.x), before.static_friction * impulse.y + rounding) << "impact " << i;
    } else if (after.slip_rate != 0.0) {
      const double direction = after.slip_rate < 0.0 ? -1.0 : 1.0;
      ASSERT_NEAR(impulse.x, -direction * before.kinetic_friction * impulse.y, rounding) << "impact " << i;
    }
    ASSERT_GE(impulse.y, -rounding) << "the base does not pull, impact " << i;
  }
}

TEST(Impact, SlipsOnlyWhereStickingNeedsMoreThanThereIs) {
  support::SplitMix draw(5);
  int slipping = 0;
  for (int i = 0; i < 200'000; ++i) {
    const auto [block, before] = random_impact(draw);
    Landing rough = before;
    rough.static_friction = rough.kinetic_friction = std::numeric_limits<double>::max();
    const ImpactOutcome stuck = resolve_impact(rough, block, ImpactSlipRule::absolute);
    if (stuck.kind != ImpactKind::stick) continue;  // the base would have to pull
    const Impulse needed = impulse_of(before, stuck, block);
    const double spare = before.static_friction * needed.y - std::abs(needed.x);
    if (std::abs(spare) < rounding) continue;
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::absolute);
    ASSERT_EQ(after.kind, spare > 0.0 ? ImpactKind::stick : ImpactKind::slip) << "impact " << i;
    slipping += spare > 0.0 ? 0 : 1;
  }
  EXPECT_GT(slipping, 10'000);
}

// From pure rocking, sticking needs mu_s >= 3 tan(psi)/(4 + tan^2(psi)), whatever e is.
TEST(Impact, FromPureRockingNeedsTheFrictionOfTheClosedForm) {
  for (const double height : {1.0, 4.0, 10.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height});
    const double limit = 3.0 * block.tangent / (4.0 + block.tangent * block.tangent);
    for (const double e : {-0.5, 0.0, 0.9}) {
      const auto kind_at = [&](double mu) {
        return resolve_impact({0.4, 0.0, e, mu, 0.5 * mu}, block, ImpactSlipRule::absolute).kind;
      };
      EXPECT_EQ(kind_at(limit * (1.0 + 1e-13)), ImpactKind::stick) << height << " " << e;
      EXPECT_EQ(kind_at(limit * (1.0 - 1e-13)), ImpactKind::slip) << height << " " << e;
    }
  }
}

// With mu_k = mu_s the outcome is continuous where sticking changes to slipping, and V2 grows from 0 in the assumed
// direction.
TEST(Impact, IsContinuousWhereStickingTurnsIntoSlipping) {
  support::SplitMix draw(6);
  int compared = 0;
  for (int i = 0; i < 50'000; ++i) {
    auto [block, before] = random_impact(draw);
    before.static_friction = before.kinetic_friction = 1e9;
    const ImpactOutcome stuck = resolve_impact(before, block, ImpactSlipRule::absolute);
    const Impulse needed = impulse_of(before, stuck, block);
    const double mu = std::abs(needed.x) / needed.y;
    if (stuck.kind != ImpactKind::stick || !(mu > 1e-3 && mu < 1.0) || needed.y < 1e-3) continue;
    ++compared;
    for (const double factor : {1.0 - 1e-9, 1.0 - 1e-14, std::nextafter(1.0, 0.0), 1.0}) {
      before.static_friction = before.kinetic_friction = mu * factor;
      const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::absolute);
      const double bound = 100.0 * ((1.0 - factor) + rounding);
      ASSERT_NEAR(after.tilt_rate, stuck.tilt_rate, bound) << "impact " << i << " factor " << factor;
      ASSERT_NEAR(after.slip_rate, 0.0, bound) << "impact " << i << " factor " << factor;
      ASSERT_LE(after.slip_rate * needed.x, 0.0) << "slip goes against friction or is 0 exactly, impact " << i;
    }
  }
  EXPECT_GT(compared, 1'000);
}

// The model can gain energy where this is documented: squat blocks (psi > 0.62) with e > 1/3.
TEST(Impact, NeverGainsEnergyOutsideTheDocumentedCorner) {
  support::SplitMix draw(7);
  for (int i = 0; i < 500'000; ++i) {
    const auto [block, before] = random_impact(draw);
    if (before.restitution > 1.0 / 3.0 && block.shape_angle > 0.62) continue;
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::absolute);
    const double energy_before = energy_of(before.tilt_rate, before.slip_rate, block);
    ASSERT_LE(energy_of(after.tilt_rate, after.slip_rate, block),
              energy_before * (1.0 + rounding) + rounding * rounding)
        << "impact " << i << ": w1 " << before.tilt_rate << " V1 " << before.slip_rate << " e " << before.restitution
        << " mu " << before.static_friction << "/" << before.kinetic_friction << " psi " << block.shape_angle;
  }
}

// e = 0: sticking is a plastic impact. It loses energy also if the rule `signed` allows it beyond the available
// friction.
TEST(Impact, NeverGainsEnergyUnderTheSignedRuleEither) {
  support::SplitMix draw(8);
  for (int i = 0; i < 200'000; ++i) {
    auto [block, before] = random_impact(draw);
    before.restitution = 0.0;
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::signed_ratio);
    ASSERT_LE(energy_of(after.tilt_rate, after.slip_rate, block),
              energy_of(before.tilt_rate, before.slip_rate, block) * (1.0 + rounding) + rounding * rounding)
        << "impact " << i;
  }
}

TEST(SignedRule, SlipsInOneDirectionOnlyAndElseSticks) {
  support::SplitMix draw(9);
  int one_way = 0;
  for (int i = 0; i < 200'000; ++i) {
    const auto [block, before] = random_impact(draw);
    const double w2 =
        sticking_tilt_rate({.tilt_rate = before.tilt_rate, .slip_rate = before.slip_rate}, before.restitution, block);
    const double delta = w2 / before.tilt_rate;
    const double lambda = before.slip_rate / (before.tilt_rate * block.cosine) - 1.0;
    const double below = block.tangent * (1.0 + delta + 2.0 * before.restitution);  // times H/B
    const double ratio = (delta + lambda) / below;
    if (std::abs(before.tilt_rate) < 1e-3 || std::abs(below) < 1e-6 ||
        std::abs(ratio - before.static_friction) < 1e-9) {
      continue;
    }
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::signed_ratio);
    const bool slips = below > 0.0 && ratio > before.static_friction;
    ASSERT_EQ(after.kind, slips ? ImpactKind::slip : ImpactKind::stick) << "impact " << i << " ratio " << ratio;
    one_way += below > 0.0 && ratio < -before.static_friction ? 1 : 0;
  }
  EXPECT_GT(one_way, 1'000) << "the other direction has to occur for this test to say anything";
}

TEST(Impact, ReportsPainleveFromTheLimitOfItsClosedForm) {
  for (const double height : {1.0, 4.0, 10.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height});
    const double limit = (1.0 / 3.0 + block.sine * block.sine) / (block.sine * block.cosine);
    const auto kind_at = [&](double mu_k, double slip_rate) {
      return resolve_impact({1.0, slip_rate, 0.0, 0.1, mu_k}, block, ImpactSlipRule::absolute).kind;
    };
    EXPECT_EQ(kind_at(limit * (1.0 - 1e-12), -50.0), ImpactKind::slip) << height;
    EXPECT_EQ(kind_at(limit * (1.0 + 1e-12), -50.0), ImpactKind::painleve) << height;
    EXPECT_EQ(kind_at(2.0 * limit, 50.0), ImpactKind::slip) << "the other direction of slip has no such limit";
  }
}

// For slip against the new rotation, sticking requires abs(P_x)/P_y < (1/3 + sin^2)/(sin cos), however fast the block
// slips. With mu_s >= mu_k >= that limit it sticks before Painleve's paradox can occur.
TEST(Impact, NeverMeetsPainleveWhileKineticFrictionIsNotAboveTheStaticOne) {
  support::SplitMix draw(12);
  for (int i = 0; i < 100'000; ++i) {
    auto [block, before] = random_impact(draw);
    before.kinetic_friction = std::exp2(draw.uniform(-1.0, 6.0));
    before.static_friction = before.kinetic_friction;
    before.slip_rate *= std::exp2(draw.uniform(0.0, 20.0));
    for (const auto rule : {ImpactSlipRule::absolute, ImpactSlipRule::signed_ratio}) {
      ASSERT_NE(resolve_impact(before, block, rule).kind, ImpactKind::painleve) << "impact " << i;
    }
  }
}

TEST(Impact, AtPainleveLeavesTheRatesAsTheyWere) {
  const Geometry block = geometry_of({.width = 1.0, .height = 4.0});
  const ImpactOutcome after = resolve_impact({1.0, -50.0, 0.0, 0.1, 2.0}, block, ImpactSlipRule::absolute);
  EXPECT_EQ(after.kind, ImpactKind::painleve);
  EXPECT_EQ(after.tilt_rate, 1.0);
  EXPECT_EQ(after.slip_rate, -50.0);
}

TEST(Impact, ScalesWithItsRatesToTheBit) {
  support::SplitMix draw(10);
  for (int i = 0; i < 100'000; ++i) {
    const auto [block, before] = random_impact(draw);
    Landing small = before;
    small.tilt_rate = std::ldexp(before.tilt_rate, -300);
    small.slip_rate = std::ldexp(before.slip_rate, -300);
    for (const auto rule : {ImpactSlipRule::absolute, ImpactSlipRule::signed_ratio}) {
      const ImpactOutcome large_outcome = resolve_impact(before, block, rule);
      const ImpactOutcome small_outcome = resolve_impact(small, block, rule);
      ASSERT_EQ(small_outcome.kind, large_outcome.kind);
      ASSERT_EQ(small_outcome.tilt_rate, std::ldexp(large_outcome.tilt_rate, -300));
      ASSERT_EQ(small_outcome.slip_rate, std::ldexp(large_outcome.slip_rate, -300));
    }
  }
}

// lambda = V1/(w1 cos(psi)) - 1 has no limit as w1 goes to 0; the impact has.
TEST(Impact, IsWellConditionedForSmallRates) {
  const Geometry block = geometry_of({.width = 1.0, .height = 4.0});
  const Landing limit{1e-280, 0.01, 0.0, 0.4, 0.35};
  const ImpactOutcome at_limit = resolve_impact(limit, block, ImpactSlipRule::absolute);
  EXPECT_TRUE(std::isfinite(at_limit.tilt_rate));
  EXPECT_TRUE(std::isfinite(at_limit.slip_rate));
  for (int k = 8; k <= 200; k += 8) {
    Landing before = limit;
    before.tilt_rate = std::ldexp(1.0, -k);
    const ImpactOutcome after = resolve_impact(before, block, ImpactSlipRule::absolute);
    EXPECT_EQ(after.kind, at_limit.kind) << "2^-" << k;
    EXPECT_NEAR(after.tilt_rate, at_limit.tilt_rate, 10.0 * before.tilt_rate + 1e-17) << "2^-" << k;
    EXPECT_NEAR(after.slip_rate, at_limit.slip_rate, 10.0 * before.tilt_rate + 1e-17) << "2^-" << k;
  }
}

TEST(Impact, IsItsMirrorImagesMirrorImageToTheBit) {
  support::SplitMix draw(11);
  for (int i = 0; i < 100'000; ++i) {
    const auto [block, before] = random_impact(draw);
    Landing mirrored = before;
    mirrored.tilt_rate = -before.tilt_rate;
    mirrored.slip_rate = -before.slip_rate;
    for (const auto rule : {ImpactSlipRule::absolute, ImpactSlipRule::signed_ratio}) {
      const ImpactOutcome right = resolve_impact(before, block, rule);
      const ImpactOutcome left = resolve_impact(mirrored, block, rule);
      ASSERT_EQ(left.kind, right.kind);
      ASSERT_EQ(left.tilt_rate, -right.tilt_rate);
      ASSERT_EQ(left.slip_rate, -right.slip_rate);
    }
  }
}

TEST(InelasticRateRatio, IsThatOfAnImpactThatSticks) {
  for (const double height : {0.5, 1.0, 4.0, 20.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height, .gravity = 9.81});
    for (const double restitution : {-0.5, 0.0, 0.912, 1.0}) {
      // A block that rocks about its edge without slip has V1 = 0. A few roundings of numbers up to 3.
      EXPECT_NEAR(sticking_tilt_rate({.tilt_rate = 0.7, .slip_rate = 0.0}, restitution, block),
                  0.7 * inelastic_rate_ratio(block, restitution), 2e-15);
    }
  }
}

// Housner's ratio of each edge: the angular momentum about the landing edge before and after the impact, in SI units. Before
// it the centre of mass moves about the other edge.
TEST(Impact, OfAGeneralBlockConservesTheAngularMomentumAboutTheLandingEdge) {
  support::SplitMix draw(68);
  for (int i = 0; i < 1000; ++i) {
    const MassLayout mass{.left_edge = draw.uniform(0.1, 1.0),
                          .right_edge = draw.uniform(0.1, 1.0),
                          .centre_height = draw.uniform(0.3, 3.0),
                          .radius_of_gyration = draw.uniform(0.2, 1.5)};
    const Geometry block = geometry_of({.mass = mass});
    for (const double side : {1.0, -1.0}) {  // of the landing edge
      const double landing = side > 0.0 ? mass.left_edge : mass.right_edge;
      const double leaving = side > 0.0 ? mass.right_edge : mass.left_edge;
      const double height = mass.centre_height;
      const double inertia = mass.radius_of_gyration * mass.radius_of_gyration;
      const double before = inertia + height * height - landing * leaving;
      const double after = inertia + height * height + landing * landing;
      const double ratio = inelastic_rate_ratio(block.edge(side));
      ASSERT_NEAR(ratio, before / after, 1e-14);
      ASSERT_NEAR(sticking_tilt_rate({.tilt_rate = side, .slip_rate = 0.0}, 0.0, block), side * ratio, 1e-15);
      ASSERT_NEAR(restitution_of_rate_ratio(block.edge(side), ratio), 0.0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace rocking::dynamics
