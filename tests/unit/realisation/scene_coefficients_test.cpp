// Fluctuations of a scene: which draw is in force at which time, and what is counted (lib/docs/model.md, section 5).

#include "rocking/realisation/scene_coefficients.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/dynamics/impact.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using dynamics::Clock;
using dynamics::Instant;
using random::Source;

constexpr double frequency = 10.0;
const random::Draws draws(0x2012, 3);

Scene scene_with(const Fluctuation& fluctuation, double mu_s = 0.35, double mu_k = 0.3) {
  Scene scene;
  support::harmonic(scene).amplitude = 4.0;
  support::harmonic(scene).frequency_ratio = frequency;
  scene.friction = Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_k};
  scene.fluctuation = fluctuation;
  return scene;
}

/// mu_s that no kinetic draw reaches, so that nothing is clamped to it.
constexpr double out_of_reach = 100.0;

double kinetic_draw(std::uint64_t index, double sigma = 0.03, double mean = 0.3) {
  return mean + sigma * draws.standard_normal(Source::kinetic_friction, index);
}

Clock clock_at(double phase, const Instant& instant) {
  Clock clock(frequency, phase);
  clock.set(instant);
  return clock;
}

TEST(KineticFriction, HasADrawForEachIntervalOfTheGrid) {
  const Scene scene = scene_with({.kinetic_friction = 0.03}, out_of_reach);
  for (const double phase : {0.0, 1e-3, 1.0, 3.0, 6.2831853}) {
    SceneCoefficients coefficients(scene, draws);
    Clock clock(frequency, phase);
    const double interval = clock.period_length() / 200.0;
    for (std::uint64_t index = 0; index < 1000; ++index) {
      clock.advance(0.5 * interval);
      ASSERT_EQ(coefficients.kinetic_friction(clock), kinetic_draw(index))
          << "interval " << index << " phase " << phase;
      clock.advance(0.5 * interval);
    }
  }
}

// A boundary belongs to the interval that it begins, and counts as reached from within the clock's resolution.
TEST(KineticFriction, ChangesAtTheBoundariesToTheRounding) {
  const Scene scene = scene_with({.kinetic_friction = 0.03}, out_of_reach);
  for (const double phase : {0.0, 1.0, 5.0}) {
    const Clock origin(frequency, phase);
    const double length = origin.period_length();
    for (const std::int64_t index : {1, 2, 3, 99, 100, 199, 200, 201, 399, 400, 12345, 200'000'000}) {
      const Instant boundary{.period = index / 200,
                             .time = origin.start() + static_cast<double>(index % 200) * length / 200.0};
      const auto value_at = [&](double offset) {
        SceneCoefficients fresh(scene, draws);
        Clock clock = clock_at(phase, {boundary.period, boundary.time + offset});
        return fresh.kinetic_friction(clock);
      };
      const auto number = static_cast<std::uint64_t>(index);
      EXPECT_EQ(value_at(0.0), kinetic_draw(number)) << index << " phase " << phase;
      EXPECT_EQ(value_at(1e-9), kinetic_draw(number)) << index << " phase " << phase;
      EXPECT_EQ(value_at(-1e-9), kinetic_draw(number - 1)) << index << " phase " << phase;
      EXPECT_EQ(value_at(-0.5 * origin.resolution()), kinetic_draw(number)) << index << " phase " << phase;
    }
  }
}

// Following next_change from boundary to boundary visits each interval once, without a gap or an endless loop.
TEST(KineticFriction, IsMetIntervalByIntervalByWhoFollowsTheChanges) {
  const Scene scene = scene_with({.kinetic_friction = 0.03}, out_of_reach);
  for (const double phase : {0.0, 0.7, 4.0}) {
    SceneCoefficients coefficients(scene, draws);
    Clock clock(frequency, phase);
    for (std::uint64_t index = 0; index < 1000; ++index) {
      ASSERT_EQ(coefficients.kinetic_friction(clock), kinetic_draw(index)) << index << " phase " << phase;
      const auto next = coefficients.next_change(clock, true);
      ASSERT_TRUE(next);
      ASSERT_NEAR(clock.until(*next), clock.period_length() / 200.0, 1e-12);
      clock.advance(clock.until(*next));
      clock.set(*next);
    }
    EXPECT_NEAR(clock.tau(), 5.0 * clock.period_length(), 1e-13);
  }
}

