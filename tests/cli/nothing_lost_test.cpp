// Killed, stopped, or without disk or terminal at any moment: `rocking resume` gives the bytes of an undisturbed run.
// ROCKING_KILLS=100 in the environment tests a hundred kills instead of a few.

#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <unistd.h>

#include "cli/program.hpp"
#include "support/split_mix.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class NothingIsLost : public rocking::support::ProgramTest {
 protected:
  NothingIsLost() { ask_for(60); }

  /// Writes the experiment and the result of an undisturbed run.
  void ask_for(int realisations, int transient_periods = 100) {
    auto question = quick_experiment();
    question["horizon"]["transient_periods"] = transient_periods;
    question["realisations"] = realisations;
    write("question.json", question.dump());
    std::filesystem::remove_all(folder_ / "whole");
    EXPECT_EQ(rocking("run question.json -q -o whole -j 2").exit_code, 0);
  }

  /// An experiment that takes many times as long as a look at it, with sanitizers as without: longer realisations, since a
  /// look reads each of them, and since they need no more of the disk.
  void ask_for_longer() {
    const auto seconds = [this](const std::string& arguments) {
      const auto start = std::chrono::steady_clock::now();
      EXPECT_EQ(rocking(arguments).exit_code, 0);
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (int periods = 1000;; periods *= 2) {
      ask_for(100, periods);
      const double of_run = seconds("run question.json -q -o timed -j 1"), of_look = seconds("run --status timed");
      std::filesystem::remove_all(folder_ / "timed");
      if (of_run > 20.0 * of_look) return;
      ASSERT_LT(periods, 1'000'000);
    }
  }

  void expect_the_whole_of(const std::string& folder) const {
    ASSERT_TRUE(exists(folder + "/report.json"));
    EXPECT_EQ(lasting_part(folder + "/report.json"), lasting_part("whole/report.json"));
    for (const char* file : {"realisations.sqlite-wal", "realisations.sqlite-shm", "progress.json", "mended.sqlite"}) {
      EXPECT_FALSE(exists(folder + "/" + file)) << file;
    }
  }

  void expect_resumable(const std::string& folder) const {
    const auto resumed = rocking("resume " + folder + " -q");
    ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
    expect_the_whole_of(folder);
  }

  /// Damages rows of a store: changes a byte of every termination behind the fraction `share` of the file. One alone
  /// could be in the free part of a page, where SQLite leaves what it has moved elsewhere.
  void damage_rows(const std::string& name, double share) const {
    std::string bytes = read(name);
    const auto first = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    int changed = 0;
    for (auto place = bytes.find("reached_horizon", first); place != std::string::npos;
         place = bytes.find("reached_horizon", place)) {
      bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
      ++changed;
    }
    ASSERT_GT(changed, 0);
    write(name, bytes);
  }
};

TEST_F(NothingIsLost, ByKillsAtRandomTimesOneAfterTheOther) {
  const char* asked = std::getenv("ROCKING_KILLS");
  const int kills = asked == nullptr ? 8 : std::stoi(asked);
  rocking::support::SplitMix random(9);
  double longest_s = 0.01;  // adapts itself to the machine, so that half of the kills come too late, and do not count
  int under_way = 0;
  for (int attempt = 0; under_way < kills; ++attempt) {
    ASSERT_LT(attempt, 100 * kills);
    const bool begun = exists("out/realisations.sqlite");
    const std::string command = begun ? "resume out -j 2" : "run question.json -o out -j 2";
    const auto outcome =
        shell("'" ROCKING_PROGRAM "' " + command + " & child=$!; sleep " +
              std::to_string(random.uniform(0.0, longest_s)) + "; kill -9 $child 2>/dev/null; wait $child");
    ASSERT_TRUE(outcome.exit_code == 137 || outcome.exit_code == 0) << outcome.errors;
    const bool came_in_time = outcome.exit_code == 137;
    longest_s *= came_in_time ? 2.0 : 0.5;
    if (came_in_time && exists("out/realisations.sqlite")) ++under_way;
    if (!exists("out/report.json")) continue;
    expect_resumable("out");
    std::filesystem::remove_all(folder_ / "out");
  }
  if (exists("out/realisations.sqlite")) expect_resumable("out");
}

