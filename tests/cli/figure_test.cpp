// `rocking report` and `rocking trajectory --samples`: non-empty pictures, from files alone.

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/text/files.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::Outcome;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Figures : public rocking::support::ProgramTest {
 protected:
  bool has_gnuplot() const { return shell("command -v gnuplot").exit_code == 0; }

  /// Pixels of a PNG by colour, every fourth of every fourth line, read by gnuplot.
  std::map<std::string, int> colours(const std::string& png) const {
    const Outcome outcome = shell("gnuplot -d -e \"set table 'pixels'; plot '" + png +
                                  "' binary filetype=png every 4:4 using 1:2:3 with rgbimage\" && cut -c1-60 pixels");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    std::map<std::string, int> found;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields(line);
      std::string x, y, red, green, blue;
      if (line.starts_with('#') || !(fields >> x >> y >> red >> green >> blue)) continue;
      ++found[red + ' ' + green + ' ' + blue];
    }
    return found;
  }

  /// Width of a figure for a journal, in inches and in points.
  struct Column {
    const char* inches;
    const char* points;
  };
  static constexpr Column single_column{"3.31", "238"};  // 84 mm
  static constexpr Column double_column{"6.85", "493"};  // 174 mm

  /// Whether the script of a figure asks for this width, and the PDF has it. cairo 1.18 compresses the size of a page;
  /// such a PDF is not looked at.
  bool has_width(const std::string& stem, const Column& column) const {
    const std::string pdf = read(stem + ".pdf");
    const bool is_plain = pdf.find("/MediaBox") != std::string::npos;
    const bool is_drawn = pdf.find(std::string("/MediaBox [ 0 0 ") + column.points) != std::string::npos;
    const bool is_asked = read(stem + ".gp").find(std::string("size ") + column.inches + ',') != std::string::npos;
    return is_asked && (is_drawn || !is_plain);
  }

  /// Tests that every PNG that a command wrote shows something on white.
  void expect_pictures(const std::string& written) const {
    std::istringstream lines(written);
    int pictures = 0;
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(exists(line)) << line;
      if (!line.ends_with(".png")) continue;
      ++pictures;
      const auto found = colours(line);
      int all = 0;
      for (const auto& [colour, count] : found) all += count;
      EXPECT_GT(found.size(), 3U) << line;
      ASSERT_TRUE(found.contains("255 255 255")) << line;
      const int white = found.at("255 255 255");
      EXPECT_LT(white, 0.985 * all) << line;
      EXPECT_GT(white, 0.05 * all) << line;
    }
    EXPECT_GT(pictures, 0);
  }
};

TEST_F(Figures, OfARunShowSomethingAndAreDrawnWithoutRunning) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  ASSERT_EQ(rocking("run quick.json -o out -q").exit_code, 0);
  const std::string report = read("out/report.json");
  const Outcome outcome = rocking("report out --format gnuplot,csv,latex --pictures svg,png,pdf");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  expect_pictures(outcome.output);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("out/figures/divergence_times.svg"), HasSubstr("out/figures/scene.pdf"),
                                    HasSubstr("out/tables/modes.tex"), HasSubstr("out/tables/non_recurrence.csv")));
  EXPECT_EQ(read("out/report.json"), report);
  const std::string bands = read("out/figures/mode_bands.svg");
  ASSERT_EQ(shell("rm out/realisations.sqlite").exit_code, 0);
  const Outcome again = rocking("report out --format gnuplot");
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(read("out/figures/mode_bands.svg"), bands);
}

TEST_F(Figures, OfTheReadmeThatMovesIsWhatItsScriptMakes) {
  if (shell("command -v python3").exit_code != 0) GTEST_SKIP() << "python3 was not found (Debian: python3)";
  const std::string source = ROCKING_SOURCE_DIR;
  const Outcome outcome =
      shell("python3 -B '" + source + "/experiments/headline/draw_rocking_block.py' '" ROCKING_PROGRAM "' moving.svg");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(read("moving.svg"), rocking::read_file(source + "/reports/headline/rocking_block.svg"));
}