TEST(KineticFriction, IsTheSameWhateverThePathOfQueries) {
  const Scene scene = scene_with({.kinetic_friction = 0.03}, out_of_reach);
  const double phase = 2.0;
  support::SplitMix draw(30);
  for (int path = 0; path < 50; ++path) {
    SceneCoefficients visited(scene, draws);
    Clock clock(frequency, phase);
    for (int i = 0; i < 200; ++i) {
      clock.advance(std::exp2(draw.uniform(-12.0, 3.0)));
      SceneCoefficients fresh(scene, draws);
      ASSERT_EQ(visited.kinetic_friction(clock), fresh.kinetic_friction(clock)) << "path " << path << " query " << i;
    }
  }
}

TEST(KineticFriction, IsHeldAtTheStaticOneAndAtZeroAndCountsEachClampOnceAnInterval) {
  const Scene scene = scene_with({.kinetic_friction = 0.3}, 0.35, 0.3);
  SceneCoefficients coefficients(scene, draws);
  std::uint64_t at_zero = 0;
  std::uint64_t at_static = 0;
  Clock clock(frequency, 0.0);
  const double interval = clock.period_length() / 200.0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    clock.advance(0.25 * interval);
    const double wanted = kinetic_draw(index, 0.3);
    at_zero += wanted < 0.0 ? 1 : 0;
    at_static += wanted > 0.35 ? 1 : 0;
    for (int repeat = 0; repeat < 3; ++repeat) {
      ASSERT_EQ(coefficients.kinetic_friction(clock), std::clamp(wanted, 0.0, 0.35)) << index;
    }
    clock.advance(0.75 * interval);
  }
  EXPECT_EQ(coefficients.clamps().kinetic_at_zero, at_zero);
  EXPECT_EQ(coefficients.clamps().kinetic_at_static, at_static);
  OperationCounts operations;
  coefficients.add_to(operations);
  EXPECT_EQ(operations.kinetic_friction_draws, 400U);
  EXPECT_EQ(operations.static_friction_draws, 0U);
}

TEST(KineticFriction, IsDrawnAndClampedOnlyWhereItIsUsed) {
  const Scene scene = scene_with({.kinetic_friction = 3.0});
  SceneCoefficients coefficients(scene, draws);
  Clock clock(frequency, 0.0);
  for (int i = 0; i < 1000; ++i) {
    clock.advance(0.01);
    static_cast<void>(coefficients.next_change(clock, true));
    static_cast<void>(coefficients.next_change(clock, false));
  }
  OperationCounts operations;
  coefficients.add_to(operations);
  EXPECT_EQ(operations.kinetic_friction_draws, 0U);
  EXPECT_EQ(coefficients.clamps().kinetic_at_static + coefficients.clamps().kinetic_at_zero, 0U);
}