TEST_F(NothingIsLost, BySignalsThatAskToStop) {
  ask_for_longer();
  for (const std::string signal : {"INT", "TERM", "USR1", "HUP"}) {
    const auto outcome =
        until_disturbed("rm -rf out; " + in_background("run question.json -j 1 -o out", has_realisations("out")) +
                        "kill -" + signal + " $child 2>/dev/null; wait $child");
    EXPECT_EQ(outcome.exit_code, 130) << signal << outcome.errors;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("interrupted"), HasSubstr("are done and kept"),
                                      HasSubstr("`rocking resume out` continues the run")))
        << signal;
    EXPECT_FALSE(exists("out/realisations.sqlite-wal")) << signal;
    EXPECT_FALSE(exists("out/report.json")) << signal;
    expect_resumable("out");
  }
}

TEST_F(NothingIsLost, ByAnOutputThatNobodyReads) {
  EXPECT_THAT(shell("'" ROCKING_PROGRAM "' run question.json -o closed | true; echo").errors,
              HasSubstr("standard output"));
  expect_the_whole_of("closed");
  const auto deaf = shell("'" ROCKING_PROGRAM "' run question.json -o deaf -v 2>&1 >/dev/null | true");
  EXPECT_EQ(deaf.exit_code, 0);
  expect_the_whole_of("deaf");
}

TEST_F(NothingIsLost, ByALimitOfTheSizeOfFiles) {
  const auto outcome = shell("ulimit -f 30; exec '" ROCKING_PROGRAM "' run question.json -o out -q");
  EXPECT_EQ(outcome.exit_code, 74) << outcome.errors;
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("out/realisations.sqlite"), HasSubstr("rocking resume out")));
  expect_resumable("out");
}

TEST_F(NothingIsLost, ByADiskThatIsFull) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser can mount a small disk";
  ask_for_longer();
  const auto mounted = shell("mkdir small && mount -t tmpfs -o size=4m none small");
  if (mounted.exit_code != 0) GTEST_SKIP() << "no small disk can be mounted here: " << mounted.errors;
  const auto full = until_disturbed(
      "rm -rf small/*; " +
      in_background("run question.json -q -o small/out -j 1", "test -s small/out/realisations.sqlite-wal") +
      "cat /dev/zero >small/filler 2>/dev/null; wait $child");
  EXPECT_EQ(full.exit_code, 74);
  EXPECT_THAT(full.errors, AllOf(HasSubstr("small/out"), HasSubstr("rocking resume small/out")));
  const auto refused = rocking("run question.json -o small/second");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_EQ(shell("rm small/filler").exit_code, 0);
  const auto too_much = rocking("run question.json -o small/third --realisations 10000");
  EXPECT_EQ(too_much.exit_code, 74);
  EXPECT_THAT(too_much.errors, AllOf(HasSubstr("may need"), HasSubstr("free"))) << "told before it begins";
  EXPECT_FALSE(exists("small/third/realisations.sqlite"));
  expect_resumable("small/out");
  EXPECT_EQ(shell("umount small").exit_code, 0);
}

TEST_F(NothingIsLost, ByAFolderThatCannotBeWrittenTo) {
  ASSERT_EQ(rocking("run question.json -q -o out --max-time 0.0001s").exit_code, 75);
  if (geteuid() == 0) {
    if (shell("mount --bind out out && mount -o remount,ro,bind out").exit_code != 0) {
      GTEST_SKIP() << "the superuser may write everywhere, and nothing can be mounted here";
    }
  } else {
    ASSERT_EQ(shell("chmod 500 out").exit_code, 0);
  }
  const auto refused = rocking("resume out");
  const auto looked = rocking("run --status out");
  ASSERT_EQ(shell(geteuid() == 0 ? "umount out" : "chmod 700 out").exit_code, 0);
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, HasSubstr("out"));
  EXPECT_EQ(looked.exit_code, 0) << looked.errors;
  expect_resumable("out");
}

