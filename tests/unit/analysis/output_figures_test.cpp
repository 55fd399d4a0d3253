// Figures of trajectories, bifurcations and draws, and the tables of a report: their numbers are those of the files.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/figures/trajectory_figures.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/run_tables.hpp"
#include "rocking/studies/bifurcation/study.hpp"
#include "rocking/studies/check_normal/study.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/studies/studies.hpp"
#include "rocking/text/number_text.hpp"
#include "support/sample_report.hpp"

namespace {

using rocking::Json;
using rocking::report_in;
using rocking::table_files;
using rocking::analysis::bifurcation_figures;
using rocking::analysis::Cell;
using rocking::analysis::cost_figures;
using rocking::analysis::Figure;
using rocking::analysis::LayerKind;
using rocking::analysis::normal_histogram;
using rocking::analysis::output_figures;
using rocking::analysis::phase_portrait;
using rocking::analysis::poincare;
using rocking::analysis::responses;
using rocking::analysis::shown;
using rocking::analysis::Table;
using rocking::analysis::time_history;
using rocking::analysis::TrajectoryFile;
using rocking::support::sample_report;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Two periods of length 0.5, four samples each: rest, a lift at 0.2, a slip from 0.3 to the impact at 0.7.
rocking::TrajectoryReport sample_trajectory() {
  using rocking::dynamics::ContactState;
  using rocking::dynamics::EventKind;
  rocking::TrajectoryReport report;
  report.key = {.condition = 2, .realisation = 7};
  report.strobe = {
      {.period = 1, .time = 0.5, .state = {.tilt = 0.25, .tilt_rate = -0.5}, .contact = ContactState::rock_slide},
      {.period = 2, .time = 1.0, .state = {.tilt = 0.125, .tilt_rate = 0.5}, .contact = ContactState::rock}};
  const rocking::ReportedState after{.tilt = 0.0, .tilt_rate = 0.1, .slip = 0.01};
  report.events = {{.time = 0.1, .kind = EventKind::lift, .state = after},
                   {.time = 0.15, .kind = EventKind::slip_start, .state = after},
                   {.time = 0.35, .kind = EventKind::impact_stick, .state = after},
                   {.time = 0.35, .kind = EventKind::past_balance, .state = after}};
  report.samples_per_period = 4;
  for (int i = 0; i <= 8; ++i) {
    report.history.push_back({.time = 0.125 * i,
                              .state = {.tilt = 0.01 * i, .slip = -0.001 * i},
                              .contact = i == 0 ? ContactState::rest : ContactState::rock});
  }
  return report;
}

std::string text_of(const rocking::TrajectoryReport& report) { return rocking::trajectory_document().text(report); }

rocking::BifurcationReport sample_bifurcation(std::size_t steps, std::size_t points) {
  rocking::BifurcationReport report;
  report.input.experiment = Json::parse(R"({ "title": "t" })");
  report.parameter = "/excitation/amplitude";
  report.diagrams.resize(1);
  for (std::size_t i = 0; i < steps; ++i) {
    rocking::ReportedStep& step = report.diagrams[0].steps.emplace_back();
    step.value = 1.0 + 0.5 * static_cast<double>(i);
    step.step.classification.mode.kind = rocking::section::ResponseKind::chaotic;
    for (std::size_t k = 0; k < points; ++k) {
      step.step.points.push_back({.tilt = std::fmod(0.618 * static_cast<double>(k), 1.0)});
    }
  }
  return report;
}

const Table* table_named(const Figure& figure, const std::string& name) {
  for (const Table& table : figure.tables) {
    if (table.name == name) return &table;
  }
  return nullptr;
}

TEST(TrajectoryFile, TellsTheStateOfContactFromTheEvents) {
  const TrajectoryFile file = shown(sample_trajectory(), "x");
  std::vector<std::string> contacts;
  for (const auto& span : file.contacts) contacts.emplace_back(to_string(span.contact));
  EXPECT_THAT(contacts, ElementsAre("rest", "rock", "rock_slide", "rock"));
  EXPECT_EQ(file.contacts[2].from, 0.15 / 0.5);
  EXPECT_EQ(file.contacts[2].to, 0.35 / 0.5);
  EXPECT_EQ(file.contacts[3].to, 2.0);
}

TEST(TimeHistory, HasTheSamplesAndTheEventsInOrder) {
  const Figure figure = time_history(shown(sample_trajectory(), "x"), {});
  const Table& table = figure.tables.front();
  ASSERT_EQ(table.rows.size(), 13U);
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    EXPECT_LE(std::get<double>(table.rows[i - 1][0]), std::get<double>(table.rows[i][0]));
  }
  EXPECT_THAT(table.rows.back(), ElementsAre(Cell(2.0), Cell(0.08), Cell(0.0), Cell(-0.008)));
  EXPECT_THAT(table_named(figure, "impact_stick")->rows, ElementsAre(ElementsAre(Cell(0.7), Cell(0.0))));
  EXPECT_EQ(table_named(figure, "impact_slip"), nullptr);
}

