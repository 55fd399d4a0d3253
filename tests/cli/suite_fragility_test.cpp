// `rocking fragility` of a suite: the pooled law, peak tilts, annual rate, incremental dynamic analysis.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "rocking/text/number_text.hpp"
#include "support/json_schema.hpp"
#include "support/record_text.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using rocking::support::peer_at2;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Five sines as a suite, seven levels, twenty realisations of each.
class SuiteFragility : public rocking::support::ProgramTest {
 protected:
  static constexpr std::size_t records = 5;

  /// Five decaying sines. The longest overturn the statue at some levels and not at the next.
  SuiteFragility() {
    std::filesystem::create_directory(folder_ / "records");
    for (std::size_t k = 0; k < records; ++k) write("records/r" + std::to_string(k) + ".at2", sine(k));
    write("e.json", experiment().dump());
    write("hazard.csv", "pga_g, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n2, 1e-5\n");
  }

  static std::string sine(std::size_t number) {
    const double period = 0.5 + 0.15 * static_cast<double>(number);
    std::vector<double> accelerations;
    for (int i = 0; 0.02 * i <= 3.0 * period; ++i) {
      const double cycles = 0.02 * i / period;
      accelerations.push_back(0.3 * std::sin(2.0 * std::numbers::pi * cycles) * std::exp(-0.5 * cycles));
    }
    accelerations.push_back(0.0);
    return peer_at2(accelerations, ".02");
  }

  static Json experiment() {
    return Json::parse(R"({
      "format": "rocking.experiment/1", "title": "five sines", "block": { "width_m": 0.35, "height_m": 1.6 },
      "excitation": { "kind": "recorded", "suite": "records/*.at2" },
      "fluctuation": { "restitution": { "sigma": 0.05 } },
      "sweep": [ { "parameter": "/excitation/pga_g", "values": [0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 1.0] } ],
      "realisations": 20, "seed": "0x21" })");
  }

  void run() const {
    const auto ran = rocking("run e.json -q --no-page -o out");
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  }

  /// The output of `rocking fragility out` with these flags, which fits its schema.
  Json fragility(const std::string& flags = "") const {
    const auto found = rocking("fragility out --json " + flags);
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_EQ(objections("fragility", found.output), "");
    return Json::parse(found.output);
  }

  /// Overturned realisations of a record at a level, by the report.
  std::size_t overturned(std::size_t record, std::size_t level) const {
    static const std::size_t levels = experiment()["sweep"][0]["values"].size();
    return Json::parse(
        read("out/report.json"))["result"]["conditions"][levels * record + level]["counts"]["overturned"];
  }
};

double sum_of(const Json& list, const char* key, const auto& belongs) {
  double sum = 0.0;
  for (const Json& each : list) {
    if (belongs(each)) sum += each.at(key).get<double>();
  }
  return sum;
}

TEST_F(SuiteFragility, HasAPooledLawAndACurveForEachRecord) {
  run();
  const Json curves = fragility()["curves"];
  ASSERT_EQ(curves.size(), 1U);
  const Json& curve = curves[0];
  EXPECT_EQ(curve["event"], "overturned");
  EXPECT_EQ(curve["parameter"], "/excitation/pga_g");
  // The shares of these five sines fall at some levels: the law does not describe them.
  ASSERT_EQ(curve["outcome"], "rejected");
  EXPECT_LE(curve["test"]["p_value"], 0.05);
  const auto value = [&curve](const char* key) { return curve["pooled"][key]["value"].get<double>(); };
  EXPECT_NEAR(std::hypot(value("between_records"), value("within_record")), value("dispersion"), 1e-12);
  for (const char* key : {"median", "dispersion", "between_records", "within_record"}) {
    const Json& interval = curve["pooled"][key]["interval"];
    EXPECT_LE(interval[0].get<double>(), value(key)) << key;
    EXPECT_GE(interval[1].get<double>(), value(key)) << key;
  }
  ASSERT_EQ(curve["records"].size(), records);
  for (std::size_t level = 0; level < curve["levels"].size(); ++level) {
    std::size_t all = 0;
    for (std::size_t record = 0; record < records; ++record) {
      const Json& own = curve["records"][record];
      EXPECT_EQ(own["name"], "records/r" + std::to_string(record) + ".at2");
      EXPECT_EQ(own["levels"][level]["overturned"], overturned(record, level));
      all += overturned(record, level);
    }
    EXPECT_EQ(curve["levels"][level]["overturned"], all);
    EXPECT_EQ(curve["levels"][level]["records"], records);
    EXPECT_NEAR(curve["levels"][level]["estimate"].get<double>(), static_cast<double>(all) / 100.0, 1e-15);
  }
}

