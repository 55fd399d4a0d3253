// `rocking orbits`: periodic orbits of deterministic conditions.

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Orbits : public rocking::support::ProgramTest {
 protected:
  Orbits() {
    Json experiment = quick_experiment();
    experiment.erase("fluctuation");
    experiment["horizon"] = {{"transient_periods", 300}, {"sampled_periods", 60}};
    experiment["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "values": [4.5, 6.0]}])");
    write("quick.json", experiment.dump());
  }
};

TEST_F(Orbits, AreWrittenAndPrinted) {
  const auto outcome = rocking("orbits quick.json -o out --periods 3 --no-progress --branches 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("quick"), HasSubstr("amplitude"), HasSubstr("saddle"), HasSubstr("*"),
                                    HasSubstr("out/orbits.json")));
  const std::string text = read("out/orbits.json");
  EXPECT_EQ(objections("orbits", text), "");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["longest_period"], 3);
  ASSERT_EQ(json["conditions"].size(), 2U);
  for (const Json& condition : json["conditions"]) {
    ASSERT_FALSE(condition["orbits"].empty());
    const Json& on = condition["orbits"][condition["run"]["orbit"].get<std::size_t>()];
    EXPECT_EQ(condition["run"]["mode"], '(' + on["cycles"].dump() + ',' + on["period"].dump() + ')');
    EXPECT_EQ(on["stable"], true);
    EXPECT_EQ(on["found_by"], "run");
    for (const Json& orbit : condition["orbits"]) {
      EXPECT_EQ(orbit["points"].size(), orbit["period"].get<std::size_t>());
      EXPECT_EQ(orbit["points"][0][0], orbit["state"]["tilt"]);
      EXPECT_LE(orbit["residual"].get<double>(), 1e-13);
      EXPECT_EQ(orbit["symmetric"], &orbit == &condition["orbits"][orbit["mirror"].get<std::size_t>()]);
    }
  }
}

// A trajectory that starts on an orbit comes back to it: the states are in the units of `rocking trajectory`.
TEST_F(Orbits, AreThoseOfTrajectories) {
  ASSERT_EQ(rocking("orbits quick.json -q -o out --periods 3 --branches 1").exit_code, 0);
  const Json condition = Json::parse(read("out/orbits.json"))["conditions"][0];
  for (const Json& orbit : condition["orbits"]) {
    Json experiment = Json::parse(read("quick.json"));
    experiment["initial"] = orbit["state"];
    write("on_orbit.json", experiment.dump());
    const auto outcome = rocking("trajectory on_orbit.json --periods " + orbit["period"].dump());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    const Json end = Json::parse(outcome.output)["strobe"].back();
    for (const char* key : {"tilt", "tilt_rate", "slip_rate"}) {
      EXPECT_NEAR(end[key].get<double>(), orbit["state"][key].get<double>(), 1e-8) << orbit.dump();
    }
  }
}

TEST_F(Orbits, AreFollowedOverTheSweptParameter) {
  const auto outcome = rocking("orbits quick.json -o out --periods 3 --no-progress --from 4 --to 6 --branches 3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("symmetric"), HasSubstr("range"), HasSubstr("backed by a stable orbit")));
  const Json json = Json::parse(read("out/orbits.json"));
  EXPECT_EQ(json["parameter"], "/excitation/amplitude");
  EXPECT_EQ(json["range"], Json::parse("[4.0, 6.0]"));
  ASSERT_FALSE(json["branches"].empty());
  for (const Json& branch : json["branches"]) {
    for (const Json& point : branch["points"]) {
      EXPECT_GE(point["value"], 4.0);
      EXPECT_LE(point["value"], 6.0);
      EXPECT_EQ(point["points"].size(), branch["period"].get<std::size_t>());
    }
  }
  for (const Json& one : json["bifurcations"]) EXPECT_LT(one["branch"], json["branches"].size());
  EXPECT_EQ(json["labels"]["periodic"], 2);
  EXPECT_EQ(json["labels"]["certified"], 2);
  // A trajectory that starts on a point of a branch comes back to it.
  const Json& branch = json["branches"][0];
  const Json& point = branch["points"][branch["points"].size() / 2];
  Json experiment = Json::parse(read("quick.json"));
  experiment.erase("sweep");
  experiment["excitation"]["amplitude"] = point["value"];
  experiment["initial"] = point["state"];
  write("on_branch.json", experiment.dump());
  const auto trajectory = rocking("trajectory on_branch.json --periods " + branch["period"].dump());
  ASSERT_EQ(trajectory.exit_code, 0) << trajectory.errors;
  const Json end = Json::parse(trajectory.output)["strobe"].back();
  EXPECT_NEAR(end["tilt"].get<double>(), point["state"]["tilt"].get<double>(), 1e-8);
  EXPECT_EQ(rocking("report out/orbits.json -o figures").exit_code, 0);
  EXPECT_TRUE(exists("figures/branches.tsv"));
}

TEST_F(Orbits, AreNotFollowedWhereNoneOrNoNumberOfTheMotionIsSwept) {
  ASSERT_EQ(rocking("orbits quick.json -q -o none --periods 1 --no-branches").exit_code, 0);
  EXPECT_FALSE(Json::parse(read("none/orbits.json")).contains("branches"));
  EXPECT_EQ(objections("orbits", read("none/orbits.json")), "");
  Json experiment = Json::parse(read("quick.json"));
  experiment["sweep"] = Json::parse(R"([{"parameter": "/initial/tilt", "values": [0.0, 0.1]}])");
  write("starts.json", experiment.dump());
  ASSERT_EQ(rocking("orbits starts.json -q -o starts --periods 1").exit_code, 0);
  EXPECT_FALSE(Json::parse(read("starts/orbits.json")).contains("branches"));
}

TEST_F(Orbits, AreTheSameBytesOnAnyNumberOfThreadsAndAsJson) {
  ASSERT_EQ(rocking("orbits quick.json -q -o one -j 1 --periods 2 --branches 1").exit_code, 0);
  const auto printed = rocking("orbits quick.json -q -o two -j 2 --periods 2 --branches 1 --json");
  EXPECT_EQ(printed.output, read("one/orbits.json"));
  EXPECT_EQ(read("two/orbits.json"), read("one/orbits.json"));
}

}  // namespace
