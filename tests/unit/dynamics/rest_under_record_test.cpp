// A block at rest passes the samples of a ground motion without series. Nothing else may change by that: every case is
// compared with the same motion advanced by ordinary steps.

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/ordinary_steps.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

/// The amplitude changes at certain instants, whether the block slips or not.
struct SteppedAmplitude : ConstantCoefficients {
  std::vector<double> amplitudes{1.0};  ///< at the start, after the first change, ...
  std::vector<Instant> changes{};       ///< in order

  [[nodiscard]] double amplitude(const Clock& clock) const { return amplitudes[changes_reached(clock)]; }
  [[nodiscard]] std::optional<Instant> next_change(const Clock& clock, bool) const {
    const std::size_t reached = changes_reached(clock);
    return reached < changes.size() ? std::optional(changes[reached]) : std::nullopt;
  }

 private:
  [[nodiscard]] std::size_t changes_reached(const Clock& clock) const {
    std::size_t reached = 0;
    while (reached < changes.size() && clock.until(changes[reached]) <= clock.resolution()) ++reached;
    return reached;
  }
};

using RecordedRun = support::Simulation<SteppedAmplitude>;

struct RestCase {
  std::string name;
  std::vector<double> accelerations;  ///< [g]
  std::optional<double> static_friction;
  double phase = 0.0;
  int per_period = 150;                 ///< samples
  double jump = -0.5;                   ///< ratio of the accelerations after and before
  double offset = 0.0;                  ///< of the samples from the strobe instants [sample intervals]
  double pause = 0.0;                   ///< after sample 400 [periods]
  std::vector<double> amplitudes{1.0};  ///< each holds for 0.371 periods, the last one to the end
};

constexpr double tangent = 0.25;

/// Below the threshold but for a burst of samples that starts at `from`.
std::vector<double> burst(double quiet, double peak, int from) {
  std::vector<double> values;
  for (int i = 0; i < 6 * 150; ++i) {
    const bool strong = i >= from && i < from + 30;
    values.push_back((strong ? peak : quiet) * std::sin(0.7 * i));
  }
  return values;
}

void PrintTo(const RestCase& c, std::ostream* out) { *out << c.name; }

class RestUnderRecord : public testing::TestWithParam<RestCase> {
 protected:
  [[nodiscard]] static support::Stage stage() { return {.phase = GetParam().phase, .periods = 6}; }

  [[nodiscard]] static Excitation excitation() {
    const support::Stage scene = stage();
    std::vector<GroundMotionSample> samples;
    for (std::size_t i = 0; i < GetParam().accelerations.size(); ++i) {
      const double intervals = static_cast<double>(i) + GetParam().offset;
      const double time =
          scene.period_length() * (intervals / GetParam().per_period + (i > 400 ? GetParam().pause : 0.0));
      samples.push_back({time, GetParam().accelerations[i], 0.0});
      if (i % 137 == 136) samples.push_back({time, GetParam().jump * GetParam().accelerations[i], 0.0});  // a jump
    }
    const Clock clock(scene.frequency, scene.phase);
    return RecordedExcitation<false>(std::make_shared<const NormalisedGroundMotion>(samples, 1.0, clock), 1.0);
  }

  [[nodiscard]] static SteppedAmplitude coefficients() {
    const Clock start(stage().frequency, stage().phase);
    SteppedAmplitude source{{.static_value = GetParam().static_friction, .kinetic_value = 0.1}, GetParam().amplitudes};
    for (std::size_t i = 1; i < source.amplitudes.size(); ++i) {
      source.changes.push_back(
          {.period = 0, .time = start.start() + 0.371 * static_cast<double>(i) * start.period_length()});
    }
    return source;
  }
};

TEST_P(RestUnderRecord, IsAsByOrdinarySteps) {
  RecordedRun run(stage(), coefficients(), excitation());
  run.run();
  RecordedRun ordinary(stage(), coefficients(), excitation());
  support::OrdinarySteps<RecordedRun::Motion> steps{ordinary.motion};
  const integrate::LoopCounts counts = integrate::advance(steps);

  EXPECT_EQ(run.log.story(), ordinary.log.story());
  ASSERT_EQ(run.log.events.size(), ordinary.log.events.size());
  for (std::size_t i = 0; i < run.log.events.size(); ++i) EXPECT_EQ(run.log.events[i].tau, ordinary.log.events[i].tau);
  ASSERT_EQ(run.log.strobes.size(), ordinary.log.strobes.size());
  for (std::size_t i = 0; i < run.log.strobes.size(); ++i) {
    EXPECT_EQ(run.log.strobes[i].tilt, ordinary.log.strobes[i].tilt) << i;
    EXPECT_EQ(run.log.strobes[i].slip, ordinary.log.strobes[i].slip) << i;
    EXPECT_EQ(run.log.strobes[i].contact, ordinary.log.strobes[i].contact) << i;
  }
  EXPECT_EQ(run.counts.steps, counts.steps);
  EXPECT_EQ(run.counts.root_isolations, counts.root_isolations);
  EXPECT_EQ(run.motion.segments_looked_up(), ordinary.motion.segments_looked_up());
  EXPECT_EQ(run.motion.clock().now(), ordinary.motion.clock().now());
  EXPECT_EQ(run.motion.termination(), ordinary.motion.termination());
}

INSTANTIATE_TEST_SUITE_P(
    Cases, RestUnderRecord,
    testing::Values(
        RestCase{"NeverLifts", burst(0.2, 0.24, 200), std::nullopt},
        RestCase{"Lifts", burst(0.2, 0.4, 250), std::nullopt},
        RestCase{"LiftsWithAPhase", burst(0.2, 0.4, 333), std::nullopt, 2.0},
        RestCase{"LiftsByAHair", burst(0.1, tangent*(1.0 + 1e-4), 250), std::nullopt},
        RestCase{"Slides", burst(0.1, 0.4, 250), 0.2}, RestCase{"SlidesByLittle", burst(0.15, 0.22, 250), 0.2},
        RestCase{"MayRockAndSlip", burst(0.2, 0.45, 150), 0.3},
        RestCase{"StartsAboveTheThreshold", burst(0.3, 0.3, 0), std::nullopt},
        RestCase{"LiftsUnderAFewSamples", burst(0.2, 0.4, 250), std::nullopt, 0.0, 100},
        RestCase{"JumpsAboveTheThreshold", burst(0.2, 0.2, 0), std::nullopt, 0.0, 150, 3.0},
        RestCase{.name = "StrobesBetweenSamples",
                 .accelerations = burst(0.2, 0.4, 250),
                 .static_friction = 0.3,
                 .offset = 0.4},
        RestCase{.name = "StrobesRightBeforeSamples",
                 .accelerations = burst(0.2, 0.4, 250),
                 .static_friction = {},
                 .offset = 1e-13},
        RestCase{.name = "StrobesRightAfterSamples",
                 .accelerations = burst(0.2, 0.4, 250),
                 .static_friction = {},
                 .offset = -1e-13},
        RestCase{
            .name = "PausesForPeriods", .accelerations = burst(0.2, 0.4, 450), .static_friction = {}, .pause = 2.3},
        RestCase{.name = "GrowsBetweenSamples",
                 .accelerations = burst(0.2, 0.2, 0),
                 .static_friction = {},
                 .amplitudes = {0.5, 0.9, 0.4, 1.6, 0.3}}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace rocking::dynamics
