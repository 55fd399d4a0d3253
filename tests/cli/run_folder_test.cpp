// Runs that are stopped, divided, merged and verified, as seen by a user.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/store/store.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class RunFolder : public rocking::support::ProgramTest {
 protected:
  /// A run that is not finished within a millisecond on one thread.
  void write_slow() const {
    auto slow = quick_experiment();
    slow["horizon"]["transient_periods"] = 2000;
    slow["realisations"] = 40;
    write("slow.json", slow.dump());
  }

  void change_store(const std::string& sql) const {
    rocking::sqlite::Database(folder_ / "out/realisations.sqlite", rocking::sqlite::Access::write).execute(sql);
  }

  void change_report(const std::string& pointer, const Json& value) const {
    Json report = Json::parse(read("out/report.json"));
    report[Json::json_pointer(pointer)] = value;
    write("out/report.json", report.dump(2));
  }
};

TEST_F(RunFolder, HoldsItsRealisationsAndNothingElseIsLeft) {
  ASSERT_EQ(rocking("run quick.json -o out").exit_code, 0);
  EXPECT_TRUE(exists("out/realisations.sqlite"));
  EXPECT_FALSE(exists("out/realisations.sqlite-wal"));
  EXPECT_FALSE(exists("out/realisations.sqlite-shm"));
}

TEST_F(RunFolder, IsFinishedAfterItsTimeWasUp) {
  write_slow();
  const auto stopped = rocking("run slow.json -j 1 -o out --max-time 0.001s");
  EXPECT_EQ(stopped.exit_code, 75);
  EXPECT_THAT(stopped.errors,
              AllOf(HasSubstr("the time limit was reached"), HasSubstr("`rocking resume out` continues the run")));
  EXPECT_FALSE(exists("out/report.json"));
  EXPECT_EQ(rocking("resume out -q").exit_code, 0);
  ASSERT_EQ(rocking("run slow.json -q -o whole").exit_code, 0);
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

TEST_F(RunFolder, OfAnUnfinishedRunIsNotTakenForAnother) {
  write_slow();
  ASSERT_EQ(rocking("run slow.json -j 1 -o out --max-time 0.001s").exit_code, 75);
  const auto refused = rocking("run quick.json -o out");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("rocking resume out"), HasSubstr("--overwrite")));
  EXPECT_EQ(rocking("run quick.json -o out --overwrite").exit_code, 0);
  EXPECT_EQ(rocking("verify out -q").exit_code, 0);
}

TEST_F(RunFolder, IsUsedByOneAtATime) {
  const auto outcome = shell(
      in_background("run quick.json -o out -q -j 1 --realisations 1000000", "test -s out/realisations.sqlite-wal") +
      "'" ROCKING_PROGRAM "' resume out; echo second $?; kill -INT $child; wait $child");
  EXPECT_EQ(outcome.exit_code, 130) << "the first goes on";
  EXPECT_EQ(outcome.output, "second 74\n");
  EXPECT_THAT(outcome.errors, HasSubstr("another `rocking` is working"));
}

TEST_F(RunFolder, ResumeAsksForARun) {
  EXPECT_EQ(rocking("resume absent").exit_code, 66);
  write("plain/file", "");
  EXPECT_FALSE(exists("absent")) << "it must not make what it did not find";
}

TEST_F(RunFolder, IsResumedByAnotherVersionWhereItsResultsAreTheSame) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const std::filesystem::path path = folder_ / "out/realisations.sqlite";
  auto identity = rocking::Store::open(path, rocking::sqlite::Access::read).identity();
  identity.code = "0.0.9 old";
  for (const std::uint64_t results : {rocking::results_version - 1, rocking::results_version + 1}) {
    identity.results = results;
    std::filesystem::remove(path);
    rocking::Store::create(path, identity).close_up();
    const auto refused = rocking("resume out");
    EXPECT_EQ(refused.exit_code, 74);
    EXPECT_THAT(refused.errors, HasSubstr("0.0.9 old"));
  }
  identity.results = rocking::results_version;
  std::filesystem::remove(path);
  rocking::Store::create(path, identity).close_up();
  EXPECT_EQ(rocking("resume out -q").exit_code, 0);
}

