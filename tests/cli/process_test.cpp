// The program as a process: signals, standard streams, paths that are no regular files, replacement of an earlier run.

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Process : public rocking::support::ProgramTest {
 protected:
  Process() {
    auto endless = quick_experiment();
    endless["horizon"]["transient_periods"] = 100'000'000;
    endless["realisations"] = 1;
    write("endless.json", endless.dump());
    endless["excitation"]["amplitude"] = 0.1;  // never uplifts: all of its steps are made outside the lanes
    endless.erase("sweep");
    write("endless_rest.json", endless.dump());
    endless.erase("fluctuation");
    write("endless_sure.json", endless.dump());
  }

  static std::string program(const std::string& arguments) { return "'" ROCKING_PROGRAM "' " + arguments; }

  /// Puts a script called gnuplot before the real one in PATH.
  std::string with_gnuplot(const std::string& script) const {
    std::filesystem::create_directory(folder_ / "bin");
    write("bin/gnuplot", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(folder_ / "bin/gnuplot", std::filesystem::perms::owner_all);
    return "export PATH=\"$PWD/bin:$PATH\"; ";
  }

  std::string files_of(const std::string& folder) const {
    std::string all;
    for (const char* name : {"report.json", "report.html", "realisations.sqlite"})
      all += read(folder + '/' + name) + '|';
    return all;
  }
};

TEST_F(Process, LeavesIgnoredSignalsIgnored) {
  for (const std::string signal : {"HUP", "INT", "TERM", "USR1"}) {
    const auto outcome =
        shell("trap '' " + signal + "; " + program("run endless.json -q -o " + signal + " --max-time 3s") +
              " & child=$!; sleep 1; kill -" + signal + " $child; wait $child");
    EXPECT_EQ(outcome.exit_code, 75) << signal << outcome.errors;
  }
}

TEST_F(Process, StopsWithinARealisationWhenItsTimeIsUp) {
  write("pulse.txt", rocking::support::recorded_pulse());
  for (const std::string question : {"endless", "endless_rest"}) {
    const auto outcome = rocking("run " + question + ".json -o " + question + " --max-time 1s");
    EXPECT_EQ(outcome.exit_code, 75) << question << outcome.errors;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("0 of "), HasSubstr("`rocking resume " + question + "` continues the run")));
  }
}

TEST_F(Process, StopsWithinARealisationWhenItIsAskedTo) {
  for (const std::string arguments :
       {"run endless.json -o out", "run endless_rest.json -o rest", "cost endless.json",
        "bifurcation endless.json -o diagram", "orbits endless_sure.json -o orbits", "rare endless.json -o rare"}) {
    const auto outcome = shell(in_background(arguments) + "kill -INT $child; wait $child");
    EXPECT_EQ(outcome.exit_code, 130) << arguments << outcome.errors;
  }
}

TEST_F(Process, EndsWithGnuplotThatHangsWhenItIsAskedTo) {
  const auto outcome =
      shell(with_gnuplot("echo $$ >../../drawing; exec sleep 1000") + "mkdir t; export TMPDIR=$PWD/t; " +
            in_background("run quick.json -q -o out", "test -s drawing") +
            "kill -TERM $child; wait $child; code=$?; "
            "kill -0 $(cat drawing) 2>/dev/null && echo gnuplot lives; ls t; exit $code");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, HasSubstr("`rocking resume out`"));
  EXPECT_TRUE(exists("out/report.json"));
  EXPECT_EQ(rocking("resume out -q").exit_code, 0);
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(Process, RemovesTheTemporaryFilesOfOnesThatWereKilled) {
  const auto killed =
      shell(with_gnuplot("echo $$ >../../drawing; exec sleep 1000") + "mkdir t; export TMPDIR=$PWD/t; " +
            in_background("run quick.json -q -o out", "test -s drawing") +
            "kill -9 $child; wait $child; "
            "kill -9 $(cat drawing); ls t; touch out/.rocking-abcdef");
  ASSERT_THAT(killed.output, HasSubstr("rocking-figure-"));
  EXPECT_EQ(shell("export TMPDIR=$PWD/t; " + program("resume out -q")).exit_code, 0);
  EXPECT_EQ(shell("ls t; ls -A out").output, "realisations.sqlite\nreport.html\nreport.json\n");
}

