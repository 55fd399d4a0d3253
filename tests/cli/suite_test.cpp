// A run of a suite of ground motions: one store, one report, each record a point of the sweep.

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"
#include "support/record_text.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::peer_at2;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class SuiteRun : public rocking::support::ProgramTest {
 protected:
  SuiteRun() {
    std::filesystem::create_directory(folder_ / "records");
    write("records/push.at2", peer_at2(std::vector<double>(60, 0.3), ".01"));
    write("records/shake.at2", peer_at2({0.0, 0.3, -0.3, 0.3, -0.3, 0.3, -0.3, 0.0}, ".2"));
    write("records/weak.at2", peer_at2({0.0, 0.001, -0.001, 0.0}, ".2"));
    write("e.json", experiment().dump());
  }

  static Json experiment() {
    return Json::parse(R"({
      "format": "rocking.experiment/1", "title": "a suite", "block": { "width_m": 0.35, "height_m": 1.6 },
      "excitation": { "kind": "recorded", "suite": "records/*.at2" },
      "fluctuation": { "restitution": { "sigma": 0.05 } },
      "sweep": [ { "parameter": "/excitation/scale", "values": [0.5, 1.0, 2.0] } ],
      "realisations": 5, "seed": "0x21" })");
  }

  Json report(const std::string& folder) const { return Json::parse(read(folder + "/report.json")); }
};

TEST_F(SuiteRun, HasOneReportWithARowForEachRecordAndLevel) {
  const auto ran = rocking("run e.json -o out");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  EXPECT_EQ(objections("report", read("out/report.json")), "");
  const Json conditions = report("out")["result"]["conditions"];
  ASSERT_EQ(conditions.size(), 9U);
  EXPECT_EQ(conditions[4]["parameters"]["/excitation/file"], "records/shake.at2");
  EXPECT_EQ(conditions[4]["parameters"]["/excitation/scale"], 1.0);
  EXPECT_EQ(conditions[2]["counts"]["overturned"], 5);  // a push of 0.6 g for 0.6 s
  EXPECT_EQ(conditions[8]["counts"]["overturned"], 0);
  EXPECT_THAT(ran.output, AllOf(HasSubstr("push.at2"), HasSubstr("shake.at2"), Not(HasSubstr("records/push.at2  "))));
  EXPECT_THAT(read("out/report.html"), HasSubstr("shake.at2"));
  EXPECT_EQ(rocking("report out --format csv").exit_code, 0);
  EXPECT_THAT(read("out/tables/modes.csv"), HasSubstr("records/shake.at2"));
}

TEST_F(SuiteRun, TakesAPatternWithoutAFolderWhereverTheExperimentIs) {
  Json here = experiment();
  here["excitation"]["suite"] = "*.at2";
  write("records/here.json", here.dump());
  for (const char* place : {"cd records; exec '" ROCKING_PROGRAM "' validate here.json",
                            "exec '" ROCKING_PROGRAM "' validate records/here.json"}) {
    const auto found = shell(place);
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_THAT(found.output, HasSubstr("9 conditions"));
  }
}

TEST_F(SuiteRun, RefusesOneRecordUnderTwoNames) {
  std::filesystem::create_symlink("push.at2", folder_ / "records/soft.at2");
  const auto found = rocking("validate e.json");
  EXPECT_EQ(found.exit_code, 65);
  EXPECT_THAT(found.errors,
              AllOf(HasSubstr("records/soft.at2"), HasSubstr("records/push.at2"), HasSubstr("same content")));
}

TEST_F(SuiteRun, TellsBeforeItStartsWhichRecordLiftsTheBlockAtNoScale) {
  const auto planned = rocking("run e.json --dry-run");
  EXPECT_EQ(planned.exit_code, 0);
  EXPECT_THAT(planned.errors, AllOf(HasSubstr("records/weak.at2: is too weak to lift the block at any scale"),
                                    HasSubstr("from a scale of 218.7 on"), Not(HasSubstr("push.at2: is too weak")),
                                    Not(HasSubstr("shake.at2: is too weak"))));
  write("records/weak.at2", rocking::support::peer_at2({0.0, 0.0, 0.0}, ".01"));
  EXPECT_THAT(rocking("run e.json --dry-run").errors, HasSubstr("records/weak.at2: lifts the block at no scale\n"));
  Json moving = experiment();
  moving["initial"]["tilt"] = 0.1;
  Json upstairs = experiment();
  upstairs["excitation"]["building"] = {{"frequency_hz", 2.0}, {"damping_ratio", 0.05}, {"height_ratio", 1.0}};
  for (const Json& other : {moving, upstairs}) {
    write("m.json", other.dump());
    const auto found = rocking("run m.json --dry-run");
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_THAT(found.errors, Not(HasSubstr("the block at")));
  }
}

