// Slides that nearly stop: slip rates that graze zero, and slips that end just where friction ceases to hold the block.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "rocking/dynamics/forces.hpp"
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

  /// V - V0 when the argument of the excitation has grown from the phase to `angle`.
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

// V decreases while alpha > -mu and is smallest where alpha falls through -mu. The sign of this value, known to the
// rounding r of its terms, decides whether the block stops. A stop occurs at the zero of the closed form. V' there is
// the square root of 2 V'' times the depth, which gives the bound on its time.
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

// The slip ends where the increasing alpha passes mu_s. If it ends slightly before, the block rests for a moment and
// slides off; if slightly after, it reverses. In both cases it then slides the other way, and V is of second order in
// the difference.
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

// The slip stops where sticking would need N <= 0. The reference is an independent integration with 30 digits.
TEST(ReversalInRockSlide, KeepsTheBlockOnTheBaseWhereStickingWouldNot) {
  Stage stage{.frequency = 4.0, .phase = 1.213, .periods = 4};
  stage.start = {.tilt = -0.018 * support::psi, .tilt_rate = 0.407 * support::psi};
  ScriptedRun run(stage, {.amplitude_value = 7.722, .statics = {0.492}, .kinetics = {0.4377}});
  run.run();
  const auto& events = run.log.events;
  ASSERT_GE(events.size(), 2U) << run.log.story();
  const auto& stop = events[events.size() - 2];
  const auto& end = events.back();
  EXPECT_EQ(stop.kind, EventKind::slip_reverse) << run.log.story();
  EXPECT_NEAR(stop.tau, 3.20851037356, 1e-10);
  EXPECT_EQ(end.kind, EventKind::overturn) << run.log.story();
  EXPECT_NEAR(end.tau, 3.22022176636, 1e-10);
  EXPECT_NEAR(end.state.slip_rate, -0.0423, 5e-5);
}

/// For a block that rocks without slip: N of sticking, and whether slip against the friction of sticking has N > 0 and
/// is accelerated. From the laws of lib/docs/model.md, section 1.
struct Contact {
  long double sticking;
  bool slip_keeps_it;
};

Contact contact_of(const State& state, const Stage& stage, long double alpha, long double mu_k) {
  const long double phi = std::atan(static_cast<long double>(stage.block.width) / stage.block.height) -
                          state.side * static_cast<long double>(state.tilt);
  const long double s = std::sin(phi);
  const long double c = std::cos(phi);
  const long double square = static_cast<long double>(state.tilt_rate) * state.tilt_rate;
  const long double acceleration = -state.side * s + alpha * c;
  const long double friction = 4.0L / 3.0L * alpha - acceleration * c - state.side * square * s;
  const long double load = 4.0L / 3.0L - square * c;
  const long double direction = friction < 0.0L ? 1.0L : -1.0L;
  const long double q = state.side * s + direction * mu_k * c;
  const long double slipping_acceleration = -load * q / (stage.inertia + state.side * s * q);
  const long double normal = load + state.side * slipping_acceleration * s;
  const long double slip_acceleration =
      -4.0L / 3.0L * alpha - direction * mu_k * normal + slipping_acceleration * c + state.side * square * s;
  return {.sticking = load + state.side * acceleration * s,
          .slip_keeps_it = normal > 0.0L && direction * slip_acceleration > 0.0L};
}

// Stops, impacts, starts and redrawn amplitudes for blocks of every shape on a strongly moving base. After no event
// does a block stick without N > 0 where slip would keep it on the base. Cases that rounding decides are not tested.
TEST(LossOfContactInRock, NeverFollowsAnEventAfterWhichSlipKeepsTheBlockOnTheBase) {
  SplitMix draw(20161108);
  std::map<EventKind, int> saved;
  for (int scene = 0; scene < 4000; ++scene) {
    Stage stage{.periods = 3};
    stage.block.height = draw.uniform(0.6, 4.0);
    stage.frequency = draw.uniform(1.0, 12.0);
    stage.phase = draw.uniform(0.0, 6.28);
    stage.inertia = scene % 4 == 0 ? 4.0 / 3.0 : 1.0 / 3.0;
    const double shape_angle = stage.geometry().shape_angle;
    stage.start = {.tilt = draw.uniform(-0.9, 0.9) * shape_angle, .tilt_rate = draw.uniform(-1.5, 1.5)};
    if (draw.below(2) == 0) stage.start.slip_rate = draw.uniform(-0.5, 0.5);
    const double amplitude = draw.uniform(0.5, 12.0) / shape_angle;
    const double mu_s = draw.uniform(0.2, 1.2);
    const double mu_k = mu_s * draw.uniform(0.5, 1.0);
    ScriptedRun run(stage, {.amplitude_value = amplitude, .statics = {mu_s}, .kinetics = {mu_k}});
    run.run();
    const auto& events = run.log.events;
    for (std::size_t k = 0; k < events.size(); ++k) {
      if (k + 1 < events.size() && events[k + 1].tau - events[k].tau < 1e-12) continue;
      const State& after = events[k].state;
      if (!is_rocking(after.contact) || after.slip_rate != 0.0) continue;
      const long double alpha =
          amplitude * shape_angle * std::sin(static_cast<long double>(stage.frequency) * events[k].tau + stage.phase);
      const Contact contact = contact_of(after, stage, alpha, mu_k);
      if (contact.sticking > -1e-9L || !contact.slip_keeps_it) continue;
      EXPECT_EQ(after.contact, ContactState::rock_slide) << "scene " << scene << ": " << run.log.story();
      ++saved[events[k].kind];
    }
  }
  EXPECT_GT(saved[EventKind::slip_reverse], 20);
  EXPECT_GT(saved[EventKind::slip_start], 20);
}

}  // namespace
}  // namespace rocking::dynamics
