// One run by several processes: the same bytes on any number of ranks, and the behaviour when one is killed.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Ranks : public rocking::support::ProgramTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(ROCKING_PROGRAM "-mpi")) {
      GTEST_SKIP() << "rocking-mpi was not built: MPI was not found (Debian: libopenmpi-dev openmpi-bin)";
    }
    if (shell("command -v mpirun").exit_code != 0) GTEST_SKIP() << "there is no mpirun (Debian: openmpi-bin)";
    auto question = quick_experiment();
    question["realisations"] = 61;
    write("question.json", question.dump());
    question["horizon"]["transient_periods"] = 10000;
    write("long.json", question.dump());
  }

  /// The MPI library leaks a little memory at its end; that is not our fault.
  static std::string ranks(int number, const std::string& arguments) {
    return "env ASAN_OPTIONS=detect_leaks=0 mpirun --allow-run-as-root --oversubscribe -n " + std::to_string(number) +
           " '" + ROCKING_PROGRAM "' " + arguments;
  }
};

TEST_F(Ranks, GiveTheSameBytesWhateverTheirNumber) {
  ASSERT_EQ(rocking("run question.json -q -o whole").exit_code, 0);
  for (const int number : {1, 2, 4, 8}) {
    const std::string folder = "of" + std::to_string(number);
    const auto outcome = shell(ranks(number, "run question.json -q -o " + folder));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(lasting_part(folder + "/report.json"), lasting_part("whole/report.json"));
    const Json report = Json::parse(read(folder + "/report.json"));
    EXPECT_GE(report["system"]["threads"], number);
  }
}