// A source that announces the coming intervals, and is told afterwards how many have passed, has the same state as one
// that was asked in each of them.
TEST(KineticFriction, IsAnnouncedAsItWillBe) {
  const Scene scene = scene_with({.kinetic_friction = 0.3}, 0.35, 0.3);
  for (const double phase : {0.0, 2.5}) {
    SceneCoefficients asked(scene, draws);
    SceneCoefficients told(scene, draws);
    Clock clock(frequency, phase);
    ASSERT_EQ(asked.kinetic_friction(clock), told.kinetic_friction(clock));
    std::size_t announced = 0;
    for (int i = 0; i < 200; ++i) {
      const auto [wanted, per_period, next] = told.known_intervals();
      const std::size_t known = wanted.size() - 1;
      std::int64_t boundary = next;
      Instant end = *asked.next_change(clock, true);
      const std::size_t passed = std::min(known, static_cast<std::size_t>(i) % 5 + 1);
      for (std::size_t k = 0; k < passed; ++k) {
        ASSERT_EQ(dynamics::grid_boundary(clock, end.period, boundary, per_period), end) << i << " " << k;
        clock.set(end);
        ASSERT_EQ(std::clamp(wanted[k + 1], 0.0, told.static_friction()), asked.kinetic_friction(clock))
            << i << " " << k;
        if (++boundary == per_period) boundary = 0;
        end = *asked.next_change(clock, true);
      }
      if (passed > 0) told.pass_intervals(clock, passed);
      announced += passed;
      if (passed == known) {
        clock.set(*asked.next_change(clock, true));
        ASSERT_EQ(told.kinetic_friction(clock), asked.kinetic_friction(clock)) << i;
      }
      ASSERT_EQ(told.next_change(clock, true), asked.next_change(clock, true));
      ASSERT_EQ(told.clamps().kinetic_at_zero, asked.clamps().kinetic_at_zero);
      ASSERT_EQ(told.clamps().kinetic_at_static, asked.clamps().kinetic_at_static);
    }
    EXPECT_GT(announced, 300U);
    OperationCounts by_asking;
    OperationCounts by_telling;
    asked.add_to(by_asking);
    told.add_to(by_telling);
    EXPECT_EQ(by_asking.kinetic_friction_draws, by_telling.kinetic_friction_draws);
  }
}

TEST(KineticFriction, IsNotAnnouncedWhereTheAmplitudeMayChangeBefore) {
  const Scene scene = scene_with({.kinetic_friction = 0.3, .amplitude = 0.1}, 0.35, 0.3);
  SceneCoefficients coefficients(scene, draws);
  Clock clock(frequency, 0.0);
  static_cast<void>(coefficients.kinetic_friction(clock));
  EXPECT_TRUE(coefficients.known_intervals().wanted.empty());
}

double static_draw(std::uint64_t chatters, std::uint64_t stops, double sigma = 0.03) {
  return 0.35 + sigma * draws.standard_normal(Source::static_friction, random::paired_index(chatters, stops));
}

TEST(StaticFriction, IsDrawnAtTheStartAndAtEachStop) {
  SceneCoefficients coefficients(scene_with({.static_friction = 0.03}), draws);
  for (std::uint64_t stop = 0; stop < 100; ++stop) {
    ASSERT_EQ(coefficients.static_friction(), static_draw(0, stop)) << stop;
    coefficients.stop();
  }
}

TEST(StaticFriction, AfterAChatterDoesNotDependOnTheStopsWithinIt) {
  SceneCoefficients few(scene_with({.static_friction = 0.03}), draws);
  SceneCoefficients many(scene_with({.static_friction = 0.03}), draws);
  few.stop();
  for (int i = 0; i < 17; ++i) many.stop();
  EXPECT_NE(few.static_friction(), many.static_friction());
  few.chatter_ended();
  many.chatter_ended();
  EXPECT_EQ(few.static_friction(), many.static_friction());
  few.stop();
  many.stop();
  EXPECT_EQ(few.static_friction(), static_draw(1, 1));
  EXPECT_EQ(many.static_friction(), static_draw(1, 1));
}

TEST(StaticFriction, IsHeldAtZero) {
  SceneCoefficients coefficients(scene_with({.static_friction = 1.0}), draws);
  std::uint64_t clamped = 0;
  for (std::uint64_t stop = 0; stop < 200; ++stop) {
    clamped += static_draw(0, stop, 1.0) < 0.0 ? 1 : 0;
    ASSERT_EQ(coefficients.static_friction(), std::max(0.0, static_draw(0, stop, 1.0)));
    if (stop < 199) coefficients.stop();
  }
  EXPECT_GT(clamped, 20U);
  EXPECT_EQ(coefficients.clamps().static_at_zero, clamped);
}