// Names that JSON writes with escapes, one of which is another name once a backslash is taken away.
TEST_F(SuiteFragility, KeepsTheNamesOfRecords) {
  const std::vector<std::string> names{"records/a\"b.at2", "records/a\tb.at2", "records/atb.at2", "records/a\\tb.at2",
                                       "records/a\x01"
                                       "b.at2"};
  Json named = experiment();
  named["excitation"]["suite"] = names;
  for (std::size_t k = 0; k < records; ++k) write(names[k], sine(k));
  write("e.json", named.dump());
  run();
  const Json curve = fragility("--per-record")["curves"][0];
  ASSERT_EQ(curve["records"].size(), names.size());
  for (std::size_t k = 0; k < records; ++k) EXPECT_EQ(curve["records"][k]["name"], names[k]);
}

TEST_F(SuiteFragility, RanksTheMeasuresOfIntensityByDispersion) {
  run();
  const Json curve = fragility()["curves"][0];
  const Json& measures = curve["measures"];
  ASSERT_EQ(measures.size(), 6U);
  std::vector<double> dispersions;
  for (const Json& measure : measures) {
    dispersions.push_back(measure["dispersion"]);
    EXPECT_NEAR(measure["aic"].get<double>(), measure["deviance"].get<double>() + 6.0, 1e-9);
    if (measure["measure"] != "pga_g") continue;  // the swept intensity itself
    EXPECT_NEAR(measure["median"].get<double>(), curve["pooled"]["median"]["value"].get<double>(), 1e-9);
    EXPECT_NEAR(measure["deviance"].get<double>(), -2.0 * curve["pooled"]["log_likelihood"].get<double>(), 1e-6);
  }
  EXPECT_TRUE(std::ranges::is_sorted(dispersions, [](double a, double b) { return a < b - 1e-6; }));
  const auto told = rocking("fragility out");
  EXPECT_THAT(told.output, AllOf(HasSubstr("measures of intensity, smallest dispersion (most efficient) first"),
                                 HasSubstr("p_pgv_over_g_tan_psi"), HasSubstr("deviance"), HasSubstr("AIC")));
}

/// Phi((ln x - ln median)/dispersion) times |dH|, between two intensities, by the midpoint rule in ln x; not over a kink.
double rate_between(double median, double dispersion, double from, double to) {
  constexpr double kink = 0.5;
  if (from < kink && kink < to) {
    return rate_between(median, dispersion, from, kink) + rate_between(median, dispersion, kink, to);
  }
  // The hazard file of SuiteFragility: from, rate there, exponent.
  const std::array<std::array<double, 3>, 2> pieces{
      {{0.1, 1e-2, std::log(1e-1) / std::log(5.0)}, {0.5, 1e-3, std::log(1e-2) / std::log(4.0)}}};
  constexpr int steps = 40000;
  const double step = std::log(to / from) / steps;
  double rate = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double x = from * std::exp((k + 0.5) * step);
    const auto& [begin, rate_there, exponent] = pieces[x < kink ? 0 : 1];
    const double p = 0.5 * std::erfc(-std::log(x / median) / dispersion / std::numbers::sqrt2);
    rate += p * rate_there * std::pow(x / begin, exponent) * -exponent * step;
  }
  return rate;
}

