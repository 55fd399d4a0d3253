// Reports, trajectories and checks as written: they satisfy their schemas, and the schemas reject wrong ones.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/digest.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/studies/check_normal/study.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"

namespace {

using namespace rocking;
using support::objections;
using ::testing::HasSubstr;

ModeEstimate mode(section::ResponseMode kind, std::uint64_t successes, std::uint64_t trials) {
  const double p = static_cast<double>(successes) / static_cast<double>(trials);
  const stats::Interval interval{0.5 * p, 0.5 + 0.5 * p};
  return {kind,
          {.counts = {successes, trials}, .estimate = p, .alone = {interval, interval}, .simultaneous = interval}};
}

/// An invented result; only its output is tested.
ExperimentResult result_for(const Experiment& experiment) {
  using section::ResponseKind;
  ConditionResult condition;
  condition.realisations = 200;
  condition.modes = {mode(section::periodic(1, 1), 120, 200), mode(section::periodic(1, 3), 70, 200),
                     mode({ResponseKind::chaotic}, 0, 200), mode({ResponseKind::overturned}, 10, 200)};
  condition.non_recurrence.emplace();
  condition.non_recurrence->arithmetic_tolerance = 1e-11;
  condition.non_recurrence->friction = {
      .pairs = 100, .diverged = 60, .lower_quartile = 12.0, .median = 80.0, .upper_quartile = {}};
  condition.validity.clamps.kinetic_at_static = 17;
  condition.operations.steps = 1000;
  condition.operations.events[0] = 5;
  condition.stopped_because = StoppedBecause::all_realisations_done;
  return {.conditions = std::vector(experiment.conditions.size(), condition), .digest = base::sha256("made up")};
}

Experiment example() { return experiment_in(support::example_experiment().dump()); }

SystemFacts facts(const std::string& machine) {
  return {.build = base::build_info(),
          .machine = machine,
          .start = "2012-02-01T12:00:00Z",
          .duration_s = 1.25,
          .threads = 2};
}

std::string example_report() { return report_text(example(), result_for(example()), facts("here")); }

TEST(Report, KeepsToItsSchema) { EXPECT_EQ(objections("report", example_report()), ""); }

TEST(Report, OfOneRealisationSaysThatThereIsNothingToCompare) {
  auto result = result_for(example());
  result.conditions[0].non_recurrence.reset();
  const std::string text = report_text(example(), result, facts("here"));
  EXPECT_EQ(objections("report", text), "");
  EXPECT_TRUE(Json::parse(text)["result"]["conditions"][0]["non_recurrence"].is_null());
}

SideEstimate side(std::uint64_t successes, std::uint64_t trials) {
  return {mode({section::ResponseKind::overturned}, successes, trials).probability};
}

/// 10 of 200 overturned, so many of them to the left.
Report on_block(const Json& block, std::uint64_t left) {
  Json asked = support::example_experiment();
  asked["block"] = block;
  const Experiment experiment = experiment_in(asked.dump());
  ExperimentResult result = result_for(experiment);
  for (ConditionResult& condition : result.conditions) {
    condition.overturned_left = side(left, 200);
    condition.overturned_right = side(10 - left, 200);
  }
  return report_of(experiment, result, facts("here"));
}

const Json unlike_edges = {{"edges_m", {0.3, 0.5}}, {"centre_height_m", 2.0}, {"radius_of_gyration_m", 1.2}};

TEST(Report, HasBothSidesOfOverturningAndRefusesThoseThatDoNotAddUp) {
  Json report = Json::parse(report_document().text(on_block(unlike_edges, 7)));
  EXPECT_EQ(objections("report", report.dump()), "");
  EXPECT_EQ(report["result"]["conditions"][0]["overturned_left"]["count"], 7);
  EXPECT_EQ(report["result"]["conditions"][0]["overturned_right"]["estimate"], 0.015);
  const Report read = parse_report(report.dump());
  EXPECT_EQ(read.conditions[0].result.overturned_right.value().probability.counts.trials, 200U);
  report["result"]["conditions"][0]["overturned_left"]["count"] = 8;
  report["result"]["conditions"][0]["overturned_left"]["estimate"] = 0.04;
  try {
    static_cast<void>(parse_report(report.dump()));
    ADD_FAILURE() << "was read";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("/result/conditions/0/overturned_left = 11: is the sum of both sides, not the count "
                          "of overturned, 10"));
  }
}

