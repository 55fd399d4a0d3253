// `rocking fragility`: overturning as a function of the intensity.

#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Fragility : public rocking::support::ProgramTest {
 protected:
  /// A slow harmonic motion with a random phase; some realisations overturn.
  static Json random_phase() {
    return Json::parse(R"({
      "format": "rocking.experiment/1", "title": "shaken", "block": { "width_m": 1.0, "height_m": 8.0 },
      "excitation": { "amplitude": 2.0, "frequency_ratio": 4.0, "phase_rad": { "uniform": [0, 6.283185307179586] } },
      "horizon": { "transient_periods": 0, "sampled_periods": 20 },
      "sweep": [ { "parameter": "/restitution", "values": [0.0, 0.2] },
                 { "parameter": "/excitation/amplitude", "values": [3.0, 1.5, 2.0, 0.0] } ],
      "realisations": 40, "seed": "0x7" })");
  }

  Json fragility_of(const Json& experiment, const std::string& folder) {
    write("e.json", experiment.dump());
    EXPECT_EQ(rocking("run e.json -q -o " + folder).exit_code, 0);
    const auto found = rocking("fragility " + folder + " --json");
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_EQ(objections("fragility", found.output), "");
    return Json::parse(found.output);
  }
};

TEST_F(Fragility, CountsWhatTheReportCountsByGrowingAmplitudeForEachPointOfTheGrid) {
  const Json curves = fragility_of(random_phase(), "out")["curves"];
  const Json report = Json::parse(read("out/report.json"));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[1]["others"]["/restitution"], 0.2);
  const std::vector<std::size_t> order{1, 2, 0};  // by amplitude, without 0
  for (std::size_t curve = 0; curve < 2; ++curve) {
    const bool is_rejected = curves[curve]["test"]["p_value"] <= 0.05;
    EXPECT_EQ(curves[curve]["outcome"], is_rejected ? "rejected" : "fitted");
    EXPECT_EQ(curves[curve]["law"].is_null(), is_rejected);
    ASSERT_EQ(curves[curve]["levels"].size(), 3U);
    for (std::size_t level = 0; level < 3; ++level) {
      const Json& found = curves[curve]["levels"][level];
      const Json& condition = report["result"]["conditions"][4 * curve + order[level]];
      EXPECT_EQ(found["intensity"], condition["parameters"]["/excitation/amplitude"]);
      EXPECT_EQ(found["overturned"], condition["counts"]["overturned"]);
      EXPECT_EQ(found["exact"], condition["probabilities"]["overturned"]["clopper_pearson"]);
      EXPECT_EQ(found["isotonic"].is_null(), !is_rejected);
      EXPECT_EQ(found["band"] == found["simultaneous"], is_rejected);
    }
  }
}

TEST_F(Fragility, SaysAWholeSentenceOfEachOfTwoEqualRuns) {
  Json experiment = random_phase();
  experiment["sweep"].erase(0);
  static_cast<void>(fragility_of(experiment, "first"));
  ASSERT_EQ(shell("cp -r first second").exit_code, 0);
  EXPECT_THAT(rocking("fragility first second").output,
              AllOf(HasSubstr("first: The block overturn"), HasSubstr(".\nsecond: The block overturn")));
}

// The same shaking in g and in m/s^2: the same counts, and each output has the other form beside the intensity.
TEST_F(Fragility, TakesAPhysicalAmplitudeAsItsIntensity) {
  const double psi_g = std::atan(1.0 / 8.0) * 9.81;
  const Json of_ratio = fragility_of(random_phase(), "ratio")["curves"][0];
  for (const auto& [key, unit] : {std::pair{"amplitude_g", psi_g / 9.81}, std::pair{"amplitude_m_s2", psi_g}}) {
    auto physical = random_phase();
    physical["excitation"].erase("amplitude");
    physical["excitation"][key] = 1.0;
    physical["sweep"][1] = {{"parameter", std::string("/excitation/") + key},
                            {"values", {3.0 * unit, 1.5 * unit, 2.0 * unit, 0.0}}};
    const Json curve = fragility_of(physical, key)["curves"][0];
    EXPECT_EQ(curve["parameter"], std::string("/excitation/") + key);
    ASSERT_EQ(curve["levels"].size(), 3U);
    for (std::size_t level = 0; level < 3; ++level) {
      EXPECT_EQ(curve["levels"][level]["overturned"], of_ratio["levels"][level]["overturned"]);
      EXPECT_NEAR(curve["levels"][level]["shaking"]["amplitude"].get<double>(),
                  of_ratio["levels"][level]["intensity"].get<double>(), 1e-14);
    }
    EXPECT_NEAR(curve["law"]["median"]["value"].get<double>(), unit * of_ratio["law"]["median"]["value"].get<double>(),
                1e-9);
    const auto told = rocking(std::string("fragility ") + key + " -o kept_" + key);
    EXPECT_THAT(told.output, AllOf(HasSubstr(std::string(key) + "  amplitude  "), HasSubstr("  1.5  "),
                                   HasSubstr("shaking: Omega_h 4 = ")));
    EXPECT_EQ(rocking(std::string("report kept_") + key + "/fragility.json -o drawn_" + key).exit_code, 0);
  }
}

