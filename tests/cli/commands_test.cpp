// Output of each command.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/base/digest.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::example_experiment;
using rocking::support::objections;
using rocking::support::quick_experiment;
using rocking::support::recorded_experiment;
using rocking::support::recorded_pulse;
using rocking::support::without;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Command : public rocking::support::ProgramTest {};

TEST_F(Command, HelpsWithAnExample) {
  const auto all = rocking("--help");
  EXPECT_EQ(all.exit_code, 0);
  for (const char* command : {"run", "trajectory", "check-normal", "validate", "schema", "doctor"}) {
    EXPECT_THAT(all.output, HasSubstr(command));
    const auto help = rocking(std::string(command) + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.output, AllOf(HasSubstr(std::string("Example: rocking ") + command), HasSubstr("--json")));
    EXPECT_EQ(help.errors, "");
  }
}

TEST_F(Command, RunWritesAReportThatKeepsToItsSchema) {
  ASSERT_EQ(rocking("run quick.json -o out").exit_code, 0);
  EXPECT_EQ(objections("report", read("out/report.json")), "");
}

TEST_F(Command, RunPrintsTheTableAndWhereTheReportIs) {
  const auto outcome = rocking("run quick.json -o out");
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("amplitude"), HasSubstr("4.2"), HasSubstr("unresolved"),
                                    HasSubstr("report: out/report.json")));
}

// Realisation 1 of this condition of the headline experiment settles on (1,3) in the third eighth of its sampled
// periods.
TEST_F(Command, RunSaysHowManySettledLateAndTheLeastHeldShare) {
  Json experiment = without(example_experiment(), "sweep");
  experiment["realisations"] = 2;
  experiment["excitation"]["amplitude"] = 5.5;
  experiment["friction"] = {{"static", 0.40}, {"kinetic", 0.35}};
  write("late.json", experiment.dump());
  const std::string line =
      "settled late: 1 realisation, classified by the last 62.5 % of their sampled periods or more";
  EXPECT_THAT(rocking("run late.json -o late").output, HasSubstr(line));
  EXPECT_THAT(rocking("run quick.json -o out").output, Not(HasSubstr("settled late")));
}

TEST_F(Command, RunWithJsonPrintsTheReportAndNothingElse) {
  const auto outcome = rocking("run quick.json -o out --json");
  EXPECT_EQ(outcome.output, read("out/report.json"));
}

TEST_F(Command, RunQuietlySaysNothingBesideTheResult) { EXPECT_EQ(rocking("run quick.json -o out -q").errors, ""); }

TEST_F(Command, RunGivesTheSameBytesOnAnyNumberOfThreads) {
  Json reports[3];
  for (const int threads : {1, 2, 7}) {
    const std::string folder = "out" + std::to_string(threads);
    ASSERT_EQ(rocking("run quick.json -q -o " + folder + " -j " + std::to_string(threads)).exit_code, 0);
    Json& report = reports[std::min(threads - 1, 2)] = Json::parse(read(folder + "/report.json"));
    EXPECT_EQ(report["system"]["threads"], threads);
    report.erase("system");
  }
  EXPECT_EQ(reports[0].dump(), reports[1].dump());
  EXPECT_EQ(reports[0].dump(), reports[2].dump());
}

TEST_F(Command, RunTakesFlagsBeforeTheFile) {
  ASSERT_EQ(rocking("run quick.json -o out --seed 17 --realisations 2").exit_code, 0);
  const Json report = Json::parse(read("out/report.json"));
  EXPECT_EQ(report["input"]["experiment"]["seed"], "0x11");
  EXPECT_EQ(report["input"]["experiment"]["realisations"], 2);
  EXPECT_EQ(report["result"]["conditions"][0]["realisations"], 2);
}