TEST_F(Figures, OfTheReadmeOfTolerancesIsWhatItsScriptMakes) {
  if (shell("command -v python3").exit_code != 0) GTEST_SKIP() << "python3 was not found (Debian: python3)";
  const std::string source = ROCKING_SOURCE_DIR;
  const Outcome outcome = shell("python3 -B '" + source + "/experiments/headline/draw_cost_tolerance.py' drawn.svg");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(read("drawn.svg"), rocking::read_file(source + "/reports/headline/cost_tolerance.svg"));
}

TEST_F(Figures, AreWrittenAsDataWithoutGnuplot) {
  ASSERT_EQ(rocking("run quick.json -o out -q").exit_code, 0);
  const Outcome outcome = shell("PATH=/nowhere exec '" ROCKING_PROGRAM "' report out --format gnuplot");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.errors, HasSubstr("gnuplot-nox"));
  EXPECT_TRUE(exists("out/figures/mode_bands.tsv"));
  EXPECT_FALSE(exists("out/figures/mode_bands.svg"));
}

TEST_F(Figures, AreNumbersAndOnePictureUnlessOthersAreAskedFor) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  write("one.json", rocking("trajectory quick.json --periods 6 --samples 50").output);
  write("two.json", rocking("trajectory quick.json --realisation 1 --periods 6 --samples 50").output);
  const auto files = [this](const std::string& command) {
    const Outcome drawn = rocking("report " + command);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
    return shell("ls drawn | grep poincare").output;
  };
  EXPECT_EQ(files("one.json -o drawn"), "poincare.svg\npoincare.tsv\n");
  EXPECT_EQ(files("one.json -o drawn --pictures gp"), "poincare.gp\npoincare.svg\npoincare.tsv\n") << "equal numbers";
  EXPECT_EQ(files("two.json -o drawn --style journal"), "poincare.pdf\npoincare.tsv\n") << "pictures of others go";
  const Outcome wrong = rocking("report one.json -o drawn --pictures svg,eps");
  EXPECT_EQ(wrong.exit_code, 64);
  EXPECT_THAT(wrong.errors, AllOf(HasSubstr("eps"), HasSubstr("png")));
}

TEST_F(Figures, ThatFailAreAnErrorAlsoWhereTheCommandIsToBeQuiet) {
  ASSERT_EQ(
      shell("mkdir bin; printf '#!/bin/sh\\necho half >scene.svg.unfinished; echo no such word; exit 1' >bin/gnuplot; "
            "chmod +x bin/gnuplot")
          .exit_code,
      0);
  const Outcome run = shell("PATH=\"$PWD/bin:$PATH\" exec '" ROCKING_PROGRAM "' run quick.json -o out -q");
  EXPECT_EQ(run.exit_code, 70);
  EXPECT_THAT(run.errors, HasSubstr("no such word"));
  EXPECT_THAT(run.output, HasSubstr("page: out/report.html"));
  const Outcome report = shell("PATH=\"$PWD/bin:$PATH\" exec '" ROCKING_PROGRAM "' report out --format gnuplot -q");
  EXPECT_EQ(report.exit_code, 70);
  EXPECT_THAT(report.output, AllOf(HasSubstr("scene.gp"), ::testing::Not(HasSubstr(".svg"))));
  EXPECT_EQ(shell("ls out/figures | grep -v -e 'tsv$' -e 'gp$'").output, "");
}

TEST_F(Figures, ShowEveryTitleAndSaySoWhereThereIsNothing) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  Json titled = quick_experiment();
  titled["title"] = "'Tis rocking, isn''t it?";
  write("titled.json", titled.dump());
  const Outcome run = rocking("run titled.json -o titled -q");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.errors, "");
  EXPECT_EQ(rocking("report titled --format gnuplot").exit_code, 0);
  EXPECT_THAT(read("titled/figures/mode_bands.svg"), HasSubstr("'Tis rocking, isn''t it?"));
  write("over.json", R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 8},
    "excitation": {"amplitude": 50, "frequency_ratio": 0.5}, "initial": {"tilt": 0.95, "tilt_rate": 2}})");
  write("strobeless.json", rocking("trajectory over.json").output);
  ASSERT_EQ(rocking("report strobeless.json -o drawn").exit_code, 0);
  EXPECT_THAT(read("drawn/poincare.svg"), HasSubstr("nothing to show"));
}

