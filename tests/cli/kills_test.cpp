// A kill at any moment, between any two changes of a folder: `resume` then gives the former run or the new one, whole,
// leaves nothing else behind, and says what was lost.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AnyOf;
using ::testing::Eq;
using ::testing::HasSubstr;
using ::testing::Not;

class Kills : public rocking::support::ProgramTest {
 protected:
  Kills() {
    auto quick = quick_experiment();
    quick["horizon"] = {{"transient_periods", 5}, {"sampled_periods", 15}};
    write("quick.json", quick.dump());
  }

  static std::string killed_at(int call, const std::string& arguments) {
    return "exec env LD_PRELOAD='" ROCKING_KILL_AT "' KILL_AT=" + std::to_string(call) + " '" ROCKING_PROGRAM "' " +
           arguments;
  }

  std::string files_in(const std::string& folder) const { return shell("ls -A " + folder).output; }

  /// Kills the command at each of its calls, each time in a copy of the folder `base`, and passes on what is left.
  template <class Check>
  void kill_at_each_call(const std::string& command, const Check& check) const {
    constexpr int most_calls = 400;
    int call = 1;
    for (; call < most_calls; ++call) {
      ASSERT_EQ(shell("rm -rf out; cp -r base out").exit_code, 0);
      const Outcome killed = shell(killed_at(call, command));
      if (killed.exit_code == 0) break;
      ASSERT_EQ(killed.exit_code, 137) << call << killed.errors;
      check(command + ", call " + std::to_string(call));
    }
    EXPECT_GT(call, 10) << "the calls are not counted";
    EXPECT_LT(call, most_calls);
  }

  /// `resume` gives one of the two runs. A notice is due exactly where the new one had left a trace and is lost.
  void expect_either(const std::string& former, const std::string& next, const std::string& what) const {
    const bool is_lost = exists("out/extended.sqlite.new") || exists("out/extended.sqlite") ||
                         (exists("out/replacement") && !exists("out/replacement/realisations.sqlite"));
    const Outcome resumed = rocking("resume out -q --no-page");
    ASSERT_EQ(resumed.exit_code, 0) << what << resumed.errors;
    const std::string report = lasting_part("out/report.json");
    EXPECT_THAT(report, AnyOf(Eq(former), Eq(next))) << what;
    EXPECT_EQ(resumed.errors.find("is lost; repeat its command") != std::string::npos, is_lost)
        << what << resumed.errors;
    EXPECT_TRUE(report == former || !is_lost) << what;
    EXPECT_EQ(files_in("out"), "realisations.sqlite\nreport.json\n") << what;
  }
};

#if !defined(ROCKING_SANITIZED)  // sanitizers must be loaded first

TEST_F(Kills, OfAnExtensionOfAFinishedRun) {
  run_quietly("run quick.json -o base");
  run_quietly("run quick.json -o next --realisations 7");
  const std::string former = lasting_part("base/report.json");
  const std::string next = lasting_part("next/report.json");
  kill_at_each_call("resume out -q --no-page --realisations 7", [&](const std::string& what) {
    if (exists("out/replacement/realisations.sqlite")) {
      const Outcome status = rocking("run --status out --json");
      if (status.exit_code == 0) {
        EXPECT_GE(Json::parse(status.output)["done"].get<int>(), 12)
            << what << ": the realisations of the finished run are in it";
      } else {
        EXPECT_THAT(status.errors, HasSubstr("`rocking resume` includes it")) << what;
      }
    }
    expect_either(former, next, what);
  });
}

// Without its report a run is unfinished, and extended in its place.
TEST_F(Kills, OfAnExtensionOfAnUnfinishedRun) {
  run_quietly("run quick.json -o base");
  run_quietly("run quick.json -o next --realisations 7");
  const std::string former = lasting_part("base/report.json");
  const std::string next = lasting_part("next/report.json");
  std::filesystem::remove(folder_ / "base/report.json");
  kill_at_each_call("resume out -q --no-page --realisations 7",
                    [&](const std::string& what) { expect_either(former, next, what); });
}

TEST_F(Kills, OfARunThatReplacesAnother) {
  run_quietly("run quick.json -o base");
  run_quietly("run quick.json -o next --seed 7");
  const std::string former = lasting_part("base/report.json");
  const std::string next = lasting_part("next/report.json");
  kill_at_each_call("run quick.json -q --no-page -o out --seed 7 --overwrite",
                    [&](const std::string& what) { expect_either(former, next, what); });
}

