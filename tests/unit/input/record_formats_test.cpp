// Formats of recorded ground motions: the header in each of its wordings, the unit, the number of samples, and faults.

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_ground_motion.hpp"
#include "support/record_text.hpp"

namespace {

using namespace rocking;
using support::esm_asc;
using support::peer_at2;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double gravity_of_test = 9.81;

GroundMotionReading reading() { return {.name = "r.at2", .time_step = {}, .gravity = gravity_of_test}; }

GroundMotion read_record(const std::string& text, const GroundMotionReading& how = reading()) {
  Problems problems;
  auto motion = read_ground_motion(text, how, problems);
  if (!motion) ADD_FAILURE() << base::InputError(problems).what();
  return motion.value_or(GroundMotion{});
}

base::Problem problem_of(const std::string& text, const GroundMotionReading& how = reading()) {
  Problems problems;
  EXPECT_FALSE(read_ground_motion(text, how, problems));
  if (problems.size() != 1) {
    ADD_FAILURE() << problems.size() << " problems";
    return {};
  }
  return problems.front();
}

const std::vector<double> three_values{0.1, -0.25, 0.03};

class PeerHeader : public ::testing::TestWithParam<const char*> {};

TEST_P(PeerHeader, GivesTheNumberOfSamplesAndTheTimeStepInEachWording) {
  const GroundMotion motion = read_record(peer_at2(GetParam(), three_values));
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.declared, 3U);
  EXPECT_EQ(motion.time_step, 0.005);
  EXPECT_EQ(motion.samples[2].time, 2 * 0.005);
  EXPECT_EQ(motion.samples[1].horizontal, -0.25);  // in g, exactly the number of the file
  EXPECT_EQ(motion.format, "peer_at2");
  EXPECT_EQ(motion.unit, "g");
  EXPECT_FALSE(motion.has_vertical);
  EXPECT_THAT(motion.warnings, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Wordings, PeerHeader,
                         ::testing::Values("NPTS=  3, DT=   .0050 SEC", "NPTS=   3, dt=  .00500", "npts = 3 dt = 5e-3",
                                           "NPTS=3,DT=.005", "   3    0.0050    NPTS, DT", "3, .005, NPTS, DT",
                                           "NPTS: 3, DT: 0.005 SEC,", "NPTS=      3, DT=   .0050 SEC\r"));

TEST(PeerFile, HasAnyNumberOfColumnsAndAnyExponent) {
  const std::string header = "a\nb\nc\nNPTS= 7, DT= .01 SEC\n";
  const GroundMotion motion = read_record(header + "  .1181069E-02 -.25E+00  3\r\n\n 4.d-2\n +5e-2,-.6D+01 7\n");
  ASSERT_EQ(motion.samples.size(), 7U);
  const std::vector<double> expected{0.1181069e-2, -0.25, 3.0, 4e-2, 5e-2, -6.0, 7.0};
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(motion.samples[i].horizontal, expected[i]) << i;
}

TEST(PeerFile, MayHaveOneSampleMoreOrFewerThanItDeclares) {
  for (const char* declared : {"2", "4"}) {
    const GroundMotion motion = read_record(peer_at2("NPTS= " + std::string(declared) + ", DT= .01 SEC", three_values));
    EXPECT_EQ(motion.samples.size(), 3U);
    EXPECT_THAT(motion.warnings, ElementsAre(::testing::AllOf(HasSubstr("contains 3 samples"),
                                                              HasSubstr("declares " + std::string(declared)))));
  }
  for (const char* declared : {"1", "5", "0", "4000"}) {
    const auto problem = problem_of(peer_at2("NPTS= " + std::string(declared) + ", DT= .01 SEC", three_values));
    EXPECT_EQ(problem.place, "r.at2");
    EXPECT_THAT(problem.reason, HasSubstr("contains 3 samples, but its header declares " + std::string(declared)));
  }
}

TEST(PeerFile, StatesItsUnit) {
  auto how = reading();
  how.unit = RecordUnit::g;
  EXPECT_EQ(read_record(peer_at2(three_values, ".01"), how).samples[0].horizontal, 0.1);
  how.unit = RecordUnit::cm_s2;
  const auto problem = problem_of(peer_at2(three_values, ".01"), how);
  EXPECT_EQ(problem.place, "r.at2, line 4");
  EXPECT_THAT(problem.reason, HasSubstr("\"units\" is \"cm/s2\""));
  EXPECT_EQ(problem.value, "\"g\"");

  const std::string other = "a\nACCELERATION TIME SERIES IN UNITS OF CM/SEC/SEC\nNPTS= 2, DT= .01\n981. 490.5\n";
  EXPECT_EQ(read_record(other).unit, "cm/s2");
  EXPECT_EQ(read_record(other).samples[0].horizontal, 981.0 / 100.0 / gravity_of_test);
  how.unit = RecordUnit::m_s2;
  const std::string silent = "a\nb\nNPTS= 2, DT= .01\n9.81 4.905\n";
  EXPECT_EQ(read_record(silent, how).samples[1].horizontal, 0.5);
  EXPECT_EQ(read_record(silent).unit, "g");
}

TEST(PeerFile, MustAgreeWithATimeStepThatIsGiven) {
  auto how = reading();
  how.time_step = 0.01;
  EXPECT_EQ(read_record(peer_at2(three_values, ".01"), how).time_step, 0.01);
  how.time_step = 0.02;
  EXPECT_THAT(problem_of(peer_at2(three_values, ".01"), how).reason, HasSubstr("\"time_step_s\" is 0.02"));
}

TEST(PeerFile, IsRecognisedByItsHeaderAlone) {
  EXPECT_EQ(recognised_format(peer_at2(three_values, ".01")), RecordFormat::peer_at2);
  EXPECT_EQ(recognised_format(esm_asc("0.01", "cm/s^2", "2", "1\n2\n")), RecordFormat::esm_asc);
  EXPECT_EQ(recognised_format("# NPTS= 3, DT= .01\n0 1\n1 2\n"), RecordFormat::columns);
  EXPECT_EQ(recognised_format("0 1\n1 2\n"), RecordFormat::columns);
  EXPECT_EQ(recognised_format(""), RecordFormat::columns);
}

/// A fault of a file and the required report.
struct BadRecord {
  std::string text;
  const char* place;
  const char* value;
  const char* reason;
};

void PrintTo(const BadRecord& bad, std::ostream* out) { *out << bad.reason; }

class RecordFault : public ::testing::TestWithParam<BadRecord> {};

TEST_P(RecordFault, IsToldWithFileLineAndValue) {
  const auto problem = problem_of(GetParam().text);
  EXPECT_EQ(problem.place, GetParam().place);
  EXPECT_EQ(problem.value, GetParam().value);
  EXPECT_THAT(problem.reason, HasSubstr(GetParam().reason));
  EXPECT_NE(problem.remedy, "");
}

INSTANTIATE_TEST_SUITE_P(
    Peer, RecordFault,
    ::testing::Values(BadRecord{"a\nNPTS= 2, DT= .01\n1 2\n3 x\n", "r.at2, line 4", "\"x\"", "not a number"},
                      BadRecord{"a\nNPTS= 2, DT= .01\n1 NaN\n", "r.at2, line 3", "\"NaN\"", "not finite"},
                      BadRecord{"a\nNPTS= 2, DT= .01\n1 1e999\n", "r.at2, line 3", "\"1e999\"", "range of doubles"},
                      BadRecord{"a\nNPTS= 2, DT= .01\n1 2e6\n", "r.at2, line 3", "\"2e6\"", "exceeds 1e6 m/s^2"},
                      BadRecord{"a\nNPTS= 2, DT= .01\n1,,2\n", "r.at2, line 3", "\"\"", "empty field"},
                      BadRecord{"a\nNPTS= 2, DT= 0\n1 2\n", "r.at2, line 2", "\"0\"", "positive number of seconds"},
                      BadRecord{"a\nNPTS= 2, DT= -.01\n1 2\n", "r.at2, line 2", "\"-.01\"",
                                "positive number of seconds"},
                      BadRecord{"a\nNPTS= 2.5, DT= .01\n1 2\n", "r.at2, line 2", "\"2.5\"", "number of samples"},
                      BadRecord{"a\nNPTS, DT\n1 2\n", "r.at2, line 2", "\"NPTS, DT\"", "does not give a number"},
                      BadRecord{"a\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01\n1 2\n", "r.at2, line 2",
                                "\"VELOCITY TIME SERIES IN UNITS OF CM/S\"", "contains a velocity"},
                      BadRecord{"a\nNPTS= 1, DT= .01\n1\n", "r.at2", "", "only one sample"},
                      BadRecord{"a\nNPTS= 0, DT= .01\n", "r.at2", "", "no sample"}));

INSTANTIATE_TEST_SUITE_P(
    Esm, RecordFault,
    ::testing::Values(BadRecord{esm_asc("0.01", "cm/s", "2", "1\n2\n"), "r.at2, line 9", "\"cm/s\"", "known unit"},
                      BadRecord{esm_asc("", "cm/s^2", "2", "1\n2\n"), "r.at2, line 5", "\"\"", "empty field"},
                      BadRecord{esm_asc("0.01", "cm/s^2", "5", "1\n2\n"), "r.at2", "",
                                "contains 2 samples, but its header declares 5"},
                      BadRecord{esm_asc("0.01", "cm/s^2", "2", "1\n2m\n"), "r.at2, line 15", "\"2m\"", "not a number"},
                      BadRecord{"SAMPLING_INTERVAL_S: 0.01\nwhat is this\n1\n2\n", "r.at2, line 2", "\"what is this\"",
                                "KEY: value"},
                      BadRecord{"SAMPLING_INTERVAL_S: 0.01\n1\n2\n", "r.at2", "", "UNITS"},
                      BadRecord{"SAMPLING_INTERVAL_S: 0.01\nUNITS: cm/s^2\nDATA_TYPE: VELOCITY\n1\n2\n",
                                "r.at2, line 3", "\"VELOCITY\"", "kind of the data"}));

TEST(EsmFile, StatesItsTimeStepAndItsUnit) {
  const GroundMotion motion = read_record(esm_asc("0.005000", "cm/s^2", "3", "98.1\n-196.2\n0.5\n"));
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.samples[0].horizontal, 98.1 / 100.0 / gravity_of_test);
  EXPECT_EQ(motion.samples[2].time, 0.01);
  EXPECT_EQ(motion.format, "esm_asc");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(read_record(esm_asc("0.01", "g", "2", "0.1\n0.2\n")).samples[1].horizontal, 0.2);
  EXPECT_EQ(read_record(esm_asc("0.01", "m/s^2", "", "9.81\n0\n")).samples[0].horizontal, 1.0);
}