TEST_F(Fragility, MarksAMedianOutsideTheLevels) {
  auto low = random_phase();
  low["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "values": [1.4, 1.5, 1.6, 1.65]}])");
  low["restitution"] = 0.2;
  low["realisations"] = 200;
  const Json curve = fragility_of(low, "low")["curves"][0];
  ASSERT_EQ(curve["outcome"], "fitted");
  EXPECT_TRUE(curve["law"]["median"]["extrapolated"]);
  EXPECT_GT(curve["law"]["median"]["value"], 1.65);
  EXPECT_THAT(rocking("fragility low").output, HasSubstr("median > 1.65 (extrapolated: "));
}

TEST_F(Fragility, IsDiagnosedWhereThereIsNoLaw) {
  auto still = random_phase();
  still["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "values": [0.1, 0.2]}])");
  EXPECT_EQ(fragility_of(still, "still")["curves"][0]["outcome"], "never_happened");
  EXPECT_THAT(rocking("fragility still").output, HasSubstr("the block never overturned; add higher intensities"));
  EXPECT_EQ(rocking("fragility still -o kept").exit_code, 0);
  EXPECT_EQ(rocking("report kept/fragility.json -o drawn").exit_code, 0);
  auto certain = random_phase();
  certain["excitation"]["phase_rad"] = 0.0;
  EXPECT_EQ(fragility_of(certain, "certain")["curves"][0]["outcome"], "too_little");
}

TEST_F(Fragility, HasNoLawWhereEveryRealisationDoesTheSame) {
  auto scattered = random_phase();  // friction that is random but never slips: common random numbers, equal outcomes
  scattered["excitation"]["phase_rad"] = 0.0;
  scattered["friction"] = {{"static", 0.9}, {"kinetic", 0.85}};
  scattered["fluctuation"] = {{"friction", {{"sigma", 0.0001}, {"refreshes_per_period", 4}}}};
  Json& values = scattered["sweep"][1]["values"] = Json::array();
  for (int i = 0; i < 30; ++i) values.push_back(1.5 + 0.1 * i);
  scattered["realisations"] = 3;
  const Json fitted = fragility_of(scattered, "out");
  std::vector<std::string> outcomes;
  for (const Json& curve : fitted.at("curves")) {
    outcomes.push_back(curve.at("outcome"));
    EXPECT_TRUE(curve.at("law").is_null());
  }
  // With restitution 0 the outcome changes once as the amplitude increases, with 0.2 more than once.
  EXPECT_THAT(outcomes, ElementsAre("separated", "no_scatter"));
  const auto told = rocking("fragility out -o kept");
  EXPECT_THAT(told.output, HasSubstr("the realisations overturn at the same levels"));
  EXPECT_EQ(rocking("report kept/fragility.json -o drawn").exit_code, 0);
}

TEST_F(Fragility, RefusesRunsThatItCannotRead) {
  auto other = random_phase();
  other["sweep"].erase(1);
  other["sweep"][0]["values"] = {0.0, 0.1};
  write("other.json", other.dump());
  ASSERT_EQ(rocking("run other.json -q -o other").exit_code, 0);
  const auto swept = rocking("fragility other");
  EXPECT_EQ(swept.exit_code, 64);
  EXPECT_THAT(swept.errors, HasSubstr("sweeps no intensity"));
  other = random_phase();
  other["realisations"] = {{"until", {{"half_width", 0.2}, {"at_most", 60}}}};
  write("until.json", other.dump());
  ASSERT_EQ(rocking("run until.json -q -o until").exit_code, 0);
  EXPECT_EQ(rocking("fragility until").exit_code, 64);
  write("e.json", random_phase().dump());
  ASSERT_EQ(rocking("run e.json -q -o half --shard 1/2").exit_code, 0);
  const auto half = rocking("fragility half");
  EXPECT_EQ(half.exit_code, 66);
  EXPECT_THAT(half.errors, HasSubstr("rocking resume"));
  EXPECT_EQ(rocking("fragility absent").exit_code, 66);
}

}  // namespace
