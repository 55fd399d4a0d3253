// `rocking infer`: unknown numbers of an experiment from counted tests.

#include <map>
#include <string>

#include <gmock/gmock.h>

#include "cli/campaign_block.hpp"
#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::AllOf;
using ::testing::HasSubstr;

const char* const good_tests = "amplitude,\"(1,1)\",chaotic,other\n4.5,5,2,3\n6.0,5,1,4\n";

class Infer : public rocking::support::ProgramTest {
 protected:
  Infer() {
    write("block.json", experiment_.dump());
    write("tests.csv", good_tests);
  }

  /// Tests that the program refuses the input, names this in its message, and leaves an earlier answer.
  void expect_refused(const std::string& arguments, int exit_code, const ::testing::Matcher<std::string>& message) {
    std::filesystem::create_directory(folder_ / "kept");
    write("kept/infer.json", "an earlier answer");
    const auto outcome = rocking("infer " + arguments + " -q -o kept --overwrite");
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << outcome.errors;
    EXPECT_THAT(outcome.errors, message) << arguments;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(read("kept/infer.json"), "an earlier answer");
    EXPECT_NE(rocking("infer " + arguments + " -q -o new").exit_code, 0);
    EXPECT_FALSE(exists("new")) << arguments;
  }

  void expect_bad_tests(const std::string& tests, const ::testing::Matcher<std::string>& message) {
    write("bad.csv", tests);
    expect_refused("block.json --tests bad.csv", 65, message);
  }

  /// Of the experiment with another value at a place; null: without it.
  void expect_bad_experiment(const std::string& place, const Json& value, const std::string& message) {
    Json changed = experiment_;
    if (value.is_null()) {
      changed.erase(place);
    } else {
      changed[place] = value;
    }
    write("bad.json", changed.dump());
    expect_refused("bad.json --tests tests.csv", 65, AllOf(HasSubstr("bad.json"), HasSubstr(message)));
  }

  Json experiment_ = rocking::support::campaign_block();
};

TEST_F(Infer, IsWrittenAndPrinted) {
  const auto outcome = rocking("infer block.json --tests tests.csv -o out --no-progress");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("campaign"), HasSubstr("/friction/static/normal/mean"),
                                    HasSubstr("5 of 10"), HasSubstr("fit: deviance"), HasSubstr("out/infer.json")));
  const std::string text = read("out/infer.json");
  EXPECT_EQ(objections("infer", text), "");
  const Json json = Json::parse(text);
  const Json& unknown = json["unknowns"][0];
  EXPECT_LE(unknown["interval"][0].get<double>(), unknown["estimate"].get<double>());
  EXPECT_GE(unknown["interval"][1].get<double>(), unknown["estimate"].get<double>());
  EXPECT_EQ(json["tests"][1]["counts"], Json({5, 1, 4}));
  for (const Json& point : json["design"]) {
    for (const Json& counts : point["counts"]) {
      EXPECT_EQ(counts[0].get<int>() + counts[1].get<int>() + counts[2].get<int>(), 20);
    }
  }
}

TEST_F(Infer, KeepsTheFinishedPointsWhenItIsInterruptedOrKilled) {
  const std::string command = "infer block.json --tests tests.csv -q -j 1 --realisations 100 ";
  ASSERT_EQ(rocking(command + "-o whole").exit_code, 0);
  for (const auto& [signal, exit_code] : std::map<std::string, int>{{"INT", 130}, {"KILL", 137}}) {
    const auto outcome = until_disturbed("rm -rf out; " + in_background(command + "-o out", "test -s out/infer.json") +
                                         "kill -" + signal + " $child; wait $child");
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.errors;
    const std::string text = read("out/infer.json");
    EXPECT_EQ(objections("infer", text), "");
    const Json part = Json::parse(text);
    EXPECT_GT(part["design"].size(), 0U);
    if (signal == "INT") {
      EXPECT_THAT(outcome.errors, AllOf(HasSubstr("interrupted"), HasSubstr("--resume")));
      EXPECT_EQ(part["ended"], "stopped");
    }
    ASSERT_EQ(rocking(command + "--resume -o out").exit_code, 0);
    EXPECT_EQ(read("out/infer.json"), read("whole/infer.json"));
  }
}