TEST_F(Figures, NeedAFinishedRun) {
  EXPECT_EQ(rocking("report nowhere").exit_code, 66);
  EXPECT_EQ(rocking("run quick.json -o part --shard 1/2 -q").exit_code, 0);
  const Outcome unfinished = rocking("report part");
  EXPECT_EQ(unfinished.exit_code, 66);
  EXPECT_THAT(unfinished.errors, HasSubstr("rocking resume part"));
  ASSERT_EQ(shell("mkdir torn; echo '{' >torn/report.json").exit_code, 0);
  EXPECT_EQ(rocking("report torn").exit_code, 65);
}

TEST_F(Figures, OfOtherOutputsShowSomething) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  write("one.json", rocking("trajectory quick.json --periods 6 --samples 50").output);
  write("two.json", rocking("trajectory quick.json --realisation 1 --periods 6 --samples 50").output);
  write("normal.json", rocking("check-normal --json").output);
  ASSERT_EQ(rocking("bifurcation quick.json -o out -q").exit_code, 0);
  const Outcome outcome =
      rocking("report one.json two.json normal.json out/bifurcation.json -o drawn --pictures png,svg");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  expect_pictures(outcome.output);
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("drawn/responses.png"), HasSubstr("drawn/time_history_2.svg")));
}

TEST_F(Figures, ForAJournalHaveTheSizeOfItsColumn) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  write("one.json", rocking("trajectory quick.json --periods 6 --samples 50").output);
  const Outcome single = rocking("report one.json -o single --style journal --pictures png,pdf,gp");
  ASSERT_EQ(single.exit_code, 0) << single.errors;
  expect_pictures(single.output);
  ASSERT_EQ(rocking("report one.json -o double --style journal --width double --pictures pdf,gp").exit_code, 0);
  EXPECT_TRUE(has_width("single/poincare", single_column));
  EXPECT_TRUE(has_width("double/poincare", double_column));
  EXPECT_EQ(read("single/poincare.tsv"), read("double/poincare.tsv"));
  const Outcome screen = rocking("report one.json -o screen --width single");
  EXPECT_EQ(screen.exit_code, 64);
  EXPECT_THAT(screen.errors, HasSubstr("--style journal"));
  EXPECT_EQ(rocking("report one.json -o screen --style poster").exit_code, 64);
  ASSERT_EQ(rocking("run quick.json -o out -q").exit_code, 0);
  ASSERT_EQ(rocking("report out --format gnuplot --style journal --width double --pictures pdf,gp").exit_code, 0);
  EXPECT_TRUE(has_width("out/figures/mode_bands", double_column));
}

TEST_F(Figures, RefuseWhatTheyCannotDraw) {
  EXPECT_EQ(rocking("report nowhere.json -o drawn").exit_code, 66);
  const Outcome other = rocking("report quick.json -o drawn");
  EXPECT_EQ(other.exit_code, 65);
  EXPECT_THAT(other.errors, HasSubstr("quick.json"));
  write("one.json", rocking("trajectory quick.json --periods 2").output);
  EXPECT_EQ(rocking("report one.json -o drawn --from 5 --to 3").exit_code, 64);
  EXPECT_FALSE(exists("drawn"));
}

TEST_F(Figures, HaveAHistoryThatChangesNothingElse) {
  for (const char* condition : {"0", "1", "2"}) {
    const std::string asked = std::string("trajectory quick.json --periods 7 --condition ") + condition;
    const Json plain = Json::parse(rocking(asked).output);
    const std::string text = rocking(asked + " --samples 20").output;
    EXPECT_EQ(objections("trajectory", text), "");
    Json sampled = Json::parse(text);
    const Json history = sampled["history"];
    ASSERT_EQ(history.size(), 7U * 20U + 1U);
    for (std::size_t k = 0; k < 7; ++k) {
      const Json& strobe = plain["strobe"][k];
      const Json& sample = history[20 * (k + 1)];
      for (const char* key : {"tilt", "tilt_rate", "slip", "slip_rate", "contact"}) EXPECT_EQ(sample[key], strobe[key]);
    }
    sampled.erase("history");
    sampled.erase("samples_per_period");
    EXPECT_EQ(sampled, plain);
  }
}

