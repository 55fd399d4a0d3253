// Stores written by revision 61b81ca (layout 1, tests/data/store_61b81ca): read, resumed, verified, merged.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/store/store.hpp"

namespace {

using rocking::Json;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace sqlite = rocking::sqlite;

class FormerStore : public rocking::support::ProgramTest {
 protected:
  FormerStore() {
    std::filesystem::copy(ROCKING_SOURCE_DIR "/tests/data/store_61b81ca", folder_,
                          std::filesystem::copy_options::recursive);
  }

  /// Without what rows of former layouts do not tell.
  std::string part_without_peaks(const std::string& report) const {
    Json json = Json::parse(lasting_part(report));
    for (Json& condition : json["result"]["conditions"]) {
      for (const char* key : {"peak_tilt", "peak_tilt_rate", "peak_slip", "final_slip"}) condition.erase(key);
      condition["validity"].erase("left_ground_before_fall");
      condition["validity"]["first_realisations"].erase("left_ground_before_fall");
    }
    return json.dump();
  }

  void expect_report_of_a_new_run(const std::string& folder) const {
    ASSERT_EQ(rocking("run experiment.json -q -o anew").exit_code, 0);
    EXPECT_EQ(part_without_peaks(folder + "/report.json"), part_without_peaks("anew/report.json"));
  }

  void change(const std::string& folder, const std::string& sql) const {
    sqlite::Database(folder_ / folder / "realisations.sqlite", sqlite::Access::write).execute(sql);
  }

  /// With the checksum that a row has in layout 1.
  void put_row(const std::string& folder, const rocking::RealisationKey& key, const rocking::Summary& summary) const {
    const sqlite::Database database(folder_ / folder / "realisations.sqlite", sqlite::Access::write);
    const rocking::RowFormat rows(database, 1, "");
    auto insert = database.prepare("INSERT OR REPLACE INTO realisations (" + rows.columns() + ") VALUES (" +
                                   rows.placeholders() + ")");
    rows.bind(insert, key, summary);
    insert.run();
  }
};

TEST_F(FormerStore, IsLookedAt) {
  EXPECT_THAT(rocking("status whole").output, AllOf(HasSubstr("finished"), HasSubstr("64 of 64")));
  EXPECT_THAT(rocking("status stopped").output, AllOf(HasSubstr("stopped"), HasSubstr("62 of 64")));
  EXPECT_THAT(rocking("status shard").output, AllOf(HasSubstr("shard 1/2"), HasSubstr("32 of 32")));
}

TEST_F(FormerStore, IsResumedWithTheReportOfANewRun) {
  const auto resumed = rocking("resume stopped");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  // Of 62: 17 lost contact, one is the other of a pair with one of these, 6 others were rerun at a tighter tolerance.
  EXPECT_THAT(resumed.errors, HasSubstr("38 realisations converted"));
  expect_report_of_a_new_run("stopped");
  const Json resumed_conditions = Json::parse(read("stopped/report.json"))["result"]["conditions"];
  EXPECT_TRUE(resumed_conditions[0]["peak_tilt"].is_null()) << "it has converted rows, without peaks";
  EXPECT_FALSE(resumed_conditions[3]["peak_tilt"].is_null()) << "all of it was run again";
  EXPECT_FALSE(Json::parse(read("anew/report.json"))["result"]["conditions"][0]["peak_tilt"].is_null());
  EXPECT_TRUE(
      rocking::Store::open(folder_ / "stopped/realisations.sqlite", sqlite::Access::read).is_of_current_layout());
  EXPECT_THAT(rocking("verify stopped -q").output, HasSubstr("64 realisations run again, all with the same bits"));
  EXPECT_FALSE(exists("stopped/damaged-1.sqlite"));
}

TEST_F(FormerStore, ThatIsFinishedIsResumedToo) {
  ASSERT_EQ(rocking("resume whole -q").exit_code, 0);
  expect_report_of_a_new_run("whole");
}

TEST_F(FormerStore, IsVerifiedWhereItHasTheBitsOfThisProgram) {
  const auto verified = rocking("verify whole");
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
  // The 17 that lost contact, the other one of a pair with one of these, and 6 that were rerun at a tighter tolerance.
  EXPECT_THAT(verified.output,
              AllOf(HasSubstr("40 realisations run again"), HasSubstr("24 realisations were not compared"),
                    HasSubstr("results version 1"), HasSubstr("`rocking resume whole`")));
  const auto told = Json::parse(rocking("verify whole --json").output);
  EXPECT_EQ(told["realisations_run_again"], 40);
  EXPECT_EQ(told["realisations_not_compared"], 24);
  EXPECT_EQ(rocking("report whole").exit_code, 0);
}

TEST_F(FormerStore, IsReplayedWhereTheBitsAreThoseOfThisProgram) {
  EXPECT_EQ(rocking("replay whole --condition 2 --realisation 14").exit_code, 0);
  const auto other = rocking("replay whole --condition 3 --realisation 15");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.errors, HasSubstr("which rocking 0.1.0 61b81ca4680c computed"));
}

