// `rocking resume DIR --realisations N`: a longer run has the bytes of one run of N, whatever was stored before.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Extension : public rocking::support::ProgramTest {
 protected:
  Extension() {
    auto slow = quick_experiment();  // long enough to be stopped
    slow["horizon"]["transient_periods"] = 2000;
    write("slow.json", slow.dump());
  }

  /// Runs an experiment from the start with this number, and compares `out` with it.
  void expect_bytes_of_one_run(const std::string& file, int realisations) const {
    const std::string number = std::to_string(realisations);
    ASSERT_EQ(rocking("run " + file + " -q --no-page --overwrite -o whole --realisations " + number).exit_code, 0);
    EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json")) << number;
    EXPECT_EQ(rocking("verify out -q --sample 20").exit_code, 0) << number;
  }
};

// Of an odd number the last realisation has no neighbour with which it was compared.
TEST_F(Extension, OfAFinishedRunHasTheBytesOfOneRun) {
  for (const char* before : {"1", "4", "5"}) {
    ASSERT_EQ(rocking(std::string("run quick.json -q --no-page --overwrite -o out --realisations ") + before).exit_code,
              0);
    for (const int after : {7, 12}) {
      const auto extended = rocking("resume out -q --no-page --realisations " + std::to_string(after));
      ASSERT_EQ(extended.exit_code, 0) << extended.errors;
      expect_bytes_of_one_run("quick.json", after);
    }
  }
}

TEST_F(Extension, RunsOnlyWhatIsMissing) {
  ASSERT_EQ(rocking("run slow.json -q --no-page -o out --realisations 4").exit_code, 0);
  ASSERT_EQ(rocking("resume out -q --no-page -j 1 --realisations 80 --max-time 0.001s").exit_code, 75);
  const Json status = Json::parse(rocking("run --status out --json").output);
  EXPECT_EQ(status["all"], 240);
  EXPECT_GE(status["done"], 12);
  EXPECT_EQ(status["replaces_earlier_run"], true);
}

TEST_F(Extension, KeepsTheFinishedRunUntilItIsComplete) {
  ASSERT_EQ(rocking("run slow.json -q --no-page -o out --realisations 5").exit_code, 0);
  const std::string before = read("out/report.json");
  ASSERT_EQ(rocking("resume out -q --no-page -j 1 --realisations 80 --max-time 0.001s").exit_code, 75);
  EXPECT_EQ(read("out/report.json"), before);
  ASSERT_EQ(rocking("resume out -q --no-page").exit_code, 0) << "the number is in the store now";
  expect_bytes_of_one_run("slow.json", 80);
  EXPECT_FALSE(exists("out/replacement"));
}

TEST_F(Extension, OfAnUnfinishedRunHasTheBytesOfOneRun) {
  ASSERT_EQ(rocking("run slow.json -q --no-page -j 1 -o out --realisations 79 --max-time 0.001s").exit_code, 75);
  ASSERT_EQ(rocking("resume out -q --no-page -j 1 --realisations 80 --max-time 0.001s").exit_code, 75);
  EXPECT_FALSE(exists("out/replacement"));
  ASSERT_EQ(rocking("resume out -q --no-page").exit_code, 0);
  expect_bytes_of_one_run("slow.json", 80);
}

TEST_F(Extension, ReplacesUntilByTheNumber) {
  auto until = quick_experiment();
  until["realisations"] = Json::parse(R"({"until": {"half_width": 0.2, "mode": "overturned", "at_most": 7}})");
  write("until.json", until.dump());
  ASSERT_EQ(rocking("run until.json -q -o out").exit_code, 0);
  ASSERT_EQ(rocking("resume out -q --realisations 9").exit_code, 0);
  expect_bytes_of_one_run("quick.json", 9);
}

TEST_F(Extension, ToTheNumberThatARunHasChangesNothing) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const std::string before = lasting_part("out/report.json");
  ASSERT_EQ(rocking("resume out -q --realisations 4").exit_code, 0);
  EXPECT_EQ(lasting_part("out/report.json"), before);
}

TEST_F(Extension, TellsWhatALongerRunMayNotFollowFrom) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  EXPECT_THAT(rocking("resume out --realisations 5").errors, HasSubstr("`until`"));
}

TEST_F(Extension, RefusesWhatIsNone) {
  ASSERT_EQ(rocking("run quick.json -q -o out").exit_code, 0);
  const std::string before = read("out/report.json");
  const auto fewer = rocking("resume out --realisations 3");
  EXPECT_EQ(fewer.exit_code, 64);
  EXPECT_THAT(fewer.errors, AllOf(HasSubstr("--realisations 3"), HasSubstr("at least 4")));
  for (const char* number : {"0", "-1", "many", "2.5"}) {
    const auto refused = rocking(std::string("resume out --realisations=") + number);
    EXPECT_EQ(refused.exit_code, 64) << number;
    EXPECT_THAT(refused.errors, HasSubstr("--realisations")) << number;
  }
  ASSERT_EQ(rocking("run quick.json -q -o part --shard 1/2").exit_code, 0);
  const auto shard = rocking("resume part --realisations 9");
  EXPECT_EQ(shard.exit_code, 64);
  EXPECT_THAT(shard.errors, HasSubstr("merge the shards"));
  auto swept = quick_experiment();
  swept["sweep"] = Json::parse(R"([{"parameter": "/realisations", "values": [2, 3]}])");
  write("swept.json", swept.dump());
  ASSERT_EQ(rocking("run swept.json -q -o swept").exit_code, 0);
  EXPECT_THAT(rocking("resume swept --realisations 9").errors, HasSubstr("the sweep of the file"));
  EXPECT_EQ(read("out/report.json"), before);
  EXPECT_FALSE(exists("out/replacement"));
}

}  // namespace
