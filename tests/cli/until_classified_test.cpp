// horizon.until_classified: the bytes of a report do not depend on how its realisations were computed.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class UntilClassified : public rocking::support::ProgramTest {
 protected:
  UntilClassified() {
    // Responses settle at the horizon and later, do not settle, overturn, and are left.
    Json experiment = quick_experiment();
    experiment["friction"] = {{"static", 0.40}, {"kinetic", 0.35}};
    experiment["initial"] = {{"tilt", {{"uniform", {0.0, 0.5}}}}};
    experiment["sweep"][0]["values"] = {5.5, 6.0, 7.0};
    experiment["horizon"] = {
        {"transient_periods", 20},
        {"sampled_periods", 60},
        {"until_classified",
         {{"at_most_periods", 1000}, {"held_windows", 2}, {"watch_windows", 2}, {"long_run_every", 3}}}};
    experiment["realisations"] = 24;
    write("until.json", experiment.dump());
    experiment["horizon"]["until_classified"].erase("long_run_every");
    write("without.json", experiment.dump());
  }
};

TEST_F(UntilClassified, ContinuesSomeRealisationsAndNotAll) {
  Json experiment = Json::parse(read("until.json"));
  Json& until = experiment["horizon"]["until_classified"];
  until["at_most_periods"] = 700;  // up to 1000 every one is classified
  until["held_windows"] = 1;       // those that are held by two are not left
  until["watch_windows"] = 6;
  write("shorter.json", experiment.dump());
  run_quietly("run shorter.json -o whole");
  const Json report = Json::parse(read("whole/report.json"));
  std::uint64_t censored = 0;
  std::uint64_t left = 0;
  bool some_later = false;
  for (const Json& condition : report["result"]["conditions"]) {
    const Json& incidence = condition.at("incidence");
    censored += incidence.at("censored").get<std::uint64_t>();
    for (const auto& [mode, leaving] : incidence.at("leaving").items()) left += leaving.at("left").get<std::uint64_t>();
    for (const auto& [mode, curve] : incidence.at("modes").items()) {
      some_later = some_later || curve.at("periods").back() > 80;
    }
  }
  EXPECT_TRUE(some_later);
  EXPECT_GT(censored, 0U);
  EXPECT_GT(left, 0U);
}

TEST_F(UntilClassified, HasTheSameBytesOnAnyNumberOfThreads) {
  run_quietly("run until.json -o whole -j 1");
  run_quietly("run until.json -o three -j 3");
  EXPECT_EQ(lasting_part("three/report.json"), lasting_part("whole/report.json"));
}

TEST_F(UntilClassified, HasTheSameBytesInShards) {
  run_quietly("run until.json -o whole");
  for (const char* shard : {"1/3", "2/3", "3/3"})
    run_quietly(std::string("run until.json --shard ") + shard + " -o part" + shard[0]);
  run_quietly("resume joined part1 part2 part3");
  EXPECT_EQ(lasting_part("joined/report.json"), lasting_part("whole/report.json"));
}

TEST_F(UntilClassified, HasTheSameBytesWhenStoppedResumedOrExtended) {
  run_quietly("run until.json -o whole");
  ASSERT_EQ(rocking("run until.json -o out -q --no-page -j 1 --max-time 0.001s").exit_code, 75);
  run_quietly("resume out");
  EXPECT_EQ(lasting_part("out/report.json"), lasting_part("whole/report.json"));
  run_quietly("run until.json -o longer --realisations 9");
  run_quietly("resume longer --realisations 24");
  EXPECT_EQ(lasting_part("longer/report.json"), lasting_part("whole/report.json"));
}

TEST_F(UntilClassified, GivesNoLongRunSharesWithoutLongRuns) {
  const auto outcome = rocking("run without.json -o without -q");
  EXPECT_THAT(outcome.output, Not(HasSubstr("long-run shares of time")));
  ASSERT_EQ(rocking("report without --format csv,latex -q").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "without/tables/long_run_shares.csv"));
  EXPECT_THAT(read("without/report.html"), Not(HasSubstr("Long-run shares of time")));
}

