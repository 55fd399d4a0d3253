// What stands at the top of report.html, and drawings that suit one condition, categories, slices and suites.

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/page/figure_section.hpp"
#include "analysis/page/page.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/tables.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/output/report.hpp"
#include "support/sample_report.hpp"

namespace {

using rocking::Json;
using rocking::Report;
using rocking::report_in;
using rocking::ReportedCondition;
using rocking::support::sample_report;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using namespace rocking::analysis;

std::string page_of(const Report& report, const std::vector<Figure>& others = {}) {
  std::vector<DrawnFigure> drawn;
  for (const Figure& figure : run_figures(report)) drawn.push_back({figure, "<svg/>"});
  for (const Figure& figure : others) drawn.push_back({figure, "<svg/>"});
  return page_text(report, drawn);
}

/// The first condition of the sample, with nothing swept.
Report lone_condition() {
  Json json = sample_report();
  json["input"]["experiment"].erase("sweep");
  Json& conditions = json["result"]["conditions"];
  conditions.erase(conditions.begin() + 1, conditions.end());
  conditions[0]["parameters"] = Json::object();
  Report report = report_in(std::move(json));
  report.conditions.front().result.peaks.tilt = {.realisations = 30,
                                                 .beyond = 0,
                                                 .levels = {{.level = 0.05, .value = 0.1, .low = {}, .high = 0.2},
                                                            {.level = 0.5, .value = 0.3, .low = 0.2, .high = 0.4},
                                                            {.level = 0.95, .value = 0.6, .low = 0.5, .high = {}}}};
  return report;
}

/// Six amplitudes and frictions, more than have their own panels.
Report many_slices(std::size_t count) {
  Report report = report_in(sample_report());
  const std::vector<ReportedCondition> three(report.conditions.begin(), report.conditions.begin() + 3);
  report.conditions.clear();
  for (std::size_t slice = 0; slice < count; ++slice) {
    for (ReportedCondition condition : three) {
      condition.asked.parameters.at(0).value =
          rocking::WrittenPart{Json({{"static", 0.4 + 0.01 * static_cast<double>(slice)}, {"kinetic", 0.3}}).dump()};
      report.conditions.push_back(std::move(condition));
    }
  }
  return report;
}

TEST(PageOfOneCondition, HasBarsAndNumbersInPlaceOfChartsWithOnePoint) {
  const Report report = lone_condition();
  const std::string page = page_of(report);
  EXPECT_THAT(page, Not(HasSubstr("data-figure")));
  EXPECT_THAT(page, Not(HasSubstr("\"quantity\":\"the only condition\"")));
  const auto& modes = report.conditions.front().result.modes;
  std::size_t bars = 0;
  for (auto at = page.find("<svg class=\"share\""); at != std::string::npos;
       at = page.find("<svg class=\"share\"", at + 1))
    ++bars;
  EXPECT_EQ(bars, report.occurring().size());
  EXPECT_LE(bars, modes.size());
  EXPECT_THAT(page, AllOf(HasSubstr("<rect width=\"100.00\""), HasSubstr("M80.00 5H100.00")))
      << "30 of 30 respond (1,1)";
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">largest tilt |Θ|</th><td>0.3 "));
}

TEST(PageOfASweep, HasQuestionAnswerAndOneFigureBeforeAnythingElse) {
  const std::string page = page_of(report_in(sample_report()));
  const std::size_t question = page.find("A block 1 m wide");
  const std::size_t answer = page.find("<dt>Overturning</dt>");
  const std::size_t figure = page.find("<figure id=\"mode_bands\"");
  EXPECT_LT(question, answer);
  EXPECT_LT(answer, figure);
  const std::size_t first_card = page.find("class=\"card\"");
  ASSERT_NE(first_card, std::string::npos);
  for (const std::size_t place :
       {figure, page.find("<svg class=\"mode\""), page.find("(<i>m</i>,<i>n</i>): the block rocks")})
    EXPECT_LT(place, first_card);
  EXPECT_EQ(figure, page.find("<figure "));
  EXPECT_EQ(page.find("<figure id=\"mode_bands\"", figure + 1), std::string::npos) << "once";
}

