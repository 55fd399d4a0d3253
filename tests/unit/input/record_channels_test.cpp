// Files that hold several components of a record: GeoNet, COSMOS, CSMIP, and AFAD's older layout. All are invented.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/input/repeated_records.hpp"
#include "support/read_record.hpp"
#include "support/record_text.hpp"

namespace record_channels {
namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double gravity_of_test = 9.81;

GroundMotionReading reading(const std::string& component = "") {
  return {.name = "r.txt", .gravity = gravity_of_test, .component = component};
}

GroundMotion read_record(const std::string& text, const GroundMotionReading& how) {
  return support::record_of(text, how);
}

base::Problem problem_of(const std::string& text, const GroundMotionReading& how = reading()) {
  return support::problem_of_record(text, how);
}

std::string field(const std::string& value, std::size_t width) {
  return std::string(width - std::min(width, value.size()), ' ') + value;
}

/// Fields of a width, `per_line` in each line.
std::string fields(const std::vector<std::string>& values, std::size_t width, std::size_t per_line) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += field(values[i], width);
    if ((i + 1) % per_line == 0 || i + 1 == values.size()) text += '\n';
  }
  return text;
}

std::vector<std::string> same(const std::string& value, std::size_t count) { return std::vector(count, value); }

// --- GeoNet

std::string geonet(const std::string& component, const std::string& peak, const std::vector<std::string>& values,
                   bool is_corrected = false) {
  const std::string count = std::to_string(values.size());
  std::string text =
      std::string(is_corrected ? "Corrected" : "Uncorrected") +
      " accelerogram 20010101_000000_NONE_20 GNS Science\nSite NONE\nNowhere\nInstrument None\n"
      "Resolution\nAccelerogram\nnowhere\n2001\nEpicentre\nNumber of points  " +
      count + "\nRaw readings in units of 1.00 mm/s/s  at intervals of 0.005 s\nData is unfiltered\nComponent " +
      component + "   Longitudinal Axis\nAcceleration:  Peak " + peak + " mm/s/s at 0.01 s\nVelocity\nDisplacement\n";
  std::vector<std::string> numbers = same("0", 100);
  numbers[30] = is_corrected ? "9999" : count;
  if (is_corrected) numbers[33] = numbers[34] = numbers[35] = count;
  numbers[65] = "0.0050";
  numbers[70] = is_corrected ? "1.0" : peak;
  numbers[75] = is_corrected ? peak : "0.0";
  text += fields(numbers, 8, 10) + fields(values, 8, 10);
  if (is_corrected) text += fields(same("77.0", values.size()), 8, 10) + fields(same("88.0", values.size()), 8, 10);
  return text;
}

const std::vector<std::string> touching{"-11026.2", "-12345.6", "3.0", "4.0",  "5.0", "6.0",
                                        "7.0",      "8.0",      "9.0", "10.0", "11.0"};