TEST_F(Process, KeepsTableAndPageWhereNothingCanBeDrawn) {
  for (const std::string& disturbance :
       {std::string("export TMPDIR=/nowhere; "), with_gnuplot("exit 3"), with_gnuplot("kill -9 $$"),
        with_gnuplot("exit 0"), with_gnuplot("echo 'set terminal svg: unknown or ambiguous terminal type'; exit 1")}) {
    for (const std::string command : {"rm -rf out; run quick.json -o out", "rm out/report.*; resume out"}) {
      const std::size_t end = command.find("; ") + 2;
      const auto outcome = shell(command.substr(0, end) + disturbance + program(command.substr(end)));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
      EXPECT_THAT(outcome.output, HasSubstr("report: out/report.json"));
      EXPECT_THAT(outcome.errors, HasSubstr("no pictures for printing"));
      EXPECT_TRUE(exists("out/report.html"));
    }
    EXPECT_THAT(shell(disturbance + program("resume out -q")).errors, HasSubstr("no pictures for printing"));
    const auto drawn = shell(disturbance + program("report out --format html,gnuplot"));
    EXPECT_EQ(drawn.exit_code, 74) << disturbance << drawn.errors;
  }
}

TEST_F(Process, TellsOfAPictureThatGnuplotRefusesAsABug) {
  const std::string refuses = with_gnuplot("echo 'line 3: undefined variable: x'; exit 1");
  for (const std::string command : {"run quick.json -o out", "resume out", "report out"}) {
    const auto outcome = shell(refuses + program(command));
    EXPECT_EQ(outcome.exit_code, 70) << command << outcome.errors;
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("undefined variable"), HasSubstr("a bug of this program")));
    EXPECT_TRUE(exists("out/report.html"));
  }
}

TEST_F(Process, SaysThatItsOutputIsClosedOrFullAndKeepsTheRun) {
  for (const std::string end : {">&-", ">/dev/full", "<&- >&- 2>&-"}) {
    const auto outcome = shell("rm -rf out; " + program("run quick.json -q -o out " + end));
    EXPECT_EQ(outcome.exit_code, 74) << end << outcome.errors;
    EXPECT_EQ(rocking("verify out -q").exit_code, 0) << end;
  }
}

TEST_F(Process, ReadsNoPipeAndNoDevice) {
  ASSERT_EQ(shell("mkfifo pipe; mkdir folder stored; mkfifo folder/report.json stored/realisations.sqlite").exit_code,
            0);
  auto recorded = rocking::support::recorded_experiment();
  recorded["excitation"]["file"] = "pipe";
  write("record.json", recorded.dump());
  for (const std::string arguments :
       {"run pipe -o out", "validate /dev/zero", "trajectory pipe", "cost pipe", "run record.json -o out",
        "report pipe -o out", "report folder", "verify folder", "run --status stored", "compare stored stored",
        "trajectory stored --condition 0 --realisation 0"}) {
    const auto outcome = shell("exec timeout 20 " + program(arguments));
    EXPECT_EQ(outcome.exit_code, 65) << arguments << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("is a pipe or a device")) << arguments;
  }
}

TEST_F(Process, ReadsNoFolderAsAFile) {
  ASSERT_EQ(shell("mkdir -p folder/report.json stored/realisations.sqlite").exit_code, 0);
  auto recorded = rocking::support::recorded_experiment();
  recorded["excitation"]["file"] = "folder";
  write("record.json", recorded.dump());
  for (const std::string arguments :
       {"run folder -o out", "validate folder", "run record.json -o out", "report folder -o out", "report folder",
        "verify folder", "run --status stored", "resume stored"}) {
    const auto outcome = rocking(arguments);
    EXPECT_EQ(outcome.exit_code, 65) << arguments << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("is a folder; give a regular file")) << arguments;
  }
}

TEST_F(Process, ReplacesARunOnlyOnceTheNewOneIsComplete) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const std::string earlier = files_of("out");
  const auto stopped = rocking("run endless.json -o out --overwrite --max-time 1s");
  EXPECT_EQ(stopped.exit_code, 75);
  EXPECT_THAT(stopped.errors, HasSubstr("the earlier run is kept"));
  EXPECT_EQ(files_of("out"), earlier);
  EXPECT_THAT(rocking("run --status out").output, AllOf(HasSubstr("out: stopped"), HasSubstr("earlier run")));
  EXPECT_EQ(rocking("verify out -q").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o out --overwrite --seed 5").exit_code, 0) << "it replaces both";
  EXPECT_EQ(Json::parse(read("out/report.json"))["input"]["experiment"]["seed"], "0x5");
  EXPECT_EQ(shell("ls -A out").output, "realisations.sqlite\nreport.html\nreport.json\n");
}