TEST(PageOfASuite, HasThePooledAnswerBeforeTheFirstChartOfARecord) {
  Figure fragility;
  fragility.name = "fragility";
  fragility.title = "Probability of overturning";
  fragility.description = "The block overturns.\nwidth 1 m: median 0.36.\nwidth 2 m: median 0.72.";
  fragility.panels.push_back({.title = "", .x = {}, .y = {}, .layers = {}});
  fragility.tables = {{.name = "levels", .columns = {{"intensity", "intensity"}}, .rows = {{0.5}}}};
  const std::string page = page_of(report_in(sample_report()), {fragility});
  const std::size_t answer = page.find("<p class=\"headline\">The block overturns.</p>");
  ASSERT_NE(answer, std::string::npos);
  const std::size_t figure = page.find("<figure id=\"fragility\"");
  EXPECT_LT(figure, page.find(">width 1 m: median 0.36.</p>\n<p class=\"description\">width 2 m: median 0.72.</p>"));
  EXPECT_LT(answer, figure);
  EXPECT_EQ(figure, page.find("<figure "));
  EXPECT_LT(figure, page.find("<figure id=\"mode_bands\""));
  EXPECT_LT(page.find("<section id=\"fragility\""), page.find("<section id=\"responses\"")) << "its numbers too";
  EXPECT_THAT(page, Not(HasSubstr("most likely at friction")));
}

TEST(TheAnswer, SaysThatOneRealisationSufficesWhereAllRespondAlike) {
  const std::string claim = "one realisation of each suffices for the response mode";
  Report report = report_in(sample_report());
  EXPECT_THAT(answer_in_brief(report), Not(HasSubstr(claim)));
  for (ReportedCondition& condition : report.conditions) {
    condition.result.non_recurrence->differ = 0.0;
    condition.result.non_recurrence->differ_interval = {.low = 0.0, .high = 0.125};
  }
  EXPECT_THAT(answer_in_brief(report),
              AllOf(HasSubstr("Within each condition all"), HasSubstr(claim), HasSubstr("at most 12.5 % (95 %)")));
  report.conditions.front().asked.record_stream = 1;
  EXPECT_THAT(recurrence_in_brief(report), AllOf(HasSubstr("Under each ground motion"), HasSubstr(claim)));
  auto& mode = report.conditions.front().result.modes.back();
  mode.mode = {.kind = rocking::section::ResponseKind::unresolved};
  mode.probability.counts.successes = 3;
  mode.probability.estimate = 0.1;
  EXPECT_THAT(answer_in_brief(report), AllOf(Not(HasSubstr(claim)), HasSubstr("Not known")));
}

TEST(ModeBands, OfManySlicesAreStripsOfOnePanel) {
  EXPECT_EQ(mode_bands(many_slices(6)).panels.size(), 6U);
  const Figure figure = mode_bands(many_slices(7));
  ASSERT_EQ(figure.panels.size(), 1U);
  const Panel& panel = figure.panels.front();
  ASSERT_EQ(panel.y.ticks.size(), 7U);
  EXPECT_EQ(panel.y.ticks.at(1).text, "0.41/0.3");
  EXPECT_GT(panel.strip, 0.5);
  const Table& strips = figure.tables.at(panel.layers.front().table);
  ASSERT_EQ(strips.rows.size(), 21U);
  for (std::size_t i = 0; i < strips.rows.size(); ++i) {
    const auto edge = [&](const Layer& layer, std::size_t place) {
      return std::get<double>(strips.rows[i][layer.columns[place]]);
    };
    const double middle = static_cast<double>(i / 3) + 0.5;
    EXPECT_NEAR(edge(panel.layers.front(), 2), middle - 0.5 * panel.strip, 1e-12);
    EXPECT_NEAR(std::get<double>(strips.rows[i].back()), middle + 0.5 * panel.strip, 1e-12);
    EXPECT_GT(*panel.y.high, edge(panel.layers.back(), 3));
  }
}

