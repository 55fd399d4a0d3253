// Pages, figures and tables of a run show the shaking in the units of the file and in the other form, and each
// condition with its own numbers.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/page/sections.hpp"
#include "analysis/page/tables.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/report.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"
#include "support/sample_report.hpp"

namespace shaking_on_pages {
namespace {

using namespace rocking;
using namespace rocking::analysis;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The report of a run in which every realisation had the mode (1,1).
Json report_json(const Json& document) {
  const Experiment experiment = experiment_in(document.dump());
  ExperimentResult result{.conditions = {}, .digest = base::sha256("made up")};
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    ConditionResult condition;
    condition.realisations = 1;
    condition.modes.push_back({section::periodic(1, 1), support::sample_estimate(1, 1)});
    result.conditions.push_back(std::move(condition));
  }
  SystemFacts facts;
  facts.start = "2012-02-01T12:00:00Z";
  return Json::parse(report_text(experiment, result, facts));
}

Report report_of(const std::string& excitation, const std::string& sweep = "") {
  Json document = support::with(support::least_experiment(), "/excitation", excitation);
  if (!sweep.empty()) document["sweep"] = Json::parse(sweep);
  return report_in(report_json(document));
}

constexpr const char* normalised = R"({"amplitude": 4.5, "frequency_ratio": 10})";
constexpr const char* physical = R"({"amplitude_g": 1.1, "frequency_hz": 3})";
constexpr const char* widths = R"([{"parameter": "/block/width_m", "values": [0.5, 1, 2]}])";

TEST(TheQuestion, StatesTheShakingInBothForms) {
  EXPECT_THAT(
      question_in_brief(report_of(normalised)),
      HasSubstr("with amplitude <i>A<sub>h</sub></i> = 4.5 (1.1 g) at <i>&Omega;</i><sub>h</sub> = 10 (3.01 Hz)"));
  EXPECT_THAT(
      question_in_brief(report_of(physical)),
      HasSubstr("with amplitude 1.1 g (<i>A<sub>h</sub></i> = 4.49) at 3 Hz (<i>&Omega;</i><sub>h</sub> = 9.98)"));
  EXPECT_THAT(question_in_brief(report_of(R"({"amplitude_m_s2": 4, "period_s": 0.5})")),
              HasSubstr("with amplitude 4 m/s<sup>2</sup> (<i>A<sub>h</sub></i> = 1.66) at a period of 0.5 s "
                        "(<i>&Omega;</i><sub>h</sub> = 6.65)"));
}

// psi of the widths 0.5, 1 and 2 m is 0.124, 0.245 and 0.464.
TEST(TheQuestion, GivesRangesWhereTheBlockIsSwept) {
  const std::string of_ratio = question_in_brief(report_of(normalised, widths));
  EXPECT_THAT(of_ratio, HasSubstr("A block 0.5 to 2 m wide (swept) and 4 m high"));
  EXPECT_THAT(of_ratio, HasSubstr("<i>A<sub>h</sub></i> = 4.5 (0.56 to 2.09 g)"));
  EXPECT_THAT(of_ratio, HasSubstr("<i>&Omega;</i><sub>h</sub> = 10 (2.89 to 3.04 Hz)"));
  EXPECT_THAT(question_in_brief(report_of(physical, widths)),
              HasSubstr("amplitude 1.1 g (<i>A<sub>h</sub></i> = 2.37 to 8.85)"));
  EXPECT_THAT(question_in_full(report_of(physical, widths)), HasSubstr("&psi; = 0.1244 to 0.4636 rad"));
  EXPECT_THAT(question_in_full(report_of(physical)), AllOf(HasSubstr("&psi; = 0.245 rad"), HasSubstr("1.1 g (")));
}

TEST(TheQuestion, GivesBothFormsOfASweptAmplitude) {
  const char* sweep = R"([{"parameter": "/excitation/amplitude_g", "values": [0.5, 1]}])";
  EXPECT_THAT(question_in_brief(report_of(physical, sweep)),
              AllOf(HasSubstr("base amplitude 0.5, 1 g (<i>A<sub>h</sub></i> = 2.04 to 4.08)"),
                    Not(HasSubstr("with amplitude"))));
}

TEST(TheQuestion, SaysOfARandomBlockWhoseNumbersItGives) {
  Json document = support::least_experiment();
  document["block"]["width_m"] = Json::parse(R"({"uniform": [0.9, 1.1]})");
  EXPECT_THAT(question_in_brief(report_in(report_json(document))), HasSubstr("Hz) for the mean block"));
}

TEST(TheQuestion, SaysWhatIsRandom) {
  EXPECT_THAT(question_in_brief(report_of(normalised)), HasSubstr("Nothing is random."));
  Json document = support::least_experiment();
  document["excitation"]["phase_rad"] = Json::parse(R"({"uniform": [0, 6]})");
  document["fluctuation"] = Json::parse(R"({"amplitude": {"sigma": 0.1}, "restitution": {"sigma": 0.01}})");
  document["sweep"] = Json::parse(R"([{"parameter": "/fluctuation/amplitude/sigma", "values": [0.1, 0.2]}])");
  EXPECT_THAT(
      question_in_brief(report_in(report_json(document))),
      HasSubstr("Random: restitution with &sigma; = 0.01, amplitude with &sigma; = 0.1 to 0.2 (swept), phase."));
}

TEST(TheQuestion, ListsTheValuesOfEveryCondition) {
  EXPECT_THAT(question_in_full(report_of(physical, widths)),
              HasSubstr("<dt>/block/width_m</dt><dd>0.5 to 2 (swept)</dd>"));
  const char* kinds = R"([{"parameter": "/excitation", "values": [{"amplitude": 4, "frequency_ratio": 9},
                                {"kind": "pulse", "shape": "sine", "amplitude_g": 1, "frequency_ratio": 9}]}])";
  EXPECT_THAT(question_in_full(report_of(normalised, kinds)),
              AllOf(HasSubstr("<dt>/excitation/kind</dt><dd>harmonic, pulse (swept)</dd>"),
                    HasSubstr("<dt>/excitation/amplitude</dt><dd>4.0 (swept)</dd>")));
}

