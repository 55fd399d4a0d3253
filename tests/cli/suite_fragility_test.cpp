// `rocking fragility` of a suite: the pooled law, peak tilts, measures of intensity, incremental dynamic analysis.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "cli/five_sines.hpp"

namespace {

using rocking::Json;
using rocking::support::FiveSines;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class SuiteFragility : public FiveSines {};

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
  std::vector<std::string> names{"records/a\"b.at2", "records/a\tb.at2", "records/atb.at2", "records/a\\tb.at2",
                                 "records/a\x01"
                                 "b.at2"};
  Json named = experiment();
  named["excitation"]["suite"] = names;
  for (std::size_t k = 0; k < records; ++k) write(names[k], sine(k));
  write("e.json", named.dump());
  run();
  const Json curve = fragility("--per-record")["curves"][0];
  ASSERT_EQ(curve["records"].size(), names.size());
  std::ranges::sort(names);
  for (std::size_t k = 0; k < records; ++k) EXPECT_EQ(curve["records"][k]["name"], names[k]);
}

// Bootstraps draw records by their number: they number them by their names.
TEST_F(SuiteFragility, DoesNotDependOnTheOrderInWhichItsRecordsAreListed) {
  std::vector<Json> curves;
  for (const std::vector<std::size_t>& order : {std::vector<std::size_t>{0, 1, 2, 3, 4}, {3, 0, 4, 2, 1}}) {
    Json listed = experiment();
    listed["excitation"]["suite"] = Json::array();
    for (const std::size_t k : order) listed["excitation"]["suite"].push_back("records/r" + std::to_string(k) + ".at2");
    write("e.json", listed.dump());
    std::filesystem::remove_all(folder_ / "out");
    run();
    curves.push_back(fragility("--hazard hazard.csv --per-record")["curves"][0]);
    curves.back().erase("sha256");  // of the experiment, which states the order
  }
  ASSERT_TRUE(curves[0].contains("annual_rate"));
  EXPECT_EQ(curves[0].dump(1), curves[1].dump(1));
}

TEST_F(SuiteFragility, RanksTheMeasuresOfIntensityByDispersion) {
  run();
  const Json curve = fragility()["curves"][0];
  const Json& measures = curve["measures"];
  ASSERT_EQ(measures.size(), 4U);
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
                                 HasSubstr("pgv_m_s"), HasSubstr("deviance"), HasSubstr("AIC")));
}

TEST_F(SuiteFragility, CountsPeakTiltsAboveEachValueThatIsGiven) {
  run();
  const Json curves = fragility("--event 'overturning,tilt > 0.5 psi,tilt > 0.3 psi' --hazard hazard.csv")["curves"];
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[1]["event"], Json({{"peak_tilt", 0.5}}));
  EXPECT_EQ(curves[2]["event"], Json({{"peak_tilt", 0.3}}));
  for (std::size_t level = 0; level < curves[0]["levels"].size(); ++level) {
    EXPECT_LE(curves[0]["levels"][level]["overturned"], curves[1]["levels"][level]["overturned"]);
    EXPECT_LE(curves[1]["levels"][level]["overturned"], curves[2]["levels"][level]["overturned"]);
  }
  EXPECT_GT(curves[2]["levels"][2]["overturned"], curves[0]["levels"][2]["overturned"]);
  EXPECT_GT(curves[2]["annual_rate"]["value"], curves[0]["annual_rate"]["value"]);
  EXPECT_THAT(rocking("fragility out --event 'overturning,tilt > 0.3 psi'").output, HasSubstr("tilt > 0.3"));
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

TEST_F(SuiteFragility, IsStoppedByASignalWithoutWriting) {
  run();
  std::string tilts;
  for (int i = 1; i <= 1000; ++i) tilts += ",tilt > " + std::to_string(0.001 * i) + " psi";
  const auto stopped =
      until_disturbed("rm -rf kept; " + in_background("fragility out -o kept --event 'overturning" + tilts + "'") +
                      "kill -INT $child; wait $child");
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_EQ(stopped.output, "");
  EXPECT_THAT(stopped.errors, HasSubstr("interrupted; nothing was written"));
  EXPECT_FALSE(exists("kept/fragility.json"));
}

TEST_F(SuiteFragility, IsDrawnAndStandsOnThePage) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  EXPECT_THAT(
      read("out/report.html"),
      AllOf(HasSubstr("figure id=\"fragility\""), HasSubstr("figure id=\"incremental\""),
            HasSubstr("in a suite of 5 ground motions"), HasSubstr("from PGA = 0.219 g on, the least that lifts"),
            HasSubstr("stood again at a stronger one")));
  ASSERT_EQ(rocking("fragility out --ida -o kept --figure drawn --pictures gp").exit_code, 0);
  ASSERT_EQ(rocking("report kept/fragility.json -o again --pictures gp").exit_code, 0);
  for (const char* name : {"fragility.tsv", "incremental.tsv", "incremental.gp"}) {
    EXPECT_NE(read(std::string("drawn/") + name), "") << name;
    EXPECT_EQ(read(std::string("drawn/") + name), read(std::string("again/") + name)) << name;
  }
  EXPECT_THAT(read("drawn/fragility.tsv"),
              AllOf(HasSubstr("r3.at2"), HasSubstr("isotonic_low"), Not(HasSubstr("fitted"))));
  EXPECT_THAT(read("drawn/incremental.gp"), HasSubstr("overturned"));
  // Without the records there are no curves of the suite, but the other figures, and a reason.
  std::filesystem::remove(folder_ / "records/r2.at2");
  const auto without = rocking("report out --format html");
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.errors, AllOf(HasSubstr("the fragility of the suite was not drawn"), HasSubstr("r2.at2")));
  EXPECT_THAT(read("out/report.html"), Not(HasSubstr("figure id=\"incremental\"")));
}