// The block lifts at tan(psi) = 0.35/1.6 = 0.21875 g under every record.
TEST_F(SuiteFragility, GivesTheAnnualRateOfAHazardCurveAboveTheLeastUplift) {
  run();
  const Json curve = fragility("--hazard hazard.csv")["curves"][0];
  constexpr double uplift = 0.21875;
  EXPECT_NEAR(curve["least_uplift"].get<double>(), uplift, 1e-12);
  const double median = curve["pooled"]["median"]["value"];
  const double dispersion = curve["pooled"]["dispersion"]["value"];
  const Json& found = curve["annual_rate"];
  const double by_law = rate_between(median, dispersion, uplift, 200.0);
  EXPECT_EQ(found["estimates"][0]["from"], "law");
  EXPECT_NEAR(found["estimates"][0]["value"].get<double>(), by_law, 1e-6 * by_law);
  // The law is rejected, so that the value is that of the isotonic shares.
  EXPECT_EQ(found["from"], "isotonic");
  const double rate = found["estimates"][1]["value"];
  EXPECT_NEAR(found["value"].get<double>(), rate, 1e-12 * rate);
  EXPECT_NEAR(found["impossible"].get<double>(), rate_between(median, dispersion, 0.1, uplift), 1e-6 * rate);
  EXPECT_LT(found["interval"][0], found["value"]);
  EXPECT_GT(found["interval"][1], found["value"]);
  const auto all = [](const Json&) { return true; };
  EXPECT_NEAR(sum_of(found["by_level"], "rate", all), rate, 1e-6 * rate);
  EXPECT_NEAR(sum_of(found["by_level"], "share", all), 1.0, 1e-9);
  EXPECT_NEAR(sum_of(found["by_level"], "share", [](const Json& range) { return !range["tested"]; }),
              found["untested_share"].get<double>(), 1e-12);
  // From the least uplift to 0.3 g, five ranges between the levels that lift the block, and one above.
  EXPECT_EQ(found["by_level"].size(), 7U);
  EXPECT_FALSE(found["by_level"][0]["tested"]);
  EXPECT_EQ(found["by_level"][0]["to"], 0.3);
  EXPECT_TRUE(found["by_level"][1]["tested"]);
  EXPECT_FALSE(found["measure_assumed"]);
  const auto told = rocking("fragility out --hazard hazard.csv");
  EXPECT_THAT(told.output, AllOf(HasSubstr("mean annual rate of overturning: "), HasSubstr("once in "),
                                 HasSubstr("% of the rate comes from intensities outside the levels"),
                                 HasSubstr("the least that lifts the block, 0.218"), HasSubstr("not counted: ")));
}

TEST_F(SuiteFragility, CountsPeakTiltsAboveEachValueThatIsGiven) {
  run();
  const Json curves = fragility("--peak-tilt 0.5,0.3 --hazard hazard.csv")["curves"];
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[1]["event"], Json({{"peak_tilt", 0.5}}));
  EXPECT_EQ(curves[2]["event"], Json({{"peak_tilt", 0.3}}));
  for (std::size_t level = 0; level < curves[0]["levels"].size(); ++level) {
    EXPECT_LE(curves[0]["levels"][level]["overturned"], curves[1]["levels"][level]["overturned"]);
    EXPECT_LE(curves[1]["levels"][level]["overturned"], curves[2]["levels"][level]["overturned"]);
  }
  EXPECT_GT(curves[2]["levels"][2]["overturned"], curves[0]["levels"][2]["overturned"]);
  EXPECT_GT(curves[2]["annual_rate"]["value"], curves[0]["annual_rate"]["value"]);
  EXPECT_THAT(rocking("fragility out --peak-tilt 0.3").output, HasSubstr("tilt > 0.3"));
}