TEST(GeonetFile, HoldsThreeComponentsOfWhichOneIsChosen) {
  for (const bool is_corrected : {false, true}) {
    const std::string text = geonet("N28W", "-12345.6", touching, is_corrected) +
                             geonet("S62W", "20.0", same("20.0", 11), is_corrected) +
                             geonet("Up", "30.0", {"30.0", "1.0"}, is_corrected);
    const GroundMotion motion = read_record(text, reading("n28w"));
    EXPECT_EQ(motion.format, "geonet");
    EXPECT_EQ(motion.unit, "mm/s2");
    EXPECT_EQ(motion.time_step, 0.005);
    EXPECT_EQ(motion.component, "N28W");
    EXPECT_THAT(motion.components, ElementsAre("N28W", "S62W", "Up"));
    ASSERT_EQ(motion.samples.size(), 11U);
    EXPECT_EQ(motion.samples[1].horizontal, -12345.6 / 1000.0 / gravity_of_test);
    EXPECT_EQ(motion.samples[10].horizontal, 11.0 / 1000.0 / gravity_of_test);
    EXPECT_THAT(motion.warnings, IsEmpty());
    ASSERT_TRUE(motion.header_peak);
    EXPECT_TRUE(motion.header_peak->is_that_of_samples);
    EXPECT_DOUBLE_EQ(motion.header_peak->m_s2, 12.3456);
    EXPECT_EQ(read_record(text, reading("S62W")).samples[10].horizontal, 20.0 / 1000.0 / gravity_of_test);
    EXPECT_EQ(why_vertical(read_record(text, reading("Up"))), "by its header (Up)");
    const auto problem = problem_of(text);
    EXPECT_EQ(problem.place, "r.txt");
    EXPECT_THAT(problem.reason, HasSubstr("holds 3 components: N28W, S62W, Up; it was read as geonet"));
    EXPECT_THAT(problem.remedy, HasSubstr("\"component\": \"N28W\""));
    EXPECT_THAT(problem_of(text, reading("N30W")).reason, HasSubstr("holds no components of the name \"N30W\""));
  }
}

TEST(GeonetFile, StatesItsPeakInTheHeader) {
  const GroundMotion motion = read_record(geonet("N28W", "15000.0", touching), reading());
  ASSERT_TRUE(motion.header_peak);
  EXPECT_FALSE(motion.header_peak->is_that_of_samples);
  EXPECT_THAT(motion.warnings, ElementsAre(HasSubstr("a peak of 12.35 m/s2, but its header states 15")));
  EXPECT_THAT(motion.components, IsEmpty()) << "one component is not chosen";
  EXPECT_EQ(motion.component, "N28W");
}

TEST(GeonetFile, IsRefusedWhereItsSamplesAreNotWhole) {
  std::string text = geonet("N28W", "11.0", touching);
  text.resize(text.size() - 60);
  EXPECT_THAT(problem_of(text).reason, HasSubstr("but its header declares 11"));
  text = geonet("N28W", "11.0", touching);
  text.replace(text.find(" 3.0"), 4, " x.0");
  EXPECT_EQ(problem_of(text).place, "r.txt, line 27");
}

/// `text` with its `number`-th line, counted from 1, `times` times.
std::string with_line(const std::string& text, std::size_t number, std::size_t times) {
  std::string changed;
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin) + 1;
    for (std::size_t i = 0; i < (line == number ? times : 1); ++i) changed += text.substr(begin, end - begin);
    begin = end;
  }
  return changed;
}

/// In each component of a file a line of samples is repeated, and one is lost; whichever component is asked for.
void expect_lines_are_counted(const std::string& text, const std::vector<std::size_t>& lines_of_samples,
                              const std::vector<std::string>& components) {
  for (const std::string& component : components) {
    ASSERT_GT(read_record(text, reading(component)).samples.size(), 0U);
    for (const std::size_t line : lines_of_samples) {
      SCOPED_TRACE(component + ", line " + std::to_string(line));
      EXPECT_THAT(problem_of(with_line(text, line, 2), reading(component)).reason,
                  ::testing::AnyOf(HasSubstr("a line of numbers outside"), HasSubstr("but its header declares")));
      EXPECT_THAT(problem_of(with_line(text, line, 0), reading(component)).reason,
                  ::testing::AnyOf(HasSubstr("is no line of numbers, but the header declares"),
                                   HasSubstr("but its header declares")));
    }
  }
}

TEST(GeonetFile, HasTheLinesOfSamplesThatEachHeaderCounts) {
  const std::vector<std::string> forty = same("10.0", 40);
  const std::string raw = geonet("N28W", "10.0", forty, false) + geonet("S62W", "10.0", forty, false);
  expect_lines_are_counted(raw, {27, 28, 30, 57, 60}, {"N28W", "S62W"});
  const std::string corrected = geonet("N28W", "10.0", forty, true) + geonet("S62W", "10.0", forty, true);
  expect_lines_are_counted(corrected, {27, 30, 31, 38, 70}, {"N28W", "S62W"});
}