TEST_F(Process, KeepsARunWhereItsReplacementFails) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o a --shard 1/2").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o b --shard 2/2").exit_code, 0);
  const std::string earlier = files_of("out");
  std::string damaged = read("b/realisations.sqlite");
  damaged.replace(damaged.size() - 300, 200, 200, 'x');
  write("b/realisations.sqlite", damaged);
  EXPECT_EQ(rocking("resume out a b -q --overwrite").exit_code, 65);
  EXPECT_EQ(files_of("out"), earlier);
  EXPECT_FALSE(exists("out/replacement"));
  EXPECT_EQ(shell("ulimit -f 8; exec " + program("run quick.json -q -o out --overwrite --realisations 400")).exit_code,
            74);
  EXPECT_EQ(files_of("out"), earlier);
  EXPECT_EQ(rocking("verify out -q").exit_code, 0);
}

TEST_F(Process, CompletesAReplacementThatWasKilledOnItsWay) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o next --seed 5").exit_code, 0);
  for (const std::string moved : {"", "realisations.sqlite", "realisations.sqlite report.json"}) {
    ASSERT_EQ(shell("rm -rf half; cp -r out half; cp -r next half/replacement-complete; cd half; for file in " + moved +
                    "; do mv replacement-complete/$file .; done")
                  .exit_code,
              0);
    for (const char* command : {"status", "verify", "report"}) {
      const auto refused = rocking(std::string(command) + " half");
      EXPECT_EQ(refused.exit_code, 74) << command << refused.output;
      EXPECT_THAT(refused.errors, HasSubstr("`rocking resume half` completes the replacement"));
    }
    ASSERT_EQ(rocking("resume half -q").exit_code, 0) << moved;
    EXPECT_EQ(rocking("verify half -q").exit_code, 0) << moved;
    EXPECT_EQ(Json::parse(read("half/report.json"))["result"], Json::parse(read("next/report.json"))["result"])
        << moved;
    EXPECT_FALSE(exists("half/replacement-complete"));
  }
}

// Harmonic or a suite of two records; with sliding and without; of one realisation and of several, which may all
// overturn; with the page and without.
TEST_F(Process, SaysHowMuchSpaceARunTakes) {
  write("a.txt", "0 0\n0.2 5\n0.4 -4\n0.6 0\n");
  write("b.txt", "0 0\n0.1 3\n0.9 2\n1.3 0\n");
  auto harmonic = quick_experiment();
  harmonic["horizon"] = {{"transient_periods", 1}, {"sampled_periods", 4}};
  harmonic["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "from": 3, "to": 3.299, "step": 1e-3}])");
  auto suite = harmonic;
  suite.erase("horizon");
  suite["excitation"] = {{"kind", "recorded"},
                         {"suite", {"a.txt", "b.txt"}},
                         {"format", "columns"},
                         {"units", "m/s2"},
                         {"columns", {"time", "horizontal"}}};
  suite["sweep"] = Json::parse(R"([{"parameter": "/excitation/scale", "from": 0.01, "to": 1.5, "step": 0.01}])");
  auto fallen = suite;
  fallen["sweep"][0]["from"] = 6.01;
  fallen["sweep"][0]["to"] = 7.5;
  for (auto& experiment : {harmonic, suite, fallen}) {
    for (const int realisations : {1, 3}) {
      for (const bool slides : {true, false}) {
        auto wide = experiment;
        wide["realisations"] = realisations;
        if (!slides) {
          wide.erase("friction");
          wide["fluctuation"] = {{"restitution", {{"sigma", 0.01}}}};
        }
        write("wide.json", wide.dump());
        for (const std::string& page : {std::string(), std::string(" --no-page")}) {
          if (page.empty() && realisations == 1) continue;  // drawing takes most of the time
          const Json plan = Json::parse(rocking("run ./wide.json --dry-run --json" + page).output);
          ASSERT_EQ(plan["conditions"], 300);
          ASSERT_EQ(rocking("run ./wide.json -q --overwrite -o out" + page).exit_code, 0);
          double taken = 0.0;
          for (const auto& file : std::filesystem::directory_iterator(folder_ / "out"))
            taken += static_cast<double>(file.file_size());
          EXPECT_GT(plan["disk_bytes"].get<double>(), taken / 1.5) << wide.dump() << page;
          EXPECT_LT(plan["disk_bytes"].get<double>(), taken * 1.5) << wide.dump() << page;
        }
      }
    }
  }
}

TEST_F(Process, RefusesARunThatNeedsMoreMemoryThanThereIs) {
#if !defined(ROCKING_SANITIZED)  // the address sanitizer reserves terabytes of addresses
  const auto refused = shell("ulimit -v 400000; exec " + program("run endless.json -o large --realisations 100"));
  EXPECT_EQ(refused.exit_code, 74) << refused.errors;
  EXPECT_THAT(refused.errors, HasSubstr("of memory"));
  EXPECT_FALSE(exists("large"));
#endif
}

}  // namespace