TEST_F(RunFolder, IsReadInEveryLayoutThatARunWasPublishedIn) {
  const std::filesystem::path runs = ROCKING_SOURCE_DIR "/tests/reference/runs";
  ASSERT_TRUE(std::filesystem::exists(runs / ("layout_" + std::to_string(rocking::current_layout))));
  for (const auto& run : std::filesystem::directory_iterator(runs)) {
    std::filesystem::copy(run.path(), folder_ / run.path().filename());
    const std::string folder = run.path().filename().string();
    const auto drawn = rocking("report " + folder + " --format text");
    EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
    EXPECT_THAT(drawn.output, HasSubstr("66.7 [13.1, 98.4]"));
    const auto curve = rocking("fragility " + folder + " -q");
    EXPECT_EQ(curve.exit_code, 0) << curve.errors;
  }
}

TEST_F(RunFolder, OfShardsGivesTheBytesOfOneRun) {
  ASSERT_EQ(rocking("run quick.json -q -o whole").exit_code, 0);
  for (const char* part : {"1", "2", "3"}) {
    const std::string n = part;
    const auto outcome = rocking("run quick.json -o part" + n + " --shard " + n + "/3");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.errors, HasSubstr("rocking resume"));
    EXPECT_FALSE(exists("part" + n + "/report.json"));
  }
  ASSERT_EQ(rocking("resume out part3 part1 part2").exit_code, 0);
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));

  const auto partly = rocking("resume two part3 part1");
  EXPECT_EQ(partly.exit_code, 75);
  EXPECT_THAT(partly.errors, HasSubstr("rocking resume two"));
  EXPECT_EQ(rocking("resume two -q").exit_code, 0);
  EXPECT_EQ(lasting_part("two/report.json"), lasting_part("whole/report.json"));
}

TEST_F(RunFolder, OfShardsThatOverlapOrHoldNothingGivesTheBytesOfOneRun) {
  ASSERT_EQ(rocking("run quick.json -q -o whole").exit_code, 0);
  for (const char* shard : {"1/2", "2/2", "2/3", "40/50"}) {
    std::string folder = shard;
    folder[folder.find('/')] = '-';
    ASSERT_EQ(rocking("run quick.json -q -o " + folder + " --shard " + shard).exit_code, 0) << shard;
  }
  ASSERT_EQ(rocking("resume out 2-3 40-50 2-2 1-2").exit_code, 0);
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

TEST_F(RunFolder, OfShardsThatDisagreeIsNotMade) {
  ASSERT_EQ(rocking("run quick.json -q -o a").exit_code, 0);
  ASSERT_EQ(shell("cp -r a b").exit_code, 0);
  {
    auto store = rocking::Store::open(folder_ / "b/realisations.sqlite", rocking::sqlite::Access::write);
    auto changed = store.find({1, 2}).value();
    ++changed.operations.steps;
    store.add({1, 2}, changed);
    store.close_up();
  }
  const auto refused = rocking("resume out a b");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr("b: 1 realisation is different from"), HasSubstr("condition 1, realisation 2 (steps)")));
  EXPECT_FALSE(exists("out/report.json"));
  EXPECT_FALSE(exists("out/realisations.sqlite"));
}

TEST_F(RunFolder, IsMergedAnewWhereThatIsAskedFor) {
  ASSERT_EQ(rocking("run quick.json -q -o whole").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o a --shard 1/2").exit_code, 0);
  EXPECT_EQ(rocking("resume out a").exit_code, 75) << "as if it had been killed";
  const auto refused = rocking("resume out a whole");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(rocking("resume out out --overwrite").exit_code, 64) << "it would remove its own source";
  EXPECT_EQ(rocking("resume out a whole --overwrite").exit_code, 0);
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
}

TEST_F(RunFolder, OfAnotherExperimentIsNotMerged) {
  ASSERT_EQ(rocking("run quick.json -q -o a --shard 1/2").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o b --shard 2/2 --seed 7").exit_code, 0);
  const auto refused = rocking("resume out a b");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("b: belongs to another experiment"), HasSubstr("seed")));
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunFolder, TakesOnlyAPartOfAWholeAsAShard) {
  for (const char* shard : {"0/3", "4/3", "3", "a/b", "1/", "-1/3", "1/99999999999"}) {
    const auto refused = rocking(std::string("run quick.json -o out --shard=") + shard);
    EXPECT_EQ(refused.exit_code, 64) << shard;
    EXPECT_THAT(refused.errors, HasSubstr("--shard")) << shard;
  }
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunFolder, IsReplayedBitForBit) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const auto replayed = rocking("trajectory out --condition 2 --realisation 3");
  EXPECT_EQ(replayed.exit_code, 0);
  EXPECT_EQ(replayed.output, rocking("trajectory quick.json --condition 2 --realisation 3").output);
  EXPECT_EQ(rocking("trajectory out --condition 2 --realisation 4").exit_code, 64);
  EXPECT_EQ(rocking("trajectory absent --condition 0 --realisation 0").exit_code, 66);
}

