// The figure of `rocking fragility`: observed shares beside laws, and each probability by its event.

#include "rocking/studies/fragility/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/json.hpp"

namespace {

using namespace rocking::analysis;
using rocking::FragilityLevel;
using rocking::FragilityReport;
using rocking::Json;
using rocking::PooledSuite;
using rocking::RecordCurve;
using rocking::ReportedCurve;
using rocking::ReportedSuite;
using rocking::ResponseEvent;
using rocking::SuiteLevel;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

double number(const Cell& cell) { return std::get<double>(cell); }

const Layer* layer_of(const Figure& figure, LayerKind kind) {
  for (const Layer& layer : figure.panels.front().layers) {
    if (layer.kind == kind) return &layer;
  }
  return nullptr;
}

/// A suite with the law of median 0.5 and dispersion 0.5.
ReportedSuite suite(const ResponseEvent& event) {
  ReportedSuite reported{.run = {.title = "five sines"}, .curve = {}, .rate = {}};
  reported.curve.subject = {.parameter = "/excitation/pga_g", .others = {}, .event = event, .least_uplift = {}};
  PooledSuite& pooled = reported.curve.pooled.emplace();
  pooled.median.value = 0.5;
  pooled.between_records.value = 0.4;
  pooled.within_record.value = 0.3;
  RecordCurve& record = reported.curve.records.emplace_back();
  record.name = "a.at2";
  record.curve.levels.resize(2);
  record.curve.levels[0].intensity = 0.2;
  record.curve.levels[1].intensity = 0.8;
  record.curve.levels[1].estimate = 1.0;
  for (const double intensity : {0.2, 0.4, 0.8}) {
    const double z = std::log(intensity / 0.5) / 0.5;
    SuiteLevel& level = reported.curve.levels.emplace_back();
    level.intensity = intensity;
    level.records = 5;
    level.overturned = {.successes = 50, .trials = 100};
    level.estimate = 0.5 * intensity;
    level.fitted = rocking::stats::normal_cdf(z);
    level.band = {.low = rocking::stats::normal_cdf(z - 0.5), .high = rocking::stats::normal_cdf(z + 0.5)};
  }
  return reported;
}

template <class... Reported>
Figure figure_of(const Reported&... curves) {
  FragilityReport report;
  (report.curves.emplace_back(curves), ...);
  return fragility_figure(report);
}

constexpr ResponseEvent overturning_event;
constexpr ResponseEvent tilt_event{rocking::EventName::tilt, 0.5};

TEST(SuiteFigure, ShowsTheObservedSharesBesideASmoothLaw) {
  const Figure figure = figure_of(suite(overturning_event));
  const Layer* points = layer_of(figure, LayerKind::points);
  ASSERT_NE(points, nullptr);
  const Table& levels = figure.tables[points->table];
  ASSERT_EQ(levels.rows.size(), 3U);
  for (const auto& row : levels.rows) EXPECT_EQ(number(row[points->columns[1]]), 0.5 * number(row[0]));
  const auto is_law = [](const Layer& layer) { return layer.legend == "all records"; };
  const auto line = std::ranges::find_if(figure.panels.front().layers, is_law);
  ASSERT_NE(line, figure.panels.front().layers.end());
  const Table& law = figure.tables[line->table];
  EXPECT_GE(law.rows.size(), 100U);
  const Layer* ribbon = layer_of(figure, LayerKind::ribbon);
  ASSERT_NE(ribbon, nullptr);
  for (const auto& row : law.rows) {
    // Each edge is a lognormal law too, so that interpolation between the levels gives it exactly.
    const double z = std::log(number(row[0]) / 0.5) / 0.5;
    EXPECT_NEAR(number(row[line->columns[1]]), rocking::stats::normal_cdf(z), 1e-12);
    EXPECT_NEAR(number(row[ribbon->columns[1]]), rocking::stats::normal_cdf(z - 0.5), 1e-9);
    EXPECT_NEAR(number(row[ribbon->columns[2]]), rocking::stats::normal_cdf(z + 0.5), 1e-9);
  }
}

TEST(SuiteFigure, ShowsSharesAndTheirBandWithoutALawToo) {
  ReportedSuite reported = suite(overturning_event);
  reported.curve.pooled.reset();
  for (SuiteLevel& level : reported.curve.levels) {
    level.fitted.reset();
    level.band.reset();
  }
  const Figure figure = figure_of(reported);
  for (const LayerKind kind : {LayerKind::points, LayerKind::line, LayerKind::ribbon}) {
    EXPECT_NE(layer_of(figure, kind), nullptr);
  }
}

TEST(SuiteFigure, HasACurveWithItsBandForEachOption) {
  ReportedSuite wide = suite(overturning_event), narrow = wide;
  for (const auto& [reported, width] : {std::pair{&narrow, 0.35}, std::pair{&wide, 0.5}}) {
    reported->curve.subject.others = {{.pointer = "/block/width_m", .value = width}};
  }
  const Figure figure = figure_of(narrow, wide);
  std::vector<std::string> lines;
  std::size_t ribbons = 0;
  for (const Layer& layer : figure.panels.at(0).layers) {
    if (layer.kind == LayerKind::line) lines.push_back(layer.legend);
    ribbons += layer.kind == LayerKind::ribbon ? 1 : 0;
  }
  EXPECT_THAT(lines, ElementsAre("width 0.35 m, all records", "width 0.5 m, all records"));
  EXPECT_EQ(ribbons, 2U);
}

// What is tabulated and drawn is what the rate takes.
TEST(SuiteFigure, OfARejectedLawHasTheIsotonicSharesAndNoProbabilityByTheLaw) {
  ReportedSuite reported = suite(overturning_event);
  reported.curve.outcome = rocking::stats::FragilityOutcome::rejected;
  for (SuiteLevel& level : reported.curve.levels) {
    level.isotonic = 0.4 * level.intensity;
    level.isotonic_band = {.low = 0.3 * level.intensity, .high = 0.5 * level.intensity};
  }
  const Figure figure = figure_of(reported);
  for (const Table& table : figure.tables) {
    for (const auto& column : table.columns) EXPECT_EQ(column.meaning.find("law"), std::string::npos) << column.name;
  }
  const Layer* ribbon = layer_of(figure, LayerKind::ribbon);
  ASSERT_NE(ribbon, nullptr);
  const auto is_line = [](const Layer& layer) { return layer.legend == "all records"; };
  const auto line = std::ranges::find_if(figure.panels.front().layers, is_line);
  ASSERT_NE(line, figure.panels.front().layers.end());
  const Table& shares = figure.tables[line->table];
  ASSERT_EQ(shares.rows.size(), reported.curve.levels.size());
  for (const auto& row : shares.rows) {
    EXPECT_EQ(number(row[line->columns[1]]), 0.4 * number(row[0]));
    EXPECT_EQ(number(row[ribbon->columns[1]]), 0.3 * number(row[0]));
    EXPECT_EQ(number(row[ribbon->columns[2]]), 0.5 * number(row[0]));
  }
}

TEST(SuiteFigure, CallsAProbabilityByItsEvent) {
  EXPECT_EQ(figure_of(suite(overturning_event)).panels[0].y.quantity, "probability of overturning");
  const Figure of_tilt = figure_of(suite(tilt_event));
  EXPECT_EQ(of_tilt.panels[0].y.quantity, "probability of peak tilt > 0.5 psi");
  EXPECT_EQ(of_tilt.title, "Probability of peak tilt > 0.5 psi as a function of intensity");
  const Figure both = figure_of(suite(overturning_event), suite(tilt_event));
  ASSERT_EQ(both.panels.size(), 1U);
  EXPECT_EQ(both.panels[0].y.quantity, "probability");
  EXPECT_EQ(both.title, "Probability as a function of intensity");
}

TEST(FragilityFigure, CallsTheCurvesOfPeakTiltsByTheirEvent) {
  ReportedCurve reported{.run = {.title = "t"}, .curve = {}, .rate = {}};
  reported.curve.subject = {
      .parameter = "/excitation/amplitude", .others = {}, .event = tilt_event, .least_uplift = {}};
  reported.curve.outcome = rocking::stats::FragilityOutcome::does_not_rise;
  FragilityLevel& level = reported.curve.levels.emplace_back();
  level.intensity = 1.0;
  level.overturned = {.successes = 2, .trials = 10};
  level.estimate = 0.2;
  level.exact = {.low = 0.1, .high = 0.4};
  const Figure figure = figure_of(reported);
  EXPECT_EQ(figure.panels[0].y.quantity, "probability of peak tilt > 0.5 psi");
  EXPECT_EQ(layer_of(figure, LayerKind::error_bars)->legend, "peak tilt > 0.5 psi");
  EXPECT_THAT(figure.caption, HasSubstr("share of the realisations with peak tilt > 0.5"));
  EXPECT_THAT(figure.description, HasSubstr("peak tilt > 0.5"));
}

TEST(FragilityFigure, SaysWhichPointsAreRareEstimates) {
  FragilityReport report;
  ReportedSuite rare = suite({});
  rare.curve.rare = {{.intensity = 0.1, .probability = 2e-5, .interval = {1e-5, 4e-5}, .relative_error = 0.1}};
  report.curves.emplace_back(rare);
  const Figure figure = fragility_figure(report);
  const std::vector<Layer>& layers = figure.panels.front().layers;
  const auto found = std::ranges::find_if(
      layers, [](const Layer& layer) { return layer.legend.find("rare estimates") != std::string::npos; });
  ASSERT_NE(found, layers.end());
  EXPECT_EQ(found->kind, LayerKind::error_bars);
  const Table& table = figure.tables[found->table];
  ASSERT_EQ(table.rows.size(), 1U);
  const std::vector<double> expected{0.1, 2e-5, 1e-5, 4e-5};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(number(table.rows.front()[found->columns[k]]), expected[k]);
  }
  EXPECT_THAT(figure.caption, HasSubstr("rocking rare"));
  report.curves = {suite({})};
  EXPECT_THAT(fragility_figure(report).caption, ::testing::Not(HasSubstr("rocking rare")));
}