TEST_F(FormerStore, IsNotVerifiedWhereARowThatShouldHaveTheSameBitsHasOthers) {
  ASSERT_EQ(rocking("run experiment.json -q -o other --seed 5").exit_code, 0);
  const auto other = rocking::Store::open(folder_ / "other/realisations.sqlite", sqlite::Access::read);
  put_row("whole", {0, 3}, *other.find({0, 3}));
  const auto verified = rocking("verify whole");
  EXPECT_EQ(verified.exit_code, 1);
  EXPECT_THAT(verified.output, HasSubstr("condition 0, realisation 3: the new result differs"));
}

TEST_F(FormerStore, IsMergedWithAShardOfThisProgramOnceItIsResumed) {
  ASSERT_EQ(rocking("run experiment.json -q -o second --shard 2/2").exit_code, 0);
  for (const char* order : {"shard second", "second shard", "shard"}) {
    const auto refused = rocking(std::string("merge joined ") + order);
    EXPECT_EQ(refused.exit_code, 74) << order;
    EXPECT_THAT(refused.errors, HasSubstr("`rocking resume shard` runs again what differs, then merge"));
  }
  ASSERT_EQ(rocking("resume shard -q").exit_code, 0);
  const auto merged = rocking("merge joined shard second -q");
  ASSERT_EQ(merged.exit_code, 0) << merged.errors;
  expect_report_of_a_new_run("joined");
  EXPECT_EQ(rocking("verify joined -q").exit_code, 0);
}

TEST_F(FormerStore, IsMendedWhereItIsDamaged) {
  change("stopped", "UPDATE realisations SET margin = 2 WHERE condition = 1 AND realisation = 3");
  const auto resumed = rocking("resume stopped -q");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.errors, AllOf(HasSubstr("condition 1: realisations 0, 2-3, 10;"), HasSubstr("damaged-1.sqlite")));
  expect_report_of_a_new_run("stopped");
}

TEST_F(FormerStore, IsRefusedWhereItsPartIsNone) {
  const std::string sound = read("whole/realisations.sqlite");
  for (const char* edit : {"part = 0, parts = 0", "part = 0", "parts = 0", "part = 2, parts = 1"}) {
    write("whole/realisations.sqlite", sound);
    change("whole", std::string("UPDATE identity SET ") + edit);
    for (const char* command : {"status whole", "resume whole", "verify whole", "merge joined whole"}) {
      const auto refused = rocking(command);
      EXPECT_EQ(refused.exit_code, 65) << edit << ": " << command << ": " << refused.errors;
    }
  }
}

TEST_F(FormerStore, OfARevisionWithOtherResultsIsNotResumed) {
  // As an older revision would have written it, with the checksum of layout 1.
  rocking::base::Sha256Builder sum;
  std::string experiment;
  std::string files;
  {
    const auto store = rocking::Store::open(folder_ / "stopped/realisations.sqlite", sqlite::Access::read);
    experiment = store.identity().experiment;
    files = store.identity().files;
  }
  for (const std::string& text :
       {experiment, std::string("0.1.0 0123456789ab"), std::string("rocking.draws/1"), files}) {
    sum.add(std::uint64_t{text.size()});
    sum.add(text);
  }
  sum.add(std::uint64_t{0});
  sum.add(std::uint64_t{0});
  change("stopped",
         "UPDATE identity SET code = '0.1.0 0123456789ab', checksum = '" + rocking::base::to_hex(sum.finish()) + "'");
  const auto refused = rocking("resume stopped");
  EXPECT_EQ(refused.exit_code, 74) << refused.errors;
  EXPECT_THAT(refused.errors, HasSubstr("0.1.0 0123456789ab"));
  EXPECT_EQ(rocking("status stopped").exit_code, 0) << "it can be read all the same";
}

}  // namespace