TEST(TimeHistory, ShowsTheAskedPartOnly) {
  const Figure figure = time_history(shown(sample_trajectory(), "x"), {.from = 0.5, .to = 1.0});
  EXPECT_EQ(figure.panels[0].x.low, 0.5);
  EXPECT_EQ(figure.panels[0].x.high, 1.0);
  for (const auto& row : figure.tables.front().rows) EXPECT_GE(std::get<double>(row[0]), 0.5);
  EXPECT_EQ(table_named(figure, "stretches of rest"), nullptr);
  EXPECT_THAT(table_named(figure, "stretches of rock_slide")->rows, ElementsAre(ElementsAre(Cell(0.5), Cell(0.7))));
}

TEST(TimeHistory, OfATrajectoryThatEndedBeforeTheWindowSaysSo) {
  const TrajectoryFile file = shown(sample_trajectory(), "x");
  const auto figures = {time_history(file, {.from = 60.0}), responses({file, file}, {.from = 60.0})};
  for (const Figure& figure : figures) {
    EXPECT_EQ(figure.panels[0].x.low, 60.0);
    EXPECT_EQ(figure.panels[0].x.high, 61.0) << "ticks that differ";
    EXPECT_THAT(figure.caption,
                HasSubstr("x: condition 2, realisation 7 ends at 2 periods, before the first one shown."));
  }
  EXPECT_EQ(time_history(file, {.from = 60.0}).subtitle, "x: condition 2, realisation 7 ends at 2 periods");
  EXPECT_THAT(time_history(file, {.from = 0.5}).caption, ::testing::Not(HasSubstr("ends at")));
}

TEST(Poincare, HasThePointsOfTheFile) {
  const Figure figure = poincare({shown(sample_trajectory(), "x")}, {.from = 2.0});
  EXPECT_THAT(figure.tables.front().rows, ElementsAre(ElementsAre(Cell(0.125), Cell(0.5), Cell(2.0))));
}

TEST(Bifurcation, DrawsFewPointsOneByOneInTheLookOfTheirMode) {
  const auto figures = bifurcation_figures(sample_bifurcation(3, 20));
  ASSERT_EQ(figures.size(), 1U);
  const auto& layer = figures[0].panels.at(0).layers.at(0);
  EXPECT_EQ(layer.kind, LayerKind::points);
  EXPECT_EQ(layer.legend, "chaotic");
  EXPECT_EQ(figures[0].tables.at(layer.table).rows.size(), 60U);
}

TEST(Bifurcation, CountsEveryPointOfManyInItsImage) {
  const auto figures = bifurcation_figures(sample_bifurcation(120, 900));
  const auto& layer = figures.at(0).panels.at(0).layers.at(0);
  ASSERT_EQ(layer.kind, LayerKind::image);
  double points = 0.0;
  for (const auto& row : figures[0].tables.at(layer.table).rows) {
    EXPECT_EQ(row.size(), 120U);
    for (const Cell& cell : row) points += std::get<double>(cell);
  }
  EXPECT_EQ(points, 120.0 * 900.0);
}