Json sample_fragility() {
  Json json = Json::parse(R"({ "format": "rocking.fragility/1", "curves": [ { "title": "t",
    "sha256": "0123456789012345678901234567890123456789012345678901234567890123", "parameter": "/excitation/amplitude",
    "others": {}, "confidence": 0.9, "event": "overturned", "least_uplift": null, "outcome": "rejected", "law": null,
    "test": { "deviance": 40.5, "samples": 999, "as_large": 0, "p_value": 0.001 }, "missed_levels": null,
    "levels": [] } ] })");
  const std::vector<std::array<double, 5>> levels{
      {1.0, 2, 0.02, 0.01, 0.1}, {2.0, 54, 0.5, 0.4, 0.6}, {4.0, 46, 0.5, 0.3, 0.7}};
  for (const auto& [intensity, overturned, isotonic, low, high] : levels) {
    json["curves"][0]["levels"].push_back({{"intensity", intensity},
                                           {"realisations", 100},
                                           {"overturned", static_cast<int>(overturned)},
                                           {"estimate", overturned / 100.0},
                                           {"exact", {low, high}},
                                           {"simultaneous", {low, high}},
                                           {"fitted", nullptr},
                                           {"band", {low, high}},
                                           {"isotonic", isotonic}});
  }
  return json;
}

