// Stores of layout 5, written by revision b98acc1 (tests/data/store_b98acc1), with realisations that were run until
// they were classified: looked at, resumed, extended, verified, merged by this program, which writes layout 6.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/store/sqlite.hpp"
#include "rocking/store/store.hpp"

namespace {

using rocking::Json;
using ::testing::HasSubstr;
namespace sqlite = rocking::sqlite;

class FormerSettlingStore : public rocking::support::ProgramTest {
 protected:
  FormerSettlingStore() {
    std::filesystem::copy(ROCKING_SOURCE_DIR "/tests/data/store_b98acc1", folder_,
                          std::filesystem::copy_options::recursive);
  }

  std::int64_t layout_of_file(const std::string& folder) const {
    const sqlite::Database database(folder_ / folder / "realisations.sqlite", sqlite::Access::read);
    auto query = database.prepare("PRAGMA user_version");
    query.step();
    return query.integer(0);
  }

  bool is_of_current_layout(const std::string& folder) const {
    return rocking::Store::open(folder_ / folder / "realisations.sqlite", sqlite::Access::read).is_of_current_layout();
  }
};

TEST_F(FormerSettlingStore, IsOfLayoutFiveAndLookedAt) {
  EXPECT_EQ(layout_of_file("whole"), 5);
  EXPECT_FALSE(is_of_current_layout("whole"));
  EXPECT_THAT(rocking("status whole").output, HasSubstr("36 of 36"));
  EXPECT_THAT(rocking("status shard").output, HasSubstr("18 of 18"));
}

// A row of layout 5 lacks only the column `long_run`, which the experiment did not ask for.
TEST_F(FormerSettlingStore, IsResumedWithTheReportOfANewRun) {
  run_quietly("resume stopped");
  run_quietly("run experiment.json -o anew");
  EXPECT_EQ(lasting_part("stopped/report.json"), lasting_part("anew/report.json"));
  EXPECT_TRUE(is_of_current_layout("stopped"));
  EXPECT_FALSE(exists("stopped/damaged-1.sqlite"));
  EXPECT_THAT(rocking("verify stopped").output, HasSubstr("36 realisations run again, all with the same bits"));
}

TEST_F(FormerSettlingStore, ThatIsFinishedIsResumedAndExtended) {
  run_quietly("resume whole");
  run_quietly("run experiment.json -o anew");
  EXPECT_EQ(lasting_part("whole/report.json"), lasting_part("anew/report.json"));
  run_quietly("resume whole --realisations 16");
  run_quietly("run experiment.json -o longer --realisations 16");
  EXPECT_EQ(lasting_part("whole/report.json"), lasting_part("longer/report.json"));
}

TEST_F(FormerSettlingStore, ThatIsFinishedIsVerifiedAndReplayedWithTheReportOfThisProgram) {
  run_quietly("resume whole");
  EXPECT_THAT(rocking("verify whole").output, HasSubstr("36 realisations run again, all with the same bits"));
  EXPECT_EQ(rocking("replay whole --condition 1 --realisation 8").exit_code, 0);
}

TEST_F(FormerSettlingStore, IsMergedWithAShardOfThisProgram) {
  run_quietly("run experiment.json -o second --shard 2/2");
  run_quietly("merge joined shard second");
  run_quietly("run experiment.json -o anew");
  EXPECT_EQ(lasting_part("joined/report.json"), lasting_part("anew/report.json"));
  EXPECT_TRUE(is_of_current_layout("joined"));
}

TEST_F(FormerSettlingStore, WithAChangedSettlingPeriodIsMended) {
  sqlite::Database(folder_ / "stopped/realisations.sqlite", sqlite::Access::write)
      .execute("UPDATE realisations SET settling_period = 200 WHERE condition = 0 AND realisation = 11");
  const auto resumed = rocking("resume stopped -q --no-page");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.errors, HasSubstr("the row of condition 0, realisation 11 differs"));
  run_quietly("run experiment.json -o anew");
  EXPECT_EQ(lasting_part("stopped/report.json"), lasting_part("anew/report.json"));
}

}  // namespace
