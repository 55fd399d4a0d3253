// Ground motions: what is read from a file, and faults of a file.

#include "rocking/input/record_formats.hpp"
#include "rocking/scene/rules.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/record_text.hpp"

namespace {

using namespace rocking;
using ::testing::HasSubstr;

constexpr double g = 10.0;

using Columns = std::vector<RecordColumn>;
constexpr auto time_column = RecordColumn::time;
constexpr auto horizontal_column = RecordColumn::horizontal;
constexpr auto vertical_column = RecordColumn::vertical;
constexpr auto unused = RecordColumn::other;

GroundMotion read(std::string_view text, std::optional<double> time_step = {}, const Columns& columns = {}) {
  Problems problems;
  auto motion =
      read_ground_motion(text, {.name = "r.txt", .time_step = time_step, .gravity = g, .columns = columns}, problems);
  if (!motion) ADD_FAILURE() << base::InputError(problems).what();
  return motion.value_or(GroundMotion{});
}

Problems problems_of_record(std::string_view text, std::optional<double> time_step = {}, const Columns& columns = {}) {
  Problems problems;
  EXPECT_FALSE(
      read_ground_motion(text, {.name = "r.txt", .time_step = time_step, .gravity = g, .columns = columns}, problems))
      << text;
  return problems;
}

TEST(GroundMotionFile, HasAccelerationsAtEvenSpacing) {
  const auto one = read("1\n-2\n3\n", 0.5);
  ASSERT_EQ(one.samples.size(), 3U);
  EXPECT_FALSE(one.has_vertical);
  EXPECT_EQ(one.samples[2].time, 1.0);
  EXPECT_EQ(one.samples[1].horizontal, -2.0 / g);
  EXPECT_EQ(one.time_step, 0.5);
}

TEST(GroundMotionFile, HasTimesAndAccelerations) {
  const auto two = read("0.5 1\n1.0 -2\n1.5 3\n");
  EXPECT_FALSE(two.has_vertical);
  EXPECT_EQ(two.samples[1].time, 1.0);
  EXPECT_EQ(two.samples[1].horizontal, -2.0 / g);
  EXPECT_EQ(two.time_step, 0.5);
  EXPECT_THAT(two.columns, ::testing::ElementsAre("time", "horizontal"));
}

TEST(GroundMotionFile, HasTheColumnsThatAreNamed) {
  const auto three = read("0,1,4\n0.5,-2,5\n", {}, {time_column, vertical_column, horizontal_column});
  EXPECT_TRUE(three.has_vertical);
  EXPECT_EQ(three.samples[1].horizontal, 5.0 / g);
  EXPECT_EQ(three.samples[1].vertical, -2.0 / g);
  EXPECT_THAT(three.columns, ::testing::ElementsAre("time", "vertical", "horizontal"));
  const auto at_even_steps = read("1 4\n-2 5\n", 0.5, {horizontal_column, vertical_column});
  EXPECT_EQ(at_even_steps.samples[1].vertical, 5.0 / g);
  EXPECT_EQ(at_even_steps.samples[1].time, 0.5);
  const auto without_one = read("0 - 9\n1 - 8\n", {}, {time_column, unused, horizontal_column});
  EXPECT_FALSE(without_one.has_vertical);
  EXPECT_EQ(without_one.samples[1].horizontal, 8.0 / g);
  // The times of a column that is not used are replaced by even ones.
  EXPECT_EQ(read("0.00 1\n0.01 2\n0.01 3\n", 0.005, {unused, horizontal_column}).samples[2].time, 0.01);
}

TEST(GroundMotionFile, MayHaveAHeaderWhereItsColumnsAreNamed) {
  const auto motion = read("Station 12\nt [s]; a [m/s^2]\n0; 1\n1; 2\n", {}, {time_column, horizontal_column});
  ASSERT_EQ(motion.samples.size(), 2U);
  EXPECT_FALSE(motion.unit_is_assumed);
  EXPECT_THAT(motion.warnings, ::testing::IsEmpty());
  EXPECT_EQ(read("t,acc_(cm/s2)\n0,100.0\n1,200\n", {}, {time_column, horizontal_column}).samples[0].horizontal,
            1.0 / g);
}

TEST(GroundMotionFile, SaysWhereTheUnitWasAssumed) {
  const auto motion = read("0 1\n1 2\n");
  EXPECT_TRUE(motion.unit_is_assumed);
  EXPECT_EQ(motion.unit, "m/s2");
  EXPECT_THAT(motion.warnings, ::testing::ElementsAre(HasSubstr("m/s2 is assumed")));
}

TEST(GroundMotionFile, HasTheUnitThatIsGiven) {
  const auto value_in = [](RecordUnit unit) {
    Problems problems;
    const auto motion = read_ground_motion("0 0.3\n1 0.5\n", {.name = "r.txt", .gravity = g, .unit = unit}, problems);
    EXPECT_TRUE(motion.value().warnings.empty());
    return motion.value().samples[1].horizontal;
  };
  EXPECT_EQ(value_in(RecordUnit::g), 0.5);
  EXPECT_EQ(value_in(RecordUnit::m_s2), 0.5 / g);
  EXPECT_EQ(value_in(RecordUnit::cm_s2), 0.5 / 100.0 / g);
  EXPECT_EQ(value_in(RecordUnit::percent_g), 0.005);
}

TEST(GroundMotionFile, HasTimesThatRiseEvenlyToTheirPrintedDigits) {
  for (const char* times :
       {"0.00 0.01 0.02 0.03 0.04", "0 1.667E-02 3.333E-02 5E-02 6.667E-02", "3 4 5 6 7",
        "0.1 0.30000000000000004 0.5 0.7000000000000001 0.9", "99.9999 100.003 100.007 100.01 100.013"}) {
    std::string text;
    std::istringstream words(times);
    for (std::string time; words >> time;) text += time + " 1\n";
    EXPECT_EQ(read(text).samples.size(), 5U) << times;
  }
}

// 200 Hz with two digits: every second step is 0, the others are 0.01 s.
TEST(GroundMotionFile, TellsTheLargestDeviationOfRoundedTimes) {
  const auto motion = read("0.00 1\n0.01 2\n0.01 3\n0.02 1\n0.02 2\n0.03 2\n0.03 1\n");
  EXPECT_FALSE(motion.time_step);
  ASSERT_EQ(motion.warnings.size(), 2U);
  EXPECT_THAT(motion.warnings[0],
              ::testing::AllOf(HasSubstr("steps from 0 to 0.01 s"), HasSubstr("even steps of 0.005 s is 0.005 s"),
                               HasSubstr("\"time_step_s\": 0.005")));
  EXPECT_EQ(read("0.00 1\n0.01 2\n0.02 3\n0.03 1\n").warnings.size(), 1U);
}

// Every second time is rounded up or down as its bits have it, so that one step alone fits all of them.
TEST(GroundMotionFile, HasTheStepOfTimesWithTooFewDigits) {
  for (const auto& [step, format] : {std::pair{0.005, "%.2f %d\n"}, std::pair{1.0 / 300.0, "%.3f %d\n"},
                                     std::pair{0.0078125, "%.3f %d\n"}, std::pair{0.00244, "%.4g %d\n"}}) {
    std::string text;
    for (int i = 0; i < 5000; ++i) {
      char line[32];
      static_cast<void>(std::snprintf(line, sizeof line, format, step * i, i % 7));
      text += line;
    }
    const auto motion = read(text);
    ASSERT_EQ(motion.warnings.size(), 2U) << step;
    const auto begin = motion.warnings[0].find("time_step_s\": ") + 14;
    // Over all times it stays within the coarsest last digit.
    const double found = std::stod(motion.warnings[0].substr(begin));
    EXPECT_LE(std::abs(found - step) * 5000.0, 0.01) << motion.warnings[0];
  }
}

TEST(GroundMotionFile, IsTheSameHoweverItIsSpelled) {
  const auto plain = read("0 1\n0.5 -2\n");
  for (const char* spelled :
       {"0,1\n0.5,-2", "0;1\n0.5;-2\n", "\xEF\xBB\xBF# header\r\n 0 , +1.0 # first\r\n\r\n\t.5\t;\t-2e0  \r\n",
        "0 1\n\n# between\n5e-1 -2.0\n#"}) {
    const auto other = read(spelled);
    ASSERT_EQ(other.samples.size(), 2U) << spelled;
    EXPECT_EQ(other.samples[1].time, plain.samples[1].time) << spelled;
    EXPECT_EQ(other.samples[1].horizontal, plain.samples[1].horizontal) << spelled;
  }
}

TEST(GroundMotionFile, MayJumpAndMayHaveGaps) {
  const auto motion = read("0 1\n0.1 2\n0.1 -2\n7 0\n", {}, {time_column, horizontal_column});
  EXPECT_THAT(motion.warnings[0], HasSubstr("has uneven times: steps from 0 to 6.9 s"));
  EXPECT_EQ(motion.samples[1].time, motion.samples[2].time);
  EXPECT_EQ(motion.samples[3].time, 7.0);
}

TEST(VerticalComponent, ComesFromAFileOfItsOwn) {
  Problems problems;
  GroundMotion motion = read(support::peer_at2({0.1, -0.25, 0.03}, ".01"));
  ASSERT_TRUE(add_vertical(read(support::peer_at2({0.01, 0.02, 0.03, 0.04}, ".01")), motion, problems));
  EXPECT_TRUE(motion.has_vertical);
  ASSERT_EQ(motion.samples.size(), 4U);
  EXPECT_EQ(motion.samples[1].horizontal, -0.25);
  EXPECT_EQ(motion.samples[1].vertical, 0.02);
  EXPECT_EQ(motion.samples[3].horizontal, 0.0);
  EXPECT_EQ(motion.samples[3].vertical, 0.04);
  EXPECT_THAT(motion.warnings, ::testing::ElementsAre(HasSubstr("contains 3 samples, its vertical component r.txt 4")));

  GroundMotion other = read(support::peer_at2({0.1, -0.25, 0.03}, ".01"));
  EXPECT_FALSE(add_vertical(read(support::peer_at2({0.1, -0.25, 0.03}, ".02")), other, problems));
  EXPECT_THAT(problems.back().reason, HasSubstr("other times than r.txt from sample 2 on"));
}

/// A bad file of a ground motion and the required report.
struct BadGroundMotion {
  std::string text;
  std::optional<double> time_step;
  const char* place;
  const char* value;
  const char* reason;
  const char* remedy;
};

void PrintTo(const BadGroundMotion& bad, std::ostream* out) { *out << bad.text.substr(0, 60); }

class GroundMotionFault : public ::testing::TestWithParam<BadGroundMotion> {};

TEST_P(GroundMotionFault, IsToldWithFileLineValueReasonAndRemedy) {
  const BadGroundMotion& bad = GetParam();
  const auto problems = problems_of_record(bad.text, bad.time_step);
  ASSERT_EQ(problems.size(), 1U) << base::InputError(problems).what();
  EXPECT_EQ(problems[0].place, bad.place);
  EXPECT_EQ(problems[0].value, bad.value);
  EXPECT_THAT(problems[0].reason, HasSubstr(bad.reason));
  EXPECT_THAT(problems[0].remedy, HasSubstr(bad.remedy));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, GroundMotionFault,
    ::testing::Values(
        BadGroundMotion{"0 1\ntime a\n1 2", {}, "r.txt, line 2", "\"time\"", "not a number", "#"},
        BadGroundMotion{"0 1\n1 2.5m\n", {}, "r.txt, line 2", "\"2.5m\"", "not a number", "0.25"},
        BadGroundMotion{"0 1\n1 0x1p3\n", {}, "r.txt, line 2", "\"0x1p3\"", "not a number", "0.25"},
        BadGroundMotion{"0 1\n1 +-2\n", {}, "r.txt, line 2", "\"+-2\"", "not a number", "0.25"},
        BadGroundMotion{"0 1\n1 NaN\n", {}, "r.txt, line 2", "\"NaN\"", "not finite", "omit the line"},
        BadGroundMotion{"0 1\n1 -Infinity\n", {}, "r.txt, line 2", "\"-Infinity\"", "not finite", "omit the line"},
        BadGroundMotion{"0 1\n1 1e999\n", {}, "r.txt, line 2", "\"1e999\"", "range of doubles", "finite"},
        BadGroundMotion{"0 1\n1 1e-999\n", {}, "r.txt, line 2", "\"1e-999\"", "range of doubles", "or 0"},
        BadGroundMotion{"0 1\n1,,2\n", {}, "r.txt, line 2", "\"1,,2\"", "3 columns", "same columns"},
        BadGroundMotion{"0 1\n,2\n", {}, "r.txt, line 2", "\"\"", "empty field", "comma"},
        BadGroundMotion{"0 1\n1,2,\n", {}, "r.txt, line 2", "\"1,2,\"", "3 columns", "same columns"},
        BadGroundMotion{"0 1\n1\n", {}, "r.txt, line 2", "\"1\"", "1 column,", "same columns"},
        BadGroundMotion{"0 1\n1 1e7\n", {}, "r.txt, line 2", "\"1e7\"", "exceeds 1e6", "m/s^2"},
        BadGroundMotion{"0 1\n0.5 2\n0.4 3\n1 1",
                        {},
                        "r.txt, line 3",
                        "\"0.4\"",
                        "earlier than the time of the previous sample, 0.5",
                        "order"},
        BadGroundMotion{"-1 1\n0 0\n1 1\n", {}, "r.txt, line 1", "\"-1\"", "not a time", "begin at 0"},
        BadGroundMotion{"0 1\n1e8 0\n", {}, "r.txt, line 2", "\"1e8\"", "not a time", "0"},
        BadGroundMotion{
            std::string("0 1\n1 2\xff\x01\n"), {}, "r.txt, line 2", "\"2\\ufffd\\u0001\"", "not a number", "0.25"}));

INSTANTIATE_TEST_SUITE_P(Whole, GroundMotionFault,
                         ::testing::Values(BadGroundMotion{"", {}, "r.txt", "", "no sample", "one line"},
                                           BadGroundMotion{"# a\n\n  \n", 0.1, "r.txt", "", "no sample", "one line"},
                                           BadGroundMotion{"0 1", {}, "r.txt", "", "only one sample", "two"},
                                           BadGroundMotion{
                                               "1 1\n1 2\n", {}, "r.txt", "", "duration of zero", "different"}));

TEST(GroundMotionFault, OfTheColumnsPointsAtTheTimeStep) {
  EXPECT_THAT(problems_of_record("1\n2\n")[0].remedy, HasSubstr("set \"time_step_s\""));
  EXPECT_THAT(problems_of_record("0 1\n", 0.1)[0].remedy, HasSubstr("omit \"time_step_s\""));
  EXPECT_THAT(problems_of_record("0 1 2\n", 0.1)[0].remedy, HasSubstr("omit \"time_step_s\""));
}

TEST(GroundMotionFault, IsAColumnThatIsNotNamed) {
  const auto problem = [](std::string_view text, std::optional<double> time_step = {}, const Columns& columns = {}) {
    const auto problems = problems_of_record(text, time_step, columns);
    return std::string(base::InputError({problems.at(0)}).what());
  };
  EXPECT_THAT(problem("0 1 2\n1 2 3\n"), HasSubstr("line 1 = \"0 1 2\": has 3 columns; what they are is not guessed"));
  EXPECT_THAT(problem("0.1 0.2\n-0.3 0.1\n", 0.01), HasSubstr("2 columns beside \"time_step_s\""));
  EXPECT_THAT(problem("0.01 0.2\n0.02 0.1\n", 0.01), HasSubstr("2 columns beside \"time_step_s\""));
  EXPECT_THAT(problem("0 0.2\n0.4 0.1\n0.5 0.3\n"), HasSubstr("does not rise in even steps"));
  EXPECT_THAT(problem("1 0.2\n1 0.1\n1 0.3\n"), HasSubstr("r.txt: "));
  EXPECT_THAT(problem("t,a\n0,0.2\n1,0.1\n"), HasSubstr("line 1 = \"t,a\": is a header"));
  EXPECT_THAT(problem("0 1\n1 2\n", {}, {time_column, horizontal_column, vertical_column}),
              HasSubstr("has 2 columns, but \"columns\" names 3"));
  EXPECT_THAT(problem("t;vertical\n0;1\n1;2\n", {}, {time_column, horizontal_column}),
              HasSubstr("has the head \"vertical\" above the column that is taken for \"horizontal\""));
}

TEST(GroundMotionFault, IsADecimalComma) {
  for (const auto& [text, line] :
       {std::pair{"123,45\n-71,2\n", "line 1 = \"123,45\""}, std::pair{"# g\n0,123\n", "line 2 = \"0,123\""},
        std::pair{"0,00;0,12\n0,01;0,34\n", "line 1 = \"0,00;0,12\""},
        std::pair{"0.0 0.5\n0,5 1.5\n", "line 2 = \"0,5 1.5\""},
        std::pair{"0,00,0,12\n0,01,-0,34\n", "line 1 = \"0,00,0,12\""}, std::pair{"0\t1,5E-3\n", "line 1 = "}}) {
    for (const std::optional<double> step : {std::optional<double>(), std::optional(0.01)}) {
      const auto problems = problems_of_record(text, step);
      ASSERT_EQ(problems.size(), 1U) << text;
      EXPECT_THAT(base::InputError(problems).what(), ::testing::AllOf(HasSubstr(line), HasSubstr("decimal comma")));
    }
  }
  EXPECT_EQ(read("0,1\n1,2\n2,-3\n").samples.size(), 3U) << "the sign shows that the comma separates";
  EXPECT_EQ(read("0, 1\n1, 2\n").samples.size(), 2U);
  EXPECT_EQ(read("0,1\n0.5,2\n").samples.size(), 2U);
}

TEST(GroundMotionFault, IsToldForEveryLineButNotForThousands) {
  EXPECT_EQ(problems_of_record("a b\n0 1\nc d\n0 x\n").size(), 3U);
  std::string bad;
  for (int i = 0; i < 10'000; ++i) bad += "0 x\n";
  EXPECT_EQ(problems_of_record(bad).size(), 5U);
}

TEST(GroundMotionFault, QuotesNothingOfAFileThatHoldsNoNumbers) {
  for (const char* secret : {"root:x:0:0:root:/root:/bin/sh\nsecret:y\n", "-----BEGIN KEY-----\nsecret\n", "secret\n",
                             "\x7f"
                             "ELF\x01 secret\n",
                             "secret words stand here\n"}) {
    const auto problems = problems_of_record(secret);
    ASSERT_EQ(problems.size(), 1U) << secret;
    EXPECT_EQ(problems[0].place, "r.txt");
    EXPECT_EQ(problems[0].value, "");
    EXPECT_THAT(problems[0].reason, HasSubstr("not a text file of numbers"));
  }
}

TEST(GroundMotionFault, IsAGroundMotionOfMoreThanAMillionSamples) {
  std::string text;
  for (std::size_t i = 0; i < rules::most_samples; ++i) text += "0\n";
  EXPECT_EQ(read(text, 0.001).samples.size(), rules::most_samples);
  EXPECT_THAT(problems_of_record(text + "0\n", 0.001)[0].reason, HasSubstr("more than 1000000"));
}

}  // namespace