TEST(RunTable, ShowsTheSideOfOverturningWhereTheEdgesDiffer) {
  EXPECT_THAT(run_table(on_block(unlike_edges, 7)),
              HasSubstr("side of overturning, in per cent of n\n"
                        "amplitude    n       overturned      to the left      to the right\n"
                        "        3  200  5.0 [2.5, 52.5]  3.5 [1.8, 51.7]  1.5 [0.75, 50.7]\n"));
  EXPECT_THAT(run_table(on_block({{"width_m", 1.0}, {"height_m", 4.0}}, 7)), Not(HasSubstr("side of overturning")));
}

TEST(Report, DiffersInSystemOnlyBetweenEqualRuns) {
  Json here = Json::parse(example_report());
  Json there = Json::parse(report_text(example(), result_for(example()), facts("there")));
  EXPECT_NE(here["system"], there["system"]);
  here.erase("system");
  there.erase("system");
  EXPECT_EQ(here.dump(), there.dump());
}

TEST(Report, HasItsKeysInAFixedOrder) {
  const Json report = Json::parse(example_report());
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_THAT(keys, ::testing::ElementsAre("format", "input", "result", "system", "internal"));
  keys.clear();
  for (const auto& [key, value] : report["result"]["conditions"][0].items()) keys.push_back(key);
  EXPECT_THAT(keys, ::testing::ElementsAre("parameters", "shaking", "realisations", "counts", "probabilities",
                                           "non_recurrence", "peak_tilt", "peak_tilt_rate", "peak_slip", "final_slip",
                                           "validity", "stopped_because"));
}

TEST(Report, HoldsTheExperimentAndItsDigest) {
  const Json input = Json::parse(example_report())["input"];
  EXPECT_EQ(input["experiment"].dump(), example().canonical_text);
  EXPECT_EQ(input["sha256"], base::to_hex(base::sha256(input["experiment"].dump())));
  EXPECT_EQ(objections("experiment", input["experiment"].dump()), "");
}

TEST(Report, KeepsTheNamesOfSweptValuesAndRefusesOthers) {
  const auto swept =
      support::with(support::example_experiment(), "/sweep",
                    R"([{"parameter": "/excitation/amplitude", "values": [4, 5], "names": ["weak", "strong"]}])");
  const Experiment experiment = experiment_in(swept.dump());
  const std::string text = report_text(experiment, result_for(experiment), facts("here"));
  EXPECT_EQ(objections("report", text), "");
  EXPECT_EQ(parse_report(text).conditions[1].asked.parameters.front().name, "strong");
  Json changed = Json::parse(text);
  changed["result"]["conditions"][1]["parameters"]["names"]["/excitation/amplitude"] = "weak";
  EXPECT_THROW(static_cast<void>(parse_report(changed.dump())), base::InputError);
}

TEST(Report, AddsUpTheOperationCountsOfItsConditions) {
  const Json internal = Json::parse(example_report())["internal"];
  EXPECT_EQ(internal["conditions"].size(), 21U);
  EXPECT_EQ(internal["total"]["steps"], 21 * 1000);
  EXPECT_EQ(internal["total"]["events"]["lift"], 21 * 5);
  EXPECT_EQ(internal["total"]["clamped_draws"]["kinetic_friction_at_static"], 21 * 17);
}

/// A sabotaged report, which the schema must reject.
class Sabotage : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Sabotage, IsSeenByTheSchema) {
  const auto [pointer, value] = GetParam();
  EXPECT_NE(objections("report", support::with(Json::parse(example_report()), pointer, value).dump()), "");
}

INSTANTIATE_TEST_SUITE_P(All, Sabotage,
                         ::testing::Values(std::pair{"/result/digest", "\"abc\""}, std::pair{"/result/extra", "1"},
                                           std::pair{"/result/conditions/3/counts/(1,1)", "-1"},
                                           std::pair{"/result/conditions/3/counts/harmonic", "1"},
                                           std::pair{"/result/conditions/0/probabilities/(1,1)/wilson", "[0.1]"},
                                           std::pair{"/result/conditions/0/probabilities/(1,1)/estimate", "1.5"},
                                           std::pair{"/internal/total/events/jump", "1"},
                                           std::pair{"/system/start", "\"today\""},
                                           std::pair{"/result/conditions/0/non_recurrence", "{}"},
                                           std::pair{"/format", "\"rocking.report/2\""}));

TEST(ExperimentSchema, AllowsWhatTheReaderAllows) {
  EXPECT_EQ(objections("experiment", support::example_experiment().dump()), "");
  EXPECT_EQ(objections("experiment", support::least_experiment().dump()), "");
  EXPECT_EQ(objections("experiment", experiment_in(support::least_experiment().dump()).canonical_text), "");
}

