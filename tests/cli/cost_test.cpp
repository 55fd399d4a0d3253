// `rocking cost`: the cost of accuracy in an experiment.

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::quick_experiment;

class Cost : public rocking::support::ProgramTest {};

TEST_F(Cost, FindsTheSameAgainButForTimes) {
  Json results[2];
  for (const int threads : {1, 2}) {
    const auto outcome =
        rocking("cost quick.json --sample 10 --tolerances 1e-5,1e-9,1e-14 --json -j " + std::to_string(threads));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    Json& json = results[threads - 1] = Json::parse(outcome.output);
    EXPECT_EQ(json["result"]["tolerances"].size(), 4U) << "with the experiment's own, 1e-13";
    json.erase("system");
  }
  EXPECT_EQ(results[0].dump(), results[1].dump());
}

TEST_F(Cost, FindsThatErrorsFollowTheTolerance) {
  const Json json = Json::parse(rocking("cost quick.json --sample 6 --tolerances 1e-5,1e-9,1e-14 --json").output);
  const Json& rows = json["result"]["tolerances"];
  const auto error = [&](std::size_t i) { return rows[i]["departure"]["error"]["median"].get<double>(); };
  EXPECT_GT(error(0), 100.0 * error(1));
  EXPECT_GT(error(1), 100.0 * error(2));
  EXPECT_LT(rows[0]["steps_per_period"], rows[3]["steps_per_period"]);
  EXPECT_TRUE(rows[3]["departure"].is_null()) << "the reference";
}

TEST_F(Cost, MeasuresAtLeastOneRealisationHoweverShortTheTime) {
  const auto outcome = rocking("cost quick.json --time 0.000001s --json -j 1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  const Json json = Json::parse(outcome.output);
  EXPECT_EQ(json["result"]["sample"]["realisations"], 1);
  EXPECT_EQ(json["result"]["recommendation"]["assurance"], "none");
}

TEST_F(Cost, OfADeterministicExperimentMeasuresEachConditionOnce) {
  auto still = quick_experiment();
  still.erase("fluctuation");
  write("still.json", still.dump());
  const auto outcome = rocking("cost still.json --json");
  EXPECT_EQ(objections("cost", outcome.output), "");
  const Json result = Json::parse(outcome.output)["result"];
  EXPECT_EQ(result["sample"], Json::parse(R"({"realisations": 3, "conditions": 3, "is_everything": true})"));
  EXPECT_TRUE(result["realisations"].empty());
}

}  // namespace