TEST_F(SuiteRun, SaysHowItsFilesWereReadAndHowFarTheyWereScaled) {
  write("records/b.txt", "0 1\n0.1 -2\n0.2 3\n0.3 0.5\n");
  Json levels = experiment();
  levels["excitation"]["suite"] = {"records/*.at2", "records/b.txt"};
  levels["sweep"] = Json::parse(R"([ { "parameter": "/excitation/pga_g", "values": [0.2, 0.6] } ])");
  write("l.json", levels.dump());
  const auto ran = rocking("run l.json -o out -q");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  // Lines on a terminal, sentences on a page.
  const auto as_read = [](const std::string& ground, const std::string& scale) {
    return AllOf(
        HasSubstr(ground + " motion: 3 files, push.at2 ...: peer_at2; accelerations in g; horizontal component "
                           "only"),
        HasSubstr(ground + " motion: b.txt: columns time, horizontal; accelerations in m/s2 (assumed); "
                           "horizontal"),
        HasSubstr(scale + " factor: from 0.654 (b.txt) to 600 (weak.at2)"),
        HasSubstr("scale factors above 4 for 1 of 4 ground motions (weak.at2: up to 600)"));
  };
  EXPECT_THAT(ran.output, AllOf(as_read("ground", "scale"), HasSubstr("pga_g   scale")));
  EXPECT_THAT(rocking("validate l.json").output, as_read("ground", "scale"));
  EXPECT_THAT(rocking("run l.json --dry-run").output, as_read("ground", "scale"));
  EXPECT_THAT(read("out/report.html"), as_read("Ground", "Scale"));
  EXPECT_EQ(objections("report", read("out/report.json")), "");
  const Json result = report("out")["result"];
  EXPECT_EQ(result["conditions"][5]["scale"], 600.0);
  ASSERT_EQ(result["ground_motions"].size(), 4U);
  EXPECT_EQ(result["ground_motions"][2]["largest_scale"], 600.0);
  EXPECT_EQ(result["ground_motions"][3]["unit_is_assumed"], true);
  EXPECT_EQ(rocking("report out --format html").exit_code, 0) << "also from the report alone";
}

TEST_F(SuiteRun, HasTheRecordsAndFactorsThatATableGivesEachLevel) {
  write("records/other.at2", peer_at2({0.0, 0.25, -0.3, 0.28, -0.3, 0.2, -0.1, 0.0}, ".2"));
  write("records/selection.csv",
        "level,file,factor\n0.3,push.at2,0.4\n0.3,shake.at2,0.5\n0.6,shake.at2,1\n0.6,other.at2,0.8\n0.6,push.at2,0.9\n"
        "1.2,push.at2,2\n1.2,other.at2,2\n");
  Json levels = experiment();
  levels["excitation"]["suite"] = {{"levels", "records/selection.csv"}};
  levels.erase("sweep");
  write("l.json", levels.dump());
  const auto ran = rocking("run l.json -o out");
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  EXPECT_EQ(objections("report", read("out/report.json")), "");
  const Json conditions = report("out")["result"]["conditions"];
  ASSERT_EQ(conditions.size(), 7U);
  EXPECT_EQ(conditions[6]["parameters"]["/excitation/file"], "records/other.at2, level 1.2");
  EXPECT_EQ(conditions[6]["scale"], 2.0);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
  const auto replayed = rocking("trajectory out --condition 5 --realisation 3");
  EXPECT_EQ(replayed.output, rocking("trajectory l.json --condition 5 --realisation 3").output);
  const auto curves = rocking("fragility out --json");
  ASSERT_EQ(curves.exit_code, 0) << curves.errors;
  EXPECT_EQ(objections("fragility", curves.output), "");
  const Json curve = Json::parse(curves.output)["curves"][0];
  EXPECT_EQ(curve["parameter"], "/excitation/level");
  ASSERT_EQ(curve["levels"].size(), 3U);
  EXPECT_EQ(curve["levels"][0]["records"], 2);
  EXPECT_EQ(curve["levels"][1]["records"], 3);
  EXPECT_EQ(curve["levels"][2]["intensity"], 1.2);
  write("hazard.csv", "pga_g,annual_rate\n0.1,0.01\n0.5,0.001\n2,0.00001\n");
  const auto rate = rocking("fragility out --hazard hazard.csv");
  EXPECT_EQ(rate.exit_code, 0) << rate.errors;
  EXPECT_THAT(rate.output + rate.errors, HasSubstr("levels: those of the table are taken to be in pga_g"));
  write("short.csv", "pga_g,annual_rate\n0.1,0.01\n0.5,0.001\n1,0.0001\n");
  const auto unreached = rocking("fragility out --hazard short.csv");
  EXPECT_EQ(unreached.exit_code, 65);
  EXPECT_THAT(unreached.errors, HasSubstr("does not reach the level 1.2 of the run: it ends at 1"));
}

