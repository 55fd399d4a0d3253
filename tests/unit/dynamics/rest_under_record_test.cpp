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

using RecordedRun = support::Simulation<ConstantCoefficients>;

struct RestCase {
  std::string name;
  std::vector<double> accelerations;  ///< [g]
  std::optional<double> static_friction;
  double phase = 0.0;
  int per_period = 150;  ///< samples
  double jump = -0.5;    ///< ratio of the accelerations after and before
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
      const double time = static_cast<double>(i) * scene.period_length() / GetParam().per_period;
      samples.push_back({time, GetParam().accelerations[i], 0.0});
      if (i % 137 == 136) samples.push_back({time, GetParam().jump * GetParam().accelerations[i], 0.0});  // a jump
    }
    const Clock clock(scene.frequency, scene.phase);
    return RecordedExcitation<false>(std::make_shared<const NormalisedGroundMotion>(samples, 1.0, clock), 1.0);
  }

  [[nodiscard]] static ConstantCoefficients coefficients() {
    return {.amplitude_value = 1.0, .static_value = GetParam().static_friction, .kinetic_value = 0.1};
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
    testing::Values(RestCase{"NeverLifts", burst(0.2, 0.24, 200), std::nullopt},
                    RestCase{"Lifts", burst(0.2, 0.4, 250), std::nullopt},
                    RestCase{"LiftsWithAPhase", burst(0.2, 0.4, 333), std::nullopt, 2.0},
                    RestCase{"LiftsByAHair", burst(0.1, tangent*(1.0 + 1e-4), 250), std::nullopt},
                    RestCase{"Slides", burst(0.1, 0.4, 250), 0.2},
                    RestCase{"SlidesByLittle", burst(0.15, 0.22, 250), 0.2},
                    RestCase{"MayRockAndSlip", burst(0.2, 0.45, 150), 0.3},
                    RestCase{"StartsAboveTheThreshold", burst(0.3, 0.3, 0), std::nullopt},
                    RestCase{"LiftsUnderAFewSamples", burst(0.2, 0.4, 250), std::nullopt, 0.0, 100},
                    RestCase{"JumpsAboveTheThreshold", burst(0.2, 0.2, 0), std::nullopt, 0.0, 150, 3.0}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace rocking::dynamics