TEST_F(NothingIsLost, OfWhatIsSoundInADamagedStore) {
  for (const double place : {0.5, 0.8}) {
    ASSERT_EQ(shell("rm -rf out; cp -r whole out; rm out/report.json").exit_code, 0);
    damage_rows("out/realisations.sqlite", place);
    const auto resumed = rocking("resume out -q");
    EXPECT_EQ(resumed.exit_code, 0);
    EXPECT_THAT(resumed.errors, AllOf(HasSubstr("intact and kept"), HasSubstr("out/damaged-1.sqlite")));
    const auto mentions = [&](const std::string& condition) {
      const auto first = resumed.errors.find(condition + ": realisations ");
      return first != std::string::npos && resumed.errors.find(condition + ": ", first + 1) == std::string::npos;
    };
    EXPECT_TRUE(mentions("condition 2")) << resumed.errors;
    if (place == 0.5) {
      EXPECT_TRUE(mentions("condition 1")) << resumed.errors;
    }
    EXPECT_EQ(read("out/damaged-1.sqlite").size(), read("whole/realisations.sqlite").size());
    expect_the_whole_of("out");
  }
}

TEST_F(NothingIsLost, OfWhatIsLeftOfACutStore) {
  ASSERT_EQ(shell("cp -r whole out; truncate -s 30K out/realisations.sqlite").exit_code, 0);
  EXPECT_EQ(rocking("verify out").exit_code, 65);
  const auto resumed = rocking("resume out -q");
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_THAT(resumed.errors, AllOf(HasSubstr("intact and kept"), Not(HasSubstr("; 0 realisations"))));
  expect_the_whole_of("out");
}

TEST_F(NothingIsLost, ToOneWhoAsksHowFarItIs) {
  const auto whole = rocking("run --status whole --json");
  EXPECT_EQ(whole.exit_code, 0);
  const Json finished = Json::parse(whole.output);
  EXPECT_EQ(finished.at("state"), "finished");
  EXPECT_EQ(finished.at("done"), 180);
  EXPECT_EQ(finished.at("missing"), 0);
  EXPECT_EQ(finished.at("failed"), 0);

  ASSERT_EQ(rocking("run question.json -q -o part --shard 2/3 --max-time 0.0001s -j 1").exit_code, 75);
  const Json stopped = Json::parse(rocking("run --status part --json").output);
  EXPECT_EQ(stopped.at("state"), "stopped");
  EXPECT_EQ(stopped.at("shard"), "2/3");
  EXPECT_EQ(stopped.at("done").get<int>() + stopped.at("missing").get<int>(), 60);
  EXPECT_THAT(rocking("run --status part").output, HasSubstr("`rocking resume part` continues the run"));
  EXPECT_EQ(rocking("run --status absent").exit_code, 66);

  // The store on disk is behind by one commit, progress.json by seconds.
  const auto running =
      shell(in_background("run question.json -q -o out -j 1 --realisations 1000000 2>told", has_realisations("out")) +
            "'" ROCKING_PROGRAM "' run --status out --json; echo $? >code; kill -INT $child; wait $child; cat code");
  EXPECT_THAT(running.output, AllOf(HasSubstr("\"state\": \"running\""), HasSubstr("\"all\": 3000000")));
  EXPECT_TRUE(running.output.ends_with("0\n")) << running.output;
}

TEST_F(NothingIsLost, ThroughARunThatIsLookedAtAllTheTime) {
  const auto watched =
      shell("'" ROCKING_PROGRAM
            "' run question.json -q -o out & child=$!; "
            "while kill -0 $child 2>status; do '" ROCKING_PROGRAM "' run --status out >status 2>&1; done; wait $child");
  EXPECT_EQ(watched.exit_code, 0) << watched.errors;
  expect_the_whole_of("out");
}

// SQLite removes the log, and only then writes that there is none. Whoever read in between made it anew.
TEST_F(NothingIsLost, AndNothingIsLeftBesideAStoreThatIsReadWhileItIsClosed) {
  ask_for(4);
  const std::string look =
      "while kill -0 $child 2>status; do '" ROCKING_PROGRAM "' run --status out; done >status 2>&1";
  for (int attempt = 0; attempt < 10; ++attempt) {
    const auto watched = shell("rm -rf out; env LD_PRELOAD='" ROCKING_KILL_AT "' SLOW_LOCKS=20000 '" ROCKING_PROGRAM
                               "' run question.json -q --no-page -o out & child=$!; (" +
                               look + ") & (" + look + ") & wait $child; code=$?; wait; exit $code");
    ASSERT_EQ(watched.exit_code, 0) << watched.errors;
    for (const char* file : {"out/realisations.sqlite-wal", "out/realisations.sqlite-shm"}) {
      EXPECT_FALSE(exists(file)) << file << ", attempt " << attempt;
    }
  }
}

}  // namespace