TEST(Bifurcation, IsReadFromItsFileWithAllThatTheFigureShows) {
  const auto& document = rocking::bifurcation_document();
  const auto report = sample_bifurcation(3, 4);
  const auto drawn = bifurcation_figures(report);
  const auto from_file = bifurcation_figures(document.read(Json::parse(document.text(report))));
  ASSERT_EQ(from_file.size(), 1U);
  EXPECT_EQ(from_file[0].subtitle, drawn[0].subtitle);
  ASSERT_EQ(from_file[0].tables.size(), drawn[0].tables.size());
  EXPECT_EQ(from_file[0].tables[0].rows, drawn[0].tables[0].rows);
  Json bad = Json::parse(document.text(report));
  bad["diagrams"][0]["steps"][1]["mode"] = "chaos";
  bad["diagrams"][0]["steps"][2]["points"][3] = Json::array({0.5});
  try {
    static_cast<void>(document.read(bad));
    FAIL() << "a bad file was read";
  } catch (const rocking::base::InputError& error) {
    std::vector<std::string> places;
    for (const auto& problem : error.problems()) places.push_back(problem.place);
    EXPECT_THAT(places, ElementsAre("/diagrams/0/steps/1/mode", "/diagrams/0/steps/2/points/3"));
  }
}

TEST(Bifurcation, OfNothingIsEmptyNotAnError) {
  EXPECT_THAT(bifurcation_figures(sample_bifurcation(2, 0)).at(0).panels.at(0).layers, IsEmpty());
  EXPECT_EQ(bifurcation_figures(sample_bifurcation(1, 1)).at(0).tables.at(0).rows.size(), 1U);
}

TEST(NormalHistogram, HasTheCountsAndACurveOfTheSameArea) {
  rocking::SamplerCheck check{
      .distribution = {}, .generated = rocking::GeneratedNumbers{"box-muller", 1}, .of_file = {}, .found = {}};
  check.found.n = 1000;
  check.found.law = {.mean = 0.5, .sigma = 0.1};
  check.found.histogram = {
      .edges = {0.1, 0.3, 0.5, 0.7, 0.9}, .counts = {20, 480, 477, 23}, .expected = {22, 477, 477, 22}};
  const Figure figure = normal_histogram(check);
  EXPECT_THAT(figure.tables[0].rows[1], ElementsAre(Cell(0.3), Cell(0.5), Cell(0.0), Cell(480.0), Cell(477.0)));
  double area = 0.0;  // as counts: the curve is given for bins of 0.2
  const auto& curve = figure.tables[1].rows;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    area += 0.5 * (std::get<double>(curve[i][1]) + std::get<double>(curve[i - 1][1])) *
            (std::get<double>(curve[i][0]) - std::get<double>(curve[i - 1][0])) / 0.2;
  }
  EXPECT_NEAR(area, 1000.0 * std::erf(4.0 / std::sqrt(2.0)), 0.1);
}

rocking::CostReport sample_cost() {
  rocking::CostReport report;
  report.input.experiment = Json::parse(R"({ "title": "t", "accuracy": { "tolerance": 1e-8 } })");
  report.cost.sample = 50;
  report.cost.sampled_conditions = 3;
  rocking::Departure far;
  far.median_error = 0.25;
  far.largest_error = 0.5;
  far.flips = {.successes = 5, .trials = 50};
  far.flips_interval = {.low = 0.0625, .high = 0.25};
  rocking::Departure near;
  near.median_error = 0.0;
  near.flips = {.successes = 0, .trials = 50};
  near.flips_interval = {.low = 0.0, .high = 0.125};
  report.cost.curve.resize(3);
  report.cost.curve[0].tolerance = 1e-4;
  report.cost.curve[0].departure = far;
  report.cost.curve[1].tolerance = 1e-8;
  report.cost.curve[1].departure = near;
  report.cost.curve[2].tolerance = 1e-12;
  report.cost.timing = {.seconds_per_period = {1e-6, 0.5, 4e-6}, .realisations = 8, .periods = 10};
  rocking::PlannedRealisations& planned = report.cost.planned.emplace_back();
  planned.factor = 4;
  planned.half_widths = {.mean = 0.25, .widest = 0.5, .widest_wilson = 0.375};
  planned.periods = 1000;
  report.planned_seconds = {500.0};
  report.system.start = "2012-02-01T12:00:00Z";
  return report;
}

