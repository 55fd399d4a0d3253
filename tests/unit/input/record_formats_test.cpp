// Formats of recorded ground motions: the header in each of its wordings, the unit, the number of samples, and faults.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/record_formats.hpp"
#include "support/read_record.hpp"
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
  return support::record_of(text, how);
}

base::Problem problem_of(const std::string& text, const GroundMotionReading& how = reading()) {
  return support::problem_of_record(text, how);
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

// The counts are those of one column, or were "corrected" to that of all numbers.
TEST(PeerFile, IsRefusedWhereTimesStandBesideItsAccelerations) {
  for (const char* counts : {"4", "8"}) {
    for (const char* data : {"0.00 0.5\n0.01 -0.3\n0.02 0.1\n0.03 0.2\n", "0 .5 .005 -.3\n.01 .1 .015 .2\n"}) {
      const auto problem = problem_of("a\nb\nNPTS= " + std::string(counts) + ", DT= .01 SEC\n" + data);
      EXPECT_THAT(problem.reason, HasSubstr("has a column of times, which rise by 0.0"));
      EXPECT_THAT(problem.remedy, HasSubstr(R"("columns": ["time", "horizontal"])"));
    }
  }
  const std::string header = "a\nb\nNPTS= 8, DT= .01 SEC\n";
  EXPECT_EQ(read_record(header + "0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8\n").samples.size(), 8U) << "a ramp";
  EXPECT_EQ(read_record(header + "0 0.2\n0 0.4\n0 0.6\n0 0.8\n").samples.size(), 8U) << "zeros";
}

TEST(PeerFile, IsRefusedWithDecimalCommas) {
  EXPECT_THAT(problem_of("a\nb\nNPTS= 3, DT= .01 SEC\n0,1 -0,25 0,03\n").reason, HasSubstr("decimal comma"));
  EXPECT_EQ(problem_of("a\nb\nNPTS= 3, DT= .01 SEC\n0,1\n-0,25\n0,03\n").place, "r.at2, line 4");
}

TEST(PeerFile, NamesItsComponent) {
  const auto component = [](const std::string& title) {
    return read_record("P\n" + title + "\nACCELERATION IN UNITS OF G\nNPTS= 2, DT= .01\n1 2\n").component;
  };
  EXPECT_EQ(component("CAPE MENDOCINO 04/25/92 1806, RIO DELL OVERPASS FF, 270 (CDMG STATION 89324)"), "270");
  EXPECT_EQ(component("LAZIO-ABRUZZO EQ, 05/07/84, 17:50, ROCCAMONFINA,  NS"), "NS");
  EXPECT_EQ(component("Tabas_ Iran, 9/16/1978, Tabas, UP\r"), "UP");
  EXPECT_EQ(component("somewhere, Vertical component"), "VERTICAL");
  EXPECT_EQ(component("no comma here"), "");
  EXPECT_EQ(component("Kobe, Up hill station"), "");
}

TEST(PeerFile, StatesItsUnit) {
  auto how = reading();
  how.unit = RecordUnit::g;
  EXPECT_EQ(read_record(peer_at2(three_values, ".01"), how).samples[0].horizontal, 0.1);
  how.unit = RecordUnit::cm_s2;
  const auto problem = problem_of(peer_at2(three_values, ".01"), how);
  EXPECT_EQ(problem.place, "r.at2, line 3");
  EXPECT_THAT(problem.reason, HasSubstr("\"units\" is \"cm/s2\""));
  EXPECT_EQ(problem.value, "\"g\"");

  const std::string other = "a\nACCELERATION TIME SERIES IN UNITS OF CM/SEC/SEC\nNPTS= 2, DT= .01\n981. 490.5\n";
  EXPECT_EQ(read_record(other).unit, "cm/s2");
  EXPECT_EQ(read_record(other).samples[0].horizontal, 981.0 / 100.0 / gravity_of_test);
  how.unit = RecordUnit::m_s2;
  const std::string silent = "a\nb\nNPTS= 2, DT= .01\n9.81 4.905\n";
  EXPECT_EQ(read_record(silent, how).samples[1].horizontal, 0.5);
  EXPECT_THAT(read_record(silent, how).warnings, IsEmpty());
  EXPECT_EQ(read_record(silent).unit, "g");
  EXPECT_THAT(read_record(silent).warnings, ElementsAre(HasSubstr("g is assumed")));
}

/// What a file with the lines of text `title` above its counts states.
std::string file_with_title(const std::string& title) { return "a\n" + title + "\nNPTS= 2, DT= .01 SEC\n1 -0.5\n"; }

struct TitleUnit {
  const char* title;
  const char* unit;
  double one;  ///< an acceleration of 1 over 9.81 m/s^2
};

void PrintTo(const TitleUnit& title, std::ostream* out) { *out << title.title; }

class PeerUnit : public ::testing::TestWithParam<TitleUnit> {};

TEST_P(PeerUnit, IsReadInEachSpelling) {
  const GroundMotion motion = read_record(file_with_title(GetParam().title));
  EXPECT_EQ(motion.unit, GetParam().unit);
  ASSERT_EQ(motion.samples.size(), 2U);
  EXPECT_DOUBLE_EQ(motion.samples[0].horizontal, GetParam().one);
  EXPECT_THAT(motion.warnings, IsEmpty());
}

constexpr double foot = 0.3048;
INSTANTIATE_TEST_SUITE_P(
    Spellings, PeerUnit,
    ::testing::Values(
        TitleUnit{"ACCELERATION TIME SERIES IN UNITS OF G", "g", 1.0}, TitleUnit{"The units are (g)", "g", 1.0},
        TitleUnit{"UNITS: G. FILTER POINTS: HP=0.1 Hz", "g", 1.0},
        TitleUnit{"Unit = g's; step in units of sec", "g", 1.0}, TitleUnit{"ACCELERATION IN UNITS OF MG", "mg", 1e-3},
        TitleUnit{"UNITS OF %G", "%g", 0.01}, TitleUnit{"UNITS OF 0.01 G", "%g", 0.01},
        TitleUnit{"UNITS ARE % G, CORRECTED", "%g", 0.01}, TitleUnit{"UNITS OF GAL", "cm/s2", 0.01 / 9.81},
        TitleUnit{"UNITS OF GALS.", "cm/s2", 0.01 / 9.81}, TitleUnit{"UNITS OF CM/S2", "cm/s2", 0.01 / 9.81},
        TitleUnit{"UNITS OF CM / SEC / SEC", "cm/s2", 0.01 / 9.81}, TitleUnit{"UNITS: [cm/s^2]", "cm/s2", 0.01 / 9.81},
        TitleUnit{"ACCELERATION UNITS OF CM/SEC**2", "cm/s2", 0.01 / 9.81},
        TitleUnit{"UNITS OF ACCELERATION: M/S/S", "m/s2", 1.0 / 9.81}, TitleUnit{"UNITS OF M/SEC2", "m/s2", 1.0 / 9.81},
        TitleUnit{"UNITS ARE IN m s-2", "m/s2", 1.0 / 9.81}, TitleUnit{"UNITS OF MM/S/S", "mm/s2", 1e-3 / 9.81},
        TitleUnit{"UNITS OF MM/SEC^2", "mm/s2", 1e-3 / 9.81}, TitleUnit{"UNITS OF FT/SEC/SEC", "ft/s2", foot / 9.81},
        TitleUnit{"UNITS OF FT/S2", "ft/s2", foot / 9.81},
        TitleUnit{"UNITS OF IN/SEC/SEC", "in/s2", foot / 12.0 / 9.81},
        TitleUnit{"UNITS IN IN / SEC / SEC", "in/s2", foot / 12.0 / 9.81},
        TitleUnit{"ACCELERATION IN GALS", "cm/s2", 0.01 / 9.81},
        TitleUnit{"Acceleration (cm/s/s)", "cm/s2", 0.01 / 9.81},
        TitleUnit{"UNITS OF G\nPEAK ACCELERATION 300 CM/S/S", "g", 1.0}));

struct BadTitle {
  const char* title;
  const char* value;
  const char* reason;
};

void PrintTo(const BadTitle& title, std::ostream* out) { *out << title.title; }

class PeerTitle : public ::testing::TestWithParam<BadTitle> {};

TEST_P(PeerTitle, IsRefusedWithItsLineWhateverUnitIsAskedFor) {
  for (const auto unit :
       {std::optional<RecordUnit>(), std::optional(RecordUnit::g), std::optional(RecordUnit::cm_s2)}) {
    auto how = reading();
    how.unit = unit;
    Problems problems;
    ASSERT_FALSE(read_ground_motion(file_with_title(GetParam().title), how, problems));
    const base::Problem& problem = problems.back();
    EXPECT_EQ(problem.place, "r.at2, line 2");
    EXPECT_EQ(problem.value, GetParam().value);
    EXPECT_THAT(problem.reason, HasSubstr(GetParam().reason));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Unknown, PeerTitle,
    ::testing::Values(BadTitle{"UNITS OF PARSEC/S/S", "\"PARSEC/S/S\"", "not a known unit"},
                      BadTitle{"UNITS OF 0.1 G", "\"0.1 G\"", "not a known unit"},
                      BadTitle{"UNITS OF G X 100", "\"G X 100\"", "not a known unit"},
                      BadTitle{"UNITS OF G*1000", "\"G*1000\"", "not a known unit"},
                      BadTitle{"UNITS OF G / 1000", "\"G / 1000\"", "not a known unit"},
                      BadTitle{"UNITS OF COUNTS", "\"COUNTS\"", "not a known unit"},
                      BadTitle{"UNITS OF KG", "\"KG\"", "not a known unit"},
                      BadTitle{"UNITS OF", "\"OF\"", "not a known"},
                      BadTitle{"TIME SERIES IN UNITS OF CM/SEC", "\"CM/SEC\"", "unit of a velocity"},
                      BadTitle{"UNITS OF CM/S.", "\"CM/S.\"", "unit of a velocity"},
                      BadTitle{"UNITS OF m", "\"m\"", "unit of a displacement"},
                      BadTitle{"UNITS OF CM. FILTER", "\"CM.\"", "unit of a displacement"},
                      BadTitle{"UNITS OF IN", "\"IN\"", "unit of a displacement"},
                      BadTitle{"VELOCITY (CM/SEC)", "\"VELOCITY (CM/SEC)\"", "contains a velocity"},
                      BadTitle{"DISPLACEMENT TIME HISTORY IN UNITS OF CM",
                               "\"DISPLACEMENT TIME HISTORY IN UNITS OF CM\"", "contains a displacement"}));

TEST(PeerFile, OfTwoUnitsIsRefused) {
  for (const char* title :
       {"UNITS OF G\nUNITS OF CM/S2", "UNITS OF GAL\nTHE UNITS ARE MG", "ACCELERATION IN GAL\nACCELERATION IN M/S/S"}) {
    const auto problem = problem_of(file_with_title(title));
    EXPECT_EQ(problem.place, "r.at2, line 3") << title;
    EXPECT_THAT(problem.reason, HasSubstr("contradicts a line above it")) << title;
  }
  EXPECT_EQ(read_record(file_with_title("UNITS OF GAL\nUNITS OF CM/S/S")).unit, "cm/s2");
}

TEST(PeerFile, WhoseUnitContradictsTheOneAskedForIsRefused) {
  for (const auto& [title, asked] : {std::pair{"UNITS OF GALS", RecordUnit::g},
                                     {"UNITS OF MG", RecordUnit::g},
                                     {"UNITS OF G", RecordUnit::percent_g},
                                     {"ACCELERATION IN MM/S2", RecordUnit::m_s2}}) {
    auto how = reading();
    how.unit = asked;
    EXPECT_THAT(problem_of(file_with_title(title), how).reason, HasSubstr("is the unit of the file")) << title;
  }
}

TEST(PeerFile, OfVelocitiesOrDisplacementsIsKnownByItsNameWhereItStatesNoUnit) {
  for (const auto& [name, kind] :
       {std::pair{"A/B.VT2", "velocity"}, {"b.vt2", "velocity"}, {"B.DT2", "displacement"}}) {
    auto how = reading();
    how.name = name;
    const auto problem = problem_of(file_with_title("b"), how);
    EXPECT_EQ(problem.place, name);
    EXPECT_THAT(problem.reason, HasSubstr(kind));
    EXPECT_EQ(read_record(file_with_title("UNITS OF G"), how).unit, "g");
  }
}

TEST(PeerFile, HasATimeStepInSecondsOrMilliseconds) {
  const auto counts = [](const std::string& line) { return peer_at2(line, three_values); };
  for (const char* line :
       {"NPTS= 3, DT= 10 MSEC", "NPTS= 3, DT= 10. ms", "NPTS= 3 DT= 10, (msec)", "DT= 10 MS, NPTS= 3",
        "3 10 NPTS, DT (MSEC)", "NPTS= 3, DT= 0.01 SECONDS", "NPTS= 3, DT= 0.01 s.", "NPTS= 3, DT= .01 SEC HP= 0.1 HZ",
        "DT= .01 NPTS= 3", "NPTS= 3, DT= .01 HP = 0.1"}) {
    EXPECT_EQ(read_record(counts(line)).time_step, 0.01) << line;
  }
  for (const auto& [line, value] : {std::pair{"NPTS= 3, DT= 10 HZ", "\"HZ\""},
                                    {"NPTS= 3, DT= 1 MIN", "\"MIN\""},
                                    {"NPTS= 3, DT= 10 usec", "\"usec\""},
                                    {"3 10 NPTS, DT [us]", "\"us\""},
                                    {"NPTS= 3, DT= 10 *MS", "\"*MS\""}}) {
    const auto problem = problem_of(counts(line));
    EXPECT_EQ(problem.place, "r.at2, line 4") << line;
    EXPECT_EQ(problem.value, value) << line;
    EXPECT_THAT(problem.reason, HasSubstr("not a known unit of time")) << line;
  }
}

TEST(PeerFile, GivesEachCountOnce) {
  for (const char* line : {"NPTS= 3, DT= .01, DT= .02", "NPTS= 3, NPTS= 4, DT= .01", "DT= .02\nNPTS= 3, DT= .01",
                           "NPTS= 3\nNPTS= 3, DT= .01"}) {
    EXPECT_THAT(problem_of(peer_at2(line, three_values)).reason, HasSubstr("a second time")) << line;
  }
}

TEST(PeerFile, MayEndWithTextBehindTheDeclaredSamples) {
  const std::string text = peer_at2(three_values, ".01") + "\n*** End Data ***\n0.7 0.8\n";
  const GroundMotion motion = read_record(text);
  EXPECT_EQ(motion.samples.size(), 3U);
  EXPECT_THAT(motion.warnings, ElementsAre(::testing::AllOf(HasSubstr("text"), HasSubstr("line 7"), HasSubstr("***"))));
  const GroundMotion same_line = read_record("a UNITS OF G\nNPTS= 2, DT= .01\n1D-1 2D-1 END\n");
  EXPECT_EQ(same_line.samples.size(), 2U);
  EXPECT_EQ(same_line.warnings.size(), 1U);
  const GroundMotion one_more = read_record("a UNITS OF G\nNPTS= 2, DT= .01\n1 2 3D-1\nEND\n");
  EXPECT_EQ(one_more.samples.size(), 3U);
  EXPECT_EQ(one_more.warnings.size(), 2U);
  for (const char* early : {"NPTS= 4, DT= .01", "NPTS= 5, DT= .01"}) {
    const auto problem = problem_of(peer_at2(early, three_values) + "End\n");
    EXPECT_EQ(problem.place, "r.at2, line 6") << early;
    EXPECT_EQ(problem.value, "\"End\"") << early;
  }
  EXPECT_THAT(problem_of("a UNITS OF G\nNPTS= 1, DT= .01\n1 2 3\nEnd\n").reason, HasSubstr("contains 3 samples"));
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
    ::testing::Values(BadRecord{"a\nNPTS= 4, DT= .01\n1 2\n3 x\n", "r.at2, line 4", "\"x\"", "not a number"},
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
    ::testing::Values(
        BadRecord{esm_asc("0.01", "cm/s", "2", "1\n2\n"), "r.at2, line 9", "\"cm/s\"", "known unit"},
        BadRecord{esm_asc("", "cm/s^2", "2", "1\n2\n"), "r.at2, line 5", "\"\"", "empty field"},
        BadRecord{esm_asc("0.01", "cm/s^2", "5", "1\n2\n"), "r.at2", "",
                  "contains 2 samples, but its header declares 5"},
        BadRecord{esm_asc("0.01", "cm/s^2", "2", "1\n2m\n"), "r.at2, line 15", "\"2m\"", "not a number"},
        BadRecord{"SAMPLING_INTERVAL_S: 0.01\nwhat is this\n1\n2\n", "r.at2, line 2", "\"what is this\"", "KEY: value"},
        BadRecord{"SAMPLING_INTERVAL_S: 0.01\n1\n2\n", "r.at2", "", "UNITS"},
        BadRecord{esm_asc("0.01\nSAMPLING_INTERVAL_S: 0.01", "g", "2", "1\n2\n"), "r.at2, line 6",
                  "\"SAMPLING_INTERVAL_S: 0.01\"", "a second time"},
        BadRecord{esm_asc("0.01", "g\nUNITS: cm/s^2", "2", "1\n2\n"), "r.at2, line 10", "\"UNITS: cm/s^2\"",
                  "a second time"},
        BadRecord{esm_asc("0.01", "g\nunits: cm/s^2", "2", "1\n2\n"), "r.at2, line 10", "\"units: cm/s^2\"",
                  "a second time"},
        BadRecord{esm_asc("0.01", "g", "2\nNDATA: 3", "1\n2\n"), "r.at2, line 7", "\"NDATA: 3\"", "a second time"},
        BadRecord{esm_asc("10 MSEC", "g", "2", "1\n2\n"), "r.at2, line 5", "\"10 MSEC\"", "not a number"},
        BadRecord{esm_asc("0.01", "cm", "2", "1\n2\n"), "r.at2, line 9", "\"cm\"", "known unit"},
        BadRecord{"SAMPLING_INTERVAL_S: 0.01\nUNITS: cm/s^2\nDATA_TYPE: VELOCITY\n1\n2\n", "r.at2, line 3",
                  "\"VELOCITY\"", "kind of the data"}));

TEST(EsmFile, StatesItsTimeStepAndItsUnit) {
  const GroundMotion motion = read_record(esm_asc("0.005000", "cm/s^2", "3", "98.1\n-196.2\n0.5\n"));
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.samples[0].horizontal, 98.1 / 100.0 / gravity_of_test);
  EXPECT_EQ(motion.samples[2].time, 0.01);
  EXPECT_EQ(motion.format, "esm_asc");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(read_record(esm_asc("0.01", "g", "2", "0.1\n0.2\n")).samples[1].horizontal, 0.2);
  EXPECT_EQ(read_record(esm_asc("0.01", "m/s^2", "", "9.81\n0\n")).samples[0].horizontal, 1.0);
  EXPECT_EQ(read_record(esm_asc("0.01", "mm/s^2", "", "9810\n0\n")).samples[0].horizontal, 1.0);
  EXPECT_EQ(read_record(esm_asc("0.01", "g", "2", "1\n2\nend of data\n")).warnings.size(), 1U);
}

// AFAD writes the layout in small letters.
TEST(EsmFile, MayStateItsDataInSmallLettersAndItsPeak) {
  const std::string text = "SAMPLING_INTERVAL_S: 0.01\nUNITS: cm/s^2\nDATA_TYPE: Acceleration\nPGA_CM/S^2: ";
  EXPECT_TRUE(read_record(text + "-196.2\n98.1\n-196.2\n").warnings.empty());
  EXPECT_THAT(
      problem_of("SAMPLING_INTERVAL_S: 0.01\nUNITS: cm/s^2\nDATA_TYPE: acceleration response spectrum\n1\n2\n").reason,
      HasSubstr("kind of the data"));
  const GroundMotion motion = read_record(text + "250\n98.1\n-196.2\n");
  ASSERT_EQ(motion.warnings.size(), 1U);
  EXPECT_THAT(motion.warnings.front(), HasSubstr("peak of 1.962 m/s2, but its header states 2.5"));
}

std::string knet(const std::string& scale, const std::string& peak, const std::string& direction,
                 const std::string& counts) {
  return "Origin Time       2001/01/01 00:00:00\nLat.              38.1\nLong.             142.9\nDepth. (km)       "
         "24\n"
         "Mag.              7.0\nStation Code      NONE00\nStation Lat.      38.7\nStation Long.     141.0\n"
         "Station Height(m) 40\nRecord Time       2001/01/01 00:00:15\nSampling Freq(Hz) 100Hz\n"
         "Duration Time(s)  0.08\nDir.              " +
         direction + "\nScale Factor      " + scale + "\nMax. Acc. (gal)   " + peak +
         "\nLast Correction   2001/01/01 00:00:00\nMemo.             \n" + counts;
}

// Counts 4000 -+ 1000 and a scale of 1/100 gal: the offset is 40 gal, the peak 10 gal.
TEST(KnetFile, HasCountsWhoseMeanIsRemoved) {
  const std::string counts = "    5000    3000    4000    4000    5000    3000    4000    4000\n";
  const GroundMotion motion = read_record(knet("3920(gal)/392000", "10.000", "N-S", counts));
  ASSERT_EQ(motion.samples.size(), 8U);
  EXPECT_EQ(motion.format, "knet");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(motion.time_step, 0.01);
  EXPECT_EQ(motion.component, "N-S");
  EXPECT_NEAR(motion.samples[0].horizontal, 0.1 / gravity_of_test, 1e-15);
  EXPECT_NEAR(motion.samples[1].horizontal, -0.1 / gravity_of_test, 1e-15);
  EXPECT_NEAR(motion.samples[2].horizontal, 0.0, 1e-15);
  ASSERT_EQ(motion.warnings.size(), 1U);
  EXPECT_THAT(motion.warnings.front(), HasSubstr("its mean, 0.4 m/s2"));
  EXPECT_EQ(read_record(knet("3920(gal)/392000", "12.000", "N-S", counts)).warnings.size(), 2U);
  EXPECT_EQ(read_record(knet("3920(gal)/392000", "10.000", "6", counts)).component, "U-D");
}

INSTANTIATE_TEST_SUITE_P(
    Knet, RecordFault,
    ::testing::Values(BadRecord{knet("3920(gal)/0", "1", "N-S", "1 2\n"), "r.at2, line 14", "\"3920(gal)/0\"",
                                "no scale"},
                      BadRecord{knet("3920(gal)/x", "1", "N-S", "1 2\n"), "r.at2, line 14", "\"x\"", "not a number"},
                      BadRecord{knet("1(gal)/1", "1", "N-S", "1 2\n"), "r.at2", "", "header declares 8"},
                      BadRecord{"Scale Factor      1(gal)/1\n1 2\n", "r.at2", "", "has no line Memo."}));

std::string smc(const std::string& kind, const std::string& rate, const std::string& samples,
                const std::string& horizontal = "360", const std::string& count = "9",
                const std::string& smallest = "-9.8100000E+02") {
  std::string text = kind + '\n';
  for (int i = 1; i < 11; ++i) text += "*\n";
  const auto field = [](const std::string& value, std::size_t width) {
    return std::string(width - value.size(), ' ') + value;
  };
  for (int i = 0; i < 48; ++i) {
    const std::string value = i == 12   ? horizontal == "-32768" ? "0" : "90"
                              : i == 13 ? horizontal
                              : i == 15 ? "1"
                              : i == 16 ? count
                                        : "-32768";
    text += field(value, 10) + (i % 8 == 7 ? "\n" : "");
  }
  for (int i = 0; i < 50; ++i) {
    text += field(i == 1    ? rate
                  : i == 29 ? "1.0000000E+01"
                  : i == 31 ? smallest
                            : "1.7000000E+38",
                  15) +
            (i % 5 == 4 ? "\n" : "");
  }
  return text + "| invented\n" + samples;
}

TEST(SmcFile, HasFieldsThatMayTouch) {
  const std::string samples =
      "-1.0000E+1-2.0000E+0 3.0000E+0 4.0000E+0-5.0000E+0 6.0000E+0 7.0000E+0-9.8100E+2\n 8.0000E+0\n";
  const GroundMotion motion = read_record(smc("2 CORRECTED ACCELEROGRAM", "200.0000", samples));
  ASSERT_EQ(motion.samples.size(), 9U);
  EXPECT_EQ(motion.format, "smc");
  EXPECT_EQ(motion.time_step, 0.005);
  EXPECT_EQ(motion.component, "360");
  EXPECT_EQ(motion.samples[1].horizontal, -2.0 / 100.0 / gravity_of_test);
  EXPECT_EQ(motion.samples[8].horizontal, 8.0 / 100.0 / gravity_of_test);
  EXPECT_TRUE(motion.warnings.empty());
  ASSERT_TRUE(motion.header_peak);
  EXPECT_TRUE(motion.header_peak->is_that_of_samples);
  EXPECT_DOUBLE_EQ(motion.header_peak->m_s2, 9.81);
  EXPECT_EQ(read_record(smc("2 CORRECTED ACCELEROGRAM", "200.0", samples, "-32768")).component, "UP");
  const std::string other = smc("2 CORRECTED ACCELEROGRAM", "200.0", samples, "360", "9", "-8.8100000E+02");
  EXPECT_THAT(read_record(other).warnings, ElementsAre(HasSubstr("but its header states 8.81")));
  EXPECT_THAT(problem_of(smc("3 VELOCITY", "200.0", samples)).reason, HasSubstr("is no accelerogram"));
  EXPECT_THAT(problem_of(smc("2 CORRECTED ACCELEROGRAM", "1.7000000E+38", samples)).reason,
              HasSubstr("no sampling rate"));
}

TEST(SmcFile, OfAnUncorrectedRecordMayHaveTimes) {
  const std::string pairs = " 0.0000E+0 1.0000E+0 5.0000E-3-9.8100E+2 1.0000E-2 3.0000E+0 1.5000E-2 4.0000E+0\n";
  const GroundMotion motion = read_record(smc("1 UNCORRECTED ACCELEROGRAM", "1.7000000E+38", pairs, "360", "8"));
  ASSERT_EQ(motion.samples.size(), 4U);
  EXPECT_EQ(motion.samples[1].time, 0.005);
  EXPECT_EQ(motion.samples[1].horizontal, -981.0 / 100.0 / gravity_of_test);
  EXPECT_EQ(motion.time_step, 0.005);
  const GroundMotion padded =
      read_record(smc("1 UNCORRECTED ACCELEROGRAM", "1.7000000E+38", pairs + pairs, "360", "8"));
  EXPECT_EQ(padded.samples.size(), 4U);
  EXPECT_THAT(padded.warnings, ElementsAre(HasSubstr("lines behind the samples")));
  auto how = reading();
  how.time_step = 0.005;
  EXPECT_THAT(problem_of(smc("1 UNCORRECTED ACCELEROGRAM", "1.7000000E+38", pairs), how).reason,
              HasSubstr("has a time beside each acceleration"));
}

/// A file of another kind, and what it must be called.
struct OtherFile {
  std::string bytes;
  const char* kind;
  const char* remedy;
};

void PrintTo(const OtherFile& other, std::ostream* out) { *out << other.kind; }

class OtherFileOf : public ::testing::TestWithParam<OtherFile> {};

TEST_P(OtherFileOf, IsNamedAsWhatItLooksLike) {
  const auto problem = problem_of(GetParam().bytes);
  EXPECT_EQ(problem.place, "r.at2");
  EXPECT_THAT(problem.reason, HasSubstr(GetParam().kind));
  EXPECT_THAT(problem.remedy, HasSubstr(GetParam().remedy));
}

std::string with_zeros(const std::string& text, bool first) {
  std::string wide;
  for (const char c : text)
    (wide += first ? std::string(1, '\0') : std::string()) += c + (first ? std::string() : std::string(1, '\0'));
  return wide;
}

std::string of_size(std::string bytes, std::size_t size, std::size_t place = 0, const std::string& there = "") {
  bytes.resize(std::max(size, bytes.size()), 'x');
  return bytes.replace(place, there.size(), there);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OtherFileOf,
    ::testing::Values(
        OtherFile{"\xFF\xFE" + with_zeros("0 1\n1 2\n", false), "UTF-16", "iconv"},
        OtherFile{with_zeros("0.00 1.00\n0.01 2.00\n", false), "UTF-16", "iconv"},
        OtherFile{with_zeros("0.00 1.00\n0.01 2.00\n", true), "UTF-16", "iconv"},
        OtherFile{"PK\x03\x04...[Content_Types].xml", "a spreadsheet of Excel (.xlsx)", "CSV"},
        OtherFile{"PK\x03\x04...mimetypeapplication/vnd.oasis.opendocument.spreadsheet", "a spreadsheet (.ods)", "CSV"},
        OtherFile{"PK\x03\x04...a.at2", "a zip archive", "unpack"},
        OtherFile{"\x1F\x8B\x08", "packed by gzip", "unpack"}, OtherFile{"\xD0\xCF\x11\xE0", "Excel (.xls)", "CSV"},
        OtherFile{"MATLAB 5.0 MAT-file, Platform", "MATLAB (.mat)", "as text"},
        OtherFile{"\x89HDF\r\n", "HDF5", "as text"}, OtherFile{of_size("000001D NONE ", 512), "miniSEED", "ObsPy"},
        OtherFile{of_size("", 700, 304, std::string("\x06\0\0\0", 4)), "SAC", "ObsPy"},
        OtherFile{"<!DOCTYPE html>\n", "a web page", "log in"},
        OtherFile{"Response and Fourier amplitude spectra (86 periods)\nCorrected accelerogram\n1 2\n", "CSMIP (V3)",
                  "V2"},
        OtherFile{"FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:\n1 2\n", "Southern California", "PEER"},
        OtherFile{"matched to the target\n  4 0.0100  0\n .1 -.2\n .3 .4\n", "RSPMatch or eqsig",
                  "NPTS= 4, DT= 0.0100 SEC"},
        OtherFile{"label\n4 0.01\n.1\n.2\n.3\n.4\n", "RSPMatch or eqsig", "\"units\""},
        OtherFile{"the fewest samples\n2 0.01\n.1\n.2\n", "RSPMatch or eqsig", "NPTS= 2, DT= 0.01 SEC"}));

TEST(OtherFile, OfRspMatchCanBeReadOnceItsSecondLineSaysWhatItIs) {
  const GroundMotion motion = read_record("label\nNPTS= 4, DT= 0.01 SEC\n.1\n.2\n.3\n.4\n");
  EXPECT_EQ(motion.samples.size(), 4U);
  EXPECT_EQ(motion.samples[2].time, 0.02);
}

// SLIST has samples alone, TSPAIR a time before each.
TEST(TimeseriesFile, OfObspyStatesItsRateUnitAndChannel) {
  const std::string head = "TIMESERIES IV_NRC__HNE_D, 5 samples, 200 sps, 2016-08-24T01:36:30.000000, ";
  const std::string list = head + "SLIST, FLOAT, M/S**2\n1.5\t-2.5\t3\n0\t0.5\n";
  std::string pairs = head + "TSPAIR, FLOAT, CM/S**2\n";
  for (const char* line :
       {"30.000000  150\n", "30.005000  -250\n", "30.010000  300\n", "30.015000  0\n", "30.020000  50\n"}) {
    pairs += std::string("2016-08-24T01:36:") + line;
  }
  for (const std::string& text : {list, pairs}) {
    const GroundMotion motion = read_record(text);
    EXPECT_EQ(motion.format, "timeseries");
    EXPECT_EQ(motion.time_step, 0.005);
    EXPECT_EQ(motion.component, "HNE");
    EXPECT_FALSE(motion.unit_is_assumed);
    ASSERT_EQ(motion.samples.size(), 5U);
    EXPECT_DOUBLE_EQ(motion.samples[1].horizontal, -2.5 / gravity_of_test);
    EXPECT_DOUBLE_EQ(motion.samples[4].horizontal, 0.5 / gravity_of_test);
  }
  EXPECT_THAT(problem_of(head + "SLIST, INTEGER, COUNTS\n1 2 3 4 5\n").remedy, HasSubstr("remove_response"));
  EXPECT_THAT(problem_of(head + "SLIST, FLOAT, M/S\n1 2 3 4 5\n").reason, HasSubstr("is no unit of acceleration"));
  EXPECT_THAT(problem_of(list + list).reason, HasSubstr("holds several segments"));
  EXPECT_THAT(problem_of(head + "SLIST, FLOAT, M/S**2\n1 2\n").reason, HasSubstr("declares 5"));
}

TEST(ColumnsFile, OfManyNumbersALineSaysWhatWouldDo) {
  const base::Problem problem = problem_of("1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7 8\n");
  EXPECT_THAT(problem.reason, HasSubstr("likely accelerations that run on from line to line"));
  EXPECT_THAT(problem.remedy, HasSubstr("put a line NPTS= 4000, DT= .01 SEC above them"));
}

TEST(ColumnsFile, MayHaveQuotesAroundItsNumbersAndFortransExponents) {
  const GroundMotion motion = read_record("\"0.00\",\"0.01\"\n\"0.01\",\"1.2D-02\"\n0.02,1.2d-2\n0.03,-1.2E-2\n");
  ASSERT_EQ(motion.samples.size(), 4U);
  EXPECT_DOUBLE_EQ(motion.samples[1].horizontal, 0.012 / gravity_of_test);
  EXPECT_DOUBLE_EQ(motion.samples[2].horizontal, 0.012 / gravity_of_test);
}

TEST(ColumnsFile, OfVelocitiesIsRefused) {
  auto how = reading();
  how.columns = {RecordColumn::time, RecordColumn::horizontal};
  EXPECT_THAT(problem_of("time velocity_(cm/s)\n0 1\n1 2\n", how).reason, HasSubstr("that they are a velocity"));
  EXPECT_THAT(problem_of("t displacement\n0 1\n1 2\n", how).reason, HasSubstr("that they are a displacement"));
  how.columns.push_back(RecordColumn::other);
  EXPECT_EQ(read_record("time acceleration_(m/s2) velocity\n0 1 5\n1 2 5\n", how).samples.size(), 2U);
}

TEST(Refusal, NamesTheFormatThatWasRecognised) {
  EXPECT_THAT(problem_of(peer_at2("NPTS= 9, DT= .01 SEC", three_values)).reason,
              HasSubstr("; it was read as peer_at2"));
  auto how = reading();
  how.format = RecordFormat::peer_at2;
  EXPECT_THAT(problem_of(peer_at2("NPTS= 9, DT= .01 SEC", three_values), how).reason,
              ::testing::Not(HasSubstr("it was read as")));
}

}  // namespace
