// Fragility functions for other programs, read back by the rules that their documents state.

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include "rocking/studies/fragility/study.hpp"

namespace rocking {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A suite at four levels of which the law holds, or is rejected.
ShownSuite exported_suite(stats::FragilityOutcome outcome, std::vector<double> isotonic) {
  ShownSuite shown;
  SuiteCurve& curve = shown.curve;
  curve.subject.parameter = "/excitation/pga_g";
  curve.subject.least_uplift = 0.125;
  curve.outcome = outcome;
  PooledSuite& pooled = curve.pooled.emplace();
  pooled.median.value = 0.35;
  pooled.dispersion.value = 0.34;
  for (std::size_t i = 0; i < isotonic.size(); ++i) {
    SuiteLevel& level = curve.levels.emplace_back();
    level.intensity = 0.1 * std::pow(2.0, static_cast<double>(i));
    level.fitted = 0.5;  // of the law
    level.isotonic = isotonic[i];
  }
  return shown;
}

RunFragility exported_run(ShownSuite suite, const std::string& key = "pga_g") {
  RunFragility run;
  run.experiment.title = "A statue & its \"plinth\"";
  run.experiment.conditions.emplace_back().parameters.push_back({.pointer = "/excitation/" + key, .value = 0.1});
  run.suites.push_back(std::move(suite));
  return run;
}

const std::vector<double> rejected_shares{0.0, 0.2, 0.2, 0.9};

pugi::xml_node function_in(pugi::xml_document& document, const std::string& text) {
  EXPECT_TRUE(document.load_string(text.c_str())) << text;
  const pugi::xml_node model = document.child("nrml").child("fragilityModel");
  EXPECT_STREQ(document.child("nrml").attribute("xmlns").value(), "http://openquake.org/xmlns/nrml/0.5");
  EXPECT_STREQ(model.first_child().name(), "description");
  EXPECT_STREQ(model.first_child().text().get(), "A statue & its \"plinth\"");
  EXPECT_STREQ(model.first_child().next_sibling().name(), "limitStates");
  return model.child("fragilityFunction");
}

std::vector<double> numbers_in(std::string text) {
  for (char& c : text) c = c == ',' ? ' ' : c;
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  return numbers;
}

// OpenQuake: sigma^2 = ln(1 + (stddev/mean)^2), median = mean^2/sqrt(mean^2 + stddev^2).
TEST(ExportToNrml, HasMeanAndDeviationOfTheIntensity) {
  const RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::fitted, rejected_shares));
  pugi::xml_document document;
  const pugi::xml_node function = function_in(document, exported({run}, ExportFormat::nrml).text);
  EXPECT_STREQ(function.attribute("format").value(), "continuous");
  EXPECT_STREQ(function.attribute("shape").value(), "logncdf");
  EXPECT_STREQ(function.attribute("id").value(), "A_statue_its_plinth_");
  const pugi::xml_node levels = function.child("imls"), params = function.child("params");
  EXPECT_STREQ(levels.attribute("imt").value(), "PGA");
  EXPECT_EQ(levels.attribute("noDamageLimit").as_double(), 0.125);
  EXPECT_EQ(levels.attribute("minIML").as_double(), 0.0625) << "below noDamageLimit, for engines before 3.13";
  EXPECT_NEAR(levels.attribute("maxIML").as_double(), 0.35 * std::exp(6.0 * 0.34), 1e-12);
  EXPECT_STREQ(params.attribute("ls").value(), "overturning");
  const double mean = params.attribute("mean").as_double(), deviation = params.attribute("stddev").as_double();
  EXPECT_NEAR(mean, 0.37083, 5e-6);
  EXPECT_NEAR(deviation, 0.12981, 1.5e-5);
  EXPECT_NEAR(std::sqrt(std::log1p(deviation * deviation / (mean * mean))), 0.34, 1e-14);
  EXPECT_NEAR(mean * mean / std::hypot(mean, deviation), 0.35, 1e-14);
}

TEST(ExportToNrml, HasSharesWhereTheLawIsRejected) {
  const RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::rejected, rejected_shares));
  pugi::xml_document document;
  const pugi::xml_node function = function_in(document, exported({run}, ExportFormat::nrml).text);
  EXPECT_STREQ(function.attribute("format").value(), "discrete");
  EXPECT_EQ(function.child("imls").attribute("noDamageLimit").as_double(), 0.125);
  EXPECT_THAT(numbers_in(function.child("imls").text().get()), ElementsAre(0.1, 0.2, 0.4, 0.8));
  EXPECT_THAT(numbers_in(function.child("poes").text().get()), ElementsAre(0.0, 0.2, 0.2, 0.9));
}

TEST(ExportToNrml, HasAllEventsOfABlockFromTheMildest) {
  RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::fitted, rejected_shares));
  ShownSuite tilt = exported_suite(stats::FragilityOutcome::rejected, {0.3, 0.4, 0.5, 1.0});
  tilt.curve.subject.event = {EventName::tilt, 0.5};
  run.suites.push_back(tilt);
  pugi::xml_document document;
  const pugi::xml_node function = function_in(document, exported({run}, ExportFormat::nrml).text);
  EXPECT_STREQ(function.parent().child("limitStates").text().get(), "tilt_0_5_psi overturning");
  EXPECT_STREQ(function.attribute("format").value(), "discrete");  // one law is missing
  const pugi::xml_node first = function.child("poes");
  EXPECT_THAT(numbers_in(first.text().get()), ElementsAre(0.0, 0.4, 0.5, 1.0));  // 0.1 does not lift the block
  EXPECT_THAT(numbers_in(first.next_sibling().text().get()), ElementsAre(0.0, 0.5, 0.5, 0.5));
  EXPECT_FALSE(function.next_sibling());
}