// A label of one window is not said to be that in the end without the proviso that it may be left.
TEST_F(UntilClassified, QualifiesTheEndWhereAResponseWasHeldForOneWindow) {
  EXPECT_THAT(rocking("run without.json -o two -q").output, Not(HasSubstr("held_windows 1")));
  Json experiment = Json::parse(read("without.json"));
  experiment["horizon"]["until_classified"].erase("held_windows");
  write("one.json", experiment.dump());
  EXPECT_THAT(rocking("run one.json -o one -q").output, HasSubstr("may be left again later"));
  EXPECT_THAT(read("one/report.html"), HasSubstr("may be left again later"));
  ASSERT_EQ(rocking("report one --format latex -q").exit_code, 0);
  EXPECT_THAT(read("one/tables/modes.tex"), HasSubstr("may be left again later"));
  EXPECT_THAT(read("one/tables/settling.tex"), HasSubstr("may be left again later"));
}

// Another 60 periods of the excitation without a limit: the scene is too short for most responses.
TEST_F(UntilClassified, IsProposedWhereAFixedHorizonIsTooShort) {
  Json experiment = Json::parse(read("until.json"));
  experiment["horizon"].erase("until_classified");
  write("fixed.json", experiment.dump());
  EXPECT_THAT(rocking("run fixed.json -o fixed -q").output, HasSubstr("add \"until_classified\""));
  EXPECT_THAT(read("fixed/report.html"), AllOf(HasSubstr("until_classified"), Not(HasSubstr("id=\"by-when\""))));
}

TEST_F(UntilClassified, IsBoundedInAPlanAndMentionedWithCosts) {
  const auto plan = rocking("run until.json --dry-run");
  EXPECT_EQ(plan.exit_code, 0);
  EXPECT_THAT(plan.output, AllOf(HasSubstr("at most 72000 periods with until_classified"),
                                 HasSubstr("for the fixed horizon"), HasSubstr("until_classified: if every")));
  const Json facts = Json::parse(rocking("run until.json --dry-run --json").output);
  EXPECT_EQ(facts.at("most_periods"), 72000);
  EXPECT_GT(facts.at("most_seconds"), facts.at("seconds"));
  EXPECT_THAT(rocking("cost until.json --sample 4 --tolerances 1e-6,1e-8,1e-10 -q").output,
              HasSubstr("those of the fixed horizon"));
}

TEST_F(UntilClassified, IsVerifiedAndReplayed) {
  run_quietly("run until.json -o whole");
  EXPECT_EQ(rocking("verify whole -q").exit_code, 0);
  for (const char* number : {"0", "7", "23"}) {
    const auto outcome = rocking(std::string("trajectory whole --condition 1 --realisation ") + number);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
}

TEST_F(UntilClassified, HasTheSameResultsBesidesLongRuns) {
  run_quietly("run until.json -o whole");
  run_quietly("run without.json -o without");
  const Json with = Json::parse(read("whole/report.json"))["result"]["conditions"];
  const Json without = Json::parse(read("without/report.json"))["result"]["conditions"];
  for (std::size_t i = 0; i < with.size(); ++i) {
    Json condition = with[i];
    Json expected = without[i];
    for (Json* each : {&condition, &expected}) {  // all draws are counted, those of long runs included
      for (const char* key : {"draws", "clamped_draws"}) (*each)["validity"].erase(key);
    }
    const Json shares = condition["incidence"]["long_run_shares"];
    condition["incidence"].erase("long_run_shares");
    EXPECT_TRUE(condition == expected) << i;
    EXPECT_EQ(shares["realisations"], 8);
    EXPECT_EQ(shares["windows"], 8);  // of 60 periods, from 500 on: 500, ..., 920
    double sum = 0.0;
    for (const auto& [mode, share] : shares["modes"].items()) sum += share["share"].get<double>();
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

}  // namespace