TEST(StaticFriction, HoldsAConstantKineticFrictionAndCountsItOnceADraw) {
  SceneCoefficients coefficients(scene_with({.static_friction = 0.1}), draws);
  Clock clock(frequency, 0.0);
  std::uint64_t held = 0;
  for (std::uint64_t stop = 0; stop < 100; ++stop) {
    const double mu_s = static_draw(0, stop, 0.1);
    held += mu_s < 0.3 ? 1 : 0;
    for (int repeat = 0; repeat < 3; ++repeat) {
      ASSERT_EQ(coefficients.kinetic_friction(clock), std::min(0.3, std::max(0.0, mu_s)));
      clock.advance(0.01);
    }
    if (stop < 99) coefficients.stop();
  }
  EXPECT_EQ(coefficients.clamps().kinetic_at_static, held);
}

TEST(StaticAndKineticFriction, AreIndependentSources) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_NE(draws.standard_normal(Source::static_friction, i), draws.standard_normal(Source::kinetic_friction, i));
  }
}

TEST(Restitution, IsDrawnAtEachImpactAndCountedFromTheLastChatter) {
  SceneCoefficients coefficients(scene_with({.restitution = 0.1}), draws);
  const auto expected = [](std::uint64_t chatters, std::uint64_t impacts) {
    return 0.1 * draws.standard_normal(Source::restitution, random::paired_index(chatters, impacts));
  };
  for (std::uint64_t i = 0; i < 40; ++i) ASSERT_EQ(coefficients.restitution(), expected(0, i));
  coefficients.stop();
  EXPECT_EQ(coefficients.restitution(), expected(0, 40)) << "a stop is no impact";
  coefficients.chatter_ended();
  EXPECT_EQ(coefficients.restitution(), expected(1, 0));
  EXPECT_EQ(coefficients.restitution(), expected(1, 1));
}

TEST(Restitution, IsHeldWithinWhatTheModelAllows) {
  SceneCoefficients coefficients(scene_with({.restitution = 2.0}), draws);
  std::uint64_t clamped = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const double wanted = 2.0 * draws.standard_normal(Source::restitution, i);
    clamped += wanted < -0.999 || wanted > 1.0 ? 1 : 0;
    ASSERT_EQ(coefficients.restitution(), std::clamp(wanted, -0.999, 1.0));
  }
  EXPECT_EQ(coefficients.clamps().restitution, clamped);
}

// Amplitudes are constant between zeros of the sine, so that alpha has no jump; the part before the first zero has
// index 0.
// One measured ratio is two values of e, one of each edge.
TEST(Restitution, OfARateRatioIsThatOfTheEdgeThatLands) {
  Scene scene;
  scene.block.mass = GivenEdges{.edges = {0.3, 0.5}, .centre_height = 1.6, .radius_of_gyration = 0.9};
  scene.restitution = RateRatio{.value = 0.9};
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  SceneCoefficients coefficients(scene, random::Draws(1, 0));
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(dynamics::inelastic_rate_ratio(block.edge(side), coefficients.restitution(side)), 0.9, 1e-15);
  }
  EXPECT_GT(coefficients.restitution(1.0), coefficients.restitution(-1.0));
}

// Less than an impact with e = 1 leaves. Where the block may slide, or the ratio scatters along the way, e is limited.
TEST(Restitution, OfABlockThatCannotSlideLeavesTheRateRatioAsMeasured) {
  Scene scene;
  scene.restitution = RateRatio{.value = Uniform{0.3, 0.5}};
  EXPECT_EQ(refusal_of(scene, 0), std::nullopt);
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  EXPECT_EQ(bounds_of(scene, Source::mean_restitution, block).least, 0.0);
  scene.restitution = RateRatio{.value = 0.4};
  SceneCoefficients coefficients(scene, draws);
  EXPECT_NEAR(dynamics::inelastic_rate_ratio(block, coefficients.restitution(1.0)), 0.4, 1e-15);
  Scene sliding = scene;
  sliding.friction = Friction{.static_coefficient = 0.4, .kinetic_coefficient = 0.35};
  EXPECT_TRUE(refusal_of(sliding, 0).has_value());
  scene.fluctuation.restitution = 0.01;
  EXPECT_TRUE(refusal_of(scene, 0).has_value());
}