TEST_F(Kills, OfAMergeThatReplacesARun) {
  run_quietly("run quick.json -o base");
  run_quietly("run quick.json -o next --seed 7");
  run_quietly("run quick.json -o a --seed 7 --shard 1/2");
  run_quietly("run quick.json -o b --seed 7 --shard 2/2");
  const std::string former = lasting_part("base/report.json");
  const std::string next = lasting_part("next/report.json");
  kill_at_each_call("resume out a b -q --no-page --overwrite",
                    [&](const std::string& what) { expect_either(former, next, what); });
}

TEST_F(Kills, OfTheRepairOfADamagedStore) {
  run_quietly("run quick.json -o base");
  const std::string former = lasting_part("base/report.json");
  std::string store = read("base/realisations.sqlite");
  const std::string damage(200, 'x');
  store.replace(store.size() - 300, damage.size(), damage);
  write("base/realisations.sqlite", store);
  kill_at_each_call("resume out -q --no-page", [&](const std::string& what) {
    ASSERT_EQ(rocking("resume out -q --no-page").exit_code, 0) << what;
    EXPECT_EQ(lasting_part("out/report.json"), former) << what;
    EXPECT_EQ(files_in("out"), "damaged-1.sqlite\nrealisations.sqlite\nreport.json\n") << what;
    EXPECT_TRUE(read("out/damaged-1.sqlite").find(damage) != std::string::npos) << what;
  });
}

TEST_F(Kills, OfANewRunLeaveAFolderForTheNextOne) {
  ASSERT_EQ(shell("mkdir base").exit_code, 0);
  run_quietly("run quick.json -o whole");
  kill_at_each_call("run quick.json -q --no-page -o out", [&](const std::string& what) {
    ASSERT_EQ(rocking("run quick.json -q --no-page -o out --overwrite").exit_code, 0) << what;
    EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json")) << what;
    EXPECT_EQ(files_in("out"), "realisations.sqlite\nreport.json\n") << what;
  });
}

TEST_F(Kills, OfAStudyLeaveNoLock) {
  auto sure = quick_experiment();
  sure.erase("fluctuation");
  sure.erase("friction");
  sure["restitution"] = 0.9;
  write("sure.json", sure.dump());
  ASSERT_EQ(shell("mkdir base").exit_code, 0);
  for (const std::string& study :
       {std::string("orbits sure.json -q --periods 1 --no-branches -o out"),
        std::string("bifurcation quick.json -q -o out"),
        std::string("rare quick.json -q --particles 20 --event 'tilt > 0.1 psi' --relative-error 1 -o out"),
        std::string("cost quick.json -q --sample 1 --tolerances 1e-6,1e-8,1e-10 -o out")}) {
    for (int call = 1;; ++call) {
      ASSERT_EQ(shell("rm -rf out; cp -r base out").exit_code, 0);
      const Outcome killed = shell(killed_at(call, study));
      if (killed.exit_code == 0) break;
      ASSERT_EQ(killed.exit_code, 137) << study << killed.errors;
      EXPECT_FALSE(exists("out/.lock")) << study << call;
      ASSERT_EQ(rocking(study + " --overwrite").exit_code, 0) << study << call;
      EXPECT_THAT(files_in("out"), Not(HasSubstr(".rocking-"))) << study << call;
    }
  }
}

#endif

// An error leaves what a kill leaves.
TEST_F(Kills, AndErrorsLeaveNothingAfterALaterResume) {
  run_quietly("run quick.json -o out");
  const std::string former = lasting_part("out/report.json");
  for (const std::string& command : {std::string("resume out --realisations 400"),
                                     std::string("run quick.json -o out --overwrite --realisations 400")}) {
    for (const char* blocks : {"0", "8"}) {
      const Outcome failed =
          shell(std::string("ulimit -f ") + blocks + "; exec '" ROCKING_PROGRAM "' " + command + " -q --no-page");
      ASSERT_EQ(failed.exit_code, 74) << command << failed.errors;
      ASSERT_EQ(shell("rm -rf copy; cp -r out copy").exit_code, 0);
      ASSERT_EQ(rocking("resume copy -q --no-page").exit_code, 0) << command << blocks;
      EXPECT_EQ(files_in("copy"), "realisations.sqlite\nreport.json\n") << command << blocks;
      EXPECT_EQ(rocking("verify copy -q --sample 9").exit_code, 0) << command << blocks;
    }
  }
  EXPECT_EQ(lasting_part("out/report.json"), former);
}

TEST_F(Kills, AndAnExtensionThatTheMachineCannotHoldChangesNothing) {
  run_quietly("run quick.json -o out");
  const std::string files = files_in("out");
  const Outcome refused = rocking("resume out -q --no-page --realisations 900000000");
  ASSERT_EQ(refused.exit_code, 74) << refused.errors;
  EXPECT_EQ(files_in("out"), files);
  EXPECT_EQ(Json::parse(rocking("run --status out --json").output)["state"], "finished");
}

}  // namespace
