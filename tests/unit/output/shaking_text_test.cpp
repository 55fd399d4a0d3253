// Amplitude and frequency of the base in the units of the file, and the other form beside them.

#include "rocking/output/shaking_text.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Experiment shaken_by(const std::string& excitation, const std::string& sweep = "") {
  Json document = support::with(support::least_experiment(), "/excitation", excitation);
  if (!sweep.empty()) document["sweep"] = Json::parse(sweep);
  return experiment_in(document.dump());
}

std::vector<std::optional<Shaking>> shakings_of(const Experiment& experiment) {
  std::vector<std::optional<Shaking>> shakings;
  for (const Condition& condition : experiment.conditions) shakings.push_back(shaking_of(condition.scene));
  return shakings;
}

std::vector<std::string> swept_in(const Experiment& experiment) {
  std::vector<std::string> swept;
  for (const Parameter& parameter : experiment.conditions.front().parameters) swept.push_back(parameter.pointer);
  return swept;
}

std::vector<std::string_view> columns_of(const Experiment& experiment) {
  return shaking_columns(swept_in(experiment), shakings_of(experiment));
}

std::string common_to(const Experiment& experiment) {
  return common_shaking(swept_in(experiment), shakings_of(experiment));
}

// psi = atan(1/4) = 0.244979, R = sqrt(17)/2 m, p = sqrt(0.75 g/R) = 1.889 rad/s.
TEST(Shaking, HasEveryUnit) {
  const auto shaking = shaking_of(shaken_by(R"({"amplitude": 4.5, "frequency_ratio": 10})").conditions[0].scene);
  ASSERT_TRUE(shaking);
  const double p = std::sqrt(0.75 * 9.81 / (0.5 * std::sqrt(17.0)));
  EXPECT_EQ(shaking->amplitude, 4.5);
  EXPECT_NEAR(shaking->amplitude_g, 4.5 * std::atan(0.25), 1e-14);
  EXPECT_NEAR(shaking->amplitude_m_s2, 4.5 * std::atan(0.25) * 9.81, 1e-13);
  EXPECT_EQ(shaking->frequency_ratio, 10.0);
  EXPECT_NEAR(shaking->frequency_hz, 10.0 * p / (2.0 * std::acos(-1.0)), 1e-14);
  EXPECT_NEAR(shaking->period_s, 1.0 / shaking->frequency_hz, 1e-15);
}

TEST(Shaking, HasTheGivenNumbersToTheBit) {
  for (const char* excitation :
       {R"({"amplitude_g": 0.3, "period_s": 0.7})", R"({"amplitude_m_s2": 0.3, "frequency_hz": 0.7})"}) {
    const auto shaking = shaking_of(shaken_by(excitation).conditions[0].scene);
    ASSERT_TRUE(shaking);
    EXPECT_EQ(number_of(*shaking, shaking->given_amplitude), 0.3);
    EXPECT_EQ(number_of(*shaking, shaking->given_frequency), 0.7);
    Shaking again;
    std::vector<base::Problem> problems;
    type_of<Shaking>().read(type_of<Shaking>().json(&*shaking), {.pointer = "", .problems = &problems}, &again);
    EXPECT_THAT(problems, IsEmpty());
    for (const ShakingNumber& each : shaking_numbers) EXPECT_EQ(again.*each.number, (*shaking).*each.number);
    EXPECT_EQ(again.given_amplitude, shaking->given_amplitude);
    EXPECT_EQ(again.given_frequency, shaking->given_frequency);
  }
}

TEST(Shaking, IsShownInBothForms) {
  EXPECT_EQ(common_to(shaken_by(R"({"amplitude": 4.5, "frequency_ratio": 10})")),
            "A_h 4.5 = 1.1 g, Omega_h 10 = 3.01 Hz");
  EXPECT_EQ(common_to(shaken_by(R"({"amplitude_g": 1.1, "frequency_hz": 3})")),
            "1.1 g = A_h 4.49, 3 Hz = Omega_h 9.98");
  EXPECT_EQ(common_to(shaken_by(R"({"amplitude_m_s2": 4, "period_s": 0.5})")),
            "4 m/s^2 = A_h 1.66, 0.5 s = Omega_h 6.65");
}

TEST(ShakingColumns, AreTheOtherFormsThatDiffer) {
  const char* widths = R"([{"parameter": "/block/width_m", "values": [1, 2]}])";
  const auto normalised = shaken_by(R"({"amplitude": 4.5, "frequency_ratio": 10})", widths);
  EXPECT_THAT(columns_of(normalised), ElementsAre("amplitude_g", "frequency_hz"));
  EXPECT_EQ(common_to(normalised), "A_h 4.5, Omega_h 10");
  const auto physical = shaken_by(R"({"amplitude_g": 1.1, "period_s": 0.5})", widths);
  EXPECT_THAT(columns_of(physical), ElementsAre("amplitude", "frequency_ratio"));
  EXPECT_EQ(common_to(physical), "1.1 g, 0.5 s");
  const auto amplitudes = shaken_by(R"({"amplitude_g": 1.1, "period_s": 0.5})",
                                    R"([{"parameter": "/excitation/amplitude_g", "values": [1, 2]}])");
  EXPECT_THAT(columns_of(amplitudes), ElementsAre("amplitude"));
  EXPECT_EQ(common_to(amplitudes), "0.5 s = Omega_h 6.65");
  const auto restitutions =
      shaken_by(R"({"amplitude_g": 1.1, "period_s": 0.5})", R"([{"parameter": "/restitution", "values": [0, 0.1]}])");
  EXPECT_THAT(columns_of(restitutions), IsEmpty());
}

