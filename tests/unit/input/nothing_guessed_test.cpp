// What a file of a ground motion leaves open is not guessed: missing samples, times that are no seconds, units with a
// factor, boreholes, vertical components, records that stand there twice, motions that end in motion.

#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/ground_motion_files.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/text/json.hpp"
#include "support/record_text.hpp"

namespace rocking::nothing_guessed {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

using support::noise;

constexpr double g = 10.0;

struct Read {
  std::optional<GroundMotion> motion;
  std::string complaint;
};

Read read(const std::string& text, const GroundMotionReading& how = {}) {
  GroundMotionReading with_name = how;
  if (with_name.name.empty()) with_name.name = "r.txt";
  with_name.gravity = g;
  Problems problems;
  Read found{read_ground_motion(text, with_name, problems), ""};
  if (!problems.empty()) found.complaint = base::InputError(problems).what();
  return found;
}

std::string column(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += std::to_string(value) + '\n';
  return text;
}

TEST(MissingSamples, AreRefusedWithTheFirstLineAndTheirNumberInEveryFormat) {
  for (const double mark : {-999.0, -9999.0, 99999.9, 1e20, -32768.0, 999.0, 12345.0}) {
    std::vector<double> values = noise(1);
    for (const std::size_t i : {700U, 701U, 702U, 1200U}) values[i] = mark;
    const std::string in_columns = read(column(values), {.time_step = 0.01}).complaint;
    EXPECT_THAT(in_columns,
                AllOf(HasSubstr("line 701"), HasSubstr("missing samples"), HasSubstr("stands at 4 samples")))
        << mark;
    EXPECT_THAT(read(support::peer_at2(values, ".01")).complaint,
                AllOf(HasSubstr("line 145"), HasSubstr("stands at 4 samples")))
        << mark;
    EXPECT_THAT(read(support::esm_asc("0.01", "cm/s^2", "2000", column(values))).complaint,
                AllOf(HasSubstr("line 714"), HasSubstr("stands at 4 samples")))
        << mark;
  }
}

TEST(MissingSamples, AreFoundAmongAccelerationsThatAreAsLarge) {
  std::vector<double> values = noise(1, 2000, 1500.0);  // cm/s2
  values[900] = values[901] = values[902] = -999.0;
  EXPECT_THAT(read(column(values), {.time_step = 0.01, .unit = RecordUnit::cm_s2}).complaint,
              AllOf(HasSubstr("line 901 = \"-999\""), HasSubstr("stands at 3 samples")));
}

TEST(MissingSamples, AreNotSeenInPulsesPlateausAndRecordsThatAreClipped) {
  EXPECT_EQ(read("0\n0\n5\n5\n5\n-5\n-5\n0\n", {.time_step = 0.1}).complaint, "");
  EXPECT_EQ(read("0\n99\n99\n99\n0\n", {.time_step = 0.1}).complaint, "");
  EXPECT_EQ(read("0\n0.5\n5\n5\n5\n0.5\n0\n", {.time_step = 0.1}).complaint, "");
  std::vector<double> values = noise(2, 2000, 1200.0);
  for (double& value : values) value = std::clamp(value, -999.0, 999.0);
  EXPECT_EQ(read(column(values), {.time_step = 0.01, .unit = RecordUnit::cm_s2}).complaint, "");
}

std::string timed(const std::vector<double>& values, double step, const std::string& above = "") {
  return above + support::columns_text(values, step, 1.0, 12);
}

TEST(TimesThatAreNoSeconds, AreRefusedWithTheReadingsThatMakeSense) {
  EXPECT_THAT(read(timed(noise(1), 1.0)).complaint,
              AllOf(HasSubstr("mean time step of 1 s"), HasSubstr("counts the samples"), HasSubstr("time_step_s")));
  EXPECT_THAT(read(timed(noise(1), 5.0)).complaint,
              AllOf(HasSubstr("lasts 9995 s"), HasSubstr("the step is 0.005 s"), HasSubstr("# time [ms]")));
  EXPECT_THAT(read(timed(noise(1, 40'000), 0.1)).complaint, HasSubstr("lasts 4000 s"));
  EXPECT_THAT(read(column(noise(1)), {.time_step = 0.5}).complaint, HasSubstr("check \"time_step_s\""));
  EXPECT_THAT(read(support::peer_at2(noise(1), "10.")).complaint, HasSubstr("mean time step of 10 s"));
  EXPECT_EQ(read("0 0\n1 3\n2 -3\n3 0\n").complaint, "") << "corners of a pulse";
}

TEST(TimesThatAreNoSeconds, AreReadWhereTheirUnitIsStated) {
  const std::vector<RecordColumn> columns{RecordColumn::time, RecordColumn::horizontal};
  for (const char* above : {"Zeit [ms]; a [m/s2]\n", "t (ms), a\n", "time_ms acc_m/s2\n", "TIME[MSEC] ACC\n"}) {
    const Read found = read(timed(noise(1), 5.0, above), {.columns = columns});
    ASSERT_EQ(found.complaint, "") << above;
    EXPECT_EQ(found.motion->time_step, 0.005) << above;
    EXPECT_EQ(found.motion->samples[3].time, 0.015) << above;
  }
  EXPECT_EQ(read(timed(noise(1), 5.0, "t/ms a/(m/s^2)\n"), {.columns = columns}).motion.value().time_step, 0.005);
  EXPECT_EQ(read(timed(noise(1), 4096.0, "t [\u00B5s],a\n"), {.columns = columns}).motion.value().time_step, 0.004096);
  for (const char* above : {"Time [min];a [g]\n", "t/h a/g\n", "hours,g\n"}) {
    EXPECT_THAT(read(timed(noise(1), 0.01 / 60.0, above), {.columns = columns}).complaint,
                HasSubstr("above its times, which are read in s or ms only"))
        << above;
  }
  EXPECT_EQ(read(timed(noise(1), 5.0, "# time [ms], acceleration [m/s2]\n")).motion.value().time_step, 0.005);
  for (const char* remark : {"# sampled every 5 ms\n", "# Ms = 6.9, MS 6.9\n"}) {
    EXPECT_EQ(read(timed(noise(1), 0.005, remark)).motion.value().time_step, 0.005) << remark;
  }
}

std::string unit_of(const std::string& text, const GroundMotionReading& how = {}) {
  const Read found = read(text, how);
  if (!found.motion) return found.complaint;
  return found.motion->unit + (found.motion->unit_is_assumed ? " (assumed)" : "");
}

TEST(UnitsWithAFactor, AreReadOrRefusedAndNeverAssumed) {
  const GroundMotionReading how{.columns = {RecordColumn::time, RecordColumn::horizontal}};
  const std::string numbers = "0;0\n0.01;2\n0.02;-1\n";
  for (const auto& [head, unit] :
       {std::pair{"t;a [10^-2 m/s2]", "cm/s2"}, std::pair{"t [s];a (0.01 m/s^2)", "cm/s2"},
        std::pair{"t;a [1e-3 g]", "mg"}, std::pair{"t;milli-g", "mg"}, std::pair{"t;a [cm/s\u00B2]", "cm/s2"},
        std::pair{"t;a [m s-2]", "m/s2"}, std::pair{"t;a [x10^-3 m/s2]", "mm/s2"}, std::pair{"t;acc_g", "g"}}) {
    EXPECT_EQ(unit_of(std::string(head) + '\n' + numbers, how), unit) << head;
  }
  for (const char* head : {"t;a [0.1g]", "t;g*1000", "t;a [g x 1000]", "t;m/s**2; scale factor 0.01", "t;0.1g",
                           "t;a [counts]", "t;a [g/1000]", "t;a [100 m/s2]", "t;a (mV)", "t;a m/s2 * 0.01"}) {
    GroundMotionReading here = how;
    if (std::string(head).find("factor") != std::string::npos) here.columns.push_back(RecordColumn::other);
    const std::string text = here.columns.size() == 3 ? "0;0;0\n0.01;2;0\n" : numbers;
    EXPECT_THAT(unit_of(std::string(head) + '\n' + text, here), HasSubstr("which is not known; give \"units\""))
        << head;
  }
}

TEST(UnitsWithAFactor, BesideAUnitThatIsAskedForAreRefusedOrTold) {
  const std::vector<RecordColumn> columns{RecordColumn::time, RecordColumn::horizontal};
  const std::string numbers = "0;0\n0.01;2\n0.02;-1\n";
  for (const char* head : {"t;a [0.1g]", "t;a [100 m/s2]", "t;0.5g"}) {
    EXPECT_THAT(read(std::string(head) + '\n' + numbers, {.unit = RecordUnit::g, .columns = columns}).complaint,
                AllOf(HasSubstr("which is not that of \"units\", \"g\""), HasSubstr("correct what is stated")))
        << head;
  }
  for (const char* head : {"t;a [counts]", "t;g*1000", "t;a [g/1000]", "t;m/s2 with scale factor 0.01", "t;a (mV)",
                           "t;a [cm/s2] x 1000", "t;a (g)/10", "t;a in 1/100 g", "t;a (g) scaled by 9.81"}) {
    const std::string text = std::string(head) + '\n' + numbers;
    EXPECT_THAT(unit_of(text, {.columns = columns}), HasSubstr("which is not known; give \"units\"")) << head;
    const Read found = read(text, {.unit = RecordUnit::mg, .columns = columns});
    ASSERT_TRUE(found.motion) << head << ": " << found.complaint;
    EXPECT_EQ(found.motion->unit, "mg");
    EXPECT_THAT(found.motion->warnings,
                Contains(AllOf(HasSubstr("which is not known"), HasSubstr("mg, is taken for it"))))
        << head;
  }
  EXPECT_THAT(read("# in units of 0.1 g\n" + numbers, {.unit = RecordUnit::g}).complaint,
              HasSubstr("which is not that of \"units\""));
  EXPECT_THAT(unit_of("# units: counts\n" + numbers), HasSubstr("\"counts\" above its numbers, which is not known"));
  EXPECT_THAT(read(numbers + "# units: counts\n", {.unit = RecordUnit::g}).motion.value().warnings,
              ::testing::ElementsAre(HasSubstr("\"counts\" in a comment, which is not known")));
}

TEST(UnitsWithAFactor, InCommentsAreReadByTheSameRule) {
  const std::string numbers = "0 0\n0.01 2\n0.02 -1\n";
  for (const auto& [comment, unit] :
       {std::pair{"# in units of g", "g"}, std::pair{"# PGA = 0.6 g; acceleration in cm/s2", "cm/s2"},
        std::pair{"# a [10^-2 m/s2]", "cm/s2"}, std::pair{"# g = 9.81 m/s2", "m/s2 (assumed)"},
        std::pair{"# PGA [g] = 0.4", "m/s2 (assumed)"}, std::pair{"# accelerations (mg)", "mg"}}) {
    EXPECT_EQ(unit_of(std::string(comment) + '\n' + numbers), unit) << comment;
    EXPECT_EQ(unit_of(numbers + comment + '\n'), unit) << comment << " behind the numbers";
  }
  EXPECT_EQ(unit_of("0.1 # cm/s2\n0.2\n", {.time_step = 0.01}), "cm/s2");
  EXPECT_THAT(unit_of("# from g to cm/s2 in 1999\n# (g)\n" + numbers), HasSubstr("names several units"));
  EXPECT_THAT(unit_of("0.1 # cm/s2\n0.2\n", {.time_step = 0.01, .unit = RecordUnit::g}),
              HasSubstr("states the unit cm/s2 in a comment, but \"units\" is \"g\""));
}

TEST(Spectra, AreNoMotions) {
  const GroundMotionReading how{.columns = {RecordColumn::time, RecordColumn::horizontal}};
  EXPECT_THAT(unit_of("Period (s)  Sa (g)\n0.01 0.3\n0.02 0.4\n", how), HasSubstr("a response spectrum"));
  EXPECT_THAT(unit_of("# Period (s)  Sa (g)\n0.01 0.3\n0.02 0.4\n"), HasSubstr("a response spectrum"));
  EXPECT_THAT(unit_of("Frequency (Hz), Amplitude\n0.01,0.3\n0.02,0.4\n", how),
              HasSubstr("a spectrum over frequencies"));
}

std::string knet(const std::string& direction, const std::vector<double>& counts,
                 const std::string& station = "ABC001") {
  std::string text =
      "Origin Time       2001/01/01 00:00:00\nLat.              35.0\nLong.             135.0\nDepth. (km)       10\n"
      "Mag.              6.0\nStation Code      " +
      station +
      "\nStation Lat.      35.1\nStation Long.     135.1\nStation Height(m) 20\n"
      "Record Time       2001/01/01 00:00:10\nSampling Freq(Hz) 100Hz\nDuration Time(s)  20\nDir.              " +
      direction +
      "\nScale Factor      3920(gal)/6182761\nMax. Acc. (gal)   0\nLast Correction   2001/01/01 00:00:00\nMemo.\n";
  for (const double value : counts) text += std::to_string(std::lround(value * 100'000.0)) + '\n';
  return text;
}

/// Files under their names.
class Records : public ::testing::Test {
 protected:
  Experiment suite_of(const std::vector<std::string>& names, const std::string& more = "") const {
    const std::string text = R"({ "format": "rocking.experiment/1", "block": { "width_m": 0.35, "height_m": 1.6 },
      "excitation": { "kind": "recorded", "suite": )" +
                             Json(names).dump() + more + " } }";
    return experiment_in(text, {}, {.files = source()});
  }
  std::string complaint(const std::vector<std::string>& names, const std::string& more = "") const {
    try {
      static_cast<void>(suite_of(names, more));
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "";
  }
  std::vector<std::string> warnings(const std::vector<std::string>& names, std::size_t record) const {
    const Experiment experiment = suite_of(names);
    return std::get<Recorded>(experiment.conditions.at(record).scene.excitation).ground_motion->warnings;
  }
  FileSource source() const {
    return [this](const std::string& name, std::size_t) { return files_.at(name); };
  }
  std::map<std::string, std::string> files_;
};

TEST_F(Records, AreToldWhereAnotherUnitWouldExplainThem) {
  files_ = {{"usual.txt", timed(noise(1, 2000, 9.0), 0.01)},
            {"strong.txt", timed(noise(1, 2000, 90.0), 0.01)},
            {"coarse.txt", timed(noise(1), 0.2)},
            {"short.txt", timed(noise(1), 0.0004)}};
  EXPECT_THAT(warnings({"usual.txt"}, 0),
              Not(Contains(AnyOf(HasSubstr("before it is scaled"), HasSubstr("which is unusual")))));
  EXPECT_THAT(warnings({"strong.txt"}, 0), Contains(HasSubstr("has a peak of 9.17 g before it is scaled")));
  EXPECT_THAT(warnings({"coarse.txt"}, 0), Contains(HasSubstr("has a sample in 0.2 s")));
  EXPECT_THAT(warnings({"short.txt"}, 0), Contains(HasSubstr("has 2000 samples in 0.8 s")));
}

TEST_F(Records, OfBoreholesDoNotStandBesideThoseOfTheSurface) {
  files_ = {{"a.EW1", knet("2", noise(1))}, {"a.EW2", knet("5", noise(2))}, {"b.EW2", knet("5", noise(3), "B")}};
  EXPECT_THAT(complaint({"a.EW1", "a.EW2", "b.EW2"}), AllOf(HasSubstr("\"a.EW1\": is of a sensor in a borehole"),
                                                            HasSubstr("\"a.EW2\" of one at the surface")));
  EXPECT_EQ(complaint({"a.EW2", "b.EW2"}), "");
  EXPECT_THAT(warnings({"a.EW1"}, 0), Contains(HasSubstr("of a sensor in a borehole")));
}

TEST_F(Records, AreVerticalByTheCodeOfTheirSensor) {
  files_ = {{"a.txt", column(noise(1))},
            {"ST01_HNZ.txt", column(noise(2))},
            {"x.BHZ.dat", column(noise(3))},
            {"IV.NRC..HNZ.D.txt", column(noise(4))},
            {"c.txt", "# channel IV.NRC..HHZ\n" + column(noise(5))},
            {"d.txt", "# channel IV.NRC..HHN\n" + column(noise(6))},
            {"e.txt", "# component 3 (vertical)\n" + column(noise(7))}};
  for (const char* name : {"ST01_HNZ.txt", "x.BHZ.dat", "IV.NRC..HNZ.D.txt", "c.txt", "e.txt"}) {
    EXPECT_THAT(complaint({"a.txt", name}, R"(, "time_step_s": 0.01)"), HasSubstr("is a vertical component by its"))
        << name;
  }
  EXPECT_EQ(complaint({"a.txt", "d.txt"}, R"(, "time_step_s": 0.01)"), "");
}

TEST_F(Records, WarnOfAHorizontalComponentThatIsTakenForTheVerticalOne) {
  files_ = {
      {"a.at2", support::peer_at2(noise(1), ".01")}, {"a.EW2", knet("5", noise(2))}, {"v.UD2", knet("6", noise(3))}};
  GroundMotionFiles files(source());
  const auto warnings = [&files](const std::string& name, const std::string& vertical) {
    Problems problems;
    const auto motion = files.motion({.name = name, .vertical_name = vertical}, problems);
    return motion ? motion->warnings : std::vector<std::string>{"not read"};
  };
  EXPECT_THAT(warnings("a.EW2", "a.EW2"), Contains(HasSubstr("is a horizontal component by its header (E-W)")));
  EXPECT_THAT(warnings("a.at2", "a.at2"), Contains(HasSubstr("horizontal component by its header (000)")));
  EXPECT_THAT(warnings("a.EW2", "v.UD2"), Not(Contains(HasSubstr("horizontal component"))));
}

TEST_F(Records, AreToldWhereTheyAreLikelyOneRecordTwice) {
  const std::vector<double> one = noise(1, 4000);
  std::vector<double> scaled, padded(777, 0.0), cut(one.begin() + 900, one.begin() + 3000),
      backwards(one.rbegin(), one.rend()), resampled, offset;
  for (std::size_t i = 0; i < one.size(); ++i) {
    scaled.push_back(-2.5 * one[i]);
    padded.push_back(one[i]);
    offset.push_back(one[i] + 0.02);
    resampled.push_back(one[i]);
    resampled.push_back(i + 1 < one.size() ? 0.5 * (one[i] + one[i + 1]) : 0.0);
  }
  files_ = {{"one.txt", timed(one, 0.01)},        {"scaled.txt", timed(scaled, 0.01)},
            {"padded.txt", timed(padded, 0.01)},  {"cut.txt", timed(cut, 0.01)},
            {"back.txt", timed(backwards, 0.01)}, {"fine.txt", timed(resampled, 0.005)},
            {"offset.txt", timed(offset, 0.01)},  {"other.txt", timed(noise(2, 4000), 0.01)}};
  for (const char* copy : {"scaled.txt", "padded.txt", "cut.txt", "back.txt", "fine.txt", "offset.txt"}) {
    EXPECT_THAT(warnings({"other.txt", "one.txt", copy}, 2),
                Contains(HasSubstr("is likely the record \"one.txt\" once more")))
        << copy;
  }
  EXPECT_THAT(warnings({"one.txt", "other.txt"}, 1), Not(Contains(HasSubstr("once more"))));
}

TEST_F(Records, OfOneChannelInTwoStatesOfProcessingAreToldByTheirHeaders) {
  const std::vector<double> one = noise(1, 2000), two = noise(9, 2000);
  std::vector<double> mixed;
  for (std::size_t i = 0; i < one.size(); ++i) mixed.push_back(one[i] + 0.8 * two[i]);
  files_ = {{"a.EW", knet("E-W", one)}, {"b.EW", knet("E-W", mixed)}, {"c.EW", knet("E-W", mixed, "XYZ9")}};
  EXPECT_THAT(warnings({"a.EW", "b.EW"}, 1), Contains(HasSubstr("the same earthquake, station and component")));
  EXPECT_THAT(warnings({"a.EW", "c.EW"}, 1), Not(Contains(HasSubstr("once more"))));
}

TEST_F(Records, ThatEndInMotionAreToldAndHaveNoPgvToSweep) {
  std::vector<double> offset = noise(1), cut = noise(1);
  for (double& value : offset) value += 0.05;
  cut.resize(950);
  files_ = {{"a.txt", timed(noise(1), 0.01)}, {"offset.txt", timed(offset, 0.01)}, {"cut.txt", timed(cut, 0.01)}};
  EXPECT_THAT(warnings({"offset.txt"}, 0), Contains(HasSubstr("% of its PGV")));
  EXPECT_THAT(complaint({"offset.txt"}, R"(, "pgv_m_s": 0.4)"),
              HasSubstr("needs the PGV of offset.txt, which ends with"));
  cut.back() = 0.5 * *std::ranges::max_element(cut);
  files_["cut.txt"] = timed(cut, 0.01);
  EXPECT_THAT(warnings({"cut.txt"}, 0), Contains(HasSubstr("% of its PGA: it is cut in mid-motion")));
  cut.back() = 0.0;
  files_["cut.txt"] = timed(cut, 0.01);
  EXPECT_THAT(warnings({"cut.txt"}, 0), Not(Contains(HasSubstr("% of its PGA"))));
}

}  // namespace
}  // namespace rocking::nothing_guessed
