// experiments/cluster/submit with an sbatch that only writes down its arguments.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::support::Outcome;
using ::testing::HasSubstr;

class ClusterSubmit : public rocking::support::ProgramTest {
 protected:
  ClusterSubmit() { write("sbatch", "#!/bin/sh\necho \"$*\" >>asked\necho 17\n"); }

  /// Runs it with these arguments and these environment variables.
  Outcome submit(const std::string& arguments, const std::string& variables = "") const {
    return shell("chmod +x sbatch; PATH=$PWD:$PATH ROCKING='" ROCKING_PROGRAM "' " + variables +
                 " '" ROCKING_SOURCE_DIR "/experiments/cluster/submit' " + arguments);
  }

  void expect_refusal(const Outcome& outcome, int exit_code, const std::string& reason) const {
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(reason));
    EXPECT_FALSE(exists("asked")) << "nothing is submitted";
    EXPECT_FALSE(exists("out")) << "no folder is made";
  }
};

TEST_F(ClusterSubmit, SubmitsAnArrayAndAMergeThatWaitsForIt) {
  const Outcome outcome = submit("quick.json out 12 --time=4:00");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "array 17\nmerge 17\n");
  EXPECT_THAT(read("asked"), HasSubstr("--array=1-12"));
  EXPECT_THAT(read("asked"), HasSubstr("/out/shard-%a.log --time=4:00 "));
  EXPECT_THAT(read("asked"), HasSubstr("--dependency=afterok:17"));
}

TEST_F(ClusterSubmit, RefusesPartsThatAreNoPositiveWholeNumber) {
  for (const char* parts : {"0", "-3", "2.5", "1e3", "many", "''", "' 4'", "07", "4,9", "1-4", "9999999", "'$(ls)'"}) {
    expect_refusal(submit(std::string("quick.json out ") + parts), 64, "PARTS is \"");
  }
}

TEST_F(ClusterSubmit, RefusesRestartsThatAreNoWholeNumber) {
  for (const char* restarts : {"-1", "many", "'a[$(touch asked)]'", "1.5"}) {
    expect_refusal(submit("quick.json out 2", std::string("ROCKING_RESTARTS=") + restarts), 64,
                   "ROCKING_RESTARTS is \"");
  }
}

TEST_F(ClusterSubmit, RefusesWhatIsNotThere) {
  expect_refusal(submit("nowhere.json out 2"), 66, "nowhere.json");
  expect_refusal(submit("quick.json out 2", "ROCKING=/nowhere/rocking"), 66, "/nowhere/rocking is not a program");
  expect_refusal(submit("quick.json out 2", "ROCKING=/"), 66, "/ is not a program");
}

TEST_F(ClusterSubmit, RefusesAnExperimentThatTheProgramRefuses) {
  write("bad.json", "{}");
  expect_refusal(submit("bad.json out 2"), 65, "bad.json");
}

TEST_F(ClusterSubmit, GivesALogItsFoldersNameWhateverItsSigns) {
  EXPECT_EQ(submit("quick.json '100%a b' 2").exit_code, 0);
  EXPECT_THAT(read("asked"), HasSubstr("/100%%a b/shard-%a.log"));
}

}  // namespace
