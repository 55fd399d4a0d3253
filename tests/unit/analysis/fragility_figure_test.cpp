// The figure of `rocking fragility`: observed shares beside laws, and each probability by its event.

#include "analysis/fragility_figure.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/stats/normal_law.hpp"
#include "rocking/text/json.hpp"

namespace {

using namespace rocking::analysis;
using rocking::Json;
using ::testing::HasSubstr;

double number(const Cell& cell) { return std::get<double>(cell); }

const Layer* layer_of(const Figure& figure, LayerKind kind) {
  for (const Layer& layer : figure.panels.front().layers) {
    if (layer.kind == kind) return &layer;
  }
  return nullptr;
}

/// A suite with the law of median 0.5 and dispersion 0.5.
Json suite(const Json& event) {
  Json curve = Json::parse(R"({ "title": "five sines", "sha256": "a", "parameter": "/excitation/pga_g", "others": {},
    "confidence": 0.95, "outcome": "fitted",
    "pooled": { "median": { "value": 0.5, "interval": [0.4, 0.6] }, "dispersion": { "value": 0.5, "interval": [0.3, 0.8] },
                "between_records": { "value": 0.4 }, "within_record": { "value": 0.3 } },
    "records": [ { "name": "a.at2", "levels": [ { "intensity": 0.2, "estimate": 0.0 }, { "intensity": 0.8, "estimate": 1.0 } ] } ],
    "levels": [] })");
  curve["event"] = event;
  for (const double intensity : {0.2, 0.4, 0.8}) {
    const double z = std::log(intensity / 0.5) / 0.5;
    curve["levels"].push_back({{"intensity", intensity},
                               {"records", 5},
                               {"realisations", 100},
                               {"overturned", 50},
                               {"estimate", 0.5 * intensity},
                               {"fitted", rocking::stats::normal_cdf(z)},
                               {"band", {rocking::stats::normal_cdf(z - 0.5), rocking::stats::normal_cdf(z + 0.5)}}});
  }
  return curve;
}

Figure figure_of(const std::vector<Json>& curves) {
  return fragility_figures({{"format", "rocking.fragility/1"}, {"curves", curves}}).at(0);
}

TEST(SuiteFigure, ShowsTheObservedSharesBesideASmoothLaw) {
  const Figure figure = figure_of({suite("overturned")});
  const Layer* points = layer_of(figure, LayerKind::points);
  ASSERT_NE(points, nullptr);
  const Table& levels = figure.tables[points->table];
  ASSERT_EQ(levels.rows.size(), 3U);
  for (const auto& row : levels.rows) EXPECT_EQ(number(row[points->columns[1]]), 0.5 * number(row[0]));
  const auto is_law = [](const Layer& layer) { return layer.legend == "overturned, all records"; };
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

TEST(SuiteFigure, ShowsTheObservedSharesWithoutALawToo) {
  Json curve = suite("overturned");
  curve["pooled"] = nullptr;
  for (Json& level : curve["levels"]) level["fitted"] = level["band"] = nullptr;
  const Figure figure = figure_of({curve});
  const Layer* points = layer_of(figure, LayerKind::points);
  ASSERT_NE(points, nullptr);
}

TEST(SuiteFigure, CallsAProbabilityByItsEvent) {
  const Json tilt = {{"peak_tilt", 0.5}};
  EXPECT_EQ(figure_of({suite("overturned")}).panels[0].y.quantity, "probability of overturning");
  const Figure tilted = figure_of({suite(tilt)});
  EXPECT_EQ(tilted.panels[0].y.quantity, "probability of peak tilt > 0.5");
  EXPECT_EQ(tilted.title, "Probability of peak tilt > 0.5 as a function of intensity");
  const Figure both = figure_of({suite("overturned"), suite(tilt)});
  ASSERT_EQ(both.panels.size(), 1U);
  EXPECT_EQ(both.panels[0].y.quantity, "probability");
  EXPECT_EQ(both.title, "Probability as a function of intensity");
}

TEST(FragilityFigure, CallsTheCurvesOfPeakTiltsByTheirEvent) {
  Json curve = Json::parse(R"({ "title": "t", "sha256": "a", "parameter": "/excitation/amplitude", "others": {},
    "confidence": 0.95, "outcome": "does_not_rise", "law": null, "event": { "peak_tilt": 0.5 },
    "levels": [ { "intensity": 1.0, "realisations": 10, "overturned": 2, "estimate": 0.2, "exact": [0.1, 0.4] } ] })");
  const Figure figure = figure_of({curve});
  EXPECT_EQ(figure.panels[0].y.quantity, "probability of peak tilt > 0.5");
  EXPECT_EQ(layer_of(figure, LayerKind::error_bars)->legend, "peak tilt > 0.5");
  EXPECT_THAT(figure.caption, HasSubstr("share of the realisations with peak tilt > 0.5"));
  EXPECT_THAT(figure.description, HasSubstr("peak tilt > 0.5"));
}

}  // namespace