TEST_F(RunFolder, HoldsAPageThatIsWrittenAgainWithTheSameBytes) {
  ASSERT_EQ(rocking("run quick.json -q -o part1 --shard 1/2").exit_code, 0);
  ASSERT_EQ(rocking("run quick.json -q -o part2 --shard 2/2").exit_code, 0);
  EXPECT_FALSE(exists("part1/report.html"));
  EXPECT_THAT(rocking("resume out part1 part2").output, HasSubstr("page: out/report.html"));
  const std::string page = read("out/report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("<title>quick</title>"), HasSubstr("</html>")));
  std::filesystem::remove(folder_ / "out/report.html");
  EXPECT_THAT(rocking("report out --format html").output, HasSubstr("out/report.html"));
  EXPECT_TRUE(page == read("out/report.html"));
  ASSERT_EQ(rocking("run quick.json -q -o out --overwrite --shard 1/2").exit_code, 0);
  EXPECT_FALSE(exists("out/report.html")) << "it is of the run that was replaced";
}

TEST_F(RunFolder, HoldsAPageThatShowsPartingTimesWhereTheStoreIsThere) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), HasSubstr("<figure id=\"divergence_times\""));
  std::filesystem::remove(folder_ / "out/realisations.sqlite");
  ASSERT_EQ(rocking("report out --format html").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), AllOf(HasSubstr("</html>"), Not(HasSubstr("id=\"divergence_times\""))));
}

TEST_F(RunFolder, HasATableThatIsPrintedAgain) {
  Json enough = quick_experiment();
  enough["realisations"] = Json::parse(R"({ "until": { "half_width": 0.3, "at_most": 300 } })");
  write("enough.json", enough.dump());
  for (const std::string name : {"quick", "enough"}) {
    const std::string printed = rocking("run " + name + ".json --no-progress -o " + name).output;
    const std::string table = rocking("report " + name + " --format text").output;
    EXPECT_THAT(table, HasSubstr("amplitude"));
    EXPECT_THAT(printed, HasSubstr('\n' + table + "\nper cent")) << table;
  }
}

TEST_F(RunFolder, HoldsAPageWithoutPicturesWhereGnuplotIsMissing) {
  ASSERT_EQ(shell("mkdir nothing").exit_code, 0);
  const std::string without = std::string("PATH=$PWD/nothing '") + ROCKING_PROGRAM + "' ";
  const auto told = shell(without + "run quick.json -o out");
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_THAT(told.errors, HasSubstr("report.html has no pictures for printing: gnuplot"));
  EXPECT_THAT(read("out/report.html"), HasSubstr("no picture for printing"));
  EXPECT_THAT(shell(without + "run quick.json -q -o quiet").errors, HasSubstr("no pictures for printing: gnuplot"));
}

TEST_F(RunFolder, HasNoPageWithoutAReport) {
  EXPECT_EQ(rocking("report absent --format html").exit_code, 66);
  EXPECT_FALSE(exists("absent"));
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  change_report("/result/conditions/1", Json::object());
  EXPECT_EQ(rocking("report out --format html").exit_code, 65);
  EXPECT_EQ(rocking("report out --format htlm").exit_code, 64);
}

TEST_F(RunFolder, IsVerified) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const auto all = rocking("verify out");
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_THAT(all.output, HasSubstr("12 realisations run again, all with the same bits"));
  EXPECT_THAT(rocking("verify out --sample 4 --json").output, AllOf(HasSubstr("\"verified\": true"), HasSubstr("4")));
  std::filesystem::remove(folder_ / "out/realisations.sqlite");
  EXPECT_EQ(rocking("verify out").exit_code, 0) << "a report alone is checked by running it";
  EXPECT_EQ(rocking("verify out --sample 4").exit_code, 64);
}