TEST_F(SuiteFragility, AnalysesPeakTiltsAndCountsResurrections) {
  run();
  EXPECT_FALSE(fragility().contains("incremental"));
  const Json analysis = fragility("--ida")["incremental"][0];
  ASSERT_EQ(analysis["records"].size(), records);
  std::size_t again = 0;
  for (std::size_t record = 0; record < records; ++record) {
    const Json& own = analysis["records"][record];
    const Json& levels = own["levels"];
    for (std::size_t level = 0; level < levels.size(); ++level) {
      EXPECT_EQ(levels[level]["overturned"], overturned(record, level));
      const std::size_t count = overturned(record, level);
      EXPECT_EQ(levels[level]["quantiles"][0][1].is_null(), count >= 17);  // number ceil(0.16 * 20) of 20 overturned
      EXPECT_EQ(levels[level]["quantiles"][2][1].is_null(), count >= 4);
    }
    again += own["resurrections"]["trials"].get<std::size_t>();
  }
  // The fourth record overturns all at 0.4 g and none at 0.5 g, the fifth all at 0.3 g and few at 0.4 g.
  ASSERT_EQ(overturned(3, 2), 20U);
  ASSERT_EQ(overturned(4, 1), 20U);
  EXPECT_EQ(analysis["records"][3]["resurrections"]["trials"], 20 - overturned(3, 3));
  EXPECT_EQ(analysis["records"][4]["resurrections"]["trials"], 20 - overturned(4, 2));
  EXPECT_EQ(analysis["resurrections"]["trials"], again);
  const auto told = rocking("fragility out --ida");
  EXPECT_THAT(told.output, AllOf(HasSubstr("84 %"), HasSubstr(std::to_string(again) + " of "),
                                 HasSubstr("stood again at a stronger one")));
}

// Below the least uplift nothing is known of stronger shaking: the rate is that of all of it at most.
TEST_F(SuiteFragility, BoundsTheAnnualRateOfASuiteWithoutALaw) {
  Json calm = experiment();
  calm["sweep"][0]["values"] = {0.01, 0.02};
  write("e.json", calm.dump());
  run();
  const Json rate = fragility("--hazard hazard.csv")["curves"][0]["annual_rate"];
  EXPECT_EQ(rate["value"], 0.0);
  EXPECT_EQ(rate["from"], "isotonic");
  const double above = 1e-2 * std::pow(0.21875 / 0.1, std::log(0.1) / std::log(5.0));
  EXPECT_EQ(rate["estimates"][3]["from"], "at_most");
  EXPECT_NEAR(rate["estimates"][3]["value"].get<double>(), above, 1e-9 * above);
  EXPECT_FALSE(fragility()["curves"][0].contains("annual_rate"));
}

TEST_F(SuiteFragility, SaysWhatTheLevelsLeaveOpenAndAddsLevels) {
  Json few = experiment();
  few["sweep"][0]["values"] = {0.3, 0.65};
  write("e.json", few.dump());
  run();
  const Json rate = fragility("--hazard hazard.csv")["curves"][0]["annual_rate"];
  ASSERT_GT(rate["undecided_share"], 0.05);
  std::string levels;
  for (const Json& level : rate["add_levels"]) levels += (levels.empty() ? "" : ",") + level.dump();
  EXPECT_THAT(rocking("fragility out --hazard hazard.csv").output,
              AllOf(HasSubstr("% of the rate undecided; add " + levels), HasSubstr("records contribute")));
  const auto suggested = rocking("fragility out --hazard hazard.csv --suggest");
  EXPECT_EQ(suggested.output, "rocking resume out --levels " + levels + "\n");
  EXPECT_EQ(rocking("fragility out --suggest").exit_code, 64);
  const auto more = rocking("resume out -q --no-page --levels " + levels);
  ASSERT_EQ(more.exit_code, 0) << more.errors;
  // The bytes are those of one run with these levels, in which nothing was run twice.
  few["sweep"][0]["values"] = {0.3, 0.65};
  for (const Json& level : rate["add_levels"]) few["sweep"][0]["values"].push_back(level);
  std::sort(few["sweep"][0]["values"].begin(), few["sweep"][0]["values"].end());
  write("whole.json", few.dump());
  ASSERT_EQ(rocking("run whole.json -q --no-page -o whole").exit_code, 0);
  EXPECT_EQ(Json::parse(read("out/report.json"))["result"], Json::parse(read("whole/report.json"))["result"]);
  const auto twice = rocking("resume out --levels 0.65");
  EXPECT_EQ(twice.exit_code, 64);
  EXPECT_THAT(twice.errors, AllOf(HasSubstr("--levels"), HasSubstr("0.65"), HasSubstr("is a level of the run")));
  EXPECT_EQ(rocking("resume out --levels -1").exit_code, 64);
  EXPECT_EQ(rocking("verify out").exit_code, 0) << "a refused extension changes nothing";
}

