// Texts from files, and names of files, as shown by the program: on a terminal, in JSON, in tables.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ShownText : public rocking::support::ProgramTest {
 protected:
  Outcome run(const Json& experiment, const std::string& folder = "out") const {
    write("a.json", experiment.dump());
    return rocking("run a.json -o " + folder + " --no-progress");
  }
};

TEST_F(ShownText, OfTitlesAndKeysSendsNoControlCharacters) {
  Json experiment = quick_experiment();
  experiment["title"] = "\x1b]0;owned\x07\x1b[31m\xc2\x9b";
  const Outcome outcome = run(experiment);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  for (const std::string& text : {outcome.output, rocking("validate a.json").output,
                                  rocking("run a.json --dry-run").output, rocking("compare out out").output,
                                  rocking("fragility out").output, rocking("report out --format text").output}) {
    EXPECT_THAT(text, AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\x07")), Not(HasSubstr("\xc2\x9b")))) << text;
  }
  EXPECT_THAT(outcome.output, HasSubstr("\\x1b]0;owned\\x07"));
  experiment["\x1b[31m"] = 1;
  EXPECT_THAT(run(experiment, "b").errors, AllOf(HasSubstr("/\\x1b[31m"), Not(HasSubstr("\x1b"))));
}

TEST_F(ShownText, InJsonHasNoControlCharactersAndMeansTheSame) {
  Json experiment = quick_experiment();
  const std::string title = "\x7f a \xc2\x85 b \xc2\x9b[31m \xc2\xa0 \xc3\x85";
  experiment["title"] = title;
  ASSERT_EQ(run(experiment, "\"$(printf 'f\\177\\302\\205')\"").exit_code, 0);
  for (const std::string& text : {rocking("run a.json -o b --json").output, rocking("validate a.json --json").output,
                                  rocking("report \"$(printf 'f\\177\\302\\205')\" --format csv --json").output}) {
    EXPECT_THAT(text, AllOf(Not(HasSubstr("\x7f")), Not(HasSubstr("\xc2\x85")), Not(HasSubstr("\xc2\x9b")))) << text;
    ASSERT_TRUE(Json::accept(text));
  }
  EXPECT_EQ(Json::parse(rocking("validate a.json --json").output)["experiment"]["title"], title);
}

TEST_F(ShownText, OfNamesThatAreNotUtf8IsJsonAllTheSame) {
  ASSERT_EQ(run(quick_experiment(), "\"$(printf 'a\\377b')\"").exit_code, 0);
  const Outcome outcome = rocking("report \"$(printf 'a\\377b')\" --format csv --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_FALSE(Json::parse(outcome.output, nullptr, false).is_discarded());
  EXPECT_THAT(rocking("report \"$(printf 'a\\377b')\" --format csv").output, HasSubstr("a\\xffb/"));
  ASSERT_EQ(rocking("check-normal --n 1000 --json >check.json").exit_code, 0);
  const Outcome drawn =
      shell("PATH=/nowhere exec '" ROCKING_PROGRAM "' report check.json -o \"$(printf 'a\\377b')\" --json");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_TRUE(Json::accept(drawn.output)) << drawn.output;
}

TEST_F(ShownText, SaysThatAPathIsTooLongForTheStore) {
  const std::string name(200, 'n');
  const Outcome outcome = run(quick_experiment(), name + '/' + name + '/' + name);
  EXPECT_EQ(outcome.exit_code, 64);
  EXPECT_THAT(outcome.errors, HasSubstr("too long for SQLite"));
  EXPECT_FALSE(exists(name));
}

TEST_F(ShownText, OfASweptConfidenceIsThatOfEachRow) {
  Json experiment = quick_experiment();
  experiment["sweep"] = Json::parse(R"([ { "parameter": "/confidence", "values": [0.9, 0.999999999999] } ])");
  const Outcome outcome = run(experiment);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("at the confidence of each condition"), Not(HasSubstr("90 %"))));
  EXPECT_THAT(outcome.output, HasSubstr("\n0.999999999999  "));
  EXPECT_THAT(read("out/report.html"), HasSubstr("each condition&#39;s own confidence"));
}

TEST_F(ShownText, OfAConfidenceNearOneIsNotACertainty) {
  Json experiment = quick_experiment();
  experiment["confidence"] = 0.999999999999;
  const Outcome outcome = run(experiment);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("99.9999999999 % interval"), Not(HasSubstr(" 100 % interval"))));
  EXPECT_THAT(read("out/report.html"), Not(HasSubstr("100 % interval")));
}

TEST_F(ShownText, OfAProblemHasTheFileAndTheLine) {
  write("a.json",
        "{\n\"format\": \"rocking.experiment/1\",\n\"blok\": 1,\n\"block\": {\"width_m\": 1,\n\"height_m\": -4},\n"
        "\"excitation\": {\"amplitude\": 1, \"frequency_ratio\": 1}}");
  EXPECT_THAT(rocking("validate a.json").errors,
              AllOf(HasSubstr("a.json, line 3: /blok"), HasSubstr("a.json, line 5: /block/height_m")));
  EXPECT_THAT(rocking("bifurcation a.json -o b").errors, HasSubstr("a.json, line 3"));
}

}  // namespace