TEST_F(RunFolder, IsNotVerifiedWhereTheReportWasEdited) {
  for (const bool with_store : {true, false}) {
    ASSERT_EQ(rocking("run quick.json -q -o out --overwrite").exit_code, 0);
    if (!with_store) std::filesystem::remove(folder_ / "out/realisations.sqlite");
    change_report("/result/conditions/1/counts/overturned", 1);
    const auto outcome = rocking("verify out");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.output, HasSubstr("/result/conditions/1/counts/overturned is 1, not 0"));
  }
}

TEST_F(RunFolder, IsNotVerifiedWhereTheSeedWasEdited) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  change_report("/input/experiment/seed", "0x2013");
  const auto edited = rocking("verify out");
  EXPECT_EQ(edited.exit_code, 1);
  EXPECT_THAT(edited.output, HasSubstr("input.sha256"));

  ASSERT_EQ(rocking("run quick.json -q -o other --seed 0x2013").exit_code, 0);
  std::filesystem::copy_file(folder_ / "other/report.json", folder_ / "out/report.json",
                             std::filesystem::copy_options::overwrite_existing);
  const auto foreign = rocking("verify out");
  EXPECT_EQ(foreign.exit_code, 1);
  EXPECT_THAT(
      foreign.output,
      HasSubstr("report.json: another experiment than that of the realisations: /seed is \"0x2013\", not \"0x2012\""));
}

// A copy that went wrong: no command takes part of its answer from the report and part from the realisations.
TEST_F(RunFolder, IsNotReadWithTheReportOfAnotherRun) {
  run_quietly("run quick.json -o out");
  run_quietly("run quick.json -o other --seed 0x2013");
  run_quietly("run quick.json -o longer --realisations 6");
  const std::string own = read("out/report.json");
  for (const char* foreign : {"other", "longer"}) {
    write("out/report.json", read(std::string(foreign) + "/report.json"));
    for (const char* command :
         {"report out", "report out --format csv", "report out --format text", "fragility out", "compare out other",
          "compare other out", "trajectory out --condition 0 --realisation 0", "run --status out", "resume whole out",
          "resume out", "resume out --realisations 8"}) {
      const auto refused = rocking(command);
      EXPECT_EQ(refused.exit_code, 65) << command << refused.errors;
      EXPECT_EQ(refused.output, "") << command;
      EXPECT_THAT(refused.errors, AllOf(HasSubstr("out/report.json"), HasSubstr("out/realisations.sqlite"),
                                        HasSubstr(foreign == std::string("other") ? "/seed" : "/realisations"),
                                        HasSubstr("`rocking resume out`")))
          << command;
    }
    EXPECT_EQ(rocking("verify out").exit_code, 1);
    EXPECT_EQ(read("out/report.json"), read(std::string(foreign) + "/report.json"));
  }
  std::filesystem::remove(folder_ / "out/report.json");
  run_quietly("resume out");
  write("own.json", own);
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("own.json"));
}

TEST_F(RunFolder, IsNotVerifiedWhereAnotherVersionGivesOtherBits) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  change_report("/system/version", "0.0.9");
  EXPECT_EQ(rocking("verify out").exit_code, 0) << "another version with the same bits is as good";
  change_report("/result/digest", std::string(64, '0'));
  const auto outcome = rocking("verify out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("the run was made by rocking 0.0.9"), HasSubstr("/result/digest")));
}

TEST_F(RunFolder, IsNotVerifiedWhereAStoredRealisationWasEdited) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  change_store("UPDATE realisations SET mode = 'chaotic' WHERE condition = 1 AND realisation = 2");
  const auto outcome = rocking("verify out");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, HasSubstr("condition 1, realisation 2 differs from what was written"));
}

TEST_F(RunFolder, IsMadeUnderAGroundMotionWhereEachBlockHasItsOwnHorizon) {
  auto question = rocking::support::recorded_experiment();
  question["sweep"][0] = {{"parameter", "/block/height_m"}, {"values", {4.0, 8.0}}};
  write("record.json", question.dump());
  write("pulse.txt", rocking::support::recorded_pulse());
  const auto outcome = rocking("run record.json -q -o out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(read("out/report.html"), HasSubstr("each as long as the base moves"));
}

TEST_F(RunFolder, IsNotVerifiedWithoutAReport) {
  EXPECT_EQ(rocking("verify absent").exit_code, 66);
  write("report.json", "{}");
  const auto outcome = rocking("verify .");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, HasSubstr("this is not a report"));
}

}  // namespace