TEST(ShakingColumns, AreAllFormsWhereTheUnitIsSweptToo) {
  const auto experiment = shaken_by(R"({"amplitude_g": 1.1, "period_s": 0.5})", R"([{"parameter": "/excitation",
      "values": [{"amplitude_g": 1.1, "period_s": 0.5}, {"amplitude_m_s2": 5, "period_s": 0.5}]}])");
  EXPECT_THAT(columns_of(experiment), ElementsAre("amplitude_g", "amplitude", "amplitude_m_s2"));
  EXPECT_EQ(common_to(experiment), "0.5 s = Omega_h 6.65");
}

TEST(Shaking, IsToldAsAMeanWhereItIsDrawn) {
  const auto drawn = shaken_by(R"({"amplitude_g": 1.1, "period_s": {"uniform": [0.4, 0.6]}})");
  EXPECT_EQ(common_to(drawn), "1.1 g = A_h 4.49, 0.5 s = Omega_h 6.65 (mean of what is drawn)");
  const auto phase = shaken_by(R"({"amplitude_g": 1.1, "period_s": 0.5, "phase_rad": {"uniform": [0, 1]}})");
  EXPECT_EQ(common_to(phase), "1.1 g = A_h 4.49, 0.5 s = Omega_h 6.65");
}

TEST(ShakingColumns, AreAbsentWithoutShaking) {
  EXPECT_THAT(shaking_columns({}, std::vector<std::optional<Shaking>>{std::nullopt, std::nullopt}), IsEmpty());
  EXPECT_EQ(common_shaking({}, std::vector<std::optional<Shaking>>{std::nullopt}), "");
  EXPECT_EQ(column_cell(std::nullopt, "amplitude"), ".");
}

TEST(ModeTableOfShaking, HasTheOtherFormBesideTheSweptOne) {
  const auto experiment = shaken_by(R"({"amplitude": 4.5, "frequency_ratio": 10})",
                                    R"([{"parameter": "/excitation/amplitude", "values": [3, 4.5]}])");
  ConditionResult condition;
  condition.realisations = 1;
  Estimate estimate;
  estimate.counts = {.successes = 1, .trials = 1};
  estimate.estimate = 1.0;
  estimate.simultaneous = {.low = 0.5, .high = 1.0};
  condition.modes.push_back({.mode = section::periodic(1, 1), .probability = estimate});
  condition.stopped_because = StoppedBecause::deterministic;
  EXPECT_EQ(mode_table(report_of(experiment, {.conditions = {condition, condition}}, {})),
            "amplitude  amplitude_g  response\n"
            "        3       0.7349     (1,1)\n"
            "      4.5        1.102     (1,1)\n"
            "shaking: Omega_h 10 = 3.01 Hz\n");
}

TEST(Shaking, StatesTheVerticalSineThatAllConditionsHave) {
  const auto experiment = shaken_by(
      R"({"amplitude_g": 0.4, "frequency_hz": 1.8, "vertical": {"amplitude_m_s2": 1.962, "period_s": 0.5, "phase_rad": 1}})");
  std::vector<std::optional<Shaking>> shakings{shaking_of(experiment.conditions[0].scene)};
  EXPECT_EQ(common_shaking({}, shakings).substr(0, 5), "0.4 g");
  EXPECT_THAT(common_shaking({}, shakings),
              ::testing::EndsWith("Hz = Omega_h 5.99, vertically 0.2 g, 2 Hz, phase 1 rad"));
  shakings.push_back(shakings.front());
  shakings.back()->vertical->phase_rad = 2.0;
  EXPECT_THAT(common_shaking({}, shakings), ::testing::EndsWith("Omega_h 5.99"));
}

TEST(ShortValue, NamesARateRatio) {
  EXPECT_EQ(short_value({.pointer = "/restitution", .value = WrittenPart{R"({"rate_ratio":0.93})"}}),
            "rate ratio 0.93");
  EXPECT_EQ(short_value({.pointer = "/restitution", .value = WrittenPart{R"({"rate_ratio":[0.93,0.9]})"}}),
            "rate ratio [0.93,0.9]");
  EXPECT_THAT(
      short_value({.pointer = "/restitution", .value = WrittenPart{R"({"rate_ratio":{"uniform":[0.9,0.95]}})"}}),
      ::testing::HasSubstr("uniform"));
}

}  // namespace
}  // namespace rocking