TEST(TheSketch, IsThatOfTheFirstConditionWithItsOwnShaking) {
  const std::string caption = scene_sketch(report_of(physical, widths)).caption;
  EXPECT_THAT(caption, StartsWith("The first of 3 conditions: B = 0.5 m"));
  EXPECT_THAT(caption, HasSubstr("1.1 g = A_h 8.85, 3 Hz = Ω_h "));
  EXPECT_THAT(scene_sketch(report_of(normalised)).caption, HasSubstr("A_h 4.5 = 1.1 g, Ω_h 10 = 3.01 Hz"));
}

/// The least experiment with this block.
Report of_block(const char* block) {
  Json document = support::least_experiment();
  document["block"] = Json::parse(block);
  return report_in(report_json(document));
}

/// The points of a table of a figure.
std::vector<std::array<double, 2>> points_of(const Figure& figure, const std::string& name) {
  const auto found = std::ranges::find(figure.tables, name, &Table::name);
  std::vector<std::array<double, 2>> points;
  if (found == figure.tables.end()) return points;
  for (const auto& row : found->rows) points.push_back({std::get<double>(row[0]), std::get<double>(row[1])});
  return points;
}

TEST(TheSketch, DrawsEveryPartAndTheCentreOfMassAboveItsEdges) {
  const Figure figure = scene_sketch(of_block(R"({"parts": [
      {"width_m": 0.6, "height_m": 0.2, "mass_kg": 30, "x_m": 0.0, "bottom_m": 0},
      {"width_m": 0.8, "height_m": 1.0, "mass_kg": 10, "x_m": 0.2, "bottom_m": 0.2}], "base_m": [-0.2, 0.3]})"));
  // At rest the centre of mass is 0.25 m right of the left edge and 0.25 m high; the block is drawn with a tilt.
  const double tilt = 0.14;
  const auto centre = points_of(figure, "centre of mass").at(0);
  EXPECT_NEAR(centre[0], 0.25 * std::cos(tilt) - 0.25 * std::sin(tilt), 2e-6);
  EXPECT_NEAR(centre[1], 0.25 * std::sin(tilt) + 0.25 * std::cos(tilt), 2e-6);
  EXPECT_EQ(points_of(figure, "block").size(), 5U);
  EXPECT_EQ(points_of(figure, "block 2").size(), 5U);
  EXPECT_NEAR(points_of(figure, "base of the block").at(1)[0], 0.5 * std::cos(tilt), 2e-6);
  EXPECT_THAT(figure.caption,
              HasSubstr("edges 0.25 m left and 0.25 m right of the centre of mass, which is 0.25 m high"));
  EXPECT_THAT(figure.caption, HasSubstr("ψ_l = 0.785 rad = 45 deg, ψ_r = 0.785 rad = 45 deg"));
}

TEST(TheQuestion, HasBothSidesOfABlockWithUnlikeEdges) {
  const std::string text =
      question_in_full(of_block(R"({"edges_m": [0.25, 0.9], "centre_height_m": 1.0, "radius_of_gyration_m": 0.7})"));
  EXPECT_THAT(text, HasSubstr("&psi; = 0.245 rad at the left edge, 0.7328 rad at the right edge"));
  EXPECT_THAT(text, HasSubstr("base above 0.25 g to the right, or 0.9 g to the left"));
}

