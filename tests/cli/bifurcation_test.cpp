// `rocking bifurcation`: responses that coexist along a sweep.

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Bifurcation : public rocking::support::ProgramTest {};

TEST_F(Bifurcation, WritesPointsAndPrintsResponses) {
  const auto outcome = rocking("bifurcation quick.json -o out --realisation 2 --no-progress");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("quick"), HasSubstr("amplitude"), HasSubstr("upwards"),
                                    HasSubstr("out/bifurcation.json")));
  const std::string text = read("out/bifurcation.json");
  EXPECT_EQ(objections("bifurcation", text), "");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["realisation"], 2);
  EXPECT_EQ(json["parameter"], "/excitation/amplitude");
  ASSERT_EQ(json["diagrams"].size(), 1U);
  const Json& steps = json["diagrams"][0]["steps"];
  ASSERT_EQ(steps.size(), 9U);
  std::string csv = "parameter,branch,tilt,tilt_rate,diagram\n";
  for (const Json& step : steps) {
    for (const Json& point : step["points"]) {
      csv += step["value"].dump() + ',' + step["branch"].get<std::string>() + ',' + point[0].dump() + ',' +
             point[1].dump() + ",0\n";
    }
  }
  EXPECT_EQ(read("out/bifurcation.csv"), csv);
  EXPECT_GT(csv.size(), 1000U);
}

TEST_F(Bifurcation, GivesTheSameBytesOnAnyNumberOfThreadsAndPrintsThemAsJson) {
  ASSERT_EQ(rocking("bifurcation quick.json -q -o one -j 1").exit_code, 0);
  const auto printed = rocking("bifurcation quick.json -q -o five -j 5 --json");
  EXPECT_EQ(printed.output, read("one/bifurcation.json"));
  EXPECT_EQ(read("five/bifurcation.json"), read("one/bifurcation.json"));
  EXPECT_EQ(read("five/bifurcation.csv"), read("one/bifurcation.csv"));
  ASSERT_EQ(rocking("bifurcation quick.json -q -o other --seed 9").exit_code, 0);
  EXPECT_NE(read("other/bifurcation.csv"), read("one/bifurcation.csv"));
}

TEST_F(Bifurcation, IsNotDrawnWithAResponseThatDoesNotExist) {
  ASSERT_EQ(rocking("bifurcation quick.json -q -o out").exit_code, 0);
  Json file = Json::parse(read("out/bifurcation.json"));
  file["diagrams"][0]["steps"][0]["mode"] = "flying";
  EXPECT_NE(objections("bifurcation", file.dump()), "");
  write("changed.json", file.dump());
  const auto outcome = rocking("report changed.json -o pictures");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors,
              AllOf(HasSubstr("/diagrams/0/steps/0/mode"), HasSubstr("must be the name of a response mode")));
}

TEST_F(Bifurcation, NamesTheFiguresOfAGridByTheirParameters) {
  Json grid = quick_experiment();
  grid["sweep"].push_back(Json::parse(R"({"parameter": "/friction", "values": [
    {"static": 0.35, "kinetic": 0.3}, {"static": 0.4, "kinetic": 0.35}]})"));
  grid["sweep"][1]["names"] = {"", "rough"};
  write("grid.json", grid.dump());
  const auto outcome = rocking("bifurcation grid.json -o out --no-progress");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("\n/friction = {\"static\":0.35,\"kinetic\":0.3}\n"), HasSubstr("\nrough\n")));
  ASSERT_EQ(rocking("report out/bifurcation.json -o drawn").exit_code, 0);
  EXPECT_TRUE(exists("drawn/bifurcation_friction_0.35_0.3.tsv"));
  EXPECT_TRUE(exists("drawn/bifurcation_friction_rough.svg"));
  EXPECT_EQ(shell("rm out/bifurcation.json").exit_code, 0);
  EXPECT_EQ(rocking("bifurcation grid.json -o out -q").exit_code, 74);
}

}  // namespace