TEST(GeonetFile, SaysTheSameInTextAndNumbersOfItsHeader) {
  const std::string text = geonet("N28W", "-12345.6", touching, false);
  const auto reason_with = [&text](const std::string& there, const std::string& instead) {
    std::string changed = text;
    return problem_of(changed.replace(changed.rfind(there), there.size(), instead)).reason;
  };
  EXPECT_THAT(reason_with("  0.0050", " 77.0000"),
              HasSubstr("stands in the text of the header, but its numbers give 77"));
  EXPECT_THAT(reason_with("intervals of 0.005", "intervals of 0.01"), HasSubstr("but its numbers give 0.0050"));
  EXPECT_THAT(reason_with("points  11", "points  12"), HasSubstr("but its numbers give 11"));
}

TEST(GeonetFile, GivesItsVerticalComponentToTheOtherRole) {
  const std::string text = geonet("N28W", "2.0", {"1.0", "2.0", "1.0"}) + geonet("S62W", "2.0", {"1.0", "2.0", "1.0"}) +
                           geonet("Up", "5.0", {"3.0", "5.0", "4.0"});
  GroundMotionFiles files([&text](const std::string&, std::size_t) { return text; });
  GroundMotionReading how = reading("S62W");
  how.vertical_name = "r.txt";
  Problems problems;
  const auto motion = files.motion(how, problems);
  ASSERT_TRUE(motion) << base::InputError(problems).what();
  EXPECT_EQ(motion->samples[1].horizontal, 2.0 / 1000.0 / gravity_of_test);
  EXPECT_EQ(motion->samples[1].vertical, 5.0 / 1000.0 / gravity_of_test);
  EXPECT_THAT(motion->warnings, IsEmpty());
  how.component.clear();
  EXPECT_FALSE(files.motion(how, problems)) << "which horizontal one is not guessed";
}

// --- COSMOS

struct CosmosBlock {
  std::string direction = "340";
  std::string unit = "cm/sec2(04)";
  std::string kind = "acceleration";
  std::string step_ms = "10.000000";
  std::string channel = "";
};

std::string cosmos(const CosmosBlock& block, const std::vector<std::string>& values) {
  std::string text = "Corrected " + block.kind + "    (Format v01.20 with 13 text lines) Src: none\n";
  for (int i = 0; i < 12; ++i) text += "text\n";
  std::vector<std::string> whole = same("-999", 100);
  whole[53] = block.direction;
  std::vector<std::string> real = same("-999.000000", 100);
  real[33] = "0.020000";
  real[61] = block.step_ms;
  real[63] = "-196.200000";
  text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" + fields(whole, 8, 10);
  text += " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" + fields(real, 13, 6);
  text += "  2 Comment line(s) follow, each starting with a \"|\":\n| pts\n|<SCNL>NONE." + block.channel + ".XX.--\n";
  text += field(std::to_string(values.size()), 7) + ' ' + block.kind + " pts, approx 1 secs, units=" + block.unit +
          ",Format=(8F10.5)\n";
  return text + fields(values, 10, 8) + "End-of-data for Chan 1\n";
}

const std::vector<std::string> nine{"-196.20000", "-100.00000", "3.0", "4.0", "5.0", "6.0", "7.0", "8.0", "9.0"};

TEST(CosmosFile, HasItsStepAsRealNumber62) {
  const GroundMotion motion = read_record(cosmos({}, nine), reading());
  EXPECT_EQ(motion.format, "cosmos");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(motion.time_step, 0.01);
  EXPECT_EQ(motion.component, "340");
  ASSERT_EQ(motion.samples.size(), 9U);
  EXPECT_EQ(motion.samples[1].horizontal, -100.0 / 100.0 / gravity_of_test);
  EXPECT_TRUE(motion.header_peak && motion.header_peak->is_that_of_samples);
  EXPECT_EQ(read_record(cosmos({.step_ms = "-999.000000"}, nine), reading()).time_step, 0.02);
  EXPECT_EQ(read_record(cosmos({.unit = "g(02)"}, {"1.0", "2.0"}), reading()).samples[1].horizontal, 2.0);
}

