// Damaged or edited stores: each command gives the right bytes or refuses with exit code 65, and no report is wrong.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "cli/program.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/store/summary.hpp"

namespace {

using rocking::Json;
using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Eq;
using ::testing::HasSubstr;

constexpr std::size_t page_size = 4096;

class DamagedRun : public rocking::support::ProgramTest {
 protected:
  DamagedRun() {
    auto question = quick_experiment();
    question["realisations"] = 24;
    write("question.json", question.dump());
    EXPECT_EQ(shell("mkdir nothing").exit_code, 0);
    EXPECT_EQ(plainly("run question.json -q -o whole").exit_code, 0);
  }

  /// Runs `rocking` without gnuplot, since drawing would take most of the time.
  Outcome plainly(const std::string& arguments) const {
    return shell("PATH=$PWD/nothing exec '" ROCKING_PROGRAM "' " + arguments);
  }

  std::string pages() const { return read("whole/realisations.sqlite"); }

  /// Writes a finished run with these bytes as its store.
  void put_run(const std::string& store) const {
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::create_directory(folder_ / "out");
    write("out/realisations.sqlite", store);
    std::filesystem::copy_file(folder_ / "whole/report.json", folder_ / "out/report.json");
  }

  /// Tests each command on the run in `out`; `resume` comes last, without the report.
  void expect_right_or_refused(const std::string& what) const {
    const auto right_or_refused = AnyOf(Eq(0), Eq(65), Eq(74));
    for (const char* command : {"run --status out", "verify out -q", "report out --format csv,html",
                                "trajectory out --condition 2 --realisation 23", "resume joined out --overwrite"}) {
      const Outcome outcome = plainly(command);
      EXPECT_THAT(outcome.exit_code, right_or_refused) << what << ": " << command << ": " << outcome.errors;
    }
    expect_right_report("joined", what);
    std::filesystem::remove(folder_ / "out/report.json");
    const Outcome resumed = plainly("resume out -q");
    EXPECT_THAT(resumed.exit_code, right_or_refused) << what << ": " << resumed.errors;
    EXPECT_EQ(resumed.exit_code == 0, exists("out/report.json")) << what;
    expect_right_report("out", what);
  }

  void expect_right_report(const std::string& folder, const std::string& what) const {
    if (!exists(folder + "/report.json")) return;
    EXPECT_EQ(lasting_part(folder + "/report.json"), lasting_part("whole/report.json")) << what;
  }

  void change_store(const std::string& sql) const {
    put_run(pages());
    rocking::sqlite::Database(folder_ / "out/realisations.sqlite", rocking::sqlite::Access::write).execute(sql);
  }
};

TEST_F(DamagedRun, GivesNoWrongReportWhicheverPagesWereExchangedOrCopied) {
  const std::string sound = pages();
  const std::size_t count = sound.size() / page_size;
  ASSERT_GE(count, 5U);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      const std::string names = std::to_string(i) + " and " + std::to_string(j);
      std::string changed = sound;
      changed.replace(j * page_size, page_size, sound, i * page_size, page_size);
      put_run(changed);
      expect_right_or_refused("copied: " + names);
      if (i > j) continue;
      changed.replace(i * page_size, page_size, sound, j * page_size, page_size);
      put_run(changed);
      expect_right_or_refused("exchanged: " + names);
    }
  }
}

TEST_F(DamagedRun, TakesNoPageOfAnotherExperiment) {
  ASSERT_EQ(plainly("run question.json -q -o other --seed 7").exit_code, 0);
  const std::string sound = pages();
  const std::string other = read("other/realisations.sqlite");
  for (std::size_t page = 0; page < std::min(sound.size(), other.size()) / page_size; ++page) {
    std::string changed = sound;
    changed.replace(page * page_size, page_size, other, page * page_size, page_size);
    put_run(changed);
    expect_right_or_refused(std::to_string(page));
  }
}