TEST(FiguresOfManySlices, DrawThemAllOrSayHowManyAreLeftOut) {
  const Figure all = mode_bands(many_slices(60));
  EXPECT_EQ(all.panels.front().y.ticks.size(), 60U);
  EXPECT_THAT(all.caption, Not(HasSubstr("are drawn")));
  EXPECT_THAT(mode_bands(many_slices(48)).caption, Not(HasSubstr("are drawn")));
  const Figure first = mode_bands(many_slices(230));
  EXPECT_EQ(first.panels.front().y.ticks.size(), 200U);
  EXPECT_THAT(first.caption, HasSubstr(" Of 230 combinations of the other parameters the first 200 are drawn"));
  EXPECT_THAT(mode_probabilities(many_slices(60)).caption,
              HasSubstr(" Of 60 combinations of the other parameters the first 48"));
}

TEST(FiguresOfManySlices, AreFolded) {
  const auto folded = [](const Report& report, const char* id) {
    const std::string page = page_of(report);
    const std::size_t figure = page.find(std::string("<figure id=\"") + id + '"');
    EXPECT_NE(figure, std::string::npos) << id;
    return page.rfind("<details class=\"folded\">", figure) > page.rfind("</figure>", figure) &&
           page.rfind("<details class=\"folded\">", figure) != std::string::npos;
  };
  EXPECT_FALSE(folded(many_slices(2), "mode_probabilities"));
  EXPECT_TRUE(folded(many_slices(7), "mode_probabilities"));
  EXPECT_TRUE(folded(many_slices(13), "non_recurrence"));
}

TEST(ChartsOfSlices, HaveEachItsOwnRibbon) {
  Report report = many_slices(2);
  for (ReportedCondition& condition : report.conditions)
    condition.result.peaks = lone_condition().conditions.front().result.peaks;
  const Figure figure = quantile_figures(report).front();
  const std::string html = figure_html({figure, "<svg/>"});
  const std::string mark = "id=\"data-peak_tilt\">";
  const std::size_t begin = html.find(mark) + mark.size();
  const Json layers = Json::parse(html.substr(begin, html.find("</script>", begin) - begin))["panels"][0]["layers"];
  std::size_t ribbons = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i]["kind"] != "ribbon") continue;
    ++ribbons;
    EXPECT_EQ(layers[i]["group"], i + 1) << "the median that follows";
  }
  EXPECT_EQ(ribbons, 2U);
}

TEST(TablesOfAPage, HaveHeadsThatAReaderKnowsAndIntervalsBesideTheirNumbers) {
  Report report = many_slices(1);
  for (ReportedCondition& condition : report.conditions)
    condition.result.peaks = lone_condition().conditions.front().result.peaks;
  const std::string html = tables_html(report, quantile_figures(report).front());
  EXPECT_THAT(html, AllOf(HasSubstr(">of these overturned</th>"), HasSubstr(">median <span class=\"interval\">[95 %"),
                          HasSubstr("<td>0.3 <span class=\"interval\">[0.2, 0.4]</span></td>"),
                          HasSubstr("<td>0.1 <span class=\"interval\">[open, 0.2]</span></td>")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("number of them")), Not(HasSubstr("upper end of it"))));
}

TEST(TablesOfAPage, HaveTheResponsesOnce) {
  const std::string page = page_of(report_in(sample_report()));
  const std::string table = "aria-label=\"Table: response modes\"";
  EXPECT_NE(page.find(table), std::string::npos);
  EXPECT_EQ(page.find(table), page.rfind(table));
}