// Far more curves than a fraction of a second allows. Without --foreground `timeout` may send the signal twice, and the
// second one kills the program.
TEST_F(SuiteFragility, IsStoppedByASignalWithoutWriting) {
  run();
  std::string tilts;
  for (int i = 1; i <= 1000; ++i) tilts += (i > 1 ? "," : "") + std::to_string(0.001 * i);
  const auto stopped = shell("timeout --foreground --preserve-status -s INT 0.5 '" ROCKING_PROGRAM
                             "' fragility out -o kept --peak-tilt " +
                             tilts);
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_EQ(stopped.output, "");
  EXPECT_THAT(stopped.errors, HasSubstr("interrupted; nothing was written"));
  EXPECT_FALSE(exists("kept/fragility.json"));
}

TEST_F(SuiteFragility, IsDrawnAndStandsOnThePage) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  EXPECT_THAT(read("out/report.html"),
              AllOf(HasSubstr("figure id=\"fragility\""), HasSubstr("figure id=\"incremental\""),
                    HasSubstr("in a suite of 5 ground motions"), HasSubstr("The block is not lifted below 0.218"),
                    HasSubstr("stood again at a stronger one")));
  ASSERT_EQ(rocking("fragility out --ida -o kept --figure drawn").exit_code, 0);
  ASSERT_EQ(rocking("figure kept/fragility.json -o again").exit_code, 0);
  for (const char* name : {"fragility.tsv", "incremental.tsv", "incremental.gp"}) {
    EXPECT_NE(read(std::string("drawn/") + name), "") << name;
    EXPECT_EQ(read(std::string("drawn/") + name), read(std::string("again/") + name)) << name;
  }
  EXPECT_THAT(read("drawn/fragility.tsv"), AllOf(HasSubstr("r3.at2"), HasSubstr("fitted_low")));
  EXPECT_THAT(read("drawn/incremental.gp"), HasSubstr("overturned"));
  // Without the records there are no curves of the suite, but the other figures, and a reason.
  std::filesystem::remove(folder_ / "records/r2.at2");
  const auto without = rocking("report out --format html");
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.errors, AllOf(HasSubstr("the fragility of the suite was not drawn"), HasSubstr("r2.at2")));
  EXPECT_THAT(read("out/report.html"), Not(HasSubstr("figure id=\"incremental\"")));
}

TEST_F(SuiteFragility, ListsRecordsIfAsked) {
  run();
  EXPECT_THAT(rocking("fragility out").output, Not(HasSubstr("r3.at2")));
  EXPECT_THAT(rocking("fragility out --per-record").output, AllOf(HasSubstr("r3.at2"), HasSubstr("no_scatter")));
}