TEST(CosmosFile, NamesItsComponentsByNumbers) {
  for (const auto& [direction, name] : {std::pair{"400", "Up"}, {"401", "Down"}, {"402", "Vertical"}}) {
    const GroundMotion motion = read_record(cosmos({.direction = direction}, nine), reading());
    EXPECT_EQ(motion.component, name);
    EXPECT_TRUE(why_vertical(motion));
  }
  EXPECT_EQ(read_record(cosmos({.direction = "0", .channel = "BNZ"}, nine), reading()).component, "BNZ");
  const std::string two = cosmos({}, nine) + cosmos({.direction = "400"}, {"1.0", "2.0"});
  EXPECT_EQ(read_record(two, reading("340 Deg")).samples.size(), 9U);
  EXPECT_THAT(problem_of(two).reason, HasSubstr("holds 2 components: 340, Up"));
  const std::string equal = cosmos({}, nine) + cosmos({}, {"1.0", "2.0"});
  EXPECT_THAT(problem_of(equal).reason, HasSubstr("channel 1 (340), channel 2 (340)"));
  EXPECT_THAT(problem_of(equal, reading("340")).reason, HasSubstr("holds 2 components of the name"));
  EXPECT_EQ(read_record(equal, reading("channel 2")).samples.size(), 2U);
}

TEST(CosmosFile, LeavesOutVelocitiesAndRefusesCounts) {
  const CosmosBlock velocity{.unit = "cm/sec(05)", .kind = "velocity"};
  EXPECT_EQ(read_record(cosmos(velocity, {"7.0", "8.0"}) + cosmos({}, nine), reading()).samples.size(), 9U);
  EXPECT_THAT(problem_of(cosmos(velocity, nine)).reason, HasSubstr("no component of accelerations"));
  EXPECT_THAT(problem_of(cosmos({.unit = "counts(50)"}, nine)).reason, HasSubstr("raw counts (V0)"));
}

TEST(CosmosFile, HasTheLinesThatEachHeaderCounts) {
  const std::string block = cosmos({}, nine);
  const auto lines = static_cast<std::size_t>(std::ranges::count(block, '\n'));
  const std::string two = block + cosmos({.direction = "90"}, nine);
  expect_lines_are_counted(two, {lines - 2, lines - 1, 2 * lines - 1}, {"340", "90"});
  // Without any line of its header the first component is not taken for the second one.
  for (std::size_t line = 14; line <= lines - 3; ++line) {
    SCOPED_TRACE(line);
    const std::string changed = with_line(two, line, 0);
    Problems problems;
    const auto found = read_ground_motion(changed, reading("340"), problems);
    const bool is_comment = line > 42 && line < lines - 3;
    EXPECT_EQ(found.has_value(), is_comment);
  }
}

TEST(CosmosFile, HasTheDurationOfItsHeader) {
  std::string text = cosmos({}, nine);
  EXPECT_THAT(problem_of(text.replace(text.find("approx 1 "), 9, "approx 9 ")).reason,
              HasSubstr("but its samples last 0.09"));
}

// --- CSMIP

