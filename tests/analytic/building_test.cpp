// Floors of buildings: against closed forms, against the superposition of the ramps of a record, and against a reference.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/scene/building.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"
#include "support/excitation.hpp"
#include "support/record_text.hpp"

namespace rocking {
namespace {

using Samples = std::vector<dynamics::GroundMotionSample>;

Building one_mode(double frequency_hz, double damping, double factor = 1.0) {
  return {.modes = {{.frequency_hz = frequency_hz, .damping_ratio = damping, .factor = factor}}};
}

/// Acceleration of a mode over the ground where that has a + s t from t = 0 on, by the closed form.
long double acceleration_of_mode(const BuildingMode& mode, long double t, long double a, long double s) {
  const auto z = static_cast<long double>(std::get<double>(mode.damping_ratio));
  const long double w = 2.0L * std::numbers::pi_v<long double> * std::get<double>(mode.frequency_hz);
  const long double damped = w * std::sqrt(1.0L - z * z);
  const long double decay = std::exp(-z * w * t), cosine = std::cos(damped * t), sine = std::sin(damped * t);
  return -decay * (a * (cosine - z * w / damped * sine) + s * sine / damped);
}

/// The floor at time t as the sum of the responses to each kink and each jump of the ground.
double floor_by_superposition(const Samples& ground, const Building& building, double t) {
  long double at = 0.0L;
  for (const BuildingMode& mode : modes_of(building)) {
    long double sum = acceleration_of_mode(mode, t - ground[0].time, ground[0].horizontal, 0.0L);
    long double slope_before = 0.0L;
    for (std::size_t i = 0; i < ground.size() && ground[i].time < t; ++i) {
      const bool is_last = i + 1 == ground.size();
      const long double length = is_last ? 1.0L : static_cast<long double>(ground[i + 1].time) - ground[i].time;
      if (!(length > 0.0L)) continue;
      const long double slope =
          is_last ? 0.0L : (static_cast<long double>(ground[i + 1].horizontal) - ground[i].horizontal) / length;
      const long double jump = is_last ? -static_cast<long double>(ground[i].horizontal) : 0.0L;
      sum += acceleration_of_mode(mode, static_cast<long double>(t) - ground[i].time, jump, slope - slope_before);
      slope_before = slope;
    }
    at += sum * static_cast<long double>(std::get<double>(mode.factor));
  }
  return static_cast<double>(at);
}

/// The largest difference from the superposition at every `stride`-th sample, over the peak.
double largest_error(const Samples& ground, const Building& building, std::size_t stride) {
  const Samples floor = floor_motion(ground, building);
  double error = 0.0, peak = 0.0;
  for (const auto& sample : floor) peak = std::max(peak, std::abs(sample.horizontal));
  std::size_t next = 1;  // the piece of the ground in which the sample lies
  for (std::size_t i = 1; i < floor.size(); i += stride) {
    const double t = floor[i].time;
    while (next < ground.size() && ground[next].time < t) ++next;
    double base = 0.0;
    if (next < ground.size()) {
      const double share = (t - ground[next - 1].time) / (ground[next].time - ground[next - 1].time);
      base = ground[next - 1].horizontal + share * (ground[next].horizontal - ground[next - 1].horizontal);
    }
    error = std::max(error, std::abs(floor[i].horizontal - base - floor_by_superposition(ground, building, t)));
  }
  return error / peak;
}

TEST(FloorMotion, OfAStepAndOfARampIsThatOfTheClosedForm) {
  for (const double frequency : {0.2, 1.5, 12.0}) {
    for (const double damping : {0.001, 0.05, 0.4}) {
      const Building building = one_mode(frequency, damping, 1.3);
      EXPECT_LT(largest_error({{0.0, 1.0, 0.0}, {8.0, 1.0, 0.0}}, building, 7), 1e-12) << frequency << ' ' << damping;
      EXPECT_LT(largest_error({{0.5, 0.0, 0.0}, {8.0, 2.0, 0.0}}, building, 7), 1e-12) << frequency << ' ' << damping;
    }
  }
}

TEST(FloorMotion, OfAResonantSineAndOfARecordIsTheSumOfItsRamps) {
  Samples sine, record;
  for (int i = 0; i <= 2000; ++i) sine.push_back({0.01 * i, std::sin(2.0 * std::numbers::pi * 1.5 * 0.01 * i), 0.0});
  const std::vector<double> values = support::noise(5, 1500);
  for (std::size_t i = 0; i < values.size(); ++i) record.push_back({0.02 * static_cast<double>(i), values[i], 0.0});
  const Building uniform{.frequency_hz = 1.5, .damping_ratio = 0.02, .height_ratio = 0.8};
  EXPECT_LT(largest_error(sine, one_mode(1.5, 0.02), 29), 1e-12);
  EXPECT_LT(largest_error(sine, uniform, 29), 1e-12);
  EXPECT_LT(largest_error(record, uniform, 29), 1e-12);
}

// The reference: 40 digits, printed to 18; see tests/reference/README.md.
TEST(FloorMotion, IsThatOfAReferenceInFortyDigits) {
  const std::string folder = ROCKING_SOURCE_DIR "/tests/reference/building/";
  std::ifstream text(folder + "ground.txt"), known(folder + "floor.json");
  Samples ground;
  for (double value = 0.0; text >> value;) ground.push_back({0.01 * static_cast<double>(ground.size()), value, 0.0});
  ASSERT_EQ(ground.size(), 2000U);
  const Json reference = Json::parse(known);
  const Building building{.frequency_hz = 1.5, .damping_ratio = 0.05, .height_ratio = 0.8, .uniform_modes = 3};
  const Samples floor = floor_motion(ground, building);
  const std::size_t parts = 1;  // the shortest period, 0.133 s, has 13 steps
  for (const auto& [sample, value] : reference["floor_m_s2"].items()) {
    EXPECT_NEAR(floor[std::stoul(sample) * parts].horizontal, std::stod(value.get<std::string>()), 1e-13) << sample;
  }
  const std::vector<BuildingMode> modes = modes_of(building);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_NEAR(std::get<double>(modes[i].factor), std::stod(reference["modes"][i]["factor"].get<std::string>()),
                1e-15);
  }
}

TEST(FloorMotion, HasTenStepsInTheShortestPeriod) {
  const Samples ground{{0.0, 0.0, 0.1}, {0.1, 1.0, 0.3}, {0.15, 0.0, 0.0}};
  const Samples floor = floor_motion(ground, one_mode(8.0, 0.05));
  for (std::size_t i = 1; i < floor.size(); ++i) {
    EXPECT_LE(floor[i].time - floor[i - 1].time, 0.0125 * (1.0 + 1e-12));
    if (floor[i].time > 0.1) continue;
    EXPECT_NEAR(floor[i].vertical, 0.1 + 2.0 * floor[i].time, 1e-15) << "as on the ground";
  }
}

TEST(FloorMotion, DividesEvenStepsAlikeThoughTheirTimesAreRounded) {
  Samples ground;
  for (int i = 0; i < 1000; ++i) ground.push_back({0.01 * i, std::sin(0.05 * i), 0.0});
  const Samples floor = floor_motion(ground, one_mode(10.0, 0.05));  // ten steps of the record in a period
  for (std::size_t i = 0; i < ground.size(); ++i) EXPECT_EQ(floor[i].time, ground[i].time);
}

TEST(FloorMotion, GoesOnUntilItStaysBelowAThousandthOfItsPeak) {
  for (const double damping : {0.005, 0.05, 0.5}) {
    const Samples ground{{0.0, 0.0, 0.0}, {0.01, 1.0, 0.0}, {0.02, -0.5, 0.0}, {0.03, 0.0, 0.0}};
    const Building building = one_mode(2.0, damping);
    const Samples floor = floor_motion(ground, building);
    double peak = 0.0;
    for (const auto& sample : floor) peak = std::max(peak, std::abs(sample.horizontal));
    EXPECT_LT(std::abs(floor.back().horizontal), 1e-3 * peak);
    EXPECT_GE(std::abs(floor[floor.size() - 2].horizontal), 1e-3 * peak);
    for (int i = 1; i < 200; ++i) {
      EXPECT_LT(std::abs(floor_by_superposition(ground, building, floor.back().time + 0.01 * i)), 1e-3 * peak);
    }
    EXPECT_LE(floor.back().time, ground.back().time + settling_time(building) + 0.02);
  }
}

TEST(FloorMotion, OfAJumpIsThatOfTheGroundAndOfNothingIsNothing) {
  const Samples jump{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {9.0, 1.0, 0.0}};
  const Building building = one_mode(1.0, 0.05, 0.7);
  const Samples floor = floor_motion(jump, building);
  const auto at_jump = std::ranges::find_if(floor, [](const auto& sample) { return sample.horizontal != 0.0; });
  EXPECT_EQ(at_jump->time, 1.0);
  EXPECT_NEAR(at_jump->horizontal, 1.0 - 0.7, 1e-15);
  const Samples still = floor_motion({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, building);
  EXPECT_EQ(still.back().time, 1.0);
  EXPECT_EQ(still.back().horizontal, 0.0);
}

/// A block without friction under a record.
Condition block_under(Samples samples) {
  Condition condition;
  condition.scene.excitation = support::recorded_by({.samples = std::move(samples)}, 10.0, 0.6);
  condition.horizon = {.transient_periods = 0, .sampled_periods = 60};
  return condition;
}

TEST(BlockInABuilding, MovesAsOnTheRecordOfItsFloor) {
  const std::vector<double> values = support::noise(9, 800);
  Samples ground;
  for (std::size_t i = 0; i < values.size(); ++i) {
    ground.push_back({0.01 * static_cast<double>(i), values[i] / 9.81, 0.0});
  }
  const Building building{.frequency_hz = 2.0, .height_ratio = 1.0};
  Condition in_building = block_under(ground);
  support::recorded(in_building.scene).building = building;
  const RealisationResult found = realise(in_building, 1, 0);
  const RealisationResult expected = realise(block_under(floor_motion(ground, building)), 1, 0);
  EXPECT_GT(found.peaks.tilt, 0.0);
  EXPECT_EQ(found.peaks.tilt, expected.peaks.tilt);
  EXPECT_EQ(found.strobe.back().tilt, expected.strobe.back().tilt);
  EXPECT_NE(found.peaks.tilt, realise(block_under(ground), 1, 0).peaks.tilt);
}

TEST(BlockInABuilding, HasAMotionOfItsOwnInEachRealisationWhereTheBuildingIsRandom) {
  const std::vector<double> values = support::noise(9, 800);
  Samples ground;
  for (std::size_t i = 0; i < values.size(); ++i) {
    ground.push_back({0.01 * static_cast<double>(i), values[i] / 9.81, 0.0});
  }
  Condition condition = block_under(ground);
  support::recorded(condition.scene).building =
      Building{.frequency_hz = Lognormal{.mean = 2.0, .sigma = 0.4}, .height_ratio = Uniform{.low = 0.2, .high = 1.0}};
  const double first = realise(condition, 1, 0).peaks.tilt;
  EXPECT_NE(first, realise(condition, 1, 1).peaks.tilt);
  EXPECT_EQ(first, realise(condition, 1, 0).peaks.tilt);
}

TEST(FloorInWords, SaysWhatIsAMeanOfDraws) {
  Building building = one_mode(2.5, 0.05);
  EXPECT_EQ(floor_in_words(building), "on a floor of a building of 2.5 Hz, 5 % damping, with 1 mode");
  building.modes.push_back({.frequency_hz = Uniform{.low = 5.0, .high = 8.0}});
  EXPECT_EQ(floor_in_words(building),
            "on a floor of a building of 2.5 Hz, 5 % damping, with 2 modes (means of what is drawn)");
}

}  // namespace
}  // namespace rocking