// One motion: the rate of a curve without a suite, and an analysis with one nameless record.
TEST_F(SuiteFragility, TakesOneMotionToo) {
  Json one = experiment();
  one["excitation"].erase("suite");
  one["excitation"]["file"] = "records/r4.at2";
  write("one.json", one.dump());
  ASSERT_EQ(rocking("run one.json -q --no-page -o out").exit_code, 0);
  const Json found = fragility("--hazard hazard.csv --ida");
  EXPECT_FALSE(found["curves"][0].contains("pooled"));
  EXPECT_EQ(found["curves"][0]["annual_rate"]["from"], "levels");  // no function describes a record that resurrects
  ASSERT_EQ(found["incremental"][0]["records"].size(), 1U);
  EXPECT_EQ(found["incremental"][0]["records"][0]["levels"], found["incremental"][0]["levels"]);
}

TEST_F(SuiteFragility, SweepsASpectralAccelerationAndTakesItsHazard) {
  Json spectral = experiment();
  spectral["excitation"]["period_s"] = 0.5;
  spectral["sweep"][0] = {{"parameter", "/excitation/sa_g"}, {"values", {0.4, 0.7, 1.0, 1.5}}};
  write("e.json", spectral.dump());
  run();
  for (const char* name : {"sa_g", "sa_g[0.5]"}) {
    write("hazard.csv", std::string(name) + ", annual_rate\n0.1, 1e-2\n0.5, 1e-3\n5, 1e-5\n");
    EXPECT_GT(fragility("--hazard hazard.csv")["curves"][0]["annual_rate"]["value"], 0.0) << name;
  }
  for (const char* name : {"sa_g[1]", "avgsa_g", "pga_g"}) {
    write("other.csv", std::string(name) + ", annual_rate\n0.1, 1e-2\n0.5, 1e-3\n");
    const auto other = rocking("fragility out --hazard other.csv");
    EXPECT_EQ(other.exit_code, 65) << name;
    EXPECT_THAT(other.errors, HasSubstr("which is sa_g[0.5]")) << name;
  }
  // The measure of the sweep has the law of the suite.
  const Json curve = fragility()["curves"][0];
  for (const Json& measure : curve["measures"]) {
    if (measure["measure"] != "sa_g") continue;
    EXPECT_NEAR(measure["median"].get<double>(), curve["pooled"]["median"]["value"].get<double>(), 1e-6);
  }
}

TEST_F(SuiteFragility, WritesItsAnswerOnASheet) {
  Json wider = experiment();
  wider["sweep"].push_back({{"parameter", "/block/width_m"}, {"values", {0.35, 0.5}}});
  write("e.json", wider.dump());
  run();
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(made.output, AllOf(HasSubstr("sheet: sheet.html"), HasSubstr("rates compared")));
  const std::string sheet = read("sheet.html");
  const Json report = Json::parse(read("out/report.json"));
  for (const std::string& text :
       {std::string("five sines"), std::string("scale 1 : "), std::string("hazard.csv"), std::string("r3.at2"),
        std::string("data:image/png;base64,"), std::string("in 475 years"), std::string("Poisson"),
        report["input"]["sha256"].get<std::string>(), report["result"]["digest"].get<std::string>(),
        std::string("rocking fragility out --hazard hazard.csv --sheet sheet.html")}) {
    EXPECT_THAT(sheet, HasSubstr(text));
  }
  const Json found = fragility("--hazard hazard.csv");
  const double rate = found["curves"][0]["annual_rate"]["value"];
  const std::string within = "<strong>" + rocking::significant(-100.0 * std::expm1(-50.0 * rate), 2) + " %";
  EXPECT_THAT(sheet, HasSubstr(within));
  // The wider block against the narrower one, with an interval.
  const Json& comparison = found["comparisons"].at(0);
  EXPECT_EQ(comparison["option"], Json({{"/block/width_m", 0.5}}));
  const double wide = found["curves"][1]["annual_rate"]["estimates"][1]["value"];
  const double narrow = found["curves"][0]["annual_rate"]["estimates"][1]["value"];
  EXPECT_NEAR(comparison["difference"].get<double>(), wide - narrow, 1e-12 * narrow);
  EXPECT_NEAR(comparison["ratio"].get<double>(), wide / narrow, 1e-12);
  EXPECT_LE(comparison["ratio_interval"][0], comparison["ratio"]);
  EXPECT_GE(comparison["ratio_interval"][1], comparison["ratio"]);
  const auto again = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  EXPECT_EQ(again.exit_code, 74) << again.errors;
}