TEST_F(Infer, HasTheSameBytesOnAnyNumberOfThreadsAndAsJson) {
  write("candidates.csv", "amplitude\n5.0\n");
  const std::string command = "infer block.json --tests tests.csv --candidates candidates.csv -q ";
  ASSERT_EQ(rocking(command + "-o one -j 1").exit_code, 0);
  const auto printed = rocking(command + "-o two -j 2 --json");
  EXPECT_EQ(printed.exit_code, 0) << printed.errors;
  EXPECT_EQ(printed.output, read("one/infer.json"));
  EXPECT_EQ(read("two/infer.json"), read("one/infer.json"));
  ASSERT_EQ(rocking(command + "-o three --seed 5").exit_code, 0);
  EXPECT_NE(Json::parse(read("three/infer.json"))["design"], Json::parse(read("one/infer.json"))["design"]);
}

TEST_F(Infer, GoesOnFromThePointsOfAnEarlierCall) {
  const std::string command = "infer block.json --tests tests.csv -q ";
  ASSERT_EQ(rocking(command + "-o whole").exit_code, 0);
  const auto first = rocking(command + "-o part --max-time 0.001s");
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_THAT(first.output, AllOf(HasSubstr("no answer yet"), HasSubstr("the time was up")));
  const Json part = Json::parse(read("part/infer.json"));
  EXPECT_EQ(objections("infer", part.dump()), "");
  EXPECT_EQ(part["ended"], "out_of_time");
  EXPECT_EQ(part["fit"], Json());
  EXPECT_LT(part["design"].size(), 12U);
  for (int repetition = 0; repetition < 2; ++repetition) {
    const auto outcome = rocking(command + "-o part --resume");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(read("part/infer.json"), read("whole/infer.json"));
  }
}

TEST_F(Infer, TellsTheFileOfARangeThatIsNotAllowed) {
  Json changed = experiment_;
  changed["unknown"][0]["from"] = -0.3;
  write("bad.json", changed.dump());
  const auto outcome = rocking("infer bad.json -q -o out --tests tests.csv");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("bad.json, line 1"), HasSubstr("/unknown"), HasSubstr("-0.3")));
}

TEST_F(Infer, DoesNotGoOnFromTheAnswerToAnotherQuestion) {
  const std::string resume = "infer block.json -q -o out --resume --tests ";
  ASSERT_EQ(rocking(resume + "tests.csv").exit_code, 0) << "there is none yet";
  const std::string before = read("out/infer.json");
  write("others.csv", "amplitude,\"(1,1)\",chaotic,other\n4.5,5,2,3\n6.0,6,1,3\n");
  write("groups.csv", "amplitude,\"(1,1)\",\"(3,3)\",other\n4.5,5,2,3\n6.0,5,1,4\n");
  write("candidates.csv", "amplitude\n5.0\n");
  for (const auto& [change, place] :
       {std::pair{"tests.csv --seed 5", "/input"}, std::pair{"tests.csv --realisations 21", "/input"},
        std::pair{"others.csv", "/tests"}, std::pair{"groups.csv", "/groups"},
        std::pair{"tests.csv --candidates candidates.csv", "/candidates"}}) {
    const auto outcome = rocking(resume + change);
    EXPECT_EQ(outcome.exit_code, 65) << change << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr(std::string(place) + ": is not that of the earlier answer"));
    EXPECT_EQ(read("out/infer.json"), before);
  }
  write("out/infer.json", "{}");
  const auto damaged = rocking(resume + "tests.csv");
  EXPECT_EQ(damaged.exit_code, 65);
  EXPECT_THAT(damaged.errors,
              AllOf(HasSubstr("out/infer.json"), HasSubstr("`--overwrite` without `--resume` begins anew")));
  EXPECT_EQ(read("out/infer.json"), "{}");
}

