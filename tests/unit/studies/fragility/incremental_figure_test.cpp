// The figure of an incremental dynamic analysis: numbers of the file, and a flat line for what overturned.

#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/studies/incremental/look.hpp"

namespace {

using rocking::Json;
using rocking::analysis::Figure;
using rocking::analysis::incremental_figure;
using rocking::analysis::Layer;
using rocking::analysis::Table;
using ::testing::HasSubstr;

/// Two records and three levels; the second record overturns at the second level and stands at the third.
Json analysed() {
  return Json::parse(R"({ "format": "rocking.fragility/1", "curves": [], "incremental": [ {
    "title": "two", "sha256": "0123456789012345678901234567890123456789012345678901234567890123", "parameter": "/excitation/pga_g", "others": {},
    "resurrections": { "trials": 3, "of": 4 },
    "levels": [
      { "intensity": 0.2, "realisations": 8, "overturned": 0, "quantiles": [[0.16, 0.1], [0.5, 0.2], [0.84, 0.3]] },
      { "intensity": 0.4, "realisations": 8, "overturned": 4, "quantiles": [[0.16, 0.2], [0.5, 0.6], [0.84, null]] },
      { "intensity": 0.6, "realisations": 8, "overturned": 1, "quantiles": [[0.16, 0.4], [0.5, 0.7], [0.84, 0.9]] } ],
    "records": [
      { "name": "records/a.at2", "resurrections": { "trials": 0, "of": 0 }, "levels": [
        { "intensity": 0.2, "realisations": 4, "overturned": 0, "quantiles": [[0.16, 0.1], [0.5, 0.1], [0.84, 0.1]] },
        { "intensity": 0.4, "realisations": 4, "overturned": 0, "quantiles": [[0.16, 0.2], [0.5, 0.3], [0.84, 0.4]] },
        { "intensity": 0.6, "realisations": 4, "overturned": 0, "quantiles": [[0.16, 0.3], [0.5, 0.5], [0.84, 0.6]] } ] },
      { "name": "records/b.at2", "resurrections": { "trials": 3, "of": 4 }, "levels": [
        { "intensity": 0.2, "realisations": 4, "overturned": 0, "quantiles": [[0.16, 0.2], [0.5, 0.2], [0.84, 0.3]] },
        { "intensity": 0.4, "realisations": 4, "overturned": 4, "quantiles": [[0.16, null], [0.5, null], [0.84, null]] },
        { "intensity": 0.6, "realisations": 4, "overturned": 1, "quantiles": [[0.16, 0.7], [0.5, 0.8], [0.84, null]] }
      ] } ] } ] })");
}

Figure only_figure(const Json& output) {
  return incremental_figure(rocking::fragility_document().read(output).incremental).value();
}

std::vector<double> drawn_by(const Figure& figure, const Layer& layer) {
  std::vector<double> heights;
  for (const auto& row : figure.tables[layer.table].rows) heights.push_back(std::get<double>(row[layer.columns[1]]));
  return heights;
}

TEST(IncrementalFigure, DrawsOverturnedQuantilesOnAFlatLineAboveAllTilts) {
  const Figure figure = only_figure(analysed());
  ASSERT_EQ(figure.panels.size(), 1U);
  const auto& panel = figure.panels.front();
  const double flat = panel.y.ticks.back().place;
  EXPECT_GT(flat, 0.9);
  EXPECT_LT(flat, *panel.y.high);
  ASSERT_EQ(panel.layers.size(), 6U);  // the flat line, two records, three quantiles of all
  EXPECT_THAT(drawn_by(figure, panel.layers[0]), ::testing::Each(flat));
  EXPECT_THAT(drawn_by(figure, panel.layers[1]), ::testing::ElementsAre(0.1, 0.3, 0.5));
  EXPECT_THAT(drawn_by(figure, panel.layers[2]), ::testing::ElementsAre(0.2, flat, 0.8));
  EXPECT_THAT(drawn_by(figure, panel.layers[4]), ::testing::ElementsAre(0.2, 0.6, 0.7));
  EXPECT_THAT(drawn_by(figure, panel.layers[5]), ::testing::ElementsAre(0.3, flat, 0.9));
  EXPECT_GT(panel.layers[4].style.width, panel.layers[1].style.width);
  EXPECT_THAT(figure.description, HasSubstr("3 of 4 realisations"));
}

TEST(IncrementalFigure, ShowsReadersTheQuantilesWithoutPlacesOfTheFlatLine) {
  const Figure figure = only_figure(analysed());
  std::vector<const Table*> shown;
  for (const Table& table : figure.tables) {
    if (!table.only_drawn) shown.push_back(&table);
  }
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0]->columns.at(2).meaning, "b.at2");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(shown[0]->rows.at(1).at(2)));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(shown[1]->rows.at(1).at(5)));
  EXPECT_EQ(std::get<double>(shown[1]->rows.at(2).at(5)), 0.9);
}

TEST(IncrementalFigure, IsThereOnlyWithAnAnalysisAndRefusesOtherFiles) {
  EXPECT_FALSE(incremental_figure({}).has_value());
  Json broken = analysed();
  broken["incremental"][0]["levels"][0].erase("quantiles");
  EXPECT_THROW(static_cast<void>(only_figure(broken)), rocking::base::InputError);
  Json still = analysed();  // no tilt at all
  for (Json& level : still["incremental"][0]["levels"]) level["quantiles"] = {{0.16, 0.0}, {0.5, 0.0}, {0.84, 0.0}};
  still["incremental"][0]["records"] = Json::array();
  EXPECT_GT(only_figure(still).panels.front().y.ticks.back().place, 0.0);
}

}  // namespace