TEST_F(SuiteFragility, MakesAPdfOfItsSheetWhereWeasyPrintIs) {
  run();
  const auto without =
      shell("PATH=/nonexistent '" ROCKING_PROGRAM "' fragility out --hazard hazard.csv --sheet sheet.pdf");
  EXPECT_EQ(without.exit_code, 74);
  EXPECT_THAT(without.errors, HasSubstr("WeasyPrint is not installed"));
  EXPECT_FALSE(exists("sheet.pdf"));
  if (shell("command -v weasyprint").exit_code != 0) GTEST_SKIP() << "WeasyPrint is not installed";
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.pdf");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const std::string pdf = read("sheet.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  ASSERT_EQ(rocking("fragility out --hazard hazard.csv --overwrite --sheet sheet.pdf").exit_code, 0);
  EXPECT_EQ(read("sheet.pdf"), pdf) << "equal input gives equal bytes";
  EXPECT_EQ(rocking("fragility out --sheet other.pdf").exit_code, 64);
  EXPECT_EQ(rocking("fragility out --hazard hazard.csv --sheet sheet.doc").exit_code, 64);
}

TEST_F(SuiteFragility, SaysWhichMeasuresAreSufficient) {
  run();
  std::string metadata = "file,magnitude,distance_km\n";
  for (std::size_t k = 0; k < records; ++k) {
    metadata += "r" + std::to_string(k) + ".at2," + std::to_string(5.5 + 0.4 * static_cast<double>(k)) + ",20\n";
  }
  write("metadata.csv", metadata);
  for (const Json& measure : fragility("--metadata metadata.csv")["curves"][0]["measures"]) {
    EXPECT_TRUE(measure.contains("by_magnitude")) << measure.dump();
    EXPECT_FALSE(measure.contains("by_distance")) << "all distances are equal: " << measure.dump();
  }
  EXPECT_THAT(rocking("fragility out --metadata metadata.csv").output, HasSubstr("p (magnitude)"));
  EXPECT_FALSE(fragility()["curves"][0]["measures"][0].contains("by_magnitude"));
  write("metadata.csv", "file,magnitude\nr0.at2,6\n");
  const auto incomplete = rocking("fragility out --metadata metadata.csv");
  EXPECT_EQ(incomplete.exit_code, 65);
  EXPECT_THAT(incomplete.errors, AllOf(HasSubstr("r3.at2"), HasSubstr("has no line")));
}

TEST_F(SuiteFragility, RefusesBadFlagsAndHazardCurves) {
  run();
  EXPECT_EQ(rocking("fragility out --peak-tilt 0").exit_code, 64);
  EXPECT_EQ(rocking("fragility out --peak-tilt much").exit_code, 64);
  const auto absent = rocking("fragility out --hazard absent.csv");
  EXPECT_EQ(absent.exit_code, 66);
  EXPECT_THAT(absent.errors, HasSubstr("absent.csv"));
  write("bad.csv", "pga_g, annual_rate\n0.1, 1e-2\n0.5, 2e-2\n0.4, often\n-1, 1e-4\n");
  const auto bad = rocking("fragility out --hazard bad.csv");
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_THAT(bad.errors, AllOf(HasSubstr("bad.csv, line 3"), HasSubstr("2e-2"), HasSubstr("is not below the rate"),
                                HasSubstr("bad.csv, line 4"), HasSubstr("often"), HasSubstr("bad.csv, line 5"),
                                HasSubstr("must be positive")));
  write("velocity.csv", "pgv_m_s, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n");
  const auto other = rocking("fragility out --hazard velocity.csv");
  EXPECT_EQ(other.exit_code, 65);
  EXPECT_THAT(other.errors, AllOf(HasSubstr("velocity.csv, line 1"), HasSubstr("pgv_m_s"), HasSubstr("pga_g")));
  write("short.csv", "0.1, 1e-2\n");
  EXPECT_EQ(rocking("fragility out --hazard short.csv").exit_code, 65);
}

