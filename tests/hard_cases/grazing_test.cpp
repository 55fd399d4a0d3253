// Grazing contact: a block falls towards the base, which pushes it up again just as it arrives. The sign of the lowest
// point decides whether it lands. A dip below the ground is two impacts, one on each edge; a near miss is none.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/long_double_rock.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using support::LongDoubleRock;
using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

constexpr double unit_rounding = 0x1p-53;

/// A fall towards a base that pushes up when it ends.
struct Fall {
  Stage stage;
  double amplitude;
  LongDoubleRock exact;

  [[nodiscard]] double pull() const {  ///< theta'' at the ground at the peak of the base acceleration
    return amplitude * stage.geometry().shape_angle * stage.geometry().cosine - stage.geometry().sine;
  }
  [[nodiscard]] double ratio() const { return 1.0 - 1.5 * stage.geometry().sine * stage.geometry().sine; }
};

Fall fall_from(SplitMix& draw, double frequency, double phase) {
  Fall fall{.stage = {.block = {.height = draw.uniform(1.5, 8.0)},
                      .frequency = frequency,
                      .phase = phase,
                      .tolerance = 1e-17,
                      .start = {},
                      .periods = 1},
            .amplitude = 0.0,
            .exact = {}};
  const double psi = fall.stage.geometry().shape_angle;
  fall.amplitude = fall.stage.amplitude_for(std::tan(psi) + draw.uniform(0.5, 1.5));
  fall.exact = {.psi = std::atan(1.0L / static_cast<long double>(fall.stage.block.height)),
                .peak = static_cast<long double>(fall.amplitude) * static_cast<long double>(psi),
                .frequency = frequency,
                .phase = phase};
  return fall;
}

/// The impacts before `end`; mirrored for side = -1.
std::vector<support::LoggedEvent> impacts(const Fall& fall, double tilt, double rate, double end, double side) {
  Stage stage = fall.stage;
  stage.start = {.tilt = side * tilt, .tilt_rate = side * rate};
  ScriptedRun run(stage, {.amplitude_value = side * fall.amplitude});
  run.run();
  std::vector<support::LoggedEvent> found;
  for (const auto& event : run.log.events) {
    if (event.tau < end) found.push_back(event);
  }
  return found;
}

/// Expects two impacts, on one edge and on the other, at rates that decrease by Housner's ratio; the first as in long
/// double.
void expect_dip(const Fall& fall, const LongDoubleRock::Dip& dip, const std::vector<support::LoggedEvent>& events,
                double side, double relative) {
  ASSERT_EQ(events.size(), 2U);
  const auto rate = static_cast<double>(dip.ground_rate);
  for (const auto& event : events) ASSERT_EQ(event.kind, EventKind::impact_stick);
  EXPECT_NEAR(side * events[0].state.tilt_rate, fall.ratio() * rate, relative * std::abs(rate));
  EXPECT_NEAR(events[0].tau, static_cast<double>(dip.ground_time), relative * std::abs(rate) / fall.pull() + 1e-15);
  EXPECT_EQ(side * events[0].state.side, -1.0);
  EXPECT_EQ(side * events[1].state.side, 1.0);
}

