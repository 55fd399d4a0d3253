// `rocking compare`: the effect of a setting.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"
#include "support/record_text.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::quick_experiment;
using ::testing::HasSubstr;

class Compare : public rocking::support::ProgramTest {
 protected:
  Compare() {
    auto other = quick_experiment();
    other["horizon"] = {{"transient_periods", 100}, {"sampled_periods", 60}};
    write("first.json", other.dump());
    other["fluctuation"]["friction"]["sigma"] = 0.1;
    write("second.json", other.dump());
  }
};

TEST_F(Compare, HasTheConfidenceOfEachCondition) {
  auto swept = quick_experiment();
  swept["sweep"] = Json::parse(R"([ { "parameter": "/confidence", "values": [0.8, 0.999] } ])");
  write("swept.json", swept.dump());
  ASSERT_EQ(rocking("run swept.json -q -o a").exit_code, 0);
  const auto told = rocking("compare a a --json");
  EXPECT_EQ(objections("comparison", told.output), "");
  const Json json = Json::parse(told.output);
  EXPECT_TRUE(json["confidence"].is_null());
  EXPECT_EQ(json["conditions"][0]["confidence"], 0.8);
  EXPECT_EQ(json["conditions"][1]["confidence"], 0.999);
  // The two conditions differ in the confidence only: none of 4 realisations differs.
  const auto upper_end = [&](std::size_t i) { return json["conditions"][i]["changed"]["interval"][1].get<double>(); };
  EXPECT_NEAR(upper_end(0), 1.0 - std::pow(0.1, 0.25), 1e-12);
  EXPECT_NEAR(upper_end(1), 1.0 - std::pow(0.0005, 0.25), 1e-12);
  EXPECT_THAT(rocking("compare a a").output, HasSubstr("interval at the confidence of each condition"));

  const Json floor = Json::parse(read("a/report.json"))["result"]["tolerance_sensitivity"];
  ASSERT_EQ(floor["of"], 2);
  ASSERT_EQ(floor["flips"], 0);
  EXPECT_NEAR(floor["interval"][1].get<double>(), 1.0 - std::pow(0.0005, 0.5), 1e-12)
      << "the highest confidence of all";
}

// Records of a suite have independent random numbers: only the same record can be paired.
TEST_F(Compare, PairsSuitesRecordByRecord) {
  write("p.at2", rocking::support::peer_at2(std::vector<double>(60, 0.3), ".01"));
  write("q.at2", rocking::support::peer_at2({0.0, 0.3, -0.3, 0.3, -0.3, 0.0}, ".2"));
  Json suite = Json::parse(R"({ "format": "rocking.experiment/1", "block": { "width_m": 0.35, "height_m": 1.6 },
    "excitation": { "kind": "recorded", "suite": ["p.at2", "q.at2"] },
    "fluctuation": { "restitution": { "sigma": 0.05 } }, "realisations": 3 })");
  write("suite.json", suite.dump());
  suite["block"]["width_m"] = 0.4;
  write("wider.json", suite.dump());
  suite["excitation"]["suite"] = {"q.at2", "p.at2"};
  write("turned.json", suite.dump());
  for (const std::string name : {"suite", "wider", "turned"}) {
    ASSERT_EQ(rocking("run " + name + ".json -q -o " + name).exit_code, 0);
  }
  EXPECT_EQ(rocking("compare suite wider").exit_code, 0);
  const auto turned = rocking("compare suite turned");
  EXPECT_EQ(turned.exit_code, 64);
  EXPECT_THAT(turned.errors, HasSubstr("condition 0 of suite and of turned has different records"));
}

}  // namespace