TEST_F(SuiteFragility, IsAmongTheTablesOfTheRun) {
  run();
  ASSERT_EQ(rocking("report out --format csv,latex -q").exit_code, 0);
  EXPECT_THAT(read("out/tables/fragility_levels.csv"), HasSubstr("pga_g,n,count,share,"));
  EXPECT_THAT(read("out/tables/fragility_curves.tex"), HasSubstr("rejected"));
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
  // What is known of suites only is refused.
  for (const auto& [flags, code] :
       {std::pair{"--hazard hazard.csv --suggest", 64}, std::pair{"--hazard hazard.csv --sheet sheet.html", 65}}) {
    const auto refused = rocking(std::string("fragility out ") + flags);
    EXPECT_EQ(refused.exit_code, code) << flags;
    EXPECT_THAT(refused.errors, HasSubstr("suite of ground motions")) << flags;
  }
  EXPECT_EQ(rocking("report out --format html --hazard hazard.csv").exit_code, 64);
}

TEST_F(SuiteFragility, RefusesBadFlagsAndHazardCurves) {
  run();
  const auto gone = rocking("fragility out --metadata metadata.csv");
  EXPECT_EQ(gone.exit_code, 65);
  EXPECT_THAT(gone.errors, HasSubstr("dispersion")) << "what to use instead";
  EXPECT_THAT(rocking("fragility out --peak-tilt 0.5").errors, HasSubstr("--event 'tilt > A psi'"));
  const auto absent = rocking("fragility out --hazard absent.csv");
  EXPECT_EQ(absent.exit_code, 66);
  EXPECT_THAT(absent.errors, HasSubstr("absent.csv"));
  write("bad.csv", "pga_g, annual_rate\n0.1, 1e-2\n0.5, 2e-2\n0.4, often\n-1, 1e-4\n");
  const auto bad = rocking("fragility out --hazard bad.csv");
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_THAT(bad.errors, AllOf(HasSubstr("bad.csv, line 3"), HasSubstr("2e-2"),
                                HasSubstr("is above the number before it"), HasSubstr("bad.csv, line 4"),
                                HasSubstr("often"), HasSubstr("bad.csv, line 5"), HasSubstr("must be positive")));
  write("velocity.csv", "pgv_m_s, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n");
  const auto other = rocking("fragility out --hazard velocity.csv");
  EXPECT_EQ(other.exit_code, 65);
  EXPECT_THAT(other.errors, AllOf(HasSubstr("velocity.csv, line 1"), HasSubstr("pgv_m_s"), HasSubstr("pga_g")));
  write("short.csv", "pga_g, annual_rate\n0.1, 1e-2\n");
  EXPECT_EQ(rocking("fragility out --hazard short.csv").exit_code, 65);
}

TEST_F(SuiteFragility, HasASurfaceOverTwoMeasures) {
  run();
  write("joint.csv", "pga_g,pgv_over_pga_s,annual_rate\n0.3,0.1,1e-3\n0.6,0.12,1e-4\n9,0.1,1e-4\n");
  const std::string flags = "--surface pga_g,pgv_over_pga_s --joint-hazard joint.csv";
  const Json surface = fragility(flags)["surfaces"][0];
  EXPECT_EQ(surface["outcome"], "fitted");
  EXPECT_EQ(surface["tested"].size(), records * 7);
  EXPECT_GT(surface["annual_rate"]["value"].get<double>(), 1e-4);
  const auto shown = rocking("fragility out -o out " + flags);
  EXPECT_EQ(shown.exit_code, 0) << shown.errors;
  EXPECT_THAT(shown.output, HasSubstr("surface of overturning: pgv_over_pga_s "));
  EXPECT_THAT(shown.output, HasSubstr("warning: "));
  EXPECT_TRUE(rocking("report out/fragility.json -o figures").exit_code == 0 && exists("figures/surface.svg"));
  const auto unknown = rocking("fragility out --surface pga_g,pgx");
  EXPECT_EQ(unknown.exit_code, 64);
  EXPECT_THAT(unknown.errors, HasSubstr("pgv_over_pga_s"));
  EXPECT_EQ(rocking("fragility out --surface pga_g,pga_g").exit_code, 64);
  write("joint.csv", "pga_g,pgv_over_pga_s,annual_rate\n0.3,0.1,x\n");
  const auto bad = rocking("fragility out " + flags);
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_THAT(bad.errors, HasSubstr("joint.csv, line 2"));
}

}  // namespace
