// The excitation of kind "pulse" in experiment files: what is read, its default horizon, and what is refused.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/text/json.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"

namespace rocking {
namespace {

using testing::HasSubstr;

Json pulse_experiment(
    const std::string& excitation = R"({"kind": "pulse", "shape": "ricker", "amplitude": 3, "frequency_ratio": 5})") {
  return parse_json(R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4}, "excitation": )" +
                    excitation + "}");
}

Experiment pulse_experiment_of(const Json& document) { return experiment_in(document.dump()); }

TEST(PulseInFiles, IsReadWithItsShapeAmplitudeAndFrequency) {
  for (const auto& [name, shape] : {std::pair{"sine", dynamics::PulseShape::sine},
                                    {"cosine", dynamics::PulseShape::cosine},
                                    {"ricker", dynamics::PulseShape::ricker},
                                    {"half_sine", dynamics::PulseShape::half_sine},
                                    {"rectangle", dynamics::PulseShape::rectangle},
                                    {"triangle", dynamics::PulseShape::triangle}}) {
    const auto experiment = pulse_experiment_of(pulse_experiment(
        std::string(R"({"kind": "pulse", "amplitude": 3, "frequency_ratio": 5, "shape": ")") + name + "\"}"));
    EXPECT_EQ(std::get<Pulse>(experiment.conditions.at(0).scene.excitation),
              (Pulse{.shape = shape, .amplitude = 3.0, .frequency_ratio = 5.0}));
  }
  EXPECT_EQ(support::objections("experiment", pulse_experiment().dump()), "");
}

TEST(PulseInFiles, IsReadWithItsPhaseAndItsCycles) {
  const std::string text =
      R"({"kind":"pulse","shape":"mavroeidis_papageorgiou","amplitude":3.0,"frequency_ratio":5.0,"phase_rad":0.5,"cycles":1.6})";
  const auto experiment = pulse_experiment_of(pulse_experiment(text));
  EXPECT_EQ(std::get<Pulse>(experiment.conditions.at(0).scene.excitation),
            (Pulse{.shape = dynamics::PulseShape::mavroeidis_papageorgiou,
                   .amplitude = 3.0,
                   .frequency_ratio = 5.0,
                   .phase_of_shape = 0.5,
                   .cycles = 1.6}));
  EXPECT_THAT(experiment.canonical_text, HasSubstr(text));
  EXPECT_EQ(support::objections("experiment", pulse_experiment(text).dump()), "");
  const std::string c = R"({"kind": "pulse", "shape": "type_c", "amplitude": 3, "frequency_ratio": 5, "cycles": 2})";
  EXPECT_EQ(std::get<Pulse>(pulse_experiment_of(pulse_experiment(c)).conditions.at(0).scene.excitation).cycles, 2.0);
}

TEST(PulseInFiles, LastsWithItsSweptCycles) {
  Json document =
      pulse_experiment(R"({"kind": "pulse", "shape": "type_c", "amplitude": 3, "frequency_ratio": 5, "cycles": 1})");
  document["sweep"] = parse_json(R"([{"parameter": "/excitation/cycles", "values": [1, 11]}])");
  const Experiment experiment = pulse_experiment_of(document);
  const auto periods = [&](std::size_t i) { return experiment.conditions.at(i).horizon.sampled_periods; };
  EXPECT_NEAR(periods(1) - periods(0), 10, 1) << "11.5 and 1.4 periods, and until it rests";
}

TEST(PulseInFiles, HasACanonicalTextThatIsItsOwn) {
  const auto experiment = pulse_experiment_of(pulse_experiment());
  EXPECT_THAT(experiment.canonical_text,
              HasSubstr(R"("excitation":{"kind":"pulse","shape":"ricker","amplitude":3.0,"frequency_ratio":5.0})"));
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
}

// The pulse lasts 2.6504 periods; then 8 + 4/(1 - delta) in units of 1/p, delta = 1 - 1.5 sin^2(psi) = 1 - 1.5/17.
TEST(PulseInFiles, IsRunUntilTheBlockRestsAfterIt) {
  const double rest = 8.0 + 4.0 * 17.0 / 1.5;
  const Horizon horizon = pulse_experiment_of(pulse_experiment()).conditions.at(0).horizon;
  EXPECT_EQ(horizon.transient_periods, 0);
  EXPECT_EQ(horizon.sampled_periods,
            static_cast<int>(std::ceil(2.650352614923577 + rest * 5.0 / (2.0 * std::numbers::pi))));
}