std::string csmip(bool is_volume_one, const std::string& channel, const std::string& peak, const std::string& below) {
  std::string text;
  const int lines = is_volume_one ? 13 : 25;
  for (int i = 1; i <= lines; ++i) {
    if (i == 1) text += is_volume_one ? "Uncorrected Accelerogram Data" : "Corrected accelerogram   1  Chan  1:";
    if (i == 2 && !is_volume_one) text += "Uncorrected Accelerogram Data";
    if (i == 7) text += "Chan  1: " + channel + "    (STA CHN:  1)";
    if (i == 11) text += "No. of Points =  3  Record Length = 1 sec";
    if (i == 12) text += "Units of uncor accel are sec and g/10.     MAX  =  " + peak + " g, at 1 sec";
    if (i == 16) text += "  3 points of instrument- and baseline-corrected accel, veloc and displ data";
    if (i == 18) text += "Peak acceleration =    " + peak + "    cm/sec/sec  at   0.010   sec.";
    text += "\r\n";
  }
  for (int i = 0; i < (is_volume_one ? 14 : 20); ++i) text += "    1    2-999.00000\r\n";
  return text + below + "/&  ----------  End of data for channel  1  ----------\r\n";
}

std::string volume_two(const std::string& channel) {
  const std::string veloc = "  3 points of veloc data equally spaced at  .010 sec, in cm/sec.  (8f10.7)\r\n 7 7 7\r\n";
  return csmip(false, channel, "-196.200",
               "  3 points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)    \r\n"
               "-100.00000-196.20000   5.00000\r\n" +
                   veloc + "  3 points of displ data equally spaced at  .010 sec, in cm. (8f10.7)\r\n 8 8 8\r\n");
}

TEST(CsmipFile, OfVolumeTwoGoesOnWithVelocitiesAndDisplacements) {
  const std::string text = volume_two("360 Deg") + volume_two("Up") + volume_two("90 Deg");
  const GroundMotion motion = read_record(text, reading("360"));
  EXPECT_EQ(motion.format, "csmip");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(motion.time_step, 0.01);
  EXPECT_THAT(motion.components, ElementsAre("360", "Up", "90"));
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.samples[1].horizontal, -196.2 / 100.0 / gravity_of_test);
  EXPECT_TRUE(motion.header_peak && motion.header_peak->is_that_of_samples);
  EXPECT_THAT(motion.warnings, IsEmpty());
  EXPECT_EQ(read_record(text, reading("0")).component, "360");
  EXPECT_THAT(problem_of(text).reason, HasSubstr("holds 3 components: 360, Up, 90"));
}

TEST(CsmipFile, OfVolumeOneHasARateOrPairs) {
  const GroundMotion even = read_record(csmip(true, "H1", ".250",
                                              "  3 Accelerogram points at 200 pts/sec in units of g .      Format: "
                                              "(8f9.6)\r\n  .100000 -.250000  0.03\r\n"),
                                        reading());
  EXPECT_EQ(even.time_step, 0.005);
  EXPECT_EQ(even.unit, "g");
  EXPECT_EQ(even.samples[1].horizontal, -0.25);
  EXPECT_EQ(even.component, "H1");
  const GroundMotion old =
      read_record(csmip(true, "90 DEG", ".250",
                        "  3 POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)\r\n .1 -.25 .03\r\n"),
                  reading());
  EXPECT_EQ(old.time_step, 0.005);
  EXPECT_EQ(old.samples[1].horizontal, -0.25);
  const GroundMotion pairs =
      read_record(csmip(true, "L", ".250", "  0.000  1.000100.010 -2.500100.020  0.300\r\n"), reading());
  ASSERT_EQ(pairs.samples.size(), 3U);
  EXPECT_EQ(pairs.samples[1].time, 100.01);
  EXPECT_EQ(pairs.samples[1].horizontal, 0.1 * -2.5);
  EXPECT_TRUE(pairs.header_peak && pairs.header_peak->is_that_of_samples);
  EXPECT_FALSE(pairs.time_step);
  EXPECT_THAT(pairs.warnings, ElementsAre(HasSubstr("uneven times")));
  const GroundMotion even_pairs =
      read_record(csmip(true, "L", ".250", "  0.000  1.000  0.010 -2.500  0.020  0.300\r\n"), reading());
  EXPECT_EQ(even_pairs.time_step, 0.01);
  EXPECT_THAT(even_pairs.warnings, IsEmpty());
}