TEST_F(DamagedRun, SaysWhichRealisationsAreRunAgain) {
  change_store(
      "UPDATE realisations SET steps = steps + 1 WHERE condition = 1 AND realisation IN (3, 4, 5, 9) OR condition = 2 "
      "AND realisation = 0");
  const Outcome resumed = plainly("resume out -q");
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_THAT(resumed.errors,
              HasSubstr("is run again: condition 1: realisations 3-5, 9; condition 2: realisations 0. The damaged"));
  expect_right_report("out", "");
}

TEST_F(DamagedRun, SaysOfManyRealisationsTheFirstOnes) {
  change_store("UPDATE realisations SET steps = steps + 1 WHERE realisation % 2 = 1");
  const Outcome resumed = plainly("resume out -q");
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_THAT(resumed.errors, HasSubstr("condition 0: realisations 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, and 24 "
                                        "more"));
  expect_right_report("out", "");
}

TEST_F(DamagedRun, IsRefusedWhereItsIdentityWasEdited) {
  for (const char* change :
       {"UPDATE identity SET part = 0, parts = 0", "UPDATE identity SET part = 0", "UPDATE identity SET parts = 0",
        "UPDATE identity SET part = 1, parts = 1", "UPDATE identity SET part = 3, parts = 2",
        "UPDATE identity SET part = -1, parts = 2", "UPDATE identity SET results = results + 1",
        "UPDATE identity SET experiment_sha256 = 'x'", "UPDATE identity SET code = 'x'",
        "INSERT INTO identity SELECT * FROM identity", "DELETE FROM identity", "UPDATE identity SET checksum = 'x'",
        "PRAGMA user_version = 0", "PRAGMA user_version = 1", "PRAGMA user_version = -7", "PRAGMA application_id = 0",
        "DROP TABLE identity", "DROP TABLE realisations"}) {
    for (const char* command :
         {"run --status out", "resume out", "verify out", "report out --format html", "resume m out"}) {
      change_store(change);
      const Outcome outcome = plainly(command);
      EXPECT_EQ(outcome.exit_code, 65) << change << ": " << command << ": " << outcome.errors;
      EXPECT_THAT(outcome.errors, HasSubstr("out/realisations.sqlite")) << change;
    }
  }
}

TEST_F(DamagedRun, IsRefusedWhereItHoldsMoreThanItsTables) {
  for (const auto& [change, named] : std::map<std::string, std::string>{
           {"CREATE TRIGGER t AFTER INSERT ON realisations BEGIN DELETE FROM realisations; END", "trigger \"t\""},
           {"CREATE TRIGGER t BEFORE INSERT ON realisations BEGIN SELECT RAISE(ABORT, 'x'); END", "trigger \"t\""},
           {"CREATE VIEW v AS SELECT 1", "view \"v\""},
           {"CREATE INDEX i ON realisations (mode)", "index \"i\""},
           {"CREATE TABLE more (a)", "table \"more\""},
           {"DROP TABLE identity; CREATE VIEW identity AS SELECT 1 AS code", "view \"identity\""}}) {
    for (const char* command : {"run --status out", "resume out", "verify out", "report out --format html",
                                "resume m out", "trajectory out --condition 0 --realisation 0"}) {
      change_store(change);
      const Outcome outcome = plainly(command);
      EXPECT_EQ(outcome.exit_code, 65) << change << ": " << command << ": " << outcome.errors;
      EXPECT_THAT(outcome.errors, HasSubstr(named)) << command;
    }
  }
}

TEST_F(DamagedRun, OfAnotherLayoutIsRefusedWithTheVersionThatWroteIt) {
  const std::string next = std::to_string(rocking::current_layout + 1);
  change_store("PRAGMA user_version = " + next + "; UPDATE identity SET code = '0.9.0 fedcba987654'");
  const Outcome refused = plainly("resume out");
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("was written by rocking 0.9.0 fedcba987654 in layout " + next),
                                    HasSubstr("reads layout " + std::to_string(rocking::current_layout))));
}