TEST(PulseInFiles, HasAHorizonOfItsOwnAtEachSweptShapeAndFrequency) {
  Json document = pulse_experiment();
  document["sweep"] = parse_json(R"([{"parameter": "/excitation/shape", "values": ["sine", "ricker"]},
                                     {"parameter": "/excitation/frequency_ratio", "values": [1, 20]}])");
  const auto experiment = pulse_experiment_of(document);
  ASSERT_EQ(experiment.conditions.size(), 4U);
  EXPECT_LT(experiment.conditions[0].horizon.sampled_periods, experiment.conditions[2].horizon.sampled_periods);
  EXPECT_LT(experiment.conditions[0].horizon.sampled_periods, experiment.conditions[1].horizon.sampled_periods);
}

TEST(PulseInFiles, MayHaveARandomAmplitude) {
  Json document = pulse_experiment();
  document["fluctuation"] = parse_json(R"({"amplitude": {"relative_sigma": 0.1}})");
  EXPECT_DOUBLE_EQ(pulse_experiment_of(document).conditions.at(0).scene.fluctuation.amplitude, 0.3);
}

struct BadPulse {
  const char* excitation;
  const char* place;
  const char* reason;
  const char* remedy;
  bool by_schema = true;
};

void PrintTo(const BadPulse& bad, std::ostream* out) { *out << bad.excitation; }

class PulseFault : public ::testing::TestWithParam<BadPulse> {};

TEST_P(PulseFault, IsToldWithPlaceReasonAndRemedy) {
  try {
    static_cast<void>(pulse_experiment_of(pulse_experiment(GetParam().excitation)));
    FAIL() << "was read";
  } catch (const base::InputError& error) {
    const auto& problems = error.problems();
    ASSERT_EQ(problems.size(), 1U) << error.what();
    EXPECT_EQ(problems[0].place, GetParam().place);
    EXPECT_THAT(problems[0].reason, HasSubstr(GetParam().reason));
    EXPECT_THAT(problems[0].remedy, HasSubstr(GetParam().remedy));
  }
  EXPECT_EQ(support::objections("experiment", pulse_experiment(GetParam().excitation).dump()) != "",
            GetParam().by_schema);
}

INSTANTIATE_TEST_SUITE_P(
    All, PulseFault,
    ::testing::Values(
        BadPulse{R"({"kind": "pulse", "amplitude": 3, "frequency_ratio": 5})", "/excitation/shape", "is missing",
                 "ricker"},
        BadPulse{R"({"kind": "pulse", "shape": "rikker", "amplitude": 3, "frequency_ratio": 5})", "/excitation/shape",
                 "one of", "did you mean \"ricker\""},
        BadPulse{R"({"kind": "pulse", "shape": 3, "amplitude": 3, "frequency_ratio": 5})", "/excitation/shape",
                 "one of", "choose"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "frequency_ratio": 5})", "/excitation/amplitude", "is missing",
                 "4.2"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3})", "/excitation/frequency_ratio", "is missing",
                 "10.0"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": -3, "frequency_ratio": 5})",
                 "/excitation/amplitude", "from 0", "4.2"},
        BadPulse{R"({"kind": "pulse", "shape": "ricker", "amplitude": 3, "frequency_ratio": 5, "phase_rad": 0})",
                 "/excitation/phase_rad", "has no phase", "omit", false},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5, "cycles": 2})",
                 "/excitation/cycles", "is for the shapes type_c", "omit", false},
        BadPulse{R"({"kind": "pulse", "shape": "type_c", "amplitude": 3, "frequency_ratio": 5})", "/excitation/cycles",
                 "is missing", "2", false},
        BadPulse{R"({"kind": "pulse", "shape": "type_c", "amplitude": 3, "frequency_ratio": 5, "cycles": 1.5})",
                 "/excitation/cycles", "whole number", "give 1 or 2", false},
        BadPulse{R"({"kind": "pulse", "shape": "mavroeidis_papageorgiou", "amplitude": 3, "frequency_ratio": 5,
                     "cycles": 0.9})",
                 "/excitation/cycles", "from 1 to 1000", "2"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5, "scale": 2})",
                 "/excitation/scale", "has an amplitude", "\"amplitude\""},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5, "file": "r.txt"})",
                 "/excitation/file", "given by its shape", "recorded"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5, "time_step_s": 0.1})",
                 "/excitation/time_step_s", "given by its shape", "recorded"},
        BadPulse{R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5, "period": 2})",
                 "/excitation/period", "is not a key", ""}));

}  // namespace
}  // namespace rocking
