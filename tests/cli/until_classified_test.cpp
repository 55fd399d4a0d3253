// horizon.until_classified: the bytes of a report do not depend on how its realisations were computed.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;

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
        {"until_classified", {{"at_most_periods", 1000}, {"held_windows", 2}, {"watch_windows", 2}}}};
    experiment["realisations"] = 24;
    write("until.json", experiment.dump());
  }

  std::string lasting_part(const std::string& folder) const {
    Json json = Json::parse(read(folder + "/report.json"));
    json.erase("system");
    return json.dump();
  }

  void run(const std::string& arguments) const {
    const auto outcome = rocking(arguments + " -q --no-page");
    ASSERT_EQ(outcome.exit_code, 0) << arguments << outcome.errors;
  }
};

TEST_F(UntilClassified, ContinuesSomeRealisationsAndNotAll) {
  run("run until.json -o whole");
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
  run("run until.json -o whole -j 1");
  run("run until.json -o three -j 3");
  EXPECT_EQ(lasting_part("three"), lasting_part("whole"));
}

TEST_F(UntilClassified, HasTheSameBytesInShards) {
  run("run until.json -o whole");
  for (const char* shard : {"1/3", "2/3", "3/3"})
    run(std::string("run until.json --shard ") + shard + " -o part" + shard[0]);
  run("merge joined part1 part2 part3");
  EXPECT_EQ(lasting_part("joined"), lasting_part("whole"));
}

TEST_F(UntilClassified, HasTheSameBytesWhenStoppedResumedOrExtended) {
  run("run until.json -o whole");
  ASSERT_EQ(rocking("run until.json -o out -q --no-page -j 1 --max-time 0.001s").exit_code, 75);
  run("resume out");
  EXPECT_EQ(lasting_part("out"), lasting_part("whole"));
  run("run until.json -o longer --realisations 9");
  run("resume longer --realisations 24");
  EXPECT_EQ(lasting_part("longer"), lasting_part("whole"));
}

TEST_F(UntilClassified, IsVerifiedAndReplayed) {
  run("run until.json -o whole");
  EXPECT_EQ(rocking("verify whole -q").exit_code, 0);
  for (const char* number : {"0", "7", "23"}) {
    const auto outcome = rocking(std::string("replay whole --condition 1 --realisation ") + number);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
}

}  // namespace
