// What counted tests say of unknown numbers as figures: their numbers are those of infer.json.

#include "rocking/studies/infer/study.hpp"

#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

namespace {

using rocking::InferReport;
using rocking::analysis::Cell;
using rocking::analysis::Figure;
using rocking::analysis::infer_figures;
using rocking::analysis::Layer;
using rocking::analysis::LayerKind;
using rocking::analysis::Panel;
using rocking::analysis::Table;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two unknowns on grids of 3 and 2 points, of which the likely ones are known; the estimate lies between the points.
InferReport two_unknowns() {
  InferReport report;
  report.unknowns = {{.parameter = "/friction/static",
                      .from = 0.0,
                      .to = 1.0,
                      .estimate = 0.3,
                      .interval = rocking::stats::Interval{.low = 0.1, .high = 0.45},
                      .reaches = rocking::ReachedBound::none,
                      .profile = {{0.2, 0.5}, {0.4, 0.25}, {0.8, 0.0}}},
                     {.parameter = "/initial/tilt",
                      .from = 0.0,
                      .to = 3.0,
                      .estimate = 1.0,
                      .interval = rocking::stats::Interval{.low = 0.5, .high = 2.5},
                      .reaches = rocking::ReachedBound::none,
                      .profile = {{1.0, 1.0}, {2.0, 0.5}}}};
  report.fit = rocking::InferenceFit{.statistic = 3.21, .p_value = 0.4};
  report.region_limit = 0.03;
  report.region = {{{0.2, 1.0}, 0.3}, {{0.4, 1.0}, 0.25}, {{0.2, 2.0}, 0.5}, {{0.3, 1.0}, 1.0}};
  report.groups = {"(1,1)", "other"};
  report.tests = {{.parameters = {{"/excitation/amplitude", 4.5}},
                   .counts = {3, 1},
                   .predicted = {0.6, 0.4},
                   .intervals = {{0.19, 0.99}, {0.01, 0.81}}},
                  {.parameters = {{"/excitation/amplitude", 5.5}},
                   .counts = {0, 2},
                   .predicted = {0.1, 0.9},
                   .intervals = {{0.0, 0.84}, {0.16, 1.0}}}};
  report.candidates = {{.parameters = {{"/excitation/amplitude", 3}}, .region = 0.9, .deviations = {0.95, 0.7}},
                       {.parameters = {{"/excitation/amplitude", 8}}, .region = 0.8, .deviations = {0.85, 1.0}}};
  return report;
}

Figure figure_named(const std::string& name, const InferReport& report) {
  for (const Figure& figure : infer_figures(report)) {
    if (figure.name == name) return figure;
  }
  return {};
}

std::vector<double> column_of(const Table& table, std::size_t column) {
  std::vector<double> numbers;
  for (const auto& row : table.rows) numbers.push_back(std::get<double>(row[column]));
  return numbers;
}

/// The columns of the first layer of a panel with this kind and entry in the legend; none if it has no such layer.
std::vector<std::vector<double>> layer_of(const Figure& figure, std::size_t panel, LayerKind kind,
                                          const std::string& legend) {
  std::vector<std::vector<double>> columns;
  for (const Layer& layer : figure.panels.at(panel).layers) {
    if (layer.kind != kind || layer.legend != legend) continue;
    for (const std::size_t column : layer.columns) columns.push_back(column_of(figure.tables[layer.table], column));
    break;
  }
  return columns;
}

TEST(InferFigures, DrawTheLikelihoodOfEachUnknownWithItsEstimateAndInterval) {
  const Figure figure = figure_named("infer_profile", two_unknowns());
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_THAT(layer_of(figure, 0, LayerKind::line, "likelihood over the largest one"),
              ElementsAre(ElementsAre(0.2, 0.3, 0.4, 0.8), ElementsAre(0.5, 1.0, 0.25, 0.0)));
  EXPECT_THAT(layer_of(figure, 0, LayerKind::spans, "95 % interval"), ElementsAre(ElementsAre(0.1), ElementsAre(0.45)));
  EXPECT_THAT(layer_of(figure, 0, LayerKind::points, "estimate"), ElementsAre(ElementsAre(0.3), ElementsAre(1.0)));
  EXPECT_THAT(layer_of(figure, 1, LayerKind::line, "likelihood over the largest one"),
              ElementsAre(ElementsAre(1.0, 2.0), ElementsAre(1.0, 0.5)))
      << "an estimate on the grid is not drawn twice";
  EXPECT_THAT(layer_of(figure, 1, LayerKind::spans, "95 % interval"), ElementsAre(ElementsAre(0.5), ElementsAre(2.5)));
}

TEST(InferFigures, SayWhetherTheTestsCanTellAndFit) {
  InferReport report = two_unknowns();
  const std::string words = figure_named("infer_profile", report).description;
  EXPECT_THAT(words, HasSubstr("static friction μ_s: 0.3 [0.1, 0.45]"));
  EXPECT_THAT(figure_named("infer_profile", report).subtitle, HasSubstr("static friction μ_s: 0.3 [0.1, 0.45]; "));
  EXPECT_THAT(words, HasSubstr("Identified: yes, all intervals end within"));
  EXPECT_THAT(words,
              HasSubstr("p = 0.4: there are as many unknowns as independent counts, so that nothing is left to test"));
  EXPECT_THAT(figure_named("infer_fit", report).description,
              HasSubstr("deviance 3.21, p = 0.4: there are as many unknowns"));
  report.identified = {"these tests cannot tell: this one"};
  report.fit->p_value = 0.04;
  EXPECT_THAT(figure_named("infer_profile", report).description, HasSubstr("Identified: no, these tests cannot tell"));
  EXPECT_THAT(figure_named("infer_profile", report).subtitle, Not(HasSubstr("0.3")));
  EXPECT_THAT(figure_named("infer_fit", report).description, HasSubstr("p = 0.04: no value of the unknowns explains"));
}

// Each of 245 conditions has the same random numbers: the errors of 50 realisations may be alike in all of them.
TEST(InferFigures, SayThatRealisationsAreTooFewForManyConditionsOfOneTest) {
  InferReport report = two_unknowns();
  rocking::ReportedTests test = report.tests.front();
  test.counts = {1, 0};
  report.tests.assign(245, test);
  report.design = {{.at = {0.5, 0.5}, .counts = std::vector<std::vector<std::uint64_t>>(245, {20, 30})}};
  const auto found = rocking::too_few_realisations(report);
  ASSERT_TRUE(found);
  EXPECT_THAT(*found, AllOf(HasSubstr("the errors of 50 realisations of a condition"), HasSubstr("alike in all 245"),
                            HasSubstr("4.9 times the variance of the tests"), HasSubstr("from 817 realisations on")));
  EXPECT_THAT(figure_named("infer_profile", report).description, HasSubstr("Warning: the errors of 50 realisations"));
  EXPECT_THAT(rocking::infer_table(report), HasSubstr("warning: the errors of 50 realisations"));
  EXPECT_THAT(rocking::infer_document().text(report), HasSubstr("\"too_few_realisations\": \"" + *found));
  report.design.front().counts.assign(245, {400, 417});
  EXPECT_EQ(rocking::too_few_realisations(report), std::nullopt);
}

// Cells end halfway to the next points of the grid; the first and last end at their points.
TEST(InferFigures, MapTheRegionOfTwoUnknowns) {
  const Figure figure = figure_named("infer_region", two_unknowns());
  ASSERT_EQ(figure.panels.size(), 1U);
  const auto boxes = [&](const std::string& legend) { return layer_of(figure, 0, LayerKind::boxes, legend); };
  using ::testing::DoubleEq;
  EXPECT_THAT(boxes("likelihood ratio 0.2 to 0.5"),
              ElementsAre(ElementsAre(0.2), ElementsAre(DoubleEq(0.6)), ElementsAre(1.0), ElementsAre(1.5)))
      << "neighbours in a row are one box";
  EXPECT_THAT(boxes("likelihood ratio 0.5 to 1"),
              ElementsAre(ElementsAre(0.2), ElementsAre(DoubleEq(0.3)), ElementsAre(1.5), ElementsAre(2.0)));
  EXPECT_EQ(figure.panels[0].layers.size(), 3U) << "nothing is drawn outside of the region";
  EXPECT_THAT(layer_of(figure, 0, LayerKind::points, "estimate"), ElementsAre(ElementsAre(0.3), ElementsAre(1.0)));
  EXPECT_THAT(figure.caption, HasSubstr("at least 0.03"));
}

TEST(InferFigures, MapEachPairOfThreeUnknownsByTheLargestLikelihood) {
  InferReport report = two_unknowns();
  report.unknowns.push_back({.parameter = "/restitution",
                             .from = 0.0,
                             .to = 1.0,
                             .estimate = 0.7,
                             .interval = rocking::stats::Interval{.low = 0.0, .high = 1.0},
                             .reaches = rocking::ReachedBound::both,
                             .profile = {{0.6, 0.6}, {0.7, 1.0}}});
  report.candidates.clear();
  report.region = {{{0.2, 1.0, 0.6}, 0.6}, {{0.2, 1.0, 0.7}, 0.3}, {{0.3, 1.0, 0.7}, 1.0}};
  const Figure figure = figure_named("infer_region", report);
  ASSERT_EQ(figure.panels.size(), 3U);
  EXPECT_THAT(layer_of(figure, 0, LayerKind::boxes, "likelihood ratio 0.5 to 1").at(3), ElementsAre(1.5));
  EXPECT_THAT(layer_of(figure, 0, LayerKind::boxes, "likelihood ratio 0.2 to 0.5"), ElementsAre())
      << "the smaller one of the same pair is hidden";
  EXPECT_EQ(figure.panels[1].y.quantity, "restitution");
  EXPECT_THAT(layer_of(figure, 1, LayerKind::boxes, "likelihood ratio 0.2 to 0.5").at(2),
              ElementsAre(::testing::DoubleEq(0.65)));
  EXPECT_THAT(layer_of(figure, 2, LayerKind::points, "estimate"), ElementsAre(ElementsAre(1.0), ElementsAre(0.7)));
  InferReport one = two_unknowns();
  one.unknowns.pop_back();
  one.candidates.clear();
  one.region = {{{0.2}, 0.5}};
  EXPECT_EQ(figure_named("infer_region", one).name, "") << "the likelihood of one unknown shows its region";
}

TEST(InferFigures, DrawCountedBesidePredictedShares) {
  const Figure figure = figure_named("infer_fit", two_unknowns());
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.panels[1].title, "base amplitude 5.5");
  EXPECT_THAT(layer_of(figure, 0, LayerKind::boxes, "predicted by the estimate").at(3), ElementsAre(0.6, 0.4));
  EXPECT_THAT(layer_of(figure, 1, LayerKind::boxes, "predicted by the estimate").at(3), ElementsAre(0.1, 0.9));
  EXPECT_THAT(
      layer_of(figure, 0, LayerKind::error_bars, ""),
      ElementsAre(ElementsAre(0, 1), ElementsAre(0.75, 0.25), ElementsAre(0.19, 0.01), ElementsAre(0.99, 0.81)));
  EXPECT_THAT(layer_of(figure, 1, LayerKind::points, "counted"), ElementsAre(ElementsAre(0, 1), ElementsAre(0.0, 1.0)));
  EXPECT_EQ(figure.panels[0].x.ticks[1].text, "other");
}

TEST(InferFigures, DrawWhatCandidatesWouldTell) {
  const Figure figure = figure_named("infer_candidates", two_unknowns());
  ASSERT_EQ(figure.panels.size(), 1U);
  EXPECT_THAT(layer_of(figure, 0, LayerKind::points, "joint region").at(1), ElementsAre(0.9, 0.8));
  EXPECT_THAT(layer_of(figure, 0, LayerKind::points, "static friction").at(1), ElementsAre(0.95, 0.85));
  EXPECT_THAT(layer_of(figure, 0, LayerKind::points, "initial tilt").at(1), ElementsAre(0.7, 1.0));
  EXPECT_EQ(figure.panels[0].x.ticks[1].text, "8");
  EXPECT_THAT(figure.description, HasSubstr("base amplitude 8"));
}

TEST(InferFigures, HaveNothingWithoutAnAnswerNorCandidates) {
  EXPECT_TRUE(infer_figures({}).empty());
  InferReport report = two_unknowns();
  report.candidates.clear();
  EXPECT_EQ(figure_named("infer_candidates", report).name, "");
  EXPECT_EQ(infer_figures(report).size(), 3U);
}

}  // namespace