TEST(TheSketch, SaysWhatFluctuates) {
  Json document = support::least_experiment();
  document["friction"] = Json::parse(R"({"static": 0.35, "kinetic": 0.3})");
  document["fluctuation"] = Json::parse(R"({"static_friction": {"relative_sigma": 0.1}, "amplitude": {"sigma": 0.2}})");
  EXPECT_THAT(scene_sketch(report_in(report_json(document))).caption,
              HasSubstr("static friction fluctuates with relative σ = 0.1, amplitude fluctuates with σ = 0.2"));
}

TEST(TheAxis, HasTheOtherFormWhereTheConversionIsTheSame) {
  const auto label = [](const char* excitation, const char* sweep) {
    return label_of(view_of(report_of(excitation, sweep)).axis);
  };
  EXPECT_EQ(label(normalised, R"([{"parameter": "/excitation/amplitude", "values": [0, 1, 2]}])"),
            "base amplitude A_h [1 = 0.245 g]");
  EXPECT_EQ(label(normalised, R"([{"parameter": "/excitation/frequency_ratio", "values": [5, 10]}])"),
            "frequency ratio Ω_h [1 = 0.301 Hz]");
  EXPECT_EQ(label(physical, R"([{"parameter": "/excitation/amplitude_g", "values": [1, 2]}])"),
            "base amplitude [g; 1 g = A_h 4.08]");
  EXPECT_EQ(label(R"({"amplitude_m_s2": 4, "period_s": 0.5})",
                  R"([{"parameter": "/excitation/period_s", "values": [0.4, 0.5]}])"),
            "base period [s; Ω_h = 3.33 s/period]");
  EXPECT_EQ(label(normalised, R"([{"parameter": "/excitation/amplitude", "values": [1, 2, 3]},
                                  {"parameter": "/block/width_m", "values": [1, 2]}])"),
            "base amplitude A_h");
}

TEST(TheAxis, HasTheOtherFormOfItsOwnPanel) {
  const SweepView view = view_of(report_of(normalised, R"([{"parameter": "/excitation/amplitude", "values": [1, 2, 3]},
                                                           {"parameter": "/block/width_m", "values": [1, 2]}])"));
  ASSERT_EQ(view.slices.size(), 2U);
  EXPECT_EQ(label_of(view.slices[0].axis), "base amplitude A_h [1 = 0.245 g]");
  EXPECT_EQ(label_of(view.slices[1].axis), "base amplitude A_h [1 = 0.464 g]");
}

TEST(ACondition, IsNamedWithBothForms) {
  const Report report = report_of(normalised, R"([{"parameter": "/excitation/amplitude", "values": [3, 4.5]}])");
  EXPECT_EQ(name_of_condition(report, report.conditions[1]), "base amplitude 4.5 = 1.1 g");
}

TEST(ASlice, IsNotSplitByAFormThatTheOtherParameterChanges) {
  const Report report = report_of(normalised, R"([{"parameter": "/excitation/amplitude", "values": [3, 4.5]},
                                                     {"parameter": "/block/width_m", "values": [0.5, 1, 2]}])");
  const SweepView view = view_of(report);
  ASSERT_EQ(view.slices.size(), 2U);
  EXPECT_EQ(view.slices[1].name, "base amplitude 4.5");
}

TEST(TablesOfARun, HaveTheOtherForm) {
  const Report report = report_of(normalised, R"([{"parameter": "/excitation/amplitude", "values": [3, 4.5]}])");
  EXPECT_THAT(mode_table_html(report), AllOf(HasSubstr("base amplitude [g]"), HasSubstr("1.102")));
}

TEST(AnExperiment, HasTheValuesOfTheConditionWhateverThePartThatIsSwept) {
  const auto width_and_height = [](const Report& report, std::size_t condition) {
    const Json experiment = applied(report.input.experiment, report.conditions[condition].asked.parameters);
    return std::array<double, 2>{experiment["block"]["width_m"], experiment["block"]["height_m"]};
  };
  const Report whole = report_of(normalised, R"([{"parameter": "/block", "values":
      [{"width_m": 1, "height_m": 4}, {"width_m": 2, "height_m": 5}]}])");
  EXPECT_EQ(width_and_height(whole, 1), (std::array{2.0, 5.0}));
  const Report part = report_of(normalised, widths);
  EXPECT_EQ(width_and_height(part, 2), (std::array{2.0, 4.0}));
  EXPECT_EQ(mean_block(part.conditions[2].asked.scene).width, 2.0);
}

}  // namespace
}  // namespace shaking_on_pages