TEST_F(Command, FrictionOfThePlaceIsToldAndGivesTheSameBitsAgain) {
  Json experiment = Json::parse(read("quick.json"));
  experiment["fluctuation"]["friction"] = {{"sigma", 0.03}, {"correlation", 1}, {"refresh_slip_m", 0.002}};
  write("cells.json", experiment.dump());
  EXPECT_THAT(rocking("validate cells.json").output,
              AllOf(HasSubstr("static friction drawn for each cell of the slip"),
                    HasSubstr("kinetic friction drawn for each cell of the slip"), Not(HasSubstr("grid in time"))));
  ASSERT_EQ(rocking("run cells.json -o out").exit_code, 0);
  const Json report = Json::parse(read("out/report.json"));
  EXPECT_FALSE(report["input"]["experiment"]["fluctuation"]["friction"].contains("refreshes_per_period"));
  EXPECT_GT(report["internal"]["total"]["draws"]["kinetic_friction"], 0);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
}

TEST_F(Command, DryRunTellsThePlanAndWritesNothing) {
  const auto outcome = rocking("run quick.json -o out --dry-run");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("3 conditions, 12 realisations, 720 periods"), HasSubstr("sliding"),
                                    HasSubstr("kinetic friction drawn")));
  EXPECT_FALSE(exists("out"));
  const Json plan = Json::parse(rocking("run quick.json --dry-run --json").output);
  EXPECT_EQ(plan["periods"], 720);
  EXPECT_EQ(plan["effects"].size(), 3U);
}

TEST_F(Command, DryRunOfADeterministicExperimentCountsOneRealisation) {
  auto quick = quick_experiment();
  quick.erase("fluctuation");
  quick.erase("friction");
  write("quiet.json", quick.dump());
  EXPECT_THAT(rocking("run quiet.json --dry-run").output,
              AllOf(HasSubstr("3 realisations"), HasSubstr("nothing is random")));
}

TEST_F(Command, DryRunOfAGroundMotionNamesItAndCountsThePeriodsOfTheStrobe) {
  write("record.json", recorded_experiment().dump());
  write("pulse.txt", recorded_pulse());
  const std::string horizontal = rocking("run record.json --dry-run").output;
  EXPECT_THAT(horizontal, AllOf(HasSubstr("of the strobe\n"), HasSubstr("recorded horizontal motion of the base")));
  EXPECT_THAT(horizontal, Not(HasSubstr("recorded vertical")));
  auto with_vertical = recorded_experiment();
  with_vertical["excitation"]["columns"].push_back("vertical");
  write("record.json", with_vertical.dump());
  write("pulse.txt", "0.5, 0, 0\n0.7, 2, 1\n");
  EXPECT_THAT(rocking("run record.json --dry-run").output, HasSubstr("recorded vertical motion of the base"));
}

TEST_F(Command, RunFindsAGroundMotionFromTheFolderOfItsExperiment) {
  ASSERT_EQ(shell("mkdir there").exit_code, 0);
  write("there/record.json", recorded_experiment().dump());
  write("there/pulse.txt", recorded_pulse());
  ASSERT_EQ(rocking("run there/record.json -o out -q").exit_code, 0);
  const std::string text = read("out/report.json");
  EXPECT_EQ(objections("report", text), "");
  const Json report = Json::parse(text);
  EXPECT_EQ(objections("experiment", report["input"]["experiment"].dump()), "");
  EXPECT_EQ(report["input"]["experiment"]["excitation"]["sha256"],
            rocking::base::to_hex(rocking::base::sha256(recorded_pulse())));
  EXPECT_EQ(report["result"]["conditions"][0]["counts"]["rest"], 1) << "below the threshold";
  EXPECT_EQ(report["result"]["conditions"][1]["counts"]["rest"], 1) << "rocks and comes to rest";
  EXPECT_EQ(report["result"]["conditions"][2]["counts"]["overturned"], 1);
  EXPECT_GT(report["internal"]["conditions"][1]["ground_motion_segments"], 4);
}

TEST_F(Command, TrajectoryKeepsToItsSchema) {
  const auto outcome = rocking("trajectory quick.json --condition 1 --realisation 3 --periods 5");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(objections("trajectory", outcome.output), "");
  const Json trajectory = Json::parse(outcome.output);
  EXPECT_EQ(trajectory["condition"], 1);
  EXPECT_EQ(trajectory["realisation"], 3);
  EXPECT_EQ(trajectory["strobe"].size(), 5U);
}

