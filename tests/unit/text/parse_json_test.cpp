// Nearly valid JSON: every fault must be found and reported with its position.

#include "rocking/text/json.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace {

using rocking::Json;
using rocking::parse_json;
using rocking::base::InputError;
using rocking::base::Problem;

/// The only problem for which the text is refused.
Problem refusal_of(const std::string& text) {
  std::vector<Problem> problems;
  try {
    static_cast<void>(parse_json(text, problems));
  } catch (const InputError& error) {
    return error.problems().front();
  }
  ADD_FAILURE() << "was read: " << text;
  return {};
}

TEST(ParseJson, TellsLineAndColumnOfWhatIsNoJson) {
  EXPECT_EQ(refusal_of("{\n  \"a\": 1,\n}").place, "line 3, column 1");
  EXPECT_EQ(refusal_of("hello").place, "line 1, column 1");
  EXPECT_EQ(refusal_of("").place, "line 1, column 1");
  EXPECT_EQ(refusal_of("{\"a\" 1}").value, "1");
}

TEST(ParseJson, RefusesNumbersThatJsonDoesNotKnow) {
  for (const std::string word : {"NaN", "nan", "Infinity", "-Infinity", "inf"}) {
    const Problem problem = refusal_of("{\"a\": " + word + "}");
    EXPECT_EQ(problem.place.substr(0, 9), "/a (line ");
    EXPECT_EQ(problem.value, word);
    EXPECT_EQ(problem.reason, "not a number that JSON allows");
    EXPECT_EQ(problem.remedy, "give a finite number, or omit the key");
  }
}

TEST(ParseJson, RefusesNumbersBeyondTheRangeOfDoubles) {
  const Problem problem = refusal_of("{\n\"a\": 1e999}");
  EXPECT_EQ(problem.place, "/a (line 2, column 10)");
  EXPECT_EQ(problem.value, "1e999");
  EXPECT_EQ(problem.reason, "exceeds the largest double, 1.8e308, in absolute value");
}

TEST(ParseJson, NamesTheKeyOfANumberItRefusesAlsoWithinLists) {
  EXPECT_EQ(refusal_of(R"({"a": [{"b": 1}, {"c": [0, 1e999]}]})").place.substr(0, 9), "/a/1/c/1 ");
  EXPECT_EQ(refusal_of(R"({"a": [1, [2, 3], NaN]})").place.substr(0, 5), "/a/2 ");
  EXPECT_EQ(refusal_of("NaN").place, "line 1, column 1") << "no key";
}

TEST(ParseJson, FindsEveryKeyThatStandsTwice) {
  std::vector<Problem> problems;
  const Json document = parse_json(R"({"a": 1, "a": {"x": {"b": 1, "b": [2]}}, "l": [0, {"c": 1, "c": 2}]})", problems);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].place, "/a");
  EXPECT_EQ(problems[1].place, "/a/x/b");
  EXPECT_EQ(problems[2].place, "/l/1/c");
  EXPECT_EQ(document["a"], 1) << "the first value stays";
  EXPECT_EQ(document["l"][1]["c"], 1);
}

TEST(ParseJson, RefusesDepthThatWouldExhaustTheStack) {
  EXPECT_EQ(refusal_of(std::string(100'000, '[')).reason, "nested more deeply than any format of rocking");
}

TEST(ParseJson, ReadsDoublesToTheBit) {
  std::vector<Problem> problems;
  for (const double x : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0}) {
    EXPECT_EQ(parse_json(Json(x).dump(), problems).get<double>(), x);
  }
}

TEST(ParseJson, RefusesANulByteWithItsPlace) {
  EXPECT_EQ(refusal_of(std::string("{\n \"a\": 1}\0{}", 14)).place, "line 2, column 9");
  EXPECT_THAT(refusal_of(std::string("\0", 1)).reason, ::testing::HasSubstr("NUL"));
}

TEST(ParseJson, TakesTimeInProportionToTheNumberOfKeys) {
  std::string text = "{";
  for (int i = 0; i < 1'000'000; ++i) text += "\"" + std::to_string(i) + "\":0,";
  text.back() = '}';
  std::vector<Problem> problems;
  EXPECT_EQ(parse_json(text, problems).size(), 1'000'000U);  // comparing each key with all others would take hours
}

}  // namespace