TEST(CsmipFile, HasTheLinesThatEachHeaderCounts) {
  // Three lines of text, header and numbers, then those of velocities and displacements, and the end.
  const std::string two = volume_two("360 Deg") + volume_two("90 Deg");
  expect_lines_are_counted(two, {47, 49, 51, 99}, {"360", "90"});
  std::string text = volume_two("360 Deg");
  EXPECT_THAT(problem_of(text.replace(text.find("  3 points of instr"), 3, "  4")).reason,
              HasSubstr("stands in the text of the header, but its numbers give 3"));
  text =
      csmip(true, "L", ".250", "  3 POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)\r\n .1 -.25 .03\r\n");
  EXPECT_THAT(problem_of(text.replace(text.find("No. of Points =  3"), 18, "No. of Points =  4")).reason,
              HasSubstr("but its numbers give 3"));
}

TEST(CsmipFile, IsRefusedWhereItIsNotWhole) {
  EXPECT_THAT(problem_of(csmip(true, "L", ".1", "  0.000  1.000  0.010\r\n")).reason,
              HasSubstr("has 3 numbers, but 2"));
  EXPECT_THAT(problem_of(csmip(true, "L", ".1", "  0.020  1.000  0.010  1.000  0.030  1.000\r\n")).reason,
              HasSubstr("is earlier than the time of the previous sample"));
  EXPECT_THAT(problem_of(csmip(false, "L", ".1", " 7 spectra\r\n")).reason, HasSubstr("does not say how many"));
}

// --- One channel in two states of processing

/// Accelerations [cm/s2] as a reader of a spreadsheet would see them.
std::vector<std::string> written(const std::vector<double>& values) {
  std::vector<std::string> text;
  for (const double value : values) text.push_back(std::to_string(value).substr(0, 8));
  return text;
}

std::vector<RepeatedRecord> repeated(const std::string& former, const std::string& later) {
  std::vector<std::shared_ptr<const GroundMotion>> motions;
  for (const std::string& text : {former, later}) {
    auto motion = read_record(text, reading());
    motion.name = "r" + std::to_string(motions.size());
    motions.push_back(std::make_shared<const GroundMotion>(std::move(motion)));
  }
  return repeated_records(motions);
}

/// A processed record, and what the recorder wrote: with an offset, a drift, and noise of its own.
struct TwoVolumes {
  std::vector<double> two = support::noise(5, 3000, 90.0), one = two;
  explicit TwoVolumes(double noise) {
    const std::vector<double> own = support::noise(8, two.size(), noise);
    for (std::size_t i = 0; i < one.size(); ++i) one[i] += 1.5 + 4.0 * std::sin(2e-3 * static_cast<double>(i)) + own[i];
  }
};

TEST(VolumesOfOneChannel, AreToldByTheirCorrelationWhereTheHeaderIsNotRead) {
  const TwoVolumes volumes(15.0);
  const auto as_cosmos = [](const std::vector<double>& values) {
    std::string text = cosmos({}, written(values));
    return text.replace(text.find("approx 1 "), 9, "approx 30 ");
  };
  EXPECT_THAT(repeated(as_cosmos(volumes.one), as_cosmos(volumes.two)), SizeIs(1));
  const auto points = [](const std::vector<double>& values) {
    return std::to_string(values.size()) +
           " Accelerogram points at 100 pts/sec in units of cm/sec2.  Format: (8f9.4)\r\n" +
           fields(written(values), 9, 8);
  };
  const auto as_csmip = [&points](const std::vector<double>& values) {
    std::string text = csmip(true, "H1", "0", points(values));
    return text.replace(text.find("Points =  3"), 11, "Points =  " + std::to_string(values.size()));
  };
  EXPECT_THAT(repeated(as_csmip(volumes.one), as_csmip(volumes.two)), SizeIs(1));
  EXPECT_THAT(repeated(as_csmip(volumes.one), as_csmip(support::noise(6, 3000, 90.0))), IsEmpty());
}

