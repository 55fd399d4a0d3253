// The files in which studies leave their results: one process at a time, and no result that is computed in vain.

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/campaign_block.hpp"
#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::campaign_block;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// A study that writes a file into the folder of `-o`.
struct Study {
  std::string file;
  std::string command;  ///< without `-o`
};

class StudyFiles : public rocking::support::ProgramTest {
 protected:
  StudyFiles() {
    Json random = quick_experiment();
    random.erase("friction");
    random["fluctuation"] = {{"amplitude", {{"sigma", 0.5}}}};
    random["horizon"] = {{"transient_periods", 5}, {"sampled_periods", 10}};
    write("random.json", random.dump());
    Json certain = quick_experiment();
    certain.erase("fluctuation");
    certain["sweep"][0]["values"] = {4.5, 6.0};
    write("certain.json", certain.dump());
    write("block.json", campaign_block().dump());
    write("tests.csv", "amplitude,\"(1,1)\",other\n4.5,5,5\n");
    run_quietly("run random.json -o run");
  }

  static std::vector<Study> studies() {
    return {{"rare.json", "rare random.json --particles 40 --relative-error 1 --event 'tilt > 0.5 psi'"},
            {"infer.json", "infer block.json --tests tests.csv --realisations 4"},
            {"cost.json", "cost random.json --sample 3"},
            {"orbits.json", "orbits certain.json --periods 1 --no-branches"},
            {"bifurcation.json", "bifurcation certain.json"},
            {"fragility.json", "fragility run"}};
  }
};

TEST_F(StudyFiles, HaveOneProcessAtATime) {
  for (const Study& study : studies()) {
    // The shell holds the lock, as a process at work would.
    const std::string lock = "out/." + study.file + ".lock";
    const auto refused = shell("mkdir out; exec 9>" + lock + "; flock 9; '" ROCKING_PROGRAM "' " + study.command +
                               " -o out --overwrite");
    EXPECT_EQ(refused.exit_code, 74) << study.command << refused.errors;
    EXPECT_THAT(refused.errors, HasSubstr("out/" + study.file + ": another `rocking` is working on this file"));
    EXPECT_EQ(refused.output, "");
    EXPECT_FALSE(exists("out/" + study.file));
    EXPECT_EQ(rocking(study.command + " -q -o out").exit_code, 0) << "a lock that nobody holds is in nobody's way";
    EXPECT_TRUE(exists("out/" + study.file));
    EXPECT_FALSE(exists(lock));
    std::filesystem::remove_all(folder_ / "out");
  }
}

TEST_F(StudyFiles, AreRefusedToTheSecondOfTwoBeforeItsWork) {
  const std::string endless = "rare random.json --relative-error 0.001 --event 'tilt > 0.9 psi' -q -o out";
  const auto both = shell(in_background(endless, "test -s out/rare.json") + "'" ROCKING_PROGRAM "' " + endless +
                          " --resume; echo $?; kill -INT $child; wait $child; echo $?");
  EXPECT_EQ(both.output.substr(0, 3), "74\n") << both.output;
  EXPECT_THAT(both.output, EndsWith("130\n"));
  EXPECT_THAT(both.errors, HasSubstr("another `rocking` is working on this file"));
}

TEST_F(StudyFiles, AreOnStandardOutputWhereTheDiskIsFull) {
  for (const Study& study : studies()) {
    // No file can have a byte, so that what is printed goes through a pipe.
    const std::string limited = "(ulimit -f 0; '" ROCKING_PROGRAM "' " + study.command + " -o full";
    const auto table = shell(limited + " 2>&1; echo exit $?) | cat");
    EXPECT_THAT(table.output, AllOf(HasSubstr("exit 74"), HasSubstr("full/"), HasSubstr("\"format\": \"rocking."),
                                    HasSubstr("follows on standard output")))
        << study.command;
    EXPECT_FALSE(exists("full/" + study.file));
    const auto json = shell(limited + " --json 2>/dev/null) | cat");
    EXPECT_TRUE(Json::accept(json.output)) << study.command << json.output;
    EXPECT_EQ(Json::parse(json.output).value("format", "").substr(0, 8), "rocking.");
  }
}

TEST_F(StudyFiles, SayHowAnEarlierOneIsReplacedOrContinued) {
  for (const Study& study : studies()) {
    std::filesystem::create_directories(folder_ / "out");
    write("out/" + study.file, "earlier");
    const auto refused = rocking(study.command + " -o out");
    EXPECT_EQ(refused.exit_code, 74);
    EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
    const bool can_resume = study.file == "rare.json" || study.file == "infer.json";
    EXPECT_EQ(refused.errors.find("--resume") != std::string::npos, can_resume) << refused.errors;
    EXPECT_EQ(read("out/" + study.file), "earlier");
  }
}

}  // namespace