TEST(ColumnsFile, HasTheUnitThatIsGiven) {
  auto how = reading();
  how.format = RecordFormat::columns;
  const auto value = [&how](RecordUnit unit) {
    how.unit = unit;
    return read_record("0 0.3\n1 0.5\n", how).samples[1].horizontal;
  };
  EXPECT_EQ(value(RecordUnit::g), 0.5);
  EXPECT_EQ(value(RecordUnit::m_s2), 0.5 / gravity_of_test);
  EXPECT_EQ(value(RecordUnit::cm_s2), 0.5 / 100.0 / gravity_of_test);
}

TEST(VerticalComponent, ComesFromAFileOfItsOwn) {
  Problems problems;
  GroundMotion motion = read_record(peer_at2(three_values, ".01"));
  ASSERT_TRUE(add_vertical(read_record(peer_at2({0.01, 0.02, 0.03, 0.04}, ".01")), motion, problems));
  EXPECT_TRUE(motion.has_vertical);
  ASSERT_EQ(motion.samples.size(), 4U);
  EXPECT_EQ(motion.samples[1].horizontal, -0.25);
  EXPECT_EQ(motion.samples[1].vertical, 0.02);
  EXPECT_EQ(motion.samples[3].horizontal, 0.0);
  EXPECT_EQ(motion.samples[3].vertical, 0.04);
  EXPECT_THAT(motion.warnings, ElementsAre(HasSubstr("contains 3 samples, its vertical component r.at2 4")));

  GroundMotion other = read_record(peer_at2(three_values, ".01"));
  EXPECT_FALSE(add_vertical(read_record(peer_at2(three_values, ".02")), other, problems));
  EXPECT_THAT(problems.back().reason, HasSubstr("other times than r.at2 from sample 2 on"));
}

}  // namespace
