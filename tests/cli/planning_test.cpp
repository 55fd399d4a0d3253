// What a user learns and decides before a run: its time, where the experiment comes from, whether there is a page.

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using rocking::support::recorded_experiment;
using rocking::support::recorded_pulse;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Planning : public rocking::support::ProgramTest {};

TEST_F(Planning, ADryRunMeasuresTheTime) {
  EXPECT_THAT(rocking("run quick.json --dry-run").output, HasSubstr("from a sample of 12 realisations\n"));
  const Json plan = Json::parse(rocking("run quick.json --dry-run --json").output);
  EXPECT_GT(plan["seconds"], 0.0);
  EXPECT_EQ(plan["sampled_realisations"], 12);
  EXPECT_EQ(plan["sampled_share_of_horizon"], 1.0);
}

TEST_F(Planning, ADryRunOfALongRunSamplesSomeOfIt) {
  auto lengthy = quick_experiment();
  lengthy["horizon"]["transient_periods"] = 100'000'000;
  lengthy["realisations"] = 1'000'000;
  write("lengthy.json", lengthy.dump());
  const Json plan = Json::parse(rocking("run lengthy.json --dry-run --json").output);
  EXPECT_GT(plan["seconds"], 1e6);
  EXPECT_LT(plan["sampled_share_of_horizon"], 0.01);
  EXPECT_THAT(rocking("run lengthy.json --dry-run").output, HasSubstr("% of their periods"));
}

TEST_F(Planning, ADryRunOfAnOpenNumberGivesTheMost) {
  auto until = quick_experiment();
  until["realisations"] = Json::parse(R"({"until": {"half_width": 0.2, "at_most": 7}})");
  write("until.json", until.dump());
  EXPECT_THAT(rocking("run until.json --dry-run").output,
              ::testing::ContainsRegex("at most [0-9.]+ [a-z]+, from a sample of 21 realisations"));
}

TEST_F(Planning, WhatIsSuspiciousIsToldBeforeARun) {
  auto swapped = quick_experiment();
  swapped["block"] = Json::parse(R"({"width_m": 1.9, "height_m": 0.35})");
  swapped["friction"] = Json::parse(R"({"static": 0.5, "kinetic": 0.45})");
  swapped["fluctuation"] = Json::parse(R"({"friction": {"sigma": 0.1}})");
  write("swapped.json", swapped.dump());
  const auto squat = HasSubstr("warning: /block: the block is squat");
  const auto clamped = HasSubstr("warning: random numbers would be clamped");
  const auto validated = rocking("validate swapped.json");
  EXPECT_EQ(validated.exit_code, 0);
  EXPECT_THAT(validated.output, AllOf(squat, clamped));
  EXPECT_THAT(rocking("run swapped.json --dry-run").output, AllOf(squat, clamped));
  EXPECT_THAT(rocking("run swapped.json -o a").errors, AllOf(squat, Not(clamped)))
      << "the run counts the clamps itself";
  const auto json = rocking("validate swapped.json --json");
  EXPECT_TRUE(Json::accept(json.output));
  EXPECT_THAT(json.errors, AllOf(squat, clamped));
  EXPECT_THAT(rocking("validate swapped.json -q").output + rocking("run swapped.json -q -o b").errors, IsEmpty());
}

TEST_F(Planning, AnExperimentMayComeFromStandardInput) {
  ASSERT_EQ(rocking("run quick.json -q -o file").exit_code, 0);
  ASSERT_EQ(shell("'" ROCKING_PROGRAM "' run - -q -o piped < quick.json").exit_code, 0);
  EXPECT_EQ(lasting_part("piped/report.json"), lasting_part("file/report.json"));
  EXPECT_EQ(rocking("verify piped -q").exit_code, 0);
  EXPECT_EQ(shell("cat quick.json | '" ROCKING_PROGRAM "' trajectory - --periods 3").output,
            rocking("trajectory quick.json --periods 3").output);
  EXPECT_EQ(shell("'" ROCKING_PROGRAM "' validate - < quick.json").exit_code, 0);
  EXPECT_EQ(shell("'" ROCKING_PROGRAM "' bifurcation - -q -o piped_b < quick.json").exit_code, 0);
}

TEST_F(Planning, FilesNamedOnStandardInputAreSeenFromTheCurrentFolder) {
  write("record.json", recorded_experiment().dump());
  write("pulse.txt", recorded_pulse());
  ASSERT_EQ(shell("mkdir there; mv record.json there").exit_code, 0);
  ASSERT_EQ(shell("'" ROCKING_PROGRAM "' run - -q -o out < there/record.json").exit_code, 0);
  const auto elsewhere = shell("cd there && '" ROCKING_PROGRAM "' verify ../out");
  EXPECT_EQ(elsewhere.exit_code, 0) << elsewhere.errors << "the run remembers the folder";
  EXPECT_EQ(shell("cd there && '" ROCKING_PROGRAM "' run - -q -o out < record.json").exit_code, 66);
}

TEST_F(Planning, ProblemsOnStandardInputHaveTheirLine) {
  const auto refused = shell("printf '{\\n\"format\": 7}' | '" ROCKING_PROGRAM "' run - -o out");
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_THAT(refused.errors, HasSubstr("standard input, line 2: /format"));
  EXPECT_EQ(shell("'" ROCKING_PROGRAM "' run - -o out < /dev/null").exit_code, 65);
  EXPECT_FALSE(exists("out"));
}

TEST_F(Planning, ThePageCanBeOmittedAndDrawnLater) {
  const auto without = rocking("run quick.json -o out --no-page");
  ASSERT_EQ(without.exit_code, 0) << without.errors;
  EXPECT_FALSE(exists("out/report.html"));
  EXPECT_THAT(without.output, Not(HasSubstr("report.html")));
  EXPECT_THAT(without.errors, Not(HasSubstr("page")));
  ASSERT_EQ(rocking("report out --format html").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), StartsWith("<!DOCTYPE html>"));
  ASSERT_EQ(rocking("resume out -q --no-page").exit_code, 0);
  EXPECT_FALSE(exists("out/report.html")) << "it belonged to the earlier report";
}

TEST_F(Planning, ThePageIsAnnouncedWithItsTime) {
  EXPECT_THAT(rocking("run quick.json -o out").errors,
              AllOf(HasSubstr("drawing the page; --no-page"), HasSubstr("page drawn in")));
}

TEST_F(Planning, ARunTellsWhichHalfWidthsItDidNotReach) {
  auto until = quick_experiment();
  until["realisations"] = Json::parse(R"({"until": {"relative_half_width": 0.1, "mode": "overturned", "at_most": 9}})");
  write("until.json", until.dump());
  const auto outcome = rocking("run until.json -o out --no-page");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("the wanted half-width was not reached in 3 of 3 conditions"),
                                    HasSubstr("amplitude 3, overturned"), HasSubstr("raise `at_most`")));
  until["realisations"]["until"] = Json::parse(R"({"half_width": 0.49, "mode": "overturned", "at_most": 500})");
  write("until.json", until.dump());
  EXPECT_THAT(rocking("run until.json -o other --no-page").output, Not(HasSubstr("not reached")));
}

}  // namespace