TEST_F(DamagedRun, DoesNotGrowWhereItsHeaderCountsTooManyPages) {
  std::string changed = pages();
  changed[28] = static_cast<char>(changed[28] ^ 0x20);
  put_run(changed);
  EXPECT_EQ(plainly("resume out -q").exit_code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) {
    if (entry.path().extension() == ".sqlite") {
      EXPECT_LE(entry.file_size(), 2 * changed.size()) << entry.path();
    }
  }
  expect_right_report("out", "");
}

TEST_F(DamagedRun, OfWhichTheStoreIsEmptyBeginsAnew) {
  std::filesystem::create_directory(folder_ / "out");
  write("out/realisations.sqlite", "");
  EXPECT_EQ(plainly("resume out").exit_code, 66);
  EXPECT_EQ(plainly("run --status out").exit_code, 66);
  EXPECT_EQ(plainly("run question.json -q -o out").exit_code, 0);
  expect_right_report("out", "");
}

TEST_F(DamagedRun, TakesNoLogOfAnotherStore) {
  // Files of a killed run with another seed; the user removes the store but not the log.
  const Outcome killed =
      shell(in_background("run question.json -q -o out --seed 7 -j 1 --realisations 1000000", has_realisations("out")) +
            "kill -9 $child; rm out/realisations.sqlite");
  ASSERT_TRUE(exists("out/realisations.sqlite-wal"));
  ASSERT_EQ(plainly("run question.json -q -o out").exit_code, 0);
  expect_right_report("out", "");
  EXPECT_EQ(plainly("verify out -q").exit_code, 0);
}

TEST_F(DamagedRun, OfWhichTheStoreIsAPipeIsRefusedAtOnce) {
  ASSERT_EQ(shell("mkdir out; mkfifo out/realisations.sqlite").exit_code, 0);
  for (const char* command : {"run --status out", "resume out"}) {
    const Outcome refused = shell(std::string("exec timeout 20 '") + ROCKING_PROGRAM + "' " + command);
    EXPECT_EQ(refused.exit_code, 65) << command;
    EXPECT_THAT(refused.errors, HasSubstr("is a pipe or a device; give a regular file"));
  }
}

TEST_F(DamagedRun, LeavesTheLockOfAnotherProcess) {
  ASSERT_EQ(shell("mkdir out; echo 17 >out/.lock").exit_code, 0);
  ASSERT_EQ(plainly("run question.json -q -o out").exit_code, 0);
  EXPECT_EQ(read("out/.lock"), "17\n") << "another program's";

  ASSERT_EQ(shell("mkdir -p pipe/out; mkfifo pipe/out/.lock").exit_code, 0);
  const Outcome ran =
      shell("timeout 60 '" ROCKING_PROGRAM "' run question.json -q -o pipe/out && timeout 60 '" ROCKING_PROGRAM
            "' run --status pipe/out");
  EXPECT_EQ(ran.exit_code, 0) << ran.errors;

  const Outcome replaced =
      shell(in_background("run question.json -q -o busy -j 1 --realisations 1000000", "test -e busy/.lock") +
            "rm busy/.lock; touch busy/.lock; kill -INT $child; wait $child; test -e busy/.lock");
  EXPECT_EQ(replaced.exit_code, 0) << "put there by another process while the run was at work";
}

TEST_F(DamagedRun, HasThePermissionsThatTheUmaskLeaves) {
  for (const auto& [mask, mode] : std::map<std::string, unsigned>{{"077", 0600}, {"007", 0660}}) {
    const std::string folder = "out" + mask;
    ASSERT_EQ(shell("umask " + mask + "; '" ROCKING_PROGRAM "' run question.json -q -o " + folder +
                    " && '" ROCKING_PROGRAM "' report " + folder)
                  .exit_code,
              0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / folder)) {
      if (!entry.is_regular_file()) continue;
      struct stat facts {};
      ASSERT_EQ(stat(entry.path().c_str(), &facts), 0);
      EXPECT_EQ(facts.st_mode & 0777U, mode) << entry.path();
    }
  }
}

}  // namespace