TEST(TablesOfAPage, NameCategories) {
  Table table{.name = "", .columns = {{"friction", "friction"}, {"y", "y"}}, .rows = {{1.0, 1.0}}};
  Figure figure;
  figure.tables.push_back(table);
  figure.panels.push_back({.title = "",
                           .x = {.quantity = "friction", .symbol = "", .unit = "", .ticks = {{1.0, "0.4/0.35"}}},
                           .y = {},
                           .layers = {}});
  EXPECT_THAT(tables_html(lone_condition(), figure), HasSubstr("<th scope=\"row\">0.4/0.35</th><td>1</td>"));
}

TEST(TablesOfAPage, OfManyRecordsHaveARowForEach) {
  Table table{.name = "", .columns = {{"intensity", "intensity"}}, .rows = {{0.25}, {0.5}}};
  for (int i = 0; i < 9; ++i) {
    table.columns.push_back({.name = "r", .meaning = "a_" + std::to_string(i) + ".at2", .is_verbatim = true});
    table.rows[0].emplace_back(0.0);
    table.rows[1].emplace_back(0.1 * i);
  }
  Figure figure;
  figure.tables.push_back(table);
  figure.panels.push_back({.title = "", .x = {}, .y = {}, .layers = {}});
  EXPECT_THAT(tables_html(lone_condition(), figure),
              AllOf(HasSubstr("<th scope=\"col\">0.25</th><th scope=\"col\">0.5</th></tr>"),
                    HasSubstr("<th scope=\"row\">a_3.at2</th><td>0</td><td>0.3</td>")));
}

TEST(TablesOfAPage, SetLevelsSideBySideThatHoldUntilTheNext) {
  const Table first{.name = "a", .columns = {{"period", "when"}, {"share", ""}}, .rows = {{1.0, 0.0}, {4.0, 0.5}}};
  const Table second{.name = "b", .columns = first.columns, .rows = {{2.0, 0.25}, {4.0, 1.0}, {9.0, 1.0}}};
  const Table joined = side_by_side({first, second});
  ASSERT_THAT(joined.columns, SizeIs(3));
  EXPECT_EQ(joined.columns[0].meaning + joined.columns[1].meaning + joined.columns[2].meaning, "whenab");
  const std::vector<std::vector<Cell>> rows{
      {1.0, 0.0, std::monostate()}, {2.0, 0.0, 0.25}, {4.0, 0.5, 1.0}, {9.0, 0.5, 1.0}};
  EXPECT_EQ(joined.rows, rows);
}

TEST(TheAnswer, DrawsEachModeButTheUnresolved) {
  using rocking::section::periodic;
  using rocking::section::ResponseKind;
  std::set<std::string> drawings;
  for (const auto& mode :
       {periodic(1, 1), periodic(1, 3), periodic(2, 3), rocking::section::ResponseMode{ResponseKind::rest},
        rocking::section::ResponseMode{ResponseKind::slide}, rocking::section::ResponseMode{ResponseKind::chaotic},
        rocking::section::ResponseMode{ResponseKind::overturned}}) {
    drawings.insert(mode_drawing(mode));
  }
  EXPECT_THAT(drawings, AllOf(SizeIs(7), Each(StartsWith("<svg class=\"mode\""))));
  EXPECT_EQ(mode_drawing({}), "");
}

TEST(TheAnswer, TellsTheSlipOfABlockThatSlidWithoutRocking) {
  rocking::Report report;
  rocking::ConditionResult& result = report.conditions.emplace_back().result;
  result.realisations = 10;
  result.modes.push_back(
      {.mode = {rocking::section::ResponseKind::slide}, .probability = rocking::support::sample_estimate(10, 10)});
  EXPECT_THAT(modes_in_brief(report), HasSubstr("without rocking</span>"));
  result.peaks.slip.emplace().metres = {{.level = 0.5, .value = 0.6, .low = {}, .high = {}}};
  EXPECT_THAT(modes_in_brief(report), HasSubstr("without rocking; largest slip 0.6 m</span>"));
}

}  // namespace