// Of a rectangle too. A scatter has the same sigma, of the ratio, at both edges.
TEST(Restitution, OfTwoRateRatiosIsThatOfTheEdgeThatLands) {
  for (const bool is_rectangle : {true, false}) {
    Scene scene;
    if (!is_rectangle) {
      scene.block.mass = GivenEdges{.edges = {0.3, 0.5}, .centre_height = 1.6, .radius_of_gyration = 0.9};
    }
    scene.restitution = RateRatio{.value = 0.9, .right = 0.87};
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
    SceneCoefficients coefficients(scene, draws);
    const auto ratio = [&block](SceneCoefficients& source, double side) {
      return dynamics::inelastic_rate_ratio(block.edge(side), source.restitution(side));
    };
    EXPECT_NEAR(ratio(coefficients, 1.0), 0.9, 1e-15);
    EXPECT_NEAR(ratio(coefficients, -1.0), 0.87, 1e-15);
    EXPECT_EQ(coefficients.constant_restitution(), std::nullopt) << "lanes compute impacts with one e";
    scene.fluctuation.restitution = 0.002;
    SceneCoefficients scattered(scene, draws);
    for (std::uint64_t i = 0; i < 20; ++i) {
      const double side = i % 3 == 0 ? -1.0 : 1.0;
      const double z = draws.standard_normal(Source::restitution, i);
      ASSERT_NEAR(ratio(scattered, side), (side < 0.0 ? 0.87 : 0.9) - 0.002 * z, 2e-15) << i;
    }
    scene.fluctuation.restitution = 0.0;
    scene.restitution = RateRatio{.value = 0.9, .right = 0.9};
    Scene one = scene;
    one.restitution = RateRatio{.value = 0.9};
    SceneCoefficients both(scene, draws), only(one, draws);
    EXPECT_EQ(both.restitution(-1.0), only.restitution(-1.0));
    EXPECT_EQ(both.constant_restitution(), only.constant_restitution());
  }
}

TEST(Amplitude, ChangesAtTheZerosOfTheSine) {
  const Scene scene = scene_with({.amplitude = 0.5});
  const auto expected = [](std::uint64_t index) {
    return std::max(0.0, 4.0 + 0.5 * draws.standard_normal(Source::amplitude, index));
  };
  for (const double phase : {0.0, 1.0, 6.0}) {
    SceneCoefficients coefficients(scene, draws);
    Clock clock(frequency, phase);
    EXPECT_EQ(coefficients.amplitude(clock), expected(0)) << phase;
    const double first_zero = (2.0 * std::numbers::pi - phase) / frequency;
    const auto change = coefficients.next_change(clock, false);
    ASSERT_TRUE(change);
    EXPECT_NEAR(clock.until(*change), first_zero, 1e-15) << phase;
    clock.advance(first_zero * (1.0 - 1e-9));
    EXPECT_EQ(coefficients.amplitude(clock), expected(0)) << phase;
    for (std::uint64_t index = 1; index < 20; ++index) {
      clock.set({.period = static_cast<std::int64_t>(index), .time = 0.0});
      EXPECT_EQ(coefficients.amplitude(clock), expected(index)) << phase;
      clock.advance(0.999 * clock.period_length());
      EXPECT_EQ(coefficients.amplitude(clock), expected(index)) << phase;
    }
  }
}