TEST(Cost, DrawsTheNumbersAndLeavesOutWhatALogarithmCannotShow) {
  const auto figures = cost_figures(sample_cost());
  ASSERT_EQ(figures.size(), 3U);
  const auto& rows = figures[0].tables[0].rows;
  EXPECT_THAT(rows[0], ElementsAre(Cell(1e-4), Cell(0.25), Cell(0.5), Cell(10.0), Cell(6.25), Cell(25.0), Cell(1.0),
                                   Cell(std::string("0.0001"))));
  EXPECT_THAT(rows[1], ElementsAre(Cell(1e-8), Cell(), Cell(), Cell(0.0), Cell(0.0), Cell(12.5), Cell(500'000.0),
                                   Cell(std::string("1e-08"))));
  EXPECT_THAT(rows[2],
              ElementsAre(Cell(1e-12), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(4.0), Cell(std::string("1e-12"))));
  EXPECT_THAT(figures[2].tables[0].rows[0],
              ElementsAre(Cell(4.0), Cell(1000.0), Cell(500.0), Cell(25.0), Cell(50.0), Cell(37.5)));
}

TEST(Cost, OfADeterministicExperimentHasNoHalfWidths) {
  rocking::CostReport still = sample_cost();
  still.cost.planned.clear();
  still.cost.yardstick.is_everything = true;
  const auto figures = cost_figures(still);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].tables[0].rows[0][3], Cell(10.0));
  EXPECT_EQ(figures[0].tables[0].rows[0][4], Cell()) << "a share of all that there are needs no interval";
}

TEST(Cost, IsReadFromItsFileWithAllThatFiguresShow) {
  const auto& document = rocking::cost_document();
  const std::string text = document.text(sample_cost());
  const auto drawn = cost_figures(sample_cost());
  const auto from_file = cost_figures(document.read(Json::parse(text)));
  ASSERT_EQ(from_file.size(), drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_EQ(from_file[i].tables[0].rows, drawn[i].tables[0].rows) << drawn[i].name;
    EXPECT_EQ(from_file[i].caption, drawn[i].caption);
  }
}

TEST(Cost, OfABadFileIsRefusedWithEveryFault) {
  Json json = Json::parse(rocking::cost_document().text(sample_cost()));
  json["result"]["sample"]["realisations"] = -1;
  json["result"]["tolerances"][0]["departure"]["flips"]["interval"] = Json::array({0.5, 0.25});
  json["system"]["planned_processor_s"] = Json::array();
  try {
    static_cast<void>(rocking::cost_document().read(json));
    FAIL() << "a bad file was read";
  } catch (const rocking::base::InputError& error) {
    std::vector<std::string> places;
    for (const auto& problem : error.problems()) places.push_back(problem.place);
    EXPECT_THAT(places, ElementsAre("/result/sample/realisations", "/result/tolerances/0/departure/flips/interval"));
  }
  json = Json::parse(rocking::cost_document().text(sample_cost()));
  json["system"]["planned_processor_s"] = Json::array();
  EXPECT_THROW(static_cast<void>(rocking::cost_document().read(json)), rocking::base::InputError);
}

TEST(PhasePortrait, IsThePathOfTheHistoryWithItsStrobePoints) {
  const Figure figure = phase_portrait({shown(sample_trajectory(), "x")}, {.from = 0.5, .to = 1.0});
  ASSERT_EQ(figure.panels.size(), 1U);
  ASSERT_EQ(figure.panels[0].layers.size(), 2U);
  const auto& path = figure.panels[0].layers[0];
  EXPECT_EQ(path.kind, LayerKind::line);
  EXPECT_THAT(path.columns, ElementsAre(0U, 1U));
  EXPECT_THAT(
      figure.tables.at(path.table).rows,
      ElementsAre(ElementsAre(Cell(0.02), Cell(0.0), Cell(0.5)), ElementsAre(Cell(), Cell(), Cell(0.7)),
                  ElementsAre(Cell(0.0), Cell(0.1), Cell(0.7)), ElementsAre(Cell(0.0), Cell(0.1), Cell(0.7)),
                  ElementsAre(Cell(0.03), Cell(0.0), Cell(0.75)), ElementsAre(Cell(0.04), Cell(0.0), Cell(1.0))))
      << "interrupted at the impact, not at the event of the same instant";
  const auto& points = figure.panels[0].layers[1];
  EXPECT_EQ(points.kind, LayerKind::points);
  EXPECT_THAT(figure.tables.at(points.table).rows, ElementsAre(ElementsAre(Cell(0.25), Cell(-0.5), Cell(1.0))));
}

TEST(PhasePortrait, OfSeveralFilesNamesEachOnce) {
  const TrajectoryFile file = shown(sample_trajectory(), "x");
  TrajectoryFile other = file;
  other.name = "y";
  const Figure figure = phase_portrait({file, other}, {});
  std::vector<std::string> legends;
  for (const auto& layer : figure.panels.at(0).layers) legends.push_back(layer.legend);
  EXPECT_THAT(legends, ElementsAre("x: condition 2, realisation 7", "y: condition 2, realisation 7", "", ""));
}