TEST(FragilityFigure, DrawsTheIsotonicEstimateAsStepsWithTheBandBetweenLevels) {
  const auto figures = output_figures({{"f.json", sample_fragility().dump()}}, {});
  const Figure& figure = figures.at(0);
  const auto& layers = figure.panels.at(0).layers;
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].kind, LayerKind::boxes);
  EXPECT_THAT(layers[0].columns, ElementsAre(0U, 1U, 3U, 4U));
  EXPECT_EQ(layers[1].kind, LayerKind::steps);
  EXPECT_EQ(layers[2].kind, LayerKind::error_bars);
  EXPECT_THAT(figure.tables.at(layers[0].table).rows,
              ElementsAre(ElementsAre(Cell(1.0), Cell(2.0), Cell(0.02), Cell(0.01), Cell(0.6)),
                          ElementsAre(Cell(2.0), Cell(4.0), Cell(0.5), Cell(0.4), Cell(0.7)),
                          ElementsAre(Cell(4.0), Cell(4.0), Cell(0.5), Cell(0.3), Cell(0.7))));
  EXPECT_THAT(figure.caption, HasSubstr("do not decrease"));
  EXPECT_THAT(figure.description, HasSubstr("rejected"));
}

TEST(FragilityFigure, SaysThatAMedianIsExtrapolated) {
  Json json = sample_fragility();
  Json& curve = json["curves"][0];
  curve["outcome"] = "fitted";
  curve["missed_levels"] = 0;
  curve["law"] = Json::parse(R"({ "median": { "value": 5.5, "interval": [4.5, null], "extrapolated": true },
    "dispersion": { "value": 0.5, "interval": [0.25, 1.0] }, "centre": 0.7, "intercept": -1.0, "slope": 2.0,
    "covariance": [0.01, 0.0, 0.01], "degrees_of_freedom": 40 })");
  for (Json& level : curve["levels"]) {
    level["fitted"] = level["isotonic"];
    level["isotonic"] = nullptr;
  }
  const auto described = [](const Json& output) {
    return output_figures({{"f.json", output.dump()}}, {}).at(0).description;
  };
  EXPECT_THAT(described(json), HasSubstr("median 5.5 [4.5, unbounded] (extrapolated"));
  curve["law"]["median"]["extrapolated"] = false;
  EXPECT_THAT(described(json), HasSubstr("median 5.5 [4.5, unbounded], dispersion"));
}

TEST(FragilityFigure, RefusesLevelsThatContradictThemselves) {
  const auto refusal = [](const char* key, const Json& value) -> std::string {
    Json json = sample_fragility();
    json["curves"][0]["levels"][1][key] = value;
    try {
      static_cast<void>(output_figures({{"f.json", json.dump()}}, {}));
    } catch (const rocking::base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal("overturned", 100), "accepted");
  EXPECT_THAT(refusal("overturned", 101), HasSubstr("/curves/0/levels/1/overturned"));
  EXPECT_THAT(refusal("intensity", 1.0), HasSubstr("not greater than that of the previous level"));
  EXPECT_THAT(refusal("exact", {0.6, 0.4}), HasSubstr("/curves/0/levels/1/exact"));
}

}  // namespace