// Once in 475 and 2475 years: the curve falls by a decade from 0.1 to 0.5 g, and from there to 2 g by two.
TEST_F(SuiteRun, TakesTheIntensitiesOfReturnPeriodsFromTheHazardCurve) {
  write("records/other.at2", peer_at2({0.0, 0.25, -0.3, 0.28, -0.3, 0.2, -0.1, 0.0}, ".2"));
  write("records/selection.csv",
        "return_period_years,file,factor\n475,push.at2,0.4\n475,shake.at2,0.5\n2475,shake.at2,1\n2475,other.at2,0.8\n");
  Json levels = experiment();
  levels["excitation"]["suite"] = {{"levels", "records/selection.csv"}};
  levels.erase("sweep");
  write("l.json", levels.dump());
  ASSERT_EQ(rocking("run l.json -o out -q").exit_code, 0);
  EXPECT_EQ(objections("report", read("out/report.json")), "");
  write("hazard.csv", "pga_g,annual_rate\n0.1,0.01\n0.5,0.001\n2,0.00001\n");
  const Json curve = Json::parse(rocking("fragility out --hazard hazard.csv --json").output)["curves"][0];
  EXPECT_NEAR(curve["levels"][0]["intensity"].get<double>(), 0.1 * std::pow(5.0, std::log10(4.75)), 1e-12);
  EXPECT_NEAR(curve["levels"][1]["intensity"].get<double>(), 0.5 * std::pow(4.0, 0.5 * std::log10(2.475)), 1e-12);
  EXPECT_THAT(rocking("fragility out --hazard hazard.csv").output,
              HasSubstr("levels: the return periods of the table"));
}

TEST_F(SuiteRun, CanBeVerifiedReplayedAndExtended) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  EXPECT_EQ(rocking("verify out").exit_code, 0);
  const auto replayed = rocking("trajectory out --condition 5 --realisation 3");
  EXPECT_EQ(replayed.exit_code, 0);
  EXPECT_EQ(replayed.output, rocking("trajectory e.json --condition 5 --realisation 3").output);
  EXPECT_EQ(rocking("resume out --realisations 8 -q").exit_code, 0);
  EXPECT_EQ(rocking("run e.json -q -o whole --realisations 8").exit_code, 0);
  EXPECT_EQ(report("out")["result"], report("whole")["result"]);
  // A record that is added later belongs to no run that exists.
  write("records/later.at2", peer_at2({0.0, 0.1, 0.0}, ".2"));
  EXPECT_EQ(rocking("verify out").exit_code, 0);
}

TEST_F(SuiteRun, IsThatOfEachRecordAlone) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  Json alone = experiment();
  alone["excitation"].erase("suite");
  alone["excitation"]["file"] = "records/shake.at2";
  write("alone.json", alone.dump());
  ASSERT_EQ(rocking("run alone.json -q -o alone").exit_code, 0);
  const Json together = report("out")["result"]["conditions"];
  const Json one = report("alone")["result"]["conditions"];
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(together[3 + i]["counts"], one[i]["counts"]);
}

TEST_F(SuiteRun, IsRefusedWhenARecordHasChanged) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  write("records/push.at2", peer_at2(std::vector<double>(60, 0.31), ".01"));
  const auto refused = rocking("verify out");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_THAT(refused.errors, HasSubstr("is not the digest of the file"));
}

TEST_F(SuiteRun, StopsAndGoesOn) {
  Json longer = experiment();
  longer["realisations"] = 4000;
  write("l.json", longer.dump());
  ASSERT_EQ(
      until_disturbed("rm -rf out; " + in_background("run l.json -q --no-page -o out -j 1", has_realisations("out")) +
                      "kill -INT $child; wait $child")
          .exit_code,
      130);
  EXPECT_FALSE(exists("out/report.json"));
  ASSERT_EQ(rocking("resume out -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking("run l.json -q --no-page -o whole").exit_code, 0);
  EXPECT_EQ(report("out")["result"], report("whole")["result"]);
  EXPECT_EQ(report("out")["internal"], report("whole")["internal"]);
}

}  // namespace