// From a start that grazes to rounding, to one that differs by 2^-8. A rounding r of theta at the ground changes the
// rate w there by a r/w. r: the units in the last place of the terms of about ten steps.
TEST(Grazing, FallMissesNoImpactAndInventsNone) {
  int dips = 0;
  int misses = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SplitMix draw(seed);
    const double frequency = draw.uniform(1.0, 4.0);
    const Fall fall = fall_from(draw, frequency, 0.5 * std::numbers::pi - frequency * draw.uniform(0.1, 0.3));
    const double tilt = draw.uniform(0.02, 0.2) * fall.stage.geometry().shape_angle;
    long double slow = 0.0L;
    long double fast = -2.0L;
    for (int i = 0; i < 80; ++i) {
      const long double rate = 0.5L * (slow + fast);
      (fall.exact.dip(tilt, rate).tilt < 0.0L ? fast : slow) = rate;
    }
    if (slow == 0.0L) continue;                               // it lands however slowly it starts
    if (fall.exact.dip(tilt, fast).tilt < -1e-12L) continue;  // the push ends before the fall: no grazing
    const double grazing = static_cast<double>(slow);
    for (int k = 8; k <= 53; ++k) {
      for (const double direction : {1.0, -1.0}) {
        const double rate = grazing * (1.0 + direction * std::ldexp(1.0, -k));
        const LongDoubleRock::Dip dip = fall.exact.dip(tilt, rate);
        const auto end = static_cast<double>(dip.time) + 0.15;
        const double side = draw.below(2) == 0 ? 1.0 : -1.0;
        const auto events = impacts(fall, tilt, rate, end, side);
        const double rounding = 32.0 * unit_rounding * (tilt + std::abs(rate) * end);
        const testing::ScopedTrace trace(__FILE__, __LINE__,
                                         "seed " + std::to_string(seed) + ", 2^-" + std::to_string(k) + ", lowest " +
                                             std::to_string(static_cast<double>(dip.tilt) * 1e16) + "e-16");
        if (static_cast<double>(dip.tilt) > rounding) {
          ASSERT_TRUE(events.empty());
          ++misses;
        } else if (static_cast<double>(dip.tilt) < -rounding) {
          const auto ground = static_cast<double>(dip.ground_rate);
          ASSERT_NO_FATAL_FAILURE(
              expect_dip(fall, dip, events, side, 2.0 * fall.pull() * rounding / (ground * ground)));
          ++dips;
        } else {
          ASSERT_TRUE(events.empty() || events.size() == 2U) << events.size();
        }
      }
    }
  }
  EXPECT_GE(dips, 500);
  EXPECT_GE(misses, 500);
}

/// Tilt rates at the ground from 1e-3 to 1e-15. The start is as near to the ground as they are small, so that they are
/// resolved to the last digits.
class GrazingRate : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(TenToTheMinus, GrazingRate, testing::Range(3, 16), testing::PrintToStringParamName());

TEST_P(GrazingRate, IsThatOfTheClosedFormHoweverSmall) {
  const double ground = std::pow(10.0, -GetParam());
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SplitMix draw(seed);
    const Fall fall = fall_from(draw, 10.0, 0.5 * std::numbers::pi);
    const double tilt = draw.uniform(0.1, 2.0) * ground * ground;
    const double rate = -std::sqrt(ground * ground + 2.0 * fall.pull() * tilt);
    const LongDoubleRock::Dip dip = fall.exact.dip(tilt, rate);
    ASSERT_LT(dip.tilt, 0.0L);
    const double side = draw.below(2) == 0 ? 1.0 : -1.0;
    const auto events = impacts(fall, tilt, rate, 0.1, side);
    const testing::ScopedTrace trace(__FILE__, __LINE__, "seed " + std::to_string(seed));
    // w^2 = rate^2 - 2 a theta0: three roundings each, multiplied by rate^2/w^2, at most 1 + 2 a 2 < 8.
    ASSERT_NO_FATAL_FAILURE(expect_dip(fall, dip, events, side, 8.0 * 8.0 * unit_rounding));
    worst = std::max(
        worst,
        std::abs(side * events[0].state.tilt_rate / (fall.ratio() * static_cast<double>(dip.ground_rate)) - 1.0));
  }
  RecordProperty("worst", std::to_string(worst * 1e16));
}

TEST_P(GrazingRate, IsNoneWhereTheBlockTurnsJustAboveTheGround) {
  const double scale = std::pow(10.0, -GetParam());
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SplitMix draw(seed);
    const Fall fall = fall_from(draw, 10.0, 0.5 * std::numbers::pi);
    const double rate = -scale;
    const double lowest = scale * scale * std::exp2(-draw.uniform(0.0, 30.0));
    const double tilt = 0.5 * scale * scale / fall.pull() + lowest;
    if (!(fall.exact.dip(tilt, rate).tilt > 0.0L)) continue;  // the rounded start is on the other side
    ASSERT_TRUE(impacts(fall, tilt, rate, 0.1, draw.below(2) == 0 ? 1.0 : -1.0).empty()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace rocking::dynamics