TEST(Amplitude, IsHeldAtZeroAndCountsEachClampOnceAPeriod) {
  const Scene scene = scene_with({.amplitude = 10.0});
  SceneCoefficients coefficients(scene, draws);
  std::uint64_t clamped = 0;
  Clock clock(frequency, 0.0);
  for (std::uint64_t index = 0; index < 100; ++index) {
    const double wanted = 4.0 + 10.0 * draws.standard_normal(Source::amplitude, index);
    clamped += wanted < 0.0 ? 1 : 0;
    clock.set({.period = static_cast<std::int64_t>(index), .time = 0.1});
    ASSERT_EQ(coefficients.amplitude(clock), std::max(0.0, wanted));
    ASSERT_EQ(coefficients.amplitude(clock), std::max(0.0, wanted));
  }
  EXPECT_EQ(coefficients.clamps().amplitude_at_zero, clamped);
}

TEST(NextChange, IsTheEarlierOfGridAndPeriod) {
  const Scene scene = scene_with({.kinetic_friction = 0.01, .amplitude = 0.1});
  const SceneCoefficients coefficients(scene, draws);
  const Clock clock =
      clock_at(1.0, {.period = 2, .time = 0.628});  // 3e-4 before the end of the period, the grid slightly later
  const auto slipping = coefficients.next_change(clock, true);
  const auto sticking = coefficients.next_change(clock, false);
  ASSERT_TRUE(slipping && sticking);
  EXPECT_EQ(sticking->period, 3);
  EXPECT_LE(clock.until(*slipping), clock.until(*sticking));
  EXPECT_GT(clock.until(*slipping), 0.0);
}

TEST(SceneCoefficients, UnderAnotherMeanKeepTheDeviationsInForce) {
  Scene scene =
      scene_with({.static_friction = 0.05, .kinetic_friction = 0.05, .refreshes_per_period = 20, .amplitude = 0.3});
  const Clock clock(frequency, 0.0);
  SceneCoefficients coefficients(scene, draws);
  coefficients.stop();
  coefficients.stop();
  coefficients.chatter_ended();
  coefficients.chatter_ended();  // without a stop: the friction before it stays in force, though the count has advanced
  const double in_force = coefficients.static_friction();
  const SceneCoefficients same(scene, draws);
  EXPECT_EQ(coefficients.under(same).static_friction(), in_force);
  EXPECT_EQ(coefficients.under(same).kinetic_friction(clock), coefficients.kinetic_friction(clock));
  EXPECT_EQ(coefficients.under(same).amplitude(clock), coefficients.amplitude(clock));
  scene.friction->static_coefficient = mean_static(*scene.friction) + 0.25;
  support::harmonic(scene).amplitude = mean_of(support::harmonic(scene).amplitude) + 0.25;
  auto moved = coefficients.under(SceneCoefficients(scene, draws));
  EXPECT_NEAR(moved.static_friction(), in_force + 0.25, 0x1p-52);                      // a rounding of a sum below 1
  EXPECT_NEAR(moved.amplitude(clock), coefficients.amplitude(clock) + 0.25, 0x1p-49);  // of one below 8
}

TEST(NothingRandom, DrawsNothingAndNeverChanges) {
  SceneCoefficients coefficients(scene_with({}), draws);
  Clock clock(frequency, 1.0);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(coefficients.kinetic_friction(clock), 0.3);
    EXPECT_EQ(coefficients.static_friction(), 0.35);
    EXPECT_EQ(coefficients.restitution(), 0.0);
    EXPECT_EQ(coefficients.amplitude(clock), 4.0);
    EXPECT_EQ(coefficients.next_change(clock, true), std::nullopt);
    coefficients.stop();
    if (i % 10 == 0) coefficients.chatter_ended();
    clock.advance(0.123);
  }
  OperationCounts operations;
  coefficients.add_to(operations);
  EXPECT_EQ(operations.static_friction_draws + operations.kinetic_friction_draws + operations.restitution_draws +
                operations.amplitude_draws,
            0U);
}

}  // namespace
}  // namespace rocking
