// Exit codes of the program, and its messages when something is wrong.

#include <gmock/gmock.h>
#include <unistd.h>

#include "cli/program.hpp"

namespace {

using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ExitCode : public rocking::support::ProgramTest {};

TEST_F(ExitCode, Is0WhereAllIsDone) {
  const auto outcome = rocking("run quick.json -o out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_TRUE(exists("out/report.json"));
}

TEST_F(ExitCode, Is64ForAMistypedCommandAndNamesTheNearest) {
  const auto outcome = rocking("rnu quick.json");
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"run\"?"));
}

TEST_F(ExitCode, Is64ForAMistypedFlagAndNamesTheNearest) {
  const auto outcome = rocking("run quick.json -o out --relisations 3");
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean \"--realisations\"?"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is64ForAFlagInPlaceOfAValue) {
  const auto outcome = rocking("run quick.json -o --json");
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_THAT(outcome.errors,
              HasSubstr("-o --json: needs a value before --json; if that is the value, write --output=--json"));
  EXPECT_FALSE(exists("--json"));
  EXPECT_EQ(rocking("run quick.json --output=--odd --json").exit_code, 0);
  EXPECT_TRUE(exists("--odd/report.json"));
}

TEST_F(ExitCode, Is64ForACommandLineThatCannotBeFollowed) {
  for (const char* arguments :
       {"", "run", "run quick.json", "run quick.json -o out -j 0", "run quick.json -o out -j two",
        "run quick.json -o out --seed 0xz", "run quick.json -o out --realisations 0",
        "trajectory quick.json --condition 3", "trajectory quick.json --periods -1", "check-normal --sigma -1",
        "check-normal --sigma 0", "check-normal --sampler marsaglia", "check-normal --n 3", "schema reports",
        "run quick.json -o out -q -v"}) {
    const auto outcome = rocking(arguments);
    EXPECT_EQ(outcome.exit_code, 64) << arguments << '\n' << outcome.errors;
    EXPECT_FALSE(outcome.errors.empty()) << arguments;
    EXPECT_EQ(outcome.output, "") << arguments;
  }
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is64ForATimeThatIsNone) {
  for (const char* written : {"-3s", "0s", "0", "nan", "inf", "nans", "1e400s", "1e3s", "s", "", "3x", "3 s s", "3,5s",
                              "0x10s", "3s-", "1..5s"}) {
    for (const std::string flag : {"run quick.json -o out --max-time", "cost quick.json --time"}) {
      const auto outcome = rocking(flag + " '" + written + "'");
      EXPECT_EQ(outcome.exit_code, 64) << flag << written;
      EXPECT_THAT(outcome.errors, AllOf(HasSubstr("time: \"" + std::string(written) + "\" is not a positive duration"),
                                        HasSubstr("give one such as 90s")));
    }
  }
  EXPECT_FALSE(exists("out"));
  for (const std::string written : {"90s", "90", "1.5 min", " 2H ", "1d", ".5h"})
    EXPECT_EQ(rocking("run quick.json --dry-run --max-time '" + written + "'").exit_code, 0) << written;
}