TEST(ExportToNrml, HasVelocitiesInCentimetresPerSecond) {
  const RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::fitted, rejected_shares), "pgv_m_s");
  const std::string text = exported({run}, ExportFormat::nrml).text;
  EXPECT_THAT(text, HasSubstr("imt=\"PGV\" noDamageLimit=\"12.5\""));
  EXPECT_THAT(text, HasSubstr("mean=\"37.08"));
}

/// The last line of a table, its fields, of which one may be quoted.
std::vector<std::string> fields_in_last_line(std::string text) {
  text.pop_back();
  text = text.substr(text.rfind('\n') + 1);
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ',' && !is_quoted) fields.emplace_back();
    if (c != '"' && (c != ',' || is_quoted)) fields.back() += c;
  }
  return fields;
}

TEST(ExportToPelicun, IsARowOfItsTable) {
  const RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::fitted, rejected_shares));
  const std::string text = exported({run}, ExportFormat::pelicun).text;
  EXPECT_THAT(text, ::testing::StartsWith("ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional,"
                                          "LS1-Family,LS1-Theta_0,LS1-Theta_1\n"));
  const std::vector<std::string> fields = fields_in_last_line(text);
  ASSERT_EQ(fields.size(), 9U);
  EXPECT_THAT(std::vector(fields.begin(), fields.begin() + 7),
              ElementsAre("A_statue_its_plinth_", "0", "Peak Ground Acceleration", "g", "0", "1", "lognormal"));
  EXPECT_NEAR(std::stod(fields[7]), 0.35, 1e-15);
  EXPECT_EQ(std::stod(fields[8]), 0.34);
}

// pelicun: from 0 to 1, both columns strictly rising, a difference below 1e-8 being none.
TEST(ExportToPelicun, HasAMultilinearDistributionOfShares) {
  for (const std::vector<double>& shares :
       {rejected_shares, {0.1, 0.2, 0.2, 0.9}, {0.0, 0.0, 0.5, 1.0}, {0.5, 1.0, 1.0, 1.0}, {0.0, 0.0, 0.0, 0.0}}) {
    const RunFragility run = exported_run(exported_suite(stats::FragilityOutcome::rejected, shares));
    const ExportedFragility found = exported({run}, ExportFormat::pelicun);
    const std::vector<std::string> fields = fields_in_last_line(found.text);
    ASSERT_EQ(fields.size(), 9U);
    EXPECT_EQ(fields[6], "multilinear_CDF");
    EXPECT_EQ(fields[8], "");
    const std::vector<double> x = numbers_in(fields[7].substr(0, fields[7].find('|')));
    const std::vector<double> y = numbers_in(fields[7].substr(fields[7].find('|') + 1));
    ASSERT_EQ(x.size(), y.size());
    EXPECT_GE(x.front(), 0.125);
    EXPECT_EQ(y.front(), 0.0);
    EXPECT_EQ(y.back(), 1.0);
    for (std::size_t i = 1; i < x.size(); ++i) {
      EXPECT_GT(x[i], x[i - 1] + 1e-8);
      EXPECT_GT(y[i], y[i - 1] + 1e-8);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double level = 0.1 * std::pow(2.0, static_cast<double>(i));
      if (level < 0.125) continue;  // the block is not lifted
      const auto at = std::find(x.begin(), x.end(), level) - x.begin();
      if (at < static_cast<std::ptrdiff_t>(x.size())) {
        EXPECT_NEAR(y[static_cast<std::size_t>(at)], shares[i], 1e-5);
      }
    }
    EXPECT_EQ(found.notices.empty(), shares.back() == 1.0);
  }
}

TEST(ExportToCsv, HasARowForEachLevel) {
  const RunFragility run =
      exported_run(exported_suite(stats::FragilityOutcome::rejected, rejected_shares), "amplitude");
  const std::string text = exported({run}, ExportFormat::csv).text;
  EXPECT_THAT(text, HasSubstr("\nA_statue_its_plinth_,overturning,amplitude,0.125,,,0.2,0.2\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
}

TEST(Export, RefusesWhatNoFunctionSays) {
  const auto complaint_of_export = [](const RunFragility& run, ExportFormat format = ExportFormat::csv) {
    try {
      static_cast<void>(exported({run}, format));
    } catch (const UnfitQuestion& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const ShownSuite good = exported_suite(stats::FragilityOutcome::fitted, rejected_shares);
  EXPECT_EQ(complaint_of_export(exported_run(good, "amplitude")), "");
  EXPECT_THAT(complaint_of_export(exported_run(good, "amplitude"), ExportFormat::nrml),
              HasSubstr("amplitude is no measure of intensity of this format"));
  EXPECT_THAT(complaint_of_export(exported_run(good, "sa_p_g"), ExportFormat::pelicun),
              HasSubstr("or give csv as `export_as`"));
  ShownSuite unresolved = good;
  unresolved.curve.levels[1].unresolved = 1;
  EXPECT_THAT(complaint_of_export(exported_run(unresolved)), HasSubstr("realisations without an answer"));
  EXPECT_THAT(complaint_of_export(exported_run(exported_suite(stats::FragilityOutcome::too_little, {0.5}))),
              HasSubstr("fewer than two levels"));
  RunFragility motion = exported_run(good);
  motion.suites.clear();
  FragilityCurve& curve = motion.curves.emplace_back().curve;
  curve.outcome = stats::FragilityOutcome::not_monotone;
  curve.levels = {{.intensity = 0.1, .overturned = {}, .estimate = 0.9},
                  {.intensity = 0.2, .overturned = {}, .estimate = 0.1}};
  EXPECT_THAT(complaint_of_export(motion), HasSubstr("shares that decrease"));
}

}  // namespace
}  // namespace rocking