TEST(ExperimentSchema, RefusesWhatTheReaderRefuses) {
  for (const auto& [pointer, value] : {std::pair{"/titel", "1"},
                                       {"/block/width_m", "-1"},
                                       {"/confidence", "1"},
                                       {"/friction/static", "\"0.3\""},
                                       {"/sweep", "[]"},
                                       {"/realisations", "0"},
                                       {"/fluctuation/static_friction", R"({"sigma": 1})"},
                                       {"/restitution", "-1"},
                                       {"/seed", "\"0xg\""},
                                       {"/initial/tilt", R"({"uniform": [1]})"},
                                       {"/fluctuation/friction/relative_sigma", "1"}}) {
    const std::string text = support::with(support::example_experiment(), pointer, value).dump();
    EXPECT_NE(objections("experiment", text), "") << pointer;
    EXPECT_THROW(static_cast<void>(experiment_in(text)), base::InputError) << pointer;
  }
}

TEST(Trajectory, KeepsToItsSchemaAndEveryBit) {
  Trajectory trajectory;
  trajectory.block = {.width = 0.3, .height = 1.2, .gravity = 1.62};
  trajectory.strobe.push_back({1, 1.0 / 3.0, -0.1, 5e-324, -0.0, dynamics::ContactState::rock_slide});
  trajectory.events.push_back({0.1 + 0.2, dynamics::EventKind::impact_slip, 0.0, 1e-300, 2.0 / 3.0, 1.5});
  trajectory.losses_of_contact = 2;
  trajectory.first_loss_of_contact = 0.7;
  trajectory.contradictions = 3;
  trajectory.energy = {.at_start = 1.0,
                       .at_end = 2.0,
                       .base_work = 4.0,
                       .friction_work = -1.0,
                       .lost_in_impacts = 1.5,
                       .gained_in_impacts = 0.25};
  const TrajectoryReport report =
      trajectory_report({.condition = 3, .realisation = 7}, trajectory, TrajectoryUnits::normalised);
  const std::string text = trajectory_document().text(report);
  EXPECT_EQ(objections("trajectory", text), "");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["strobe"][0]["tilt"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["strobe"][0]["slip"].get<double>(), 5e-324);
  EXPECT_EQ(json["strobe"][0]["contact"], "rock_slide");
  EXPECT_EQ(json["events"][0]["tau"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["events"][0]["kind"], "impact_slip");
  EXPECT_EQ(json["validity"],
            Json::parse(R"({"losses_of_contact": 2, "first_loss_of_contact": 0.7, "losses_before_fall": 0,
                           "contradictions": 3})"));
  EXPECT_EQ(json["energy"], Json::parse(R"({"at_start": 1.0, "at_end": 2.0, "base_work": 4.0, "friction_work": -1.0,
                            "lost_in_impacts": 1.5, "gained_in_impacts": 0.25, "unaccounted": -0.75})"));
  EXPECT_EQ(json["condition"], 3);
  EXPECT_EQ(json["block"]["width_m"], 0.3);
  EXPECT_EQ(json["block"]["height_m"], 1.2);
  EXPECT_EQ(json["block"]["gravity_m_s2"], 1.62);
  EXPECT_EQ(objections("trajectory", trajectory_document().text({})), "") << "an empty one";
  EXPECT_FALSE(json.contains("history"));
}

// In both units: what is written follows the schema, and what is read gives the same text.
TEST(Trajectory, IsReadAsItWasWritten) {
  Trajectory trajectory;
  trajectory.block = {.width = 0.3, .height = 1.2, .gravity = 1.62};
  trajectory.period_length = 0.5;
  trajectory.strobe.push_back({1, 0.25, -0.1, 0.5, -0.0, dynamics::ContactState::rock_slide});
  trajectory.events.push_back({0.3, dynamics::EventKind::past_balance, 1.0, 1e-300, 2.0 / 3.0, 1.5});
  trajectory.history.push_back({0.0, 0.1, 0.2, 0.3, 0.4, dynamics::ContactState::slide, 0.0});
  trajectory.history.push_back({0.5, 0.1, 0.2, 0.3, 0.4, dynamics::ContactState::rest, 0.0});
  trajectory.samples_per_period = 1;
  trajectory.first_loss_of_contact = 0.125;
  trajectory.label = {.mode = section::periodic(1, 3), .reason = section::Reason::stable_orbit};
  for (const TrajectoryUnits units : {TrajectoryUnits::normalised, TrajectoryUnits::si}) {
    const std::string text = trajectory_document().text(trajectory_report({}, trajectory, units));
    EXPECT_EQ(objections("trajectory", text), "");
    EXPECT_EQ(trajectory_document().text(trajectory_document().read(Json::parse(text))), text);
    EXPECT_EQ(text.find("tilt_rad") != std::string::npos, units == TrajectoryUnits::si);
  }
}

/// 200 evenly spaced numbers: not normal, with the right mean.
SamplerCheck example_check() {
  std::vector<double> sample, other;
  for (int i = 0; i < 200; ++i) {
    sample.push_back(0.4 + 0.0003 * (i - 99.5));
    other.push_back(0.4 + 0.03 * (i % 2 == 0 ? 1.0 : -1.0));
  }
  return {.distribution = {},
          .generated = GeneratedNumbers{.sampler = "box-muller", .seed = 0x2012},
          .of_file = {},
          .found = stats::check_normal({sample, other, other}, {0.4, 0.03}).value()};
}

TEST(SamplerCheck, KeepsToItsSchema) {
  const Json json = Json::parse(check_normal_document().text(example_check()));
  EXPECT_EQ(objections("check_normal", json.dump()), "");
  for (const auto& [pointer, value] : {std::pair{"/skewness/p_value", "1.5"}, std::pair{"/skewness/nearness", "[]"},
                                       std::pair{"/correlations/0/between", "\"friends\""}, std::pair{"/refuted", "0"},
                                       std::pair{"/mean/nearness", "[]"}}) {
    EXPECT_NE(objections("check_normal", support::with(json, pointer, value).dump()), "") << pointer;
  }
}

TEST(SamplerCheck, WritesWhatWasFound) {
  const SamplerCheck check = example_check();
  const Json json = Json::parse(check_normal_document().text(check));
  EXPECT_EQ(json["n"], 200);
  EXPECT_EQ(json["kurtosis"]["nearness"][1]["probability"], check.found.kurtosis.nearness[1].probability);
  EXPECT_EQ(json["standard_deviation"]["p_value"], check.found.standard_deviation.p_value);
  EXPECT_EQ(json["correlations"].size(), 7U);
  EXPECT_EQ(json["correlations"][2]["between"], "lag_1");
  EXPECT_EQ(json["correlations"][2]["p_value"], check.found.correlations[2].test.p_value);
  EXPECT_EQ(json["refuted"], true) << "neighbours all but equal";
}

// skewness within 0.01, standard error sqrt(6 198/(201 203)) = 0.1706: erf(0.01/0.1706/sqrt 2) = 0.047
TEST(SamplerCheck, SaysInPlainWordsWhatIsRemarkable) {
  const std::string text = check_normal_summary(example_check());
  EXPECT_THAT(text,
              ::testing::HasSubstr("skewness within 0.01: expected in 5 % of normal samples of this size; within "));
  EXPECT_THAT(text, ::testing::ContainsRegex("mean +0\\.4 .* not remarkable\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("lag 1 .* not this distribution\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex(
                        "D'Agostino-Pearson .* 1 sample in [0-9.e+]+\n|D'Agostino-Pearson .* not this distribution\n"));
  EXPECT_THAT(text, ::testing::HasSubstr("smallest of 17 p-values: "));
}

TEST(Trajectory, StatesTheMassAndBothShapeAnglesOfABlockThatIsGivenSo) {
  Trajectory trajectory;
  trajectory.block.mass =
      dynamics::MassLayout{.left_edge = 0.25, .right_edge = 0.9, .centre_height = 1.0, .radius_of_gyration = 0.7};
  trajectory.strobe = {{.period = 1,
                        .tilt = 0.5,
                        .tilt_rate = 0.0,
                        .slip = 0.0,
                        .slip_rate = 0.0,
                        .contact = dynamics::ContactState::rock},
                       {.period = 2,
                        .tilt = -0.5,
                        .tilt_rate = 0.0,
                        .slip = 0.0,
                        .slip_rate = 0.0,
                        .contact = dynamics::ContactState::rock}};
  const std::string text = trajectory_document().text(trajectory_report({}, trajectory, TrajectoryUnits::si));
  EXPECT_EQ(objections("trajectory", text), "");
  const Json block = Json::parse(text)["block"];
  EXPECT_EQ(block["edges_m"], Json({0.25, 0.9}));
  EXPECT_EQ(block["radius_of_gyration_m"], 0.7);
  EXPECT_NEAR(block["shape_angles_rad"][0].get<double>(), std::atan(0.25), 1e-15);
  EXPECT_NEAR(block["shape_angles_rad"][1].get<double>(), std::atan(0.9), 1e-15);
  EXPECT_EQ(block["shape_angle_rad"], block["shape_angles_rad"][0]);
  // What is read has the units of its own block.
  const TrajectoryReport read = trajectory_document().read(Json::parse(text));
  const TrajectoryScales scales = read.scales();
  EXPECT_EQ(read.strobe[0].state.tilt / scales.tilt, 0.5);
  EXPECT_NEAR(read.strobe[1].state.tilt / scales.tilt / scales.right_share, -0.5, 1e-15);
}

}  // namespace