TEST_F(SuiteFragility, RefusesAHazardCurveInAnotherMeasure) {
  run();
  const std::string points = "0.1, 1e-2\n0.5, 1e-3\n";
  for (const char* name : {"sa_g", "PGV", "arias_m_s", "annual_rate", "/excitation/scale"}) {
    write("other.csv", "# a comment\n" + std::string(name) + ", annual_rate\n" + points);
    const auto other = rocking("fragility out --hazard other.csv");
    EXPECT_EQ(other.exit_code, 65) << name;
    EXPECT_EQ(other.output, "") << name;
    EXPECT_THAT(other.errors, AllOf(HasSubstr("other.csv, line 2"), HasSubstr(name), HasSubstr("which is pga_g")))
        << name;
  }
  for (const char* name : {"pga_g", "/excitation/pga_g", "\"pga_g\""}) {
    write("own.csv", std::string(name) + ", annual_rate\n" + points);
    const auto own = rocking("fragility out --hazard own.csv");
    EXPECT_EQ(own.exit_code, 0) << name << own.errors;
    EXPECT_THAT(own.output, Not(HasSubstr("was assumed"))) << name;
  }
  write("nameless.csv", points);
  EXPECT_THAT(rocking("fragility out --hazard nameless.csv").output,
              HasSubstr("does not name its intensity measure: pga_g was assumed"));
  EXPECT_TRUE(fragility("--hazard nameless.csv")["curves"][0]["annual_rate"]["measure_assumed"]);
}

// Neighbouring doubles, the least and the largest numbers, and as many points as are allowed.
TEST_F(SuiteFragility, TakesExtremeHazardCurves) {
  run();
  const auto rate = [this](const std::string& text) {
    write("extreme.csv", "pga_g, annual_rate\n" + text);
    return fragility("--hazard extreme.csv")["curves"][0]["annual_rate"];
  };
  const Json plain = rate("0.3, 1e-3\n2, 1e-5\n");
  const auto by_law = [](const Json& found) { return found["estimates"][0]["value"].get<double>(); };
  // The rate falls by half at 0.3 g, the second level.
  const Json stepped = rate("0.3, 2e-3\n0.30000000000000004, 1e-3\n2, 1e-5\n");
  const double there = fragility()["curves"][0]["levels"][1]["fitted"];
  EXPECT_NEAR(by_law(stepped), by_law(plain) + 1e-3 * there, 1e-9);
  EXPECT_GT(rate("1e-308, 1e-2\n1e308, 1e-3\n")["value"], 1e-3);
  std::string many;
  for (int i = 0; i < 10000; ++i) {
    const double x = 0.3 * std::pow(2.0 / 0.3, i / 9999.0);
    many +=
        std::to_string(x) + ", " + Json(1e-3 * std::pow(x / 0.3, std::log(1e-2) / std::log(2.0 / 0.3))).dump() + '\n';
  }
  EXPECT_NEAR(rate(many)["value"].get<double>(), plain["value"].get<double>(), 1e-5 * plain["value"].get<double>());
  write("extreme.csv", many + "3, 1e-9\n");
  const auto refused = rocking("fragility out --hazard extreme.csv");
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_THAT(refused.errors, HasSubstr("more than 10000 points"));
}

}  // namespace