TEST(VolumesOfOneChannel, AreToldByTheTimeAndTheStationInTheHeaderOfGeonet) {
  const TwoVolumes volumes(80.0);
  const std::string one = geonet("N28W", "0", written(volumes.one)),
                    two = geonet("N28W", "0", written(volumes.two), true);
  const auto found = repeated(one, two);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].why, HasSubstr("the same earthquake, station and component"));
  EXPECT_THAT(repeated(one, geonet("S62W", "0", written(volumes.two), true)), IsEmpty()) << "of another component";
  std::string elsewhere = two;
  EXPECT_THAT(repeated(one, elsewhere.replace(elsewhere.find("NONE"), 4, "HERE")), IsEmpty()) << "of another station";
}

// --- AFAD

std::string afad(const std::string& rows) {
  return "STRONG GROUND MOTION RECORDS OF TURKIYE\r\nPLACE                   : K\xDCTAHYA\r\nNUMBER OF DATA          : "
         "3\r\n"
         "SAMPLING INTERVAL (sec) : 0.01\r\nRAW PGA VALUES (gal)    : (N-S) 196.200000 (E-W) 5.000000 (U-D) "
         "7.000000\r\n"
         "Copyright NOBODY\r\n       N-S          E-W          U-D\r\n" +
         rows;
}

TEST(AfadFile, OfTheOlderLayoutHasThreeColumns) {
  const std::string text = afad("   98.100000     1.000000   4.000000\r\n -196.200000  2.0  -7.0\r\n 1 5 6\r\n");
  const GroundMotion motion = read_record(text, reading("N-S"));
  EXPECT_EQ(motion.format, "afad");
  EXPECT_EQ(motion.unit, "cm/s2");
  EXPECT_EQ(motion.time_step, 0.01);
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.samples[1].horizontal, -196.2 / 100.0 / gravity_of_test);
  EXPECT_TRUE(motion.header_peak && motion.header_peak->is_that_of_samples);
  EXPECT_EQ(read_record(text, reading("e-w")).samples[2].horizontal, 5.0 / 100.0 / gravity_of_test);
  EXPECT_EQ(why_vertical(read_record(text, reading("U-D"))), "by its header (U-D)");
  EXPECT_THAT(problem_of(text).reason, HasSubstr("holds 3 components: N-S, E-W, U-D"));
  EXPECT_THAT(problem_of(afad("1 2 3\r\n1 2\r\n4 5 6\r\n"), reading("N-S")),
              AllOf(::testing::Field(&base::Problem::place, "r.txt, line 9"),
                    ::testing::Field(&base::Problem::reason, HasSubstr("has 2 numbers, but 3"))));
}

TEST(AfadFile, OfTheNewerLayoutIsThatOfEsm) {
  GroundMotionReading how = reading();
  how.format = RecordFormat::afad;
  const std::string text =
      "STREAM: HGN\nSAMPLING_INTERVAL_S: 0.01\nUNITS: cm/s^2\nDATA_TYPE: Acceleration\n98.1\n-196.2\n";
  EXPECT_EQ(read_record(text, how).samples[1].horizontal, -196.2 / 100.0 / gravity_of_test);
}

TEST(RecordComponent, OfAFileWithOneMustBeThatWhichIsAskedFor) {
  const std::string text = "STREAM: HGN\nSAMPLING_INTERVAL_S: 0.01\nUNITS: g\n1\n2\n";
  EXPECT_EQ(read_record(text, reading("HGN")).samples.size(), 2U);
  EXPECT_THAT(problem_of(text, reading("HGE")).reason, HasSubstr("holds the component HGN"));
  EXPECT_THAT(problem_of("0 1\n1 2\n", reading("HGE")).reason, HasSubstr("does not name its component"));
}

}  // namespace
}  // namespace record_channels