TEST_F(ExitCode, Is64ForANumberOutOfItsRangeAndNamesFlagValueAndRange) {
  for (const std::string arguments : {"run quick.json -o out --threads|0|1 to 4096",
                                      "resume out --threads|-1|1 to 4096",
                                      "verify out --threads|1.5|1 to 4096",
                                      "verify out --sample|0|1 to ",
                                      "trajectory quick.json --periods|0|1 to ",
                                      "trajectory quick.json --condition|-1|0 to ",
                                      "trajectory quick.json --realisation|1e3|0 to ",
                                      "trajectory out --realisation 0 --condition|-1|0 to ",
                                      "trajectory out --condition 0 --realisation|x|0 to ",
                                      "trajectory quick.json --samples|-1|0 to ",
                                      "bifurcation quick.json -o out --realisation|-1|0 to ",
                                      "orbits quick.json -o out --periods|13|1 to 12",
                                      "rare quick.json -o out --particles|3|20 to ",
                                      "rare quick.json -o out --relative-error|0|0.001 to 1",
                                      "check-normal --n|99999999999999999999|20 to ",
                                      "check-normal --mean|nan|-1e+06 to ",
                                      "check-normal --sigma|inf|0 to ",
                                      "cost quick.json --tolerances|nan|1e-16 to 0.01",
                                      "cost quick.json --sample|0|1 to ",
                                      "report x.json -o out --from|nan|0 to ",
                                      "report x.json -o out --to|-1|0 to "}) {
    const std::size_t value = arguments.find('|');
    const std::size_t range = arguments.rfind('|');
    const std::string written = arguments.substr(value + 1, range - value - 1);
    const auto outcome = rocking(arguments.substr(0, value) + ' ' + written);
    EXPECT_EQ(outcome.exit_code, 64) << arguments << outcome.errors;
    const std::string flag = arguments.substr(arguments.rfind(' ', value) + 1, value - arguments.rfind(' ', value) - 1);
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr(flag + ": \"" + written + '"'), HasSubstr(arguments.substr(range + 1))));
  }
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is64ForAPartOfNoWhole) {
  for (const std::string part :
       {"0/3", "4/3", "1/0", "-1/3", "1", "1/", "/3", "1/2/3", "a/b", "1.5/3", "''", "1/9999999999"}) {
    const auto outcome = rocking("run quick.json -o out --shard " + part);
    EXPECT_EQ(outcome.exit_code, 64) << part;
    EXPECT_THAT(outcome.errors, HasSubstr("give i/n with 1 <= i <= n"));
  }
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is65ForABadFileOfWhichEveryProblemIsTold) {
  auto bad = quick_experiment();
  bad["block"]["width_m"] = -1;
  bad["frction"] = 3;
  write("bad.json", bad.dump());
  for (const char* command :
       {"validate bad.json", "run bad.json -o out", "trajectory bad.json", "run bad.json --dry-run"}) {
    const auto outcome = rocking(command);
    EXPECT_EQ(outcome.exit_code, 65) << command;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("2 problems"), HasSubstr("/block/width_m = -1: must be a positive number of metres"),
                      HasSubstr("did you mean \"friction\"?")));
  }
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is65ForWhatIsNoJson) {
  write("bad.json", "{\n \"format\": NaN }");
  const auto outcome = rocking("validate bad.json");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, HasSubstr("line 2, column"));
}

TEST_F(ExitCode, Is66ForAFileThatIsNotThere) {
  const auto outcome = rocking("run absent.json -o out");
  EXPECT_EQ(outcome.exit_code, 66);
  EXPECT_THAT(outcome.errors, HasSubstr("absent.json"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is66ForAGroundMotionThatIsNotThere) {
  write("record.json", rocking::support::recorded_experiment().dump());
  const auto outcome = rocking("run record.json -o out");
  EXPECT_EQ(outcome.exit_code, 66);
  EXPECT_THAT(outcome.errors, HasSubstr("pulse.txt"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is65ForAGroundMotionOfWhichEveryBadLineIsTold) {
  write("record.json", rocking::support::recorded_experiment().dump());
  write("pulse.txt", "0 0\n1 x\n2 NaN\n");
  const auto outcome = rocking("run record.json -o out");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("2 problems"), HasSubstr("pulse.txt, line 2 = \"x\": is not a number"),
                                    HasSubstr("pulse.txt, line 3 = \"NaN\": is not finite")));
  EXPECT_FALSE(exists("out"));
}

TEST_F(ExitCode, Is74ForAFolderThatCannotBeMade) {
  write("out", "a file stands here");
  const auto outcome = rocking("run quick.json -o out");
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_THAT(outcome.errors, HasSubstr("out"));
  EXPECT_EQ(read("out"), "a file stands here");
}

TEST_F(ExitCode, Is74ForAFolderThatCannotBeWrittenTo) {
  // The superuser may write everywhere, unless that capability is removed.
  const std::string powerless = geteuid() == 0 ? "setpriv --bounding-set=-dac_override " : "";
  if (shell(powerless + "true").exit_code != 0)
    GTEST_SKIP() << "skipped: the superuser cannot give up a capability here";
  ASSERT_EQ(shell("mkdir out && chmod 500 out").exit_code, 0);
  const auto outcome = shell("exec " + powerless + "'" ROCKING_PROGRAM "' run quick.json -o out");
  EXPECT_EQ(outcome.exit_code, 74);
  EXPECT_THAT(outcome.errors, HasSubstr("out"));
}

TEST_F(ExitCode, Is74WhereAReportWouldBeLost) {
  ASSERT_EQ(rocking("run quick.json -o out").exit_code, 0);
  const std::string first = read("out/report.json");
  const auto refused = rocking("run quick.json -o out --seed 5");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(read("out/report.json"), first);
  EXPECT_EQ(rocking("run quick.json -o out --seed 5 --overwrite").exit_code, 0);
  EXPECT_NE(read("out/report.json"), first);
}

TEST_F(ExitCode, Is74WhereTheResultCannotBePrinted) {
  EXPECT_EQ(rocking("trajectory quick.json > /dev/full").exit_code, 74);
  EXPECT_EQ(rocking("schema report > /dev/full").exit_code, 74);
}

}  // namespace