TEST_F(Command, TrajectoryCoversTheHorizonByItself) {
  EXPECT_EQ(Json::parse(rocking("trajectory quick.json").output)["strobe"].size(), 60U);
}

TEST_F(Command, CheckNormalKeepsToItsSchema) {
  const auto outcome = rocking("check-normal --json");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(objections("check_normal", outcome.output), "");
  const Json check = Json::parse(outcome.output);
  EXPECT_EQ(check["n"], 20'000);
  EXPECT_EQ(check["sampler"], "box-muller");
  EXPECT_NEAR(check["mean"]["value"].get<double>(), 0.4, 5 * 0.03 / std::sqrt(20'000.0));
}

TEST_F(Command, CheckNormalKnowsThreeSamplers) {
  for (const std::string sampler : {"box-muller", "ziggurat", "inverse-cdf"}) {
    const auto outcome = rocking("check-normal --json --n 2000 --sampler " + sampler);
    EXPECT_EQ(outcome.exit_code, 0) << sampler;
    EXPECT_EQ(objections("check_normal", outcome.output), "");
    const Json check = Json::parse(outcome.output);
    EXPECT_EQ(check["sampler"], sampler);
    EXPECT_EQ(check["refuted"], false);
    EXPECT_EQ(check["correlations"].size(), 8U);
  }
}

TEST_F(Command, CheckNormalSaysWhatASmallSkewnessIsWorth) {
  const auto outcome = rocking("check-normal --n 20000 --mean 0.4 --sigma 0.03 --seed 7");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output,
              HasSubstr("skewness within 0.01: expected in 44 % of normal samples of this size; within "));
  EXPECT_THAT(outcome.output, HasSubstr("neighbouring realisations"));
  for (const char* law : {"--law lognormal --mean 1e-60 --sigma 1e-61", "--mean 0 --sigma 1e-200"}) {
    const auto tiny = rocking(std::string("check-normal ") + law);
    EXPECT_EQ(tiny.exit_code, 64) << law;
    EXPECT_THAT(tiny.errors, HasSubstr(law[2] == 'l' ? "--mean = 1e-60: must be at least 1e-12"
                                                     : "--sigma: \"1e-200\" is not a number from 1e-70"))
        << law;
  }
  EXPECT_EQ(rocking("check-normal --mean 0 --sigma 1e-60").exit_code, 0);
}

TEST_F(Command, ValidateTellsProblemsAsJsonToo) {
  write("bad.json", R"({"format": "rocking.experiment/1"})");
  const auto outcome = rocking("validate bad.json --json");
  EXPECT_EQ(outcome.exit_code, 65);
  const Json json = Json::parse(outcome.output);
  EXPECT_EQ(json["valid"], false);
  EXPECT_EQ(json["problems"].size(), 4U);
  const auto good = Json::parse(rocking("validate quick.json --json").output);
  EXPECT_EQ(good["valid"], true);
  EXPECT_EQ(objections("experiment", good["experiment"].dump()), "");
}

TEST_F(Command, SchemaPrintsWhatIsPublished) {
  for (const std::string name : {"experiment", "report", "trajectory", "check_normal"}) {
    const auto outcome = rocking("schema " + name);
    std::ifstream file(std::string(ROCKING_SOURCE_DIR "/reports/schemas/") + name + ".schema.json");
    std::ostringstream published;
    published << file.rdbuf();
    EXPECT_EQ(outcome.output, published.str());
  }
}

TEST_F(Command, DoctorNamesTheSystemsThatTheSetUpSupports) {
  const auto listed = shell("bash -c 'source " ROCKING_SOURCE_DIR "/tests/support/setup.sh; list_of_systems'");
  ASSERT_THAT(listed.output, HasSubstr("Debian 13"));
  EXPECT_EQ(Json::parse(rocking("doctor --json").output)["supported_systems"].get<std::string>() + "\n", listed.output);
}

TEST_F(Command, DoctorFindsTheArithmeticSound) {
  const auto outcome = rocking("doctor --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(Json::parse(outcome.output)["sound"], true);
}

}  // namespace
