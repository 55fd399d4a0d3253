// Stores that revision 61b81ca wrote (layout 1, tests/data/store_61b81ca): read, resumed, verified, joined.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/experiment/sqlite.hpp"
#include "rocking/experiment/store.hpp"

namespace {

using rocking::report::Json;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace sqlite = rocking::experiment::sqlite;

class FormerStore : public rocking::support::ProgramTest {
 protected:
  FormerStore() {
    std::filesystem::copy(ROCKING_SOURCE_DIR "/tests/data/store_61b81ca", folder_,
                          std::filesystem::copy_options::recursive);
  }

  std::string digest_of(const std::string& report) const {
    return Json::parse(read(report)).at("result").at("digest").get<std::string>();
  }

  void change(const std::string& folder, const std::string& sql) const {
    sqlite::Database(folder_ / folder / "realisations.sqlite", sqlite::Access::write).execute(sql);
  }
};

TEST_F(FormerStore, IsLookedAt) {
  EXPECT_THAT(rocking("status whole").output, AllOf(HasSubstr("finished"), HasSubstr("64 of 64")));
  EXPECT_THAT(rocking("status stopped").output, AllOf(HasSubstr("stopped"), HasSubstr("62 of 64")));
  EXPECT_THAT(rocking("status shard").output, AllOf(HasSubstr("shard 1/2"), HasSubstr("32 of 32")));
}

TEST_F(FormerStore, IsResumedWithTheDigestOfTheWhole) {
  const auto resumed = rocking("resume stopped");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.errors, HasSubstr("62 realisations converted"));
  EXPECT_EQ(digest_of("stopped/report.json"), digest_of("whole/report.json"));
  EXPECT_TRUE(rocking::experiment::Store::open(folder_ / "stopped/realisations.sqlite", sqlite::Access::read)
                  .is_of_current_layout());
  EXPECT_EQ(rocking("verify stopped -q").exit_code, 0);
  EXPECT_FALSE(exists("stopped/damaged-1.sqlite"));
}

TEST_F(FormerStore, IsVerifiedAndReported) {
  const auto verified = rocking("verify whole");
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
  EXPECT_THAT(verified.output, HasSubstr("64 realisations run again"));
  EXPECT_EQ(rocking("report whole").exit_code, 0);
  EXPECT_EQ(rocking("replay whole --condition 3 --realisation 15").exit_code, 0);
}

TEST_F(FormerStore, IsMergedWithAShardOfThisProgram) {
  ASSERT_EQ(rocking("run experiment.json -q -o second --shard 2/2").exit_code, 0);
  const auto merged = rocking("merge joined shard second -q");
  ASSERT_EQ(merged.exit_code, 0) << merged.errors;
  EXPECT_EQ(digest_of("joined/report.json"), digest_of("whole/report.json"));
  EXPECT_EQ(rocking("verify joined -q").exit_code, 0);
}

TEST_F(FormerStore, IsMendedWhereItIsDamaged) {
  change("stopped", "UPDATE realisations SET margin = 2 WHERE condition = 1 AND realisation = 3");
  const auto resumed = rocking("resume stopped -q");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.errors, AllOf(HasSubstr("condition 1: realisations 3"), HasSubstr("damaged-1.sqlite")));
  EXPECT_EQ(digest_of("stopped/report.json"), digest_of("whole/report.json"));
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
  // As an older revision would have written it, with the checksum that layout 1 has.
  rocking::base::Sha256Builder sum;
  std::string experiment;
  std::string files;
  {
    const auto store = rocking::experiment::Store::open(folder_ / "stopped/realisations.sqlite", sqlite::Access::read);
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
