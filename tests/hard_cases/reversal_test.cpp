// A slide that all but stops: slip rates that graze zero, and slips that end just where friction no longer holds the block.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

constexpr long double pi = std::numbers::pi_v<long double>;

/// A block in full contact that slides to the right on a harmonic base, V > 0; mu_s = mu_k.
struct Slide {
  long double peak;  ///< of the base acceleration, in g
  long double frequency;
  long double phase;
  long double friction;

  /// V - V0 after the base's angle has grown from the phase to `angle`.
  [[nodiscard]] long double gain(long double angle) const {
    const long double swing = peak * (std::cos(angle) - std::cos(phase));
    return 4.0L / 3.0L * (swing - friction * (angle - phase)) / frequency;
  }

  [[nodiscard]] Stage stage(double slip_rate, double side) const {
    return {.frequency = static_cast<double>(frequency),
            .phase = static_cast<double>(phase),
            .tolerance = 1e-17,
            .start = {.slip_rate = side * slip_rate}};
  }

  [[nodiscard]] ScriptedCoefficients coefficients(double side) const {
    const auto mu = static_cast<double>(friction);
    return {
        .amplitude_value = side * Stage{}.amplitude_for(static_cast<double>(peak)), .statics = {mu}, .kinetics = {mu}};
  }
};

Slide random_slide(SplitMix& draw) {
  return {.peak = draw.uniform(0.3, 2.0),
          .frequency = draw.uniform(1.0, 20.0),
          .phase = 0.0L,
          .friction = draw.uniform(0.05, 0.2)};
}

// V falls while alpha > -mu and is lowest where alpha = -mu on its way down. Whether it stops there is the sign of that value,
// known to rounding r of the terms that make it up. A stop comes where the closed form has its zero; V' there is the root of
// 2 V'' times the depth, which gives the bound on its instant.
TEST(GrazingSlip, StopsIfAndOnlyIfTheClosedFormFallsBelowZero) {
  int stops = 0;
  int misses = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SplitMix draw(seed);
    Slide slide = random_slide(draw);
    const long double lowest = pi + std::asin(slide.friction / slide.peak);
    slide.phase = static_cast<double>(lowest - static_cast<long double>(draw.uniform(0.5, 3.0)));
    const long double grazing = -slide.gain(lowest);
    const long double curvature =
        4.0L / 3.0L * slide.frequency * std::sqrt(slide.peak * slide.peak - slide.friction * slide.friction);
    for (int k = 6; k <= 53; ++k) {
      for (const long double direction : {1.0L, -1.0L}) {
        const auto start = static_cast<double>(grazing * (1.0L + direction * std::exp2(static_cast<long double>(-k))));
        const double side = draw.below(2) == 0 ? 1.0 : -1.0;
        const auto depth = static_cast<double>(grazing - static_cast<long double>(start));
        ScriptedRun run(slide.stage(start, side), slide.coefficients(side));
        run.run();
        const auto end =
            static_cast<double>((lowest - slide.phase) / slide.frequency) + 0.01 * run.motion.clock().period_length();
        const bool stopped = !run.log.events.empty() && run.log.events[0].tau < end;
        const double rounding = 16.0 * 0x1p-53 * (start + static_cast<double>(4.0L * slide.peak / slide.frequency));
        const testing::ScopedTrace trace(__FILE__, __LINE__,
                                         "seed " + std::to_string(seed) + ", 2^-" + std::to_string(k));
        if (std::abs(depth) <= rounding) continue;
        ASSERT_EQ(stopped, depth > 0.0);
        ++(stopped ? stops : misses);
        if (!stopped) continue;
        const EventKind kind = run.log.events[0].kind;
        ASSERT_TRUE(kind == EventKind::slide_stop || kind == EventKind::slip_reverse) << to_string(kind);
        long double low = slide.phase;
        long double high = lowest;
        for (int i = 0; i < 80; ++i) {
          const long double middle = 0.5L * (low + high);
          (static_cast<long double>(start) + slide.gain(middle) > 0.0L ? low : high) = middle;
        }
        const auto expected = static_cast<double>((high - slide.phase) / slide.frequency);
        const double bound = rounding / std::sqrt(depth * static_cast<double>(curvature));
        ASSERT_NEAR(run.log.events[0].tau, expected, bound + 1e-15);
        worst = std::max(worst, std::abs(run.log.events[0].tau - expected) / (bound + 1e-15));
      }
    }
  }
  EXPECT_GT(stops, 2000);
  EXPECT_GT(misses, 2000);
  RecordProperty("worst", std::to_string(worst));
}

// The slip ends where alpha, growing, passes mu_s: a bit before, the block rests for a moment and slides off; a bit after, it
// reverses. Either way it slides the other way from then on. V is then of the second order in what separates the two.
TEST(Reversal, WhereTheStopMeetsTheThresholdIsTheSameSlideByEitherStory) {
  int reversed = 0;
  int rested = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SplitMix draw(seed);
    Slide slide = random_slide(draw);
    const long double meeting = std::asin(slide.friction / slide.peak);
    slide.phase = static_cast<double>(draw.uniform(0.1, 0.9)) * meeting;
    slide.phase = static_cast<double>(slide.phase);
    const auto start = static_cast<double>(-slide.gain(meeting));
    const double side = draw.below(2) == 0 ? 1.0 : -1.0;
    std::optional<State> first;
    for (int ulps = -40; ulps <= 40; ++ulps) {
      ScriptedRun run(slide.stage(start + ulps * 0x1p-52 * start, side), slide.coefficients(side));
      run.run();
      const std::string story = run.log.story();
      const bool reverses = story.starts_with("slip_reverse");
      const testing::ScopedTrace trace(__FILE__, __LINE__,
                                       "seed " + std::to_string(seed) + ", " + std::to_string(ulps));
      ASSERT_TRUE(reverses || story.starts_with("slide_stop slide_start")) << story.substr(0, 100);
      ++(reverses ? reversed : rested);
      ASSERT_EQ(run.motion.contradictions(), 0U);
      const State end = run.log.strobes.back();
      if (!first) first = end;
      const double scale = static_cast<double>(4.0L * slide.peak / slide.frequency) + start;
      worst = std::max(worst, std::abs(end.slip_rate - first->slip_rate) / scale);
      ASSERT_NEAR(end.slip_rate, first->slip_rate, 32.0 * 0x1p-53 * scale);
      ASSERT_NEAR(end.slip, first->slip, (32.0 + 80.0) * 0x1p-52 * scale * static_cast<double>(6.3L / slide.frequency));
    }
  }
  EXPECT_GT(reversed, 1000);
  EXPECT_GT(rested, 1000);
  RecordProperty("worst", std::to_string(worst * 1e16));
}

}  // namespace
}  // namespace rocking::dynamics