TEST(OutputFigures, AreOfEachFileAndOfAllTogether) {
  const std::string text = text_of(sample_trajectory());
  std::vector<std::string> names;
  for (const Figure& figure : output_figures({{"a.json", text}, {"b.json", text}}, {})) names.push_back(figure.name);
  EXPECT_THAT(names, ElementsAre("time_history", "time_history_2", "responses", "phase_portrait", "poincare"));
}

TEST(OutputFigures, RefuseWithTheFilesName) {
  Json torn = Json::parse(text_of(sample_trajectory()));
  torn.erase("strobe");
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(output_figures({{"some.json", text}}, {}));
    } catch (const rocking::base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(torn.dump()), HasSubstr("some.json"));
  Json mixed = Json::parse(text_of(sample_trajectory()));
  mixed["units"] = "si";
  EXPECT_THAT(refusal(mixed.dump()), HasSubstr("/strobe/0/tilt_rad"));
  Json reversed = Json::parse(text_of(sample_trajectory()));
  std::swap(reversed["history"][3], reversed["history"][4]);
  EXPECT_THAT(refusal(reversed.dump()), HasSubstr("/history/4"));
  EXPECT_THAT(refusal(R"({"format": "rocking.report/1"})"), HasSubstr("rocking report DIR"));
  EXPECT_THAT(refusal("[1]"), HasSubstr("/format"));
}

TEST(LatexText, HasTheSignsThatWereWrittenAndCompilesWithoutPackages) {
  using rocking::look::latex_text;
  EXPECT_EQ(latex_text("a < b > c | d"), "a \\textless{} b \\textgreater{} c \\textbar{} d");
  EXPECT_EQ(latex_text("50 % \\ _{x}$#&~^"),
            "50 \\% \\textbackslash{} \\_\\{x\\}\\$\\#\\&\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(latex_text("α Ω π/p, µ ≥ 2 m²"), "$\\alpha$ $\\Omega$ $\\pi$/p, $\\mu$ $\\ge$ 2 m$^2$");
  EXPECT_EQ(latex_text("ΑΒ ς"), "$A$$B$ $\\varsigma$");
  EXPECT_EQ(latex_text("Zürich, Łódź, Ångström"), "Zürich, Łódź, Ångström");
  EXPECT_EQ(latex_text("ą 🌊 ж 中"), "[U+0105] [U+1F30A] [U+0436] [U+4E2D]")
      << "not in the fonts that LaTeX loads itself";
  EXPECT_EQ(latex_text("a\nb"), "a b");
}

TEST(Tables, BoundWhatDidNotOccurAndShowNoIntervalWhereNothingIsRandom) {
  Json json = sample_report();
  const auto high = json["result"]["conditions"][0]["probabilities"]["overturned"]["simultaneous"][1].get<double>();
  EXPECT_EQ(json["result"]["conditions"][0]["counts"]["overturned"], 0);
  EXPECT_THAT(table_files(report_in(json), {"csv", "latex"}).at("modes.tex"),
              HasSubstr("$<$ " + rocking::per_cent(high)));
  for (Json& condition : json["result"]["conditions"]) condition["stopped_because"] = "deterministic";
  const auto report = report_in(json);
  EXPECT_FALSE(report.is_random());
  EXPECT_THAT(table_files(report, {"csv", "latex"}).at("modes.tex"), Not(ContainsRegex("\\[[0-9]")));
  EXPECT_THAT(table_files(report, {"csv", "latex"}).at("modes.csv"), HasSubstr(",4,0.13333333333333333,,\n"));
}

TEST(Tables, SetTextForLatexSoThatItIsText) {
  Json json = sample_report();
  json["input"]["experiment"]["title"] = "50 % of #1_a \\input{x} a\u202eb";
  const std::string latex = table_files(report_in(json), {"csv", "latex"}).at("modes.tex");
  EXPECT_THAT(latex, HasSubstr("50 \\% of \\#1\\_a \\textbackslash{}input\\{x\\} a\\textbackslash{}u202eb. Response"));
  EXPECT_THAT(latex, HasSubstr("0.35/0.3 & 4 & 0.9799 & 30 & 83.3 ["));
}

}  // namespace
