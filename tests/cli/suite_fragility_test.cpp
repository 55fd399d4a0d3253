// `rocking fragility` of a suite: the pooled law, peak tilts, annual rate, incremental dynamic analysis.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/program.hpp"
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
  ASSERT_EQ(curve["outcome"], "fitted");
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
  EXPECT_THAT(told.output, AllOf(HasSubstr("measures of intensity, smallest dispersion first"),
                                 HasSubstr("p_pgv_over_g_tan_psi"), HasSubstr("deviance"), HasSubstr("AIC")));
}

// The integral of P |dH| from the law in the file, by the midpoint rule in ln x.
TEST_F(SuiteFragility, GivesTheAnnualRateOfAHazardCurve) {
  run();
  const Json curve = fragility("--hazard hazard.csv")["curves"][0];
  const double median = curve["pooled"]["median"]["value"];
  const double dispersion = curve["pooled"]["dispersion"]["value"];
  const std::vector<std::array<double, 3>> pieces{{0.1, 1e-2, 0.5}, {0.5, 1e-3, 100.0}};  // from, rate there, to
  double rate = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double slope = i == 0 ? std::log(1e-1) / std::log(5.0) : std::log(1e-2) / std::log(4.0);
    const auto& [from, rate_there, to] = pieces[i];
    constexpr int steps = 20000;
    const double step = std::log(to / from) / steps;
    for (int k = 0; k < steps; ++k) {
      const double beyond = (k + 0.5) * step;
      const double z = (std::log(from / median) + beyond) / dispersion;
      rate += 0.5 * std::erfc(-z / std::numbers::sqrt2) * rate_there * -slope * std::exp(slope * beyond) * step;
    }
  }
  const Json& found = curve["annual_rate"];
  EXPECT_NEAR(found["value"].get<double>(), rate, 1e-6 * rate);
  EXPECT_LT(found["interval"][0], found["value"]);
  EXPECT_GT(found["interval"][1], found["value"]);
  const auto all = [](const Json&) { return true; };
  EXPECT_NEAR(sum_of(found["by_level"], "rate", all), rate, 1e-6 * rate);
  EXPECT_NEAR(sum_of(found["by_level"], "share", all), 1.0, 1e-9);
  EXPECT_NEAR(sum_of(found["by_level"], "share", [](const Json& range) { return !range["tested"]; }),
              found["untested_share"].get<double>(), 1e-12);
  EXPECT_EQ(found["by_level"].size(), 8U);  // six ranges between the levels, one on each side
  const auto told = rocking("fragility out --hazard hazard.csv");
  EXPECT_THAT(told.output, AllOf(HasSubstr("mean annual rate of overturning: "), HasSubstr("once in "),
                                 HasSubstr("% of the rate comes from intensities outside the levels")));
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

TEST_F(SuiteFragility, IsDrawnAndStandsOnThePage) {
  ASSERT_EQ(rocking("run e.json -q -o out").exit_code, 0);
  EXPECT_THAT(read("out/report.html"),
              AllOf(HasSubstr("figure id=\"fragility\""), HasSubstr("figure id=\"incremental\""),
                    HasSubstr("in a suite of 5 ground motions"), HasSubstr("stood again at a stronger one")));
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

}  // namespace