TEST_F(Figures, HaveAHistoryAsFineAsTheCoarserOneAtItsInstants) {
  const Json coarse = Json::parse(rocking("trajectory quick.json --periods 4 --samples 10").output)["history"];
  const Json fine = Json::parse(rocking("trajectory quick.json --periods 4 --samples 30").output)["history"];
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(coarse[i]["tau"].get<double>(), fine[3 * i]["tau"].get<double>(), 1e-12);
    EXPECT_NEAR(coarse[i]["tilt"].get<double>(), fine[3 * i]["tilt"].get<double>(), 1e-12);
    EXPECT_NEAR(coarse[i]["slip"].get<double>(), fine[3 * i]["slip"].get<double>(), 1e-12);
  }
}

/// The motions in a page.
Json motions_in(const std::string& page) {
  const std::string open = "id=\"data-motions\">";
  const std::size_t at = page.find(open);
  if (at == std::string::npos) return nullptr;
  return Json::parse(page.substr(at + open.size(), page.find("</script>", at) - at - open.size()));
}

TEST_F(Figures, AnimateOneRealisationInAPageOfItsOwn) {
  const Outcome outcome = rocking("trajectory quick.json --condition 1 --periods 30 --samples 20 --html motion.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "motion.html\n");
  const Json motion = motions_in(read("motion.html")).at(0);
  const Json history =
      Json::parse(rocking("trajectory quick.json --condition 1 --periods 30 --samples 20").output)["history"];
  ASSERT_EQ(motion["tilts"].size(), history.size());
  const double shape_angle = std::atan2(1.0, 4.0);
  const double p = std::sqrt(0.75 * 9.81 / (0.5 * std::hypot(1.0, 4.0)));
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double tau = history[i]["tau"];
    EXPECT_NEAR(motion["times"][i].get<double>(), tau / p, 5.1e-5);
    EXPECT_NEAR(motion["tilts"][i].get<double>(), history[i]["tilt"].get<double>(), 5.1e-6);
    EXPECT_NEAR(motion["slips"][i].get<double>(), history[i]["slip"].get<double>(), 5.1e-7);
    EXPECT_NEAR(motion["bases"][i].get<double>(), 4.2 * shape_angle * std::sin(10.0 * tau), 5.1e-5) << i;
  }
  EXPECT_NEAR(motion["period"].get<double>(), 2.0 * std::acos(-1.0) / 10.0 / p, 1e-12);
}

TEST_F(Figures, AnimateInThePageOfARunOneRealisationOfEachResponse) {
  ASSERT_EQ(rocking("run quick.json -o out -q").exit_code, 0);
  const Json motions = motions_in(read("out/report.html"));
  std::size_t samples = 0;
  for (const Json& motion : motions) samples += motion["times"].size();
  EXPECT_GE(motions.size(), 1U);
  EXPECT_LE(samples, motions.size() * 2401);
  const Json report = Json::parse(read("out/report.json"));
  for (const Json& motion : motions) {
    const std::string name = motion["name"];
    const std::string mode = name.substr(0, name.find(':'));
    const Json& conditions = report["result"]["conditions"];
    const auto has = [&mode](const Json& condition) { return condition["counts"].value(mode, 0) > 0; };
    EXPECT_TRUE(std::any_of(conditions.begin(), conditions.end(), has)) << name;
  }
  ASSERT_EQ(shell("rm out/realisations.sqlite").exit_code, 0);
  ASSERT_EQ(rocking("report out --format html").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), HasSubstr("No realisation is shown: realisations.sqlite was not beside"));
}

TEST_F(Figures, AnimateARecordedMotionInSeconds) {
  write("motion.txt", "0\n5.886\n-5.886\n0\n");  // m/s^2
  Json question = quick_experiment();
  question.erase("sweep");
  question.erase("horizon");
  question["excitation"] = {{"kind", "recorded"}, {"file", "motion.txt"}, {"time_step_s", 0.5}};
  write("recorded.json", question.dump());
  const Outcome outcome = rocking("trajectory recorded.json --html motion.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const Json motion = motions_in(read("motion.html")).at(0);
  EXPECT_EQ(motion["period"], 0.0);
  EXPECT_THAT(read("motion.html"), HasSubstr(" seconds"));
  double most = 0.0;
  for (const Json& base : motion["bases"]) most = std::max(most, base.get<double>());
  EXPECT_NEAR(most, 0.6, 0.05);
}

}  // namespace
