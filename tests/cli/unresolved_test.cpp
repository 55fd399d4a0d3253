// Realisations that a budget of steps ends: they are unresolved, and never count as standing.

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Unresolved : public rocking::support::ProgramTest {
 protected:
  /// At 0.6 g the block slides 2 m in a period, through two million cells of friction.
  Unresolved() {
    write("e.json", R"({
      "format": "rocking.experiment/1", "title": "fine cells", "block": { "width_m": 0.6, "height_m": 1.6 },
      "excitation": { "kind": "harmonic", "amplitude_g": 0.6, "frequency_hz": 0.5 },
      "friction": { "static": 0.05, "kinetic": 0.04 },
      "fluctuation": { "friction": { "sigma": 0.001, "correlation": 1, "refresh_slip_m": 1e-6 } },
      "horizon": { "transient_periods": 0, "sampled_periods": 1 },
      "sweep": [ { "parameter": "/excitation/amplitude_g", "values": [0.01, 0.6] } ],
      "realisations": 2, "confidence": 0.9, "seed": "0x21" })");
    write("hazard.csv", "amplitude_g, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n2, 1e-5\n");
  }
};

TEST_F(Unresolved, IsToldInTheTableAndBoundsTheShares) {
  const auto outcome = rocking("run e.json -o out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(
      outcome.output,
      AllOf(HasSubstr("overturning: none in 4 realisations, of which 2 ended without an answer; at most 100.0 %"),
            HasSubstr("warning: 2 of 4 realisations ended before their horizon without an answer")));
  const Json conditions = Json::parse(read("out/report.json"))["result"]["conditions"];
  EXPECT_EQ(conditions[1]["validity"]["stopped"], 2);
  EXPECT_EQ(conditions[1]["counts"]["unresolved"], 2);
  const Json& overturned = conditions[1]["probabilities"]["overturned"];
  for (const char* key : {"wilson", "clopper_pearson", "simultaneous"}) {
    EXPECT_EQ(overturned[key][0], 0.0) << key;
    EXPECT_EQ(overturned[key][1], 1.0) << key;
  }
  EXPECT_LT(conditions[0]["probabilities"]["overturned"]["clopper_pearson"][1].get<double>(), 1.0);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), HasSubstr("ended without an answer"));

  const std::string ask = "fragility out --hazard hazard.csv --event 'overturning,tilt > 0.5 psi' ";
  EXPECT_THAT(rocking(ask).output,
              AllOf(HasSubstr("unresolved"), HasSubstr("some realisations ended without an answer")));
  const auto found = rocking(ask + "--json");
  EXPECT_EQ(objections("fragility", found.output), "");
  const Json answer = Json::parse(found.output);
  for (const Json& curve : answer["curves"]) {
    EXPECT_EQ(curve["outcome"], "unresolved");
    EXPECT_FALSE(curve["levels"][0].contains("unresolved"));
    EXPECT_EQ(curve["levels"][1]["unresolved"], 2);
    EXPECT_EQ(curve["levels"][1]["exact"], Json({0.0, 1.0}));
    EXPECT_EQ(curve["annual_rate"]["from"], "levels");
    const double above = 1e-2 * std::pow(3.75, -std::log(10.0) / std::log(5.0));  // from the least uplift on
    EXPECT_NEAR(curve["annual_rate"]["interval"][1].get<double>(), above, 1e-9);
  }
}

TEST_F(Unresolved, StopsAnInferenceThatWouldCountIt) {
  Json experiment = Json::parse(read("e.json"));
  experiment.erase("sweep");
  experiment["realisations"] = 1;
  experiment["unknown"] = {{{"parameter", "/friction/static"}, {"from", 0.041}, {"to", 0.06}}};
  write("unknown.json", experiment.dump());
  write("tests.csv", "overturned,other\n0,5\n");
  const auto outcome = rocking("infer unknown.json --tests tests.csv -o out -q");
  EXPECT_EQ(outcome.exit_code, 65) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("end before their horizon without an answer"));
}

}  // namespace