TEST_F(Ranks, GiveTheSameBytesOfAnyBlockUnderVerticalMotion) {
  auto question = quick_experiment();
  question["realisations"] = 61;
  question["block"] = {
      {"parts", Json::parse(R"([{"width_m": 1.0, "height_m": 2.0, "mass_kg": 300, "x_m": 0, "bottom_m": 0},
      {"width_m": 0.6, "height_m": 2.0, "mass_kg": 100, "x_m": 0.1, "bottom_m": 2.0}])")}};
  question["excitation"]["vertical"] = {{"amplitude", 2.0}, {"frequency_ratio", 20.0}};
  write("parts.json", question.dump());
  Json recorded = rocking::support::recorded_experiment();
  recorded["realisations"] = 61;
  recorded["fluctuation"] = {{"restitution", {{"sigma", 0.02}}}};
  recorded["excitation"]["vertical_file"] = "pulse.txt";
  write("recorded.json", recorded.dump());
  write("pulse.txt", rocking::support::recorded_pulse());
  for (const std::string name : {"parts", "recorded"}) {
    const auto alone = rocking("run " + name + ".json -q -o " + name + "_alone");
    ASSERT_EQ(alone.exit_code, 0) << alone.errors;
    const auto outcome = shell(ranks(3, "run " + name + ".json -q -o " + name + "_ranks"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(lasting_part(name + "_ranks/report.json"), lasting_part(name + "_alone/report.json")) << name;
  }
}

TEST_F(Ranks, StopAtTheSameNumberWhereIntervalsSayWhen) {
  auto question = quick_experiment();
  question["realisations"] = Json::parse(R"({ "until": { "half_width": 0.2, "at_most": 300 } })");
  write("until.json", question.dump());
  ASSERT_EQ(rocking("run until.json -q -o whole").exit_code, 0);
  const auto outcome = shell(ranks(3, "run until.json -q -j 2 -o together"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(lasting_part("together/report.json"), lasting_part("whole/report.json"));
}

TEST_F(Ranks, LoseAtMostTheirOpenBlocksWhenOneDies) {
  ASSERT_EQ(shell(ranks(3, "run long.json -q -o whole")).exit_code, 0);
  // The last rank is killed when the first pairs have been stored: the status counts finished realisations.
  const auto outcome = until_disturbed("rm -rf out; " + ranks(3, "run long.json -q -o out") + " & job=$!; until " +
                                       has_realisations("out") +
                                       "; do sleep 0.01; done 2>/dev/null; "
                                       "set -- $(cat /proc/$job/task/$job/children); shift 2; kill -9 $1; wait $job");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_FALSE(exists("out/report.json"));
  EXPECT_THAT(outcome.errors + outcome.output, HasSubstr("signal 9"));
  const auto resumed = shell(ranks(2, "resume out -q"));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

// The other ranks, which only compute, end with the one that writes.
TEST_F(Ranks, LoseAtMostTheirOpenBlocksWhenTheOneThatWritesDies) {
  ASSERT_EQ(shell(ranks(3, "run long.json -q -o whole")).exit_code, 0);
  const auto outcome = until_disturbed(
      "rm -rf out; " + ranks(3, "run long.json -q -o out") + " & job=$!; until " + has_realisations("out") +
      "; do sleep 0.01; done 2>/dev/null; "
      "set -- $(cat /proc/$job/task/$job/children); kill -9 $1; wait $job; code=$?; "
      "while kill -0 $2 || kill -0 $3; do sleep 0.1; done 2>/dev/null; echo all gone; exit $code");
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("all gone"));
  EXPECT_FALSE(exists("out/report.json"));
  const auto resumed = shell(ranks(2, "resume out -q"));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

// As where a file was copied to the hosts of a cluster, and one copy is old.
TEST_F(Ranks, RefuseToComputeWithAnotherFile) {
  Json question = rocking::support::recorded_experiment();
  question["realisations"] = 100'000;
  question["fluctuation"] = {{"restitution", {{"sigma", 0.02}}}};
  const std::string pulse = rocking::support::recorded_pulse();
  for (const std::string host : {"first", "second"}) {
    std::filesystem::create_directory(folder_ / host);
    write(host + "/question.json", question.dump());
    write(host + "/pulse.txt", host == "first" ? pulse : pulse + "0.8, 0.1\n0.9, 0\n");
  }
  const std::string begin = "env ASAN_OPTIONS=detect_leaks=0 mpirun --allow-run-as-root --oversubscribe";
  const std::string command =
      std::string(" '") + ROCKING_PROGRAM "' run /proc/self/cwd/question.json -q -o " + (folder_ / "out").string();
  const auto both = [&](const std::string& host, const std::string& more = "") {
    return shell(begin + " -n 1 -wdir first" + command + more + " : -n 1 -wdir " + host + command);
  };
  const auto refused = both("second");
  EXPECT_EQ(refused.exit_code, 74) << refused.errors;
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("rank 1: on "), HasSubstr("is not the digest of the file")));
  EXPECT_FALSE(exists("out/report.json"));
  std::filesystem::remove_all(folder_ / "out");
  EXPECT_EQ(both("first", " --realisations 40").exit_code, 0);
}

TEST_F(Ranks, StopCleanlyWhenTheirTimeIsUpOrTheyAreAskedTo) {
  ASSERT_EQ(shell(ranks(3, "run long.json -q -o whole")).exit_code, 0);
  const auto timed = shell(ranks(3, "run long.json -q -o out --max-time 0.01s"));
  EXPECT_EQ(timed.exit_code, 75) << timed.errors;
  EXPECT_THAT(timed.errors, HasSubstr("`rocking resume out` continues the run"));
  const auto asked = shell(ranks(3, "resume out -q") +
                           " & job=$!; until test -e out/progress.json || "
                           "test -e out/report.json; do sleep 0.01; done; kill -USR1 $job; wait $job");
  EXPECT_TRUE(asked.exit_code == 130 || exists("out/report.json")) << asked.exit_code << asked.errors;
  const auto resumed = rocking("resume out -q");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors << asked.exit_code << asked.errors;
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

TEST_F(Ranks, StopWithinARealisation) {
  auto question = quick_experiment();
  question["horizon"]["transient_periods"] = 100'000'000;
  write("endless.json", question.dump());
  const auto timed = shell("timeout 60 " + ranks(3, "run endless.json -q -o out --max-time 1s"));
  EXPECT_EQ(timed.exit_code, 75) << timed.errors;
}

TEST_F(Ranks, TellABadFileOnce) {
  write("bad.json", "{}");
  const auto outcome = shell(ranks(3, "run bad.json -o out"));
  EXPECT_EQ(outcome.exit_code, 65) << outcome.errors;
  const auto first = outcome.errors.find("the input cannot be used");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(outcome.errors.find("the input cannot be used", first + 1), std::string::npos);
}

TEST_F(Ranks, AreAskedForWhereThisProgramHasNone) {
  ASSERT_EQ(shell("mkdir alone; cp '" ROCKING_PROGRAM "' alone/rocking").exit_code, 0);
  const auto outcome = shell("OMPI_COMM_WORLD_SIZE=4 alone/rocking run question.json -o out");
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("4 processes"), HasSubstr("libopenmpi-dev"), HasSubstr("--shard")));
  EXPECT_FALSE(exists("out"));
}

}  // namespace