TEST_F(Infer, RefusesTestsWithLineValueAndRemedy) {
  const auto at = [](const std::string& place_and_value, const std::string& remedy) {
    return AllOf(HasSubstr("bad.csv, " + place_and_value), HasSubstr(remedy));
  };
  expect_bad_tests("amplitud3,\"(1,1)\",other\n4.5,1,2\n", at("line 1 = \"amplitud3\"", "did you mean \"amplitude\"?"));
  expect_bad_tests("/excitation/amplitud,\"(1,1)\",other\n4.5,1,2\n",
                   at("line 1 = \"/excitation/amplitud\"", "did you mean \"/excitation/amplitude\"?"));
  expect_bad_tests("amplitude,/excitation/amplitude,other\n4.5,4.5,2\n",
                   at("line 1 = \"/excitation/amplitude\": is set by another column too", "keep one of them"));
  expect_bad_tests("amplitude,\"(1,1)|(3,3)\",\"(3,3)\"\n4.5,1,2\n",
                   at("line 1 = \"(3,3)\": has a mode that stands in an earlier column", "keep one of them"));
  expect_bad_tests("# tests\n\namplitude,\"(1,1)\",other\n4.5,-1,2\n",
                   at("line 4 = \"-1\": is not a number of tests", "give a whole number"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n4.5,1.5,2\n",
                   at("line 2 = \"1.5\": is not a number of tests", "give a whole number"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n4.5,1,2\n-6,1,2\n",
                   at("line 3 = \"-6\": /excitation/amplitude", "give"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n4.5,1\n",
                   at("line 2 = \"4.5,1\": has 2 fields", "give every line as many"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n4.5,0,0\n", at("line 2", "omit the line"));
  expect_bad_tests("mean,\"(1,1)\",other\n0.3,1,2\n", at("line 1 = \"mean\": is an unknown", "omit the column"));
  expect_bad_tests("amplitude\n4.5\n", HasSubstr("has no column of a response mode"));
  expect_bad_tests("", HasSubstr("has no conditions"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n4,1,2\n4.0,1,2\n", at("line 3 = \"4.0\": stands in line 2", "add up"));
  expect_bad_tests("amplitude,\"(1,1)\",other\n\xFF,1,2\n", at("line 2", "convert the file to UTF-8"));
}

TEST_F(Infer, RefusesExperimentsWithPlaceValueAndRemedy) {
  const Json good = experiment_["unknown"][0];
  const auto with = [&good](const char* key, const Json& value) {
    Json unknown = good;
    unknown[key] = value;
    return Json::array({unknown});
  };
  expect_bad_experiment("unknown", nullptr, "/unknown: is missing: there is nothing to infer; add for example");
  expect_bad_experiment("unknown", Json::array(), "/unknown = []: must be a list of one to three entries");
  expect_bad_experiment("unknown", Json::array({good, good, good, good}), "must be a list of one to three entries");
  expect_bad_experiment("unknown", Json::array({good, good}), "/unknown/1/parameter");
  expect_bad_experiment("unknown", with("from", 0.45), "/unknown/0/to = 0.45: is not above \"from\"");
  expect_bad_experiment("unknown", with("from", 0.5), "/unknown/0/to = 0.45: is not above \"from\"");
  expect_bad_experiment("unknown", with("parameter", "/friction/statik"), "did you mean \"/friction/static\"?");
  expect_bad_experiment("unknown", with("parameter", "/friction"), "is no number in this file");
  expect_bad_experiment("unknown", with("form", 0.3), "did you mean \"from\"?");
  expect_bad_experiment("unknown", with("prior", Json::parse(R"({"normal": {"mean": 0.35, "sigma": 0}})")),
                        "/unknown/0/prior: has no weight between 0.3 and 0.45");
  expect_bad_experiment("realisations", Json::parse(R"({"until": {"half_width": 0.1, "at_most": 1000}})"),
                        "/realisations: depends on intervals");
}

TEST_F(Infer, RefusesASuite) {
  write("record1.txt", rocking::support::recorded_pulse());
  write("record2.txt", "0, 0\n0, 1\n0.5, 1\n0.5, 0\n");
  experiment_.erase("horizon");
  expect_bad_experiment(
      "excitation", Json::parse(R"({"kind": "recorded", "suite": "record*.txt", "columns": ["time", "horizontal"]})"),
      "/excitation/suite: gives one test several records; give the record as \"file\"");
}

}  // namespace
