// Counted tests: what is read, and every fault with its line.

#include "rocking/input/read_tests.hpp"

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"

namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// With unknown friction and an amplitude that each line of tests gives.
Experiment tested_experiment(
    const std::string& unknown = R"({"parameter": "/friction/static", "from": 0.3, "to": 0.4})") {
  return experiment_in(R"({"format": "rocking.experiment/1", "block": {"width_m": 1.0, "height_m": 4.0},
      "excitation": {"amplitude": 4.2, "frequency_ratio": 10.0},
      "friction": {"static": 0.35, "kinetic": {"ratio": 0.8}},
      "unknown": [)" + unknown +
                       "]}");
}

CountedTests tests_in(const std::string& text) { return read_tests(text, "t.csv", tested_experiment(), "."); }

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(tests_in(text));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadTests, TakesTheNamesOfTheSweep) {
  const Experiment named = tested_experiment(R"({"parameter": "/friction/static", "from": 0.3, "to": 0.4}],
      "sweep": [{"parameter": "/excitation/amplitude", "values": [4.5, 6], "names": ["weak", "strong"]})");
  const CountedTests found = read_tests("amplitude,overturned\n6.0,3\n5,1\n", "t.csv", named, ".");
  EXPECT_EQ(found.conditions[0].parameters[0].name, "strong");
  EXPECT_EQ(found.conditions[1].parameters[0].name, "");
}

TEST(ReadTests, TakesParametersAndCounts) {
  const CountedTests found = tests_in("amplitude,\"(1,1)\",chaotic,other\n4.5,5,2,3\n6,1,0,0\n");
  ASSERT_EQ(found.conditions.size(), 2U);
  EXPECT_EQ(found.conditions[0].parameters[0].pointer, "/excitation/amplitude");
  EXPECT_EQ(json_text_of(found.conditions[0].parameters[0].value), "4.5");
  EXPECT_THAT(found.conditions[0].counts, ElementsAre(5, 2, 3));
  EXPECT_THAT(found.conditions[1].counts, ElementsAre(1, 0, 0));
  ASSERT_EQ(found.groups.size(), 3U);
  EXPECT_THAT(found.groups[0].modes, ElementsAre(section::periodic(1, 1)));
  EXPECT_THAT(found.groups[1].modes, ElementsAre(section::ResponseMode{.kind = section::ResponseKind::chaotic}));
  EXPECT_THAT(found.groups[2].modes, IsEmpty());
}

TEST(ReadTests, TakesMarksLineEndsCommentsAndAnySeparator) {
  const CountedTests usual = tests_in("amplitude,\"(1,1)\",other\n4.5,1,2\n");
  for (const char* text :
       {"\xEF\xBB\xBF"
        "amplitude,\"(1,1)\",other\r\n\r\n4.5,1,2\r\n",
        "# tests\n\namplitude;(1,1);other # all\n4.5;1;2 # x", "amplitude\t(1,1)\tother\n 4.5 \t1\t 2\n",
        "\"amplitude\" , \"(1,1)\" , \"other\"\n\"4.5\",\"1\",\"2\"\n",
        "/excitation/amplitude,\"(1,1)\",other\n+4.5,1,2"}) {
    const CountedTests found = tests_in(text);
    ASSERT_EQ(found.conditions.size(), 1U) << text;
    EXPECT_EQ(found.conditions[0].parameters[0].pointer, "/excitation/amplitude") << text;
    EXPECT_EQ(json_text_of(found.conditions[0].parameters[0].value), "4.5") << text;
    EXPECT_EQ(found.conditions[0].counts, usual.conditions[0].counts) << text;
    EXPECT_EQ(found.groups[0].modes, usual.groups[0].modes) << text;
  }
}

TEST(ReadTests, PutsAllOtherModesLast) {
  const CountedTests moved = tests_in("amplitude,other,\"(1,1)|(3,3)\",rest\n4.5,1,2,3\n");
  EXPECT_THAT(moved.conditions[0].counts, ElementsAre(2, 3, 1));
  EXPECT_THAT(moved.groups[0].modes, ElementsAre(section::periodic(1, 1), section::periodic(3, 3)));
  EXPECT_EQ(group_of(moved.groups, section::periodic(3, 3)), 0U);
  EXPECT_EQ(group_of(moved.groups, section::periodic(1, 3)), 2U);
  const CountedTests added = tests_in("amplitude,\"(1,1) | (3,3)\"\n4.5,2\n");
  ASSERT_EQ(added.groups.size(), 2U);
  EXPECT_EQ(added.groups[1].name, "other");
  EXPECT_THAT(added.conditions[0].counts, ElementsAre(2, 0));
}

TEST(ReadTests, TakesObjectsAndTestsOfOneConditionWithoutParameters) {
  const CountedTests found = tests_in("/block,rest,other\n\"{\"\"width_m\"\": 1.0, \"\"height_m\"\": 3.0}\",1,2\n");
  EXPECT_EQ(json_text_of(found.conditions[0].parameters[0].value), R"({"width_m":1.0,"height_m":3.0})");
  EXPECT_THAT(tests_in("rest,other\n1,2\n").conditions[0].parameters, IsEmpty());
}

TEST(ReadTests, RefusesColumnsWithNameAndNearestWord) {
  const std::string rest = ",\"(1,1)\",other\n4.5,1,2\n";
  EXPECT_THAT(complaint("amplitud" + rest),
              HasSubstr("line 1 = \"amplitud\": is neither a value of the experiment nor a "
                        "response mode; did you mean \"amplitude\"?"));
  EXPECT_THAT(complaint("/excitation/amplitud" + rest), HasSubstr("did you mean \"/excitation/amplitude\"?"));
  EXPECT_THAT(complaint("amplitude,chaotik,other\n4.5,1,2\n"), HasSubstr("\"chaotik\""));
  EXPECT_THAT(complaint("amplitude,chaotik,other\n4.5,1,2\n"), HasSubstr("did you mean \"chaotic\"?"));
  EXPECT_THAT(complaint("amplitude,Other\n4.5,1\n"), HasSubstr("did you mean \"other\"?"));
  EXPECT_THAT(complaint("mode," + rest), HasSubstr("write modes such as (1,1)"));
  EXPECT_THAT(
      complaint("amplitude,\"(1,1)|other\"\n4.5,1\n"),
      AllOf(HasSubstr("\"other\": is neither"), HasSubstr("or \"other\" alone"), Not(HasSubstr("has no column"))));
  EXPECT_THAT(complaint("amplitude,(1,1,other\n4.5,1,2\n"), HasSubstr("\"(1\": is neither"));
  EXPECT_THAT(complaint("amplitude,,other\n4.5,1,2\n"),
              AllOf(HasSubstr("line 1 = \"\": is neither"), Not(HasSubstr("earlier column"))));
  EXPECT_THAT(complaint("seed" + rest), HasSubstr("\"seed\": is neither"));
  EXPECT_THAT(complaint("/seed" + rest),
              HasSubstr("\"/seed\": is not a value of the experiment that a sweep may change"));
  EXPECT_THAT(complaint("static" + rest), HasSubstr("\"static\": is an unknown of the experiment"));
  EXPECT_THAT(complaint("/friction" + rest), HasSubstr("\"/friction\": is an unknown of the experiment"));
  EXPECT_THAT(complaint("amplitude,/excitation" + rest), HasSubstr("\"/excitation\": is set by another column too"));
  EXPECT_THAT(complaint("\"(1,1)\",amplitude\n1,4.5\n"), HasSubstr("\"amplitude\": stands after a column of counts"));
  EXPECT_THAT(complaint("amplitude,\"(1,1)|(1,1)\",other\n4.5,1,2\n"), HasSubstr("names a response mode twice"));
  EXPECT_THAT(complaint("amplitude,\"(1,1)|(3,3)\",\"(3,3)|(1,3)\"\n4.5,1,2\n"),
              HasSubstr("line 1 = \"(3,3)|(1,3)\": has a mode that stands in an earlier column"));
  EXPECT_THAT(complaint("amplitude,other,other\n4.5,1,2\n"), HasSubstr("stands in an earlier column"));
}

TEST(ReadTests, RefusesAColumnThatSeveralPlacesHaveOrThatASweepNeeds) {
  Json document = Json::parse(tested_experiment().canonical_text);
  document["fluctuation"] = Json::parse(R"({"amplitude": {"sigma": 0.1}})");
  const auto complaint_about = [&document](const char* text) {
    try {
      static_cast<void>(read_tests(text, "t.csv", experiment_in(document.dump()), "."));
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint_about("amplitude,other\n4.5,1\n"),
              HasSubstr("write the whole pointer, /excitation/amplitude or /fluctuation/amplitude"));
  document["sweep"] = Json::parse(R"([{"parameter": "/excitation/amplitude", "values": [3.0, 4.0]}])");
  EXPECT_EQ(complaint_about("amplitude,other\n4.5,1\n"), "") << "what is swept is meant";
  EXPECT_THAT(complaint_about("other\n1\n"),
              HasSubstr("line 1 = \"/excitation/amplitude\": is swept by the experiment and has no column"));
}

TEST(ReadTests, RefusesCountsWithLineAndValue) {
  const std::string columns = "amplitude,\"(1,1)\",other\n";
  for (const char* count : {"-1", "1.5", "1e3", "", "x", "0x2", "+1", "1 2", "1000001", "99999999999999999999"}) {
    EXPECT_THAT(
        complaint(columns + "4.5,1,2\n5.5," + count + ",2\n"),
        HasSubstr("t.csv, line 3 = \"" + std::string(count) + "\": is not a number of tests; give a whole number"));
  }
  EXPECT_EQ(complaint(columns + "4.5,1000000,0\n"), "");
  EXPECT_THAT(complaint(columns + "4.5,0,0\n"), HasSubstr("line 2 = \"4.5\": has no tests; omit the line"));
  EXPECT_THAT(complaint(columns + "4.5,1\n"), HasSubstr("line 2 = \"4.5,1\": has 2 fields, but the first line has 3"));
  EXPECT_THAT(complaint(columns + "4,5,1,2\n"),
              HasSubstr("line 2 = \"4,5,1,2\": has 4 fields, but the first line has 3"));
  EXPECT_THAT(complaint(columns + "\"4.5,1,2\n"), HasSubstr("has a quotation mark that is not closed"));
}

TEST(ReadTests, RefusesAConditionTwiceHoweverItIsWritten) {
  for (const char* again : {"4", "4.0", "+4", "40e-1"}) {
    EXPECT_THAT(
        complaint("amplitude,other\n4,1\n5,1\n" + std::string(again) + ",2\n"),
        HasSubstr("line 4 = \"" + std::string(again) + "\": stands in line 2 too; add up the counts in one line"));
  }
  EXPECT_THAT(complaint("rest,other\n1,2\n3,4\n"), HasSubstr("stands in line 2 too"));
}

TEST(ReadTests, RefusesParametersWithLineAndValue) {
  const std::string columns = "amplitude,\"(1,1)\",other\n";
  EXPECT_THAT(complaint(columns + "-4,1,2\n"),
              AllOf(HasSubstr("line 2 = \"-4\": /excitation/amplitude must be a number from 0"),
                    HasSubstr("(with /friction/static = ")));
  EXPECT_THAT(complaint(columns + "x,1,2\n"),
              HasSubstr("line 2 = \"x\": /excitation/amplitude must be a number, not text"));
  EXPECT_THAT(complaint(columns + ",1,2\n"), HasSubstr("line 2 = \"\": is an empty field"));
  EXPECT_THAT(complaint(columns + "1e999,1,2\n"), HasSubstr("line 2 = \"1e999\": exceeds the largest double"));
  EXPECT_THAT(complaint(columns + "\xFF,1,2\n"), HasSubstr("is not text in UTF-8"));
  EXPECT_THAT(complaint(columns + "{1,1,2\n"), HasSubstr("line 2 = \"{1\": not JSON"));
  EXPECT_THAT(complaint(columns + std::string(100'000, '[') + ",1,2\n"), HasSubstr("nested more deeply"));
  EXPECT_THAT(complaint(columns + std::string("4.5\0,1,2\n", 9)), HasSubstr("line 2"));
}

TEST(ReadTests, RefusesFilesWithoutTestsOrTooLong) {
  for (const char* text : {"", "\n\n", "# nothing\n", "\xEF\xBB\xBF", "amplitude,other\n"}) {
    EXPECT_THAT(complaint(text), HasSubstr("t.csv: has no conditions")) << text;
  }
  EXPECT_THAT(complaint("amplitude\n4.5\n"), HasSubstr("t.csv: has no column of a response mode"));
  EXPECT_THAT(complaint(std::string(most_tests_bytes + 1, '\n')), HasSubstr("is longer than 1 MB"));
  std::string columns;
  for (int rocks = 1; rocks <= 101; ++rocks) columns += "(" + std::to_string(rocks) + ",1);";
  EXPECT_THAT(complaint(columns + "other\n"), HasSubstr("line 1 = \"102 columns\": are too many; give at most 100"));
  std::string many = "tilt,other\n";
  for (std::size_t i = 0; i <= most_tested_conditions; ++i)
    many += std::to_string(0.0001 * static_cast<double>(i)) + ",1\n";
#if !ROCKING_CONTRACTS
  EXPECT_THAT(complaint(many), HasSubstr("t.csv: has more than 1000 conditions"));
#endif
}

TEST(ReadTests, RefusesUnknownsThatTheExperimentDoesNotAllow) {
  const auto complaint_about = [](const std::string& unknown) {
    try {
      static_cast<void>(read_tests("amplitude,other\n4.5,1\n", "t.csv", tested_experiment(unknown), "."));
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(
      complaint_about(R"({"parameter": "/friction/static", "from": -1, "to": 0.4})"),
      AllOf(HasSubstr("/unknown = /friction/static = -1.0: is not allowed: /friction/static must not be negative"),
            HasSubstr("change \"from\" or \"to\"")));
  EXPECT_THAT(complaint_about(R"({"parameter": "/realisations", "from": 1, "to": 4})"),
              HasSubstr("/realisations must be a whole number"));
}

TEST(ReadCandidates, TakesParametersAlone) {
  const Experiment experiment = tested_experiment();
  CountedTests tests = tests_in("amplitude,other\n4.5,1\n");
  read_candidates("amplitude\n4.5\n7\n", "c.csv", experiment, ".", tests);
  ASSERT_EQ(tests.candidates.size(), 2U);
  EXPECT_EQ(json_text_of(tests.candidates[1].parameters[0].value), "7");
  EXPECT_THAT(tests.candidates[1].counts, IsEmpty());
  EXPECT_THROW(read_candidates("amplitude,other\n4.5,1\n", "c.csv", experiment, ".", tests), base::InputError);
  EXPECT_THROW(read_candidates("amplitude\n4.5\n4.50\n", "c.csv", experiment, ".", tests), base::InputError);
  EXPECT_THROW(read_candidates("", "c.csv", experiment, ".", tests), base::InputError);
}

}  // namespace
