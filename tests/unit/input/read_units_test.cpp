// Physical units in experiment files: an amplitude in g or m/s^2, a frequency in Hz or as a period in s, a measured
// ratio of the tilt rates. What is read, what a sweep of the block leaves as it is, and what is refused.

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/dynamics/impact.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/text/json.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"

namespace rocking {
namespace {

using testing::HasSubstr;

Json shaken_by(const std::string& excitation) {
  return support::with(support::least_experiment(), "/excitation", excitation);
}

Experiment experiment_of(const Json& document) { return experiment_in(document.dump()); }

const Scene& scene_of(const Experiment& experiment, std::size_t condition = 0) {
  return experiment.conditions.at(condition).scene;
}

std::string refusal_of(const Json& document) {
  try {
    static_cast<void>(experiment_of(document));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

dynamics::Geometry geometry_of(const Scene& scene) { return dynamics::geometry_of(mean_block(scene)); }

double amplitude_of(const Scene& scene) { return amplitude_for(scene, geometry_of(scene)); }

TEST(UnitsInFiles, GiveTheSameShakingInEveryUnit) {
  const dynamics::Geometry block = dynamics::geometry_of({1.0, 4.0, 9.81});
  const double hertz = 10.0 * block.frequency_parameter / (2.0 * std::acos(-1.0));
  for (const auto& [key, amplitude] : {std::pair{"amplitude", 4.5},
                                       {"amplitude_g", 4.5 * block.shape_angle},
                                       {"amplitude_m_s2", 4.5 * block.shape_angle * 9.81}}) {
    for (const auto& [other, frequency] :
         {std::pair{"frequency_ratio", 10.0}, {"frequency_hz", hertz}, {"period_s", 1.0 / hertz}}) {
      for (const char* kind : {R"({"kind": "harmonic"})", R"({"kind": "pulse", "shape": "sine"})"}) {
        Json excitation = Json::parse(kind);
        excitation[key] = amplitude;
        excitation[other] = frequency;
        const Json document = shaken_by(excitation.dump());
        const Experiment experiment = experiment_of(document);
        EXPECT_NEAR(amplitude_of(scene_of(experiment)), 4.5, 4.5 * 0x1p-50);
        EXPECT_NEAR(support::mean_frequency_ratio(scene_of(experiment)), 10.0, 10.0 * 0x1p-50);
        EXPECT_EQ(support::objections("experiment", document.dump()), "");
        EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
        EXPECT_EQ(support::objections("experiment", experiment.canonical_text), "");
      }
    }
  }
}

// Values that are exact in both forms: psi = pi/4 of a cube, and g = 1.
TEST(UnitsInFiles, AreTheSameBitsWhereTheConversionIsExact) {
  const dynamics::Block block{2.0, 2.0, 1.0};
  const double psi = dynamics::geometry_of(block).shape_angle;
  Json document = shaken_by(R"({"amplitude_g": 1, "frequency_ratio": 10})");
  document["block"] = Json::parse(R"({"width_m": 2, "height_m": 2, "gravity_m_s2": 1})");
  document["excitation"]["amplitude_g"] = 4.0 * psi;
  EXPECT_EQ(amplitude_of(scene_of(experiment_of(document))), 4.0);
  document["excitation"].erase("amplitude_g");
  document["excitation"]["amplitude_m_s2"] = 0.5 * psi;
  EXPECT_EQ(amplitude_of(scene_of(experiment_of(document))), 0.5);
}

TEST(UnitsInFiles, AreThoseOfTheFileInItsCanonicalText) {
  const auto experiment = experiment_of(shaken_by(R"({"period_s": 0.5, "amplitude_g": 0.4})"));
  EXPECT_THAT(experiment.canonical_text,
              HasSubstr(R"("excitation":{"kind":"harmonic","amplitude_g":0.4,"period_s":0.5,"phase_rad":0.0})"));
}

TEST(UnitsInFiles, KeepTheAccelerationAndThePeriodWhereTheBlockIsSwept) {
  Json document = shaken_by(R"({"amplitude_m_s2": 3, "period_s": 0.5})");
  document["sweep"] = parse_json(R"([{"parameter": "/block/width_m", "values": [0.5, 1, 2]},
                                     {"parameter": "/block/height_m", "values": [2, 8]}])");
  const auto experiment = experiment_of(document);
  ASSERT_EQ(experiment.conditions.size(), 6U);
  for (const Condition& condition : experiment.conditions) {
    const dynamics::Geometry block = geometry_of(condition.scene);
    EXPECT_NEAR(amplitude_of(condition.scene) * block.shape_angle * 9.81, 3.0, 3.0 * 0x1p-50);
    EXPECT_NEAR(support::mean_frequency_ratio(condition.scene) * block.frequency_parameter, 4.0 * std::acos(-1.0),
                0x1p-47);
  }
  EXPECT_NE(amplitude_of(scene_of(experiment, 0)), amplitude_of(scene_of(experiment, 4)));
}

TEST(UnitsInFiles, CanBeSwept) {
  for (const char* key : {"amplitude_g", "amplitude_m_s2", "frequency_hz", "period_s"}) {
    Json excitation = {{"amplitude_g", 0.4}, {"frequency_hz", 3}};
    excitation.erase(std::string(key).starts_with("amplitude") ? "amplitude_g" : "frequency_hz");
    excitation[key] = 1;
    Json document = shaken_by(excitation.dump());
    document["sweep"] =
        Json::array({{{"parameter", std::string("/excitation/") + key}, {"from", 0.2}, {"to", 0.6}, {"step", 0.2}}});
    const auto experiment = experiment_of(document);
    ASSERT_EQ(experiment.conditions.size(), 3U);
    EXPECT_EQ(json_text_of(experiment.conditions[1].parameters[0].value), "0.4");
    const bool is_amplitude = std::string(key).starts_with("amplitude");
    const auto number = [&](std::size_t i) {
      return is_amplitude ? amplitude_of(scene_of(experiment, i))
                          : support::mean_frequency_ratio(scene_of(experiment, i));
    };
    const double ratio = number(2) / number(0);
    EXPECT_NEAR(ratio, std::string(key) == "period_s" ? 1.0 / 3.0 : 3.0, 1e-14);
  }
}

// The pulse lasts one period of 0.5 s; then 8 + 4/(1 - delta) in units of 1/p, delta = 1 - 1.5/17.
TEST(UnitsInFiles, SetTheDefaultHorizonOfAPulse) {
  Json document = shaken_by(R"({"kind": "pulse", "shape": "sine", "amplitude_g": 0.4, "period_s": 0.5})");
  const double p = dynamics::geometry_of({1.0, 4.0, 9.81}).frequency_parameter;
  const double rest_s = (8.0 + 4.0 * 17.0 / 1.5) / p;
  EXPECT_EQ(experiment_of(document).conditions.at(0).horizon.sampled_periods,
            static_cast<int>(std::ceil(1.0 + rest_s / 0.5)));
  document["sweep"] = parse_json(R"([{"parameter": "/excitation/period_s", "values": [0.5, 2]}])");
  const auto swept = experiment_of(document);
  EXPECT_EQ(swept.conditions[1].horizon.sampled_periods, static_cast<int>(std::ceil(1.0 + rest_s / 2.0)));
  EXPECT_EQ(experiment_in(swept.canonical_text).canonical_text, swept.canonical_text);
}

TEST(UnitsInFiles, AreTheUnitsOfAFluctuation) {
  Json document = shaken_by(R"({"amplitude_g": 0.4, "frequency_hz": 3})");
  document["restitution"] = {{"rate_ratio", 0.9}};
  document["fluctuation"] = parse_json(R"({"amplitude": {"sigma": 0.02}, "restitution": {"sigma": 0.01}})");
  EXPECT_EQ(scene_of(experiment_of(document)).fluctuation.amplitude, 0.02);
  EXPECT_EQ(scene_of(experiment_of(document)).fluctuation.restitution, 0.01);
  document["fluctuation"] =
      parse_json(R"({"amplitude": {"relative_sigma": 0.1}, "restitution": {"relative_sigma": 0.1}})");
  EXPECT_DOUBLE_EQ(scene_of(experiment_of(document)).fluctuation.amplitude, 0.04);
  EXPECT_DOUBLE_EQ(scene_of(experiment_of(document)).fluctuation.restitution, 0.09);
}

TEST(ARateRatioInFiles, IsThatOfAnImpactWithoutSlipOfEachBlock) {
  Json document = support::least_experiment();
  document["restitution"] = {{"rate_ratio", 0.93}};
  document["sweep"] = parse_json(R"([{"parameter": "/block/width_m", "values": [0.7, 1, 2, 6]}])");
  EXPECT_EQ(support::objections("experiment", document.dump()), "");
  const auto experiment = experiment_of(document);
  EXPECT_THAT(experiment.canonical_text, HasSubstr(R"("restitution":{"rate_ratio":0.93})"));
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  for (const Condition& condition : experiment.conditions) {
    const dynamics::Geometry block = geometry_of(condition.scene);
    const double e = mean_restitution(condition.scene.restitution, block);
    const auto impact =
        dynamics::sticking_impact({.tilt_rate = -0.2, .slip_rate = 0.0, .restitution = e, .static_friction = 100.0},
                                  block, dynamics::ImpactSlipRule::absolute);
    ASSERT_TRUE(impact);
    EXPECT_NEAR(impact->tilt_rate / -0.2, 0.93, 0x1p-48);
  }
}

TEST(ARateRatioInFiles, CanBeSweptAmongOtherRestitutions) {
  Json document = support::least_experiment();
  document["sweep"] = parse_json(R"([{"parameter": "/restitution", "values": [0.1, "jy25", {"rate_ratio": 0.9}]}])");
  const auto experiment = experiment_of(document);
  EXPECT_EQ(scene_of(experiment, 0).restitution, Restitution(0.1));
  EXPECT_EQ(scene_of(experiment, 1).restitution, Restitution(Jy25Restitution{}));
  EXPECT_EQ(scene_of(experiment, 2).restitution, Restitution(RateRatio{0.9}));
  document["restitution"] = {{"rate_ratio", 0.9}};
  document["sweep"] = parse_json(R"([{"parameter": "/restitution/rate_ratio", "values": [0.85, 0.95]}])");
  EXPECT_EQ(scene_of(experiment_of(document), 1).restitution, Restitution(RateRatio{0.95}));
}

TEST(ARateRatioInFiles, MayDifferBetweenTheEdges) {
  Json document = support::least_experiment();
  document["restitution"] = parse_json(R"({"rate_ratio": [0.93, {"normal": {"mean": 0.9, "sigma": 0.01}}]})");
  EXPECT_EQ(support::objections("experiment", document.dump()), "");
  EXPECT_EQ(scene_of(experiment_of(document)).restitution,
            Restitution(RateRatio{.value = 0.93, .right = Normal{.mean = 0.9, .sigma = 0.01}}));
  document["restitution"] = parse_json(R"({"rate_ratio": [0.93, 0.9]})");
  document["fluctuation"] = parse_json(R"({"restitution": {"relative_sigma": 0.1}})");
  EXPECT_DOUBLE_EQ(scene_of(experiment_of(document)).fluctuation.restitution, 0.0915) << "of the mean of both";
  document["sweep"] = parse_json(R"([{"parameter": "/restitution/rate_ratio/1", "values": [0.85, 0.95]}])");
  const auto experiment = experiment_of(document);
  EXPECT_EQ(scene_of(experiment, 1).restitution, Restitution(RateRatio{.value = 0.93, .right = 0.95}));
  EXPECT_THAT(experiment.canonical_text, HasSubstr(R"("restitution":{"rate_ratio":[0.93,0.9]})"));
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  EXPECT_FALSE(has_mirror_symmetry(scene_of(experiment, 1))) << "of a rectangle with two ratios";
  document["sweep"] = parse_json(R"([{"parameter": "/restitution/rate_ratio", "values": [[0.9, 0.9], 0.9]}])");
  EXPECT_TRUE(has_mirror_symmetry(scene_of(experiment_of(document))));
}

// The least experiment has 500 + 120 periods of a harmonic excitation; a pulse ends, and the block goes on.
TEST(ARateRatioInFiles, OfOneNeedsAHorizon) {
  Json document = support::least_experiment();
  document["restitution"] = {{"rate_ratio", 1}};
  EXPECT_EQ(mean_restitution(scene_of(experiment_of(document)).restitution, dynamics::geometry_of({})), -1.0);
  document["horizon"] = parse_json(R"({"until_classified": {"at_most_periods": 5000}})");
  EXPECT_THAT(refusal_of(document), HasSubstr("/horizon/until_classified = {\"at_most_periods\":5000}: waits until"));
  document["restitution"] = parse_json(R"({"rate_ratio": [1, 0.99]})");
  EXPECT_EQ(refusal_of(document), "");
  document["restitution"] = {{"rate_ratio", 1}};
  document["excitation"] = parse_json(R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 5})");
  document["horizon"] = parse_json(R"({"transient_periods": 0})");
  EXPECT_THAT(refusal_of(document), HasSubstr("/horizon/sampled_periods: is missing: at a rate ratio of 1"));
  Json bad_block = document;
  bad_block.erase("restitution");
  bad_block["block"]["width_m"] = -1;
  EXPECT_THAT(refusal_of(bad_block), testing::Not(HasSubstr("/horizon")));
  document["horizon"] = parse_json(R"({"sampled_periods": 50})");
  EXPECT_EQ(refusal_of(document), "");
}

TEST(TheBalanceInFiles, MayEndAMotionThatBeginsBelowIt) {
  Json document = support::least_experiment();
  EXPECT_THAT(experiment_of(document).canonical_text, testing::Not(HasSubstr("until")));
  document["horizon"] = {{"until", "balance"}};
  EXPECT_EQ(support::objections("experiment", document.dump()), "");
  const Experiment experiment = experiment_of(document);
  EXPECT_EQ(experiment.conditions.at(0).horizon.until, MotionEnd::balance);
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  document["initial"] = {{"tilt", -1.0}};
  EXPECT_THAT(refusal_of(document), HasSubstr("/initial/tilt = -1.0: reaches the balance"));
  document["initial"] = {{"tilt_rad", 0.25}};  // psi is 0.245
  EXPECT_THAT(refusal_of(document), HasSubstr("/initial/tilt_rad = 0.25: reaches the balance"));
  document["initial"] = {{"tilt_deg", 14.1}};
  EXPECT_THAT(refusal_of(document), HasSubstr("/initial/tilt_deg = 14.1: reaches the balance"));
  for (const Json& below : {Json{{"tilt_rad", 0.24}}, Json{{"tilt_deg", 14.0}}}) {
    document["initial"] = below;
    EXPECT_EQ(refusal_of(document), "");
  }
}

TEST(AnInitialStateInFiles, IsGivenInSiUnitsOrNormalised) {
  Json document = support::least_experiment();
  document["friction"] = parse_json(R"({"static": 0.4, "kinetic": 0.35})");
  document["initial"] =
      parse_json(R"({"tilt_rad": -0.05, "tilt_rate": 0.2, "slip_m": 0.1, "slip_rate_m_s": {"uniform": [0, 0.1]}})");
  EXPECT_EQ(support::objections("experiment", document.dump()), "");
  const auto experiment = experiment_of(document);
  const InitialState expected{.tilt = -0.05,
                              .tilt_rate = 0.2,
                              .slip = 0.1,
                              .slip_rate = Uniform{0.0, 0.1},
                              .units = {.tilt = StateUnit::si, .slip = StateUnit::si, .slip_rate = StateUnit::si}};
  EXPECT_EQ(scene_of(experiment).initial, expected);
  EXPECT_THAT(experiment.canonical_text,
              HasSubstr(R"("initial":{"tilt_rad":-0.05,"tilt_rate":0.2,"slip_m":0.1,"slip_rate_m_s":{"uniform":[0)"));
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  document["sweep"] = parse_json(R"([{"parameter": "/initial/tilt_rad", "values": [0.01, 0.02]}])");
  EXPECT_EQ(scene_of(experiment_of(document), 1).initial.tilt, Quantity(0.02));
  EXPECT_EQ(scene_of(experiment_of(document), 1).initial.units, expected.units);
}

TEST(AVerticalMotionInFiles, TakesTheKeysOfTheHorizontalOne) {
  Json document = shaken_by(R"({"amplitude_g": 0.4, "frequency_hz": 1.8,
      "vertical": {"amplitude_m_s2": {"uniform": [1, 2]}, "period_s": 0.2777777777777778, "phase_rad": 0.5}})");
  EXPECT_EQ(support::objections("experiment", document.dump()), "");
  const auto experiment = experiment_of(document);
  const VerticalHarmonic expected{.phase = 0.5,
                                  .physical_amplitude = PhysicalAmplitude{Uniform{1.0, 2.0}, AccelerationUnit::m_s2},
                                  .physical_frequency = PhysicalFrequency{0.2777777777777778, FrequencyUnit::period_s}};
  EXPECT_EQ(std::get<Harmonic>(scene_of(experiment).excitation).vertical, expected);
  EXPECT_EQ(periods_of_base(scene_of(experiment)), 1) << "twice as fast, up to the rounding of the period";
  EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  EXPECT_NO_THROW(check_strobe(experiment));
  document["sweep"] = parse_json(R"([{"parameter": "/excitation/vertical/period_s", "values": [0.4, 1.1]}])");
  const auto swept = experiment_of(document);
  EXPECT_EQ(periods_of_base(scene_of(swept, 0)), std::nullopt);
  EXPECT_EQ(std::get<Harmonic>(scene_of(swept, 1).excitation).vertical->physical_frequency->value, Quantity(1.1));
  try {
    check_strobe(swept);
    FAIL() << "has strobe points";
  } catch (const base::InputError& error) {
    EXPECT_EQ(error.problems().at(0).place, "/excitation/vertical/period_s");
    EXPECT_THAT(error.problems()[0].reason, HasSubstr("another phase"));
  }
}

struct BadUnit {
  const char* place;  ///< of the edit
  std::string value;
  const char* told_at;
  const char* reason;
  const char* remedy;
  bool schema_sees_it = true;
};

void PrintTo(const BadUnit& bad, std::ostream* out) { *out << bad.place << " = " << bad.value; }

/// An experiment of a block that can slide, with a restitution.
std::string sliding_with(const std::string& restitution) {
  Json document = support::with(support::least_experiment(), "/restitution", restitution);
  document["friction"] = parse_json(R"({"static": 0.4, "kinetic": 0.35})");
  return document.dump();
}

class UnitFault : public ::testing::TestWithParam<BadUnit> {};

TEST_P(UnitFault, IsToldWithPlaceReasonAndRemedy) {
  const Json document = support::with(support::least_experiment(), GetParam().place, GetParam().value);
  try {
    static_cast<void>(experiment_of(document));
    FAIL() << "was read";
  } catch (const base::InputError& error) {
    const auto& problems = error.problems();
    ASSERT_EQ(problems.size(), 1U) << error.what();
    EXPECT_EQ(problems[0].place, GetParam().told_at);
    EXPECT_THAT(problems[0].reason, HasSubstr(GetParam().reason));
    EXPECT_THAT(problems[0].remedy, HasSubstr(GetParam().remedy));
  }
  EXPECT_EQ(support::objections("experiment", document.dump()).empty(), !GetParam().schema_sees_it);
}

INSTANTIATE_TEST_SUITE_P(
    All, UnitFault,
    ::testing::Values(
        BadUnit{"/excitation", R"({"frequency_ratio": 3})", "/excitation/amplitude", "is missing",
                "\"amplitude_g\": 0.4"},
        BadUnit{"/excitation", R"({"amplitude": 3})", "/excitation/frequency_ratio", "is missing", "\"period_s\": 0.5"},
        BadUnit{"/excitation/amplitude_g", "0.4", "/excitation/amplitude_g", "excludes \"amplitude\"", "keep one"},
        BadUnit{"/excitation/period_s", "1", "/excitation/period_s", "excludes \"frequency_ratio\"", "keep one"},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "amplitude_m_s2": 4, "frequency_hz": 3})",
                "/excitation/amplitude_m_s2", "excludes \"amplitude_g\"", "keep one"},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "frequency_hz": 3, "period_s": 0.3})", "/excitation/period_s",
                "excludes \"frequency_hz\"", "keep one"},
        BadUnit{"/excitation", R"({"amplitude_g": -0.4, "frequency_hz": 3})", "/excitation/amplitude_g", "from 0",
                "0.4"},
        BadUnit{"/excitation", R"({"amplitude_g": null, "frequency_hz": 3})", "/excitation/amplitude_g", "not null",
                "0.4"},
        BadUnit{"/excitation", R"({"amplitude_m_s2": "4", "frequency_hz": 3})", "/excitation/amplitude_m_s2",
                "must be a number", "without quotes"},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "frequency_hz": 0})", "/excitation/frequency_hz",
                "positive number of Hz", "3.0"},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "period_s": -1})", "/excitation/period_s",
                "positive number of seconds", "0.5"},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "period_s": 1e5})", "/excitation/period_s", "makes Omega_h",
                "give from", false},
        BadUnit{"/excitation", R"({"amplitude_g": 0.4, "frequency_hz": 3, "frequency_h": 3})",
                "/excitation/frequency_h", "is not a key", "did you mean"},
        BadUnit{"/restitution", R"({"rate_ratio": 1.01})", "/restitution/rate_ratio", "from 0 to 1", "0.93"},
        BadUnit{"", sliding_with(R"({"rate_ratio": 0.5})"), "/restitution/rate_ratio",
                "needs a restitution e = 4.66667", "0.823529", false},
        BadUnit{"", sliding_with(R"({"rate_ratio": [0.9, 0.5]})"), "/restitution/rate_ratio/1",
                "needs a restitution e = 4.66667 at the right edge", "omit \"friction\"", false},
        BadUnit{"/excitation/vertical", R"({"frequency_hz": 3})", "/excitation/vertical/amplitude", "is missing",
                "\"amplitude_g\": 0.4"},
        BadUnit{"/excitation/vertical", R"({"amplitude_g": 0.3, "frequency_hz": 3, "period_s": 1})",
                "/excitation/vertical/period_s", "excludes \"frequency_hz\"", "keep one"},
        BadUnit{"/excitation/vertical", R"({"amplitude_g": 0.3, "frequency_hz": 4e5})",
                "/excitation/vertical/frequency_hz", "makes Omega_v", "give from", false},
        BadUnit{"/excitation/vertical", R"({"amplitude_g": 0.3, "frequency_ratio": 2e5})",
                "/excitation/vertical/frequency_ratio", "1e4 times", "at most", false},
        BadUnit{"/excitation/vertical", R"({"amplitude_g": 3e5, "frequency_ratio": 20})",
                "/excitation/vertical/amplitude_g", "makes A_v", "give at most", false},
        BadUnit{"/excitation", R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 3,
                "vertical": {}})",
                "/excitation/vertical", "is for harmonic", "harmonic"},
        BadUnit{"/restitution", R"({"rate_ratio": [1.01, 0.9]})", "/restitution/rate_ratio/0", "from 0 to 1", "0.93"},
        BadUnit{"/restitution", R"({"rate_ratio": [0.9]})", "/restitution/rate_ratio", "list of two",
                "one ratio for each edge"},
        BadUnit{"/initial", R"({"tilt": 0.1, "tilt_rad": 0.1})", "/initial/tilt_rad", "excludes \"tilt\"", "keep one",
                false},
        BadUnit{"/initial", R"({"tilt_rad": -1.6})", "/initial/tilt_rad", "below pi/2 = 1.5708", "in rad", false},
        BadUnit{"/initial", R"({"tilt_deg": 90})", "/initial/tilt_deg", "below 90", "in degrees", false},
        BadUnit{"/initial", R"({"slip_m": 0.1})", "/initial/slip_m", "cannot slide", "friction", false},
        BadUnit{"/initial", R"({"slip_rate_m_s": 0.1})", "/initial/slip_rate_m_s", "cannot slide", "friction", false},
        BadUnit{"/sweep", R"([{"parameter": "/initial/tilt_rad", "values": [0.1]}])", "/sweep/0/parameter",
                "is not a value of this file", "the file has \"/initial/tilt\"", false},
        BadUnit{"/restitution", R"({"rate_ratio": 0.9, "ratio": 0.9})", "/restitution/ratio", "is not a key",
                "rate_ratio"},
        BadUnit{"/restitution", R"({})", "/restitution/rate_ratio", "is missing", "0.93"},
        BadUnit{"/restitution", R"("jy26")", "/restitution", "or be \"jy25\"", "rate_ratio"},
        BadUnit{"/sweep", R"([{"parameter": "/excitation/amplitude_g", "values": [0.1]}])", "/sweep/0/parameter",
                "is not a value of this file", "the file has \"/excitation/amplitude\"", false},
        BadUnit{"/sweep", R"([{"parameter": "/excitation/period_s", "values": [0.1]}])", "/sweep/0/parameter",
                "is not a value of this file", "write \"period_s\" in its place", false},
        BadUnit{"/sweep", R"([{"parameter": "/restitution/rate_ratio", "values": [0.9]}])", "/sweep/0/parameter",
                "is not a value of this file", "the file has \"/restitution\"", false}));

}  // namespace
}  // namespace rocking
