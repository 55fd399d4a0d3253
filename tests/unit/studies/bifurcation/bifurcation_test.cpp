// A continuation passes on everything on which a motion depends; diagrams show coexisting responses.

#include "rocking/studies/bifurcation/study.hpp"

#include <bit>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/continuation.hpp"
#include "rocking/realisation/strobe_recorder.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"

namespace {

using namespace rocking;
using section::ResponseMode;
using section::StrobePoint;

constexpr std::uint64_t sweep_seed = 0x2012;

/// Every source of fluctuation is on, so that a count that is not passed on is detected.
Condition fluctuating_condition(double amplitude, double friction = 0.35) {
  Condition condition;
  condition.scene.block = {.width = 1.0, .height = 4.0, .gravity = 9.81};
  support::harmonic(condition.scene).amplitude = amplitude;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.friction = Friction{.static_coefficient = friction, .kinetic_coefficient = friction - 0.05};
  condition.scene.fluctuation = {.static_friction = 0.05,
                                 .kinetic_friction = 0.05,
                                 .refreshes_per_period = 20,
                                 .restitution = 0.02,
                                 .amplitude = 0.3};
  condition.horizon = {.transient_periods = 2, .sampled_periods = 3};
  condition.tolerance = 1e-10;
  return condition;
}

bool have_same_bits(const StrobePoint& a, const StrobePoint& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return bits(a.tilt) == bits(b.tilt) && bits(a.tilt_rate) == bits(b.tilt_rate) &&
         bits(a.slip_rate) == bits(b.slip_rate);
}

/// One motion whose Taylor steps end after every `stretch` strobe points, as those of a continuation do.
std::vector<StrobePoint> one_long_run(const Condition& condition, std::uint64_t realisation, int stretches) {
  const random::Draws draws(sweep_seed, realisation);
  const int stretch = condition.horizon.transient_periods + condition.horizon.sampled_periods;
  StrobeRecorder recorder(dynamics::geometry_of(mean_block(condition.scene)), stretch * stretches);
  const auto beginning =
      begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare, stretch);
  Motion motion = motion_of(condition.scene, beginning, recorder);
  integrate::advance(motion);
  for (int i = 1; i < stretches; ++i) {
    motion.move_to_last_strobe();
    motion.extend(stretch);
    integrate::advance(motion);
  }
  std::vector<StrobePoint> points;
  for (const section::Period& period : recorder.periods()) points.push_back(period.point);
  return points;
}

TEST(Continuation, IsOneLongRunToTheBitWhileTheParameterStays) {
  constexpr int runs = 6;
  std::set<dynamics::ContactState> handed_on;
  struct Shaking {
    double amplitude;
    double friction;
  };
  for (const auto& [amplitude, friction] : {Shaking{1.1, 0.35}, Shaking{1.6, 0.2}, Shaking{4.2, 0.35}}) {
    const Condition condition = fluctuating_condition(amplitude, friction);
    for (std::uint64_t realisation = 0; realisation < 25; ++realisation) {
      Continuation continuation(random::Draws(sweep_seed, realisation));
      std::vector<StrobePoint> points;
      for (int i = 0; i < runs; ++i) {
        const RealisationResult result = continuation.run(condition);
        points.insert(points.end(), result.strobe.begin(), result.strobe.end());
        if (!continuation.can_go_on()) break;
        handed_on.insert(continuation.motion()->state().contact);
      }
      const auto expected = one_long_run(condition, realisation, runs);
      ASSERT_EQ(points.size(), expected.size()) << amplitude << ", realisation " << realisation;
      for (std::size_t k = 0; k < points.size(); ++k) {
        ASSERT_TRUE(have_same_bits(points[k], expected[k]))
            << "A_h " << amplitude << ", realisation " << realisation << ", period " << k + 1;
      }
    }
  }
  EXPECT_EQ(handed_on.size(), 4U) << "rest, slide, rock and rock_slide are to be handed on";
}

// A run without these ends has other Taylor steps. A strobe point of an attracting response is accurate to 1000
// tolerances, which the classifier also assumes.
TEST(Continuation, GivesThePointsOfARunThatIsNotCut) {
  Condition condition = fluctuating_condition(3.0);
  condition.scene.fluctuation = {};
  condition.horizon = {.transient_periods = 20, .sampled_periods = 30};
  Condition longer = condition;
  longer.horizon.sampled_periods = 180;
  const RealisationResult expected = realise(longer, sweep_seed, 0);
  Continuation continuation(random::Draws(sweep_seed, 0));
  for (std::size_t i = 0; i < 4; ++i) {
    const RealisationResult result = continuation.run(condition);
    ASSERT_EQ(result.strobe.size(), 50U);
    for (std::size_t k = 0; k < 50; ++k) {
      EXPECT_NEAR(result.strobe[k].tilt, expected.strobe[50 * i + k].tilt, 1e-7);
      EXPECT_NEAR(result.strobe[k].tilt_rate, expected.strobe[50 * i + k].tilt_rate, 1e-7);
    }
  }
}

TEST(Continuation, KeepsStateAndPartOfThePeriodWhereTheFrequencyChanges) {
  Condition condition = fluctuating_condition(4.2);
  Continuation continuation(random::Draws(sweep_seed, 3));
  const RealisationResult before = continuation.run(condition);
  const dynamics::State last = continuation.motion()->state();
  const double psi = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
  EXPECT_EQ(last.tilt / psi, before.strobe.back().tilt);
  EXPECT_EQ(last.tilt_rate / psi, before.strobe.back().tilt_rate);
  support::harmonic(condition.scene).frequency_ratio = 8.0;
  ASSERT_EQ(continuation.run(condition).strobe.size(), 5U);
  const dynamics::Clock& clock = continuation.motion()->clock();
  EXPECT_EQ(clock.frequency(), 8.0);
  const double since_strobe = -clock.until({.period = 10, .time = 0.0});
  EXPECT_LE(std::abs(since_strobe), clock.resolution());
}

Json swept(const std::string& sweep) {
  Json document = support::least_experiment();
  document["horizon"] = {{"transient_periods", 200}, {"sampled_periods", 40}};
  document["accuracy"] = {{"tolerance", 1e-10}};
  document["sweep"] = Json::parse(sweep);
  return document;
}

Experiment experiment_from(const Json& document) { return experiment_in(document.dump(), {}); }

std::vector<Diagram> drawn(const Experiment& experiment, unsigned threads = 1) {
  return bifurcation(experiment, 0, {.threads = threads});
}

const std::vector<DiagramStep>& branch_of(const Diagram& diagram, DiagramBranch branch) {
  return diagram.branches[static_cast<std::size_t>(branch)];
}

std::vector<std::string> modes_of(const Diagram& diagram, DiagramBranch branch) {
  std::vector<std::string> modes;
  for (const DiagramStep& step : branch_of(diagram, branch)) modes.push_back(to_string(step.classification.mode));
  return modes;
}

// Without sliding a (1,1) response coexists with a (1,3) one near A_h = 4.5. From rest the block reaches (1,3) there
// and (1,1) at 3.5.
TEST(Diagram, ShowsCoexistingResponsesOnDifferentBranches) {
  const auto diagrams = drawn(
      experiment_from(swept(R"([{ "parameter": "/excitation/amplitude", "from": 3.5, "to": 4.5, "step": 0.1 }])")));
  ASSERT_EQ(diagrams.size(), 1U);
  const auto& upwards = branch_of(diagrams[0], DiagramBranch::upwards).back();
  const auto& downwards = branch_of(diagrams[0], DiagramBranch::downwards).back();
  EXPECT_EQ(to_string(upwards.classification.mode), "(1,1)");
  EXPECT_TRUE(upwards.continued);
  EXPECT_EQ(to_string(downwards.classification.mode), "(1,3)");
  EXPECT_FALSE(downwards.continued);
  EXPECT_EQ(to_string(branch_of(diagrams[0], DiagramBranch::downwards)[9].classification.mode), "(1,3)");
  EXPECT_TRUE(branch_of(diagrams[0], DiagramBranch::downwards)[9].continued);
  for (const DiagramStep& step : branch_of(diagrams[0], DiagramBranch::initial)) EXPECT_FALSE(step.continued);
  EXPECT_EQ(modes_of(diagrams[0], DiagramBranch::initial).front(), "(1,1)");
  EXPECT_EQ(modes_of(diagrams[0], DiagramBranch::initial).back(), "(1,3)");
}

TEST(Diagram, HasAGapWhereTheBlockOverturnsAndStartsAnewBehindIt) {
  const Experiment experiment =
      experiment_from(swept(R"([{ "parameter": "/excitation/amplitude", "values": [3.0, 4.5, 40.0, 4.6, 50.0] }])"));
  const Diagram diagram = drawn(experiment).front();
  for (const DiagramBranch branch : all_branches) {
    const auto& steps = branch_of(diagram, branch);
    for (const std::size_t high : {3U, 4U}) {
      EXPECT_EQ(steps[high].termination, dynamics::Termination::overturned);
      EXPECT_TRUE(steps[high].points.empty());
    }
    for (const std::size_t low : {0U, 1U, 2U}) EXPECT_EQ(steps[low].points.size(), 40U);
  }
  const auto& upwards = branch_of(diagram, DiagramBranch::upwards);
  EXPECT_TRUE(upwards[3].continued);
  EXPECT_FALSE(upwards[4].continued);
  const auto& downwards = branch_of(diagram, DiagramBranch::downwards);
  EXPECT_FALSE(downwards[2].continued);
  EXPECT_TRUE(downwards[1].continued);
  const auto& initial = branch_of(diagram, DiagramBranch::initial);
  for (std::size_t k = 0; k < 40; ++k) EXPECT_TRUE(have_same_bits(downwards[2].points[k], initial[2].points[k]));
  const std::string table = bifurcation_table(experiment, {diagram});
  EXPECT_NE(table.find("(1,3) *\n"), std::string::npos) << table;
}

TEST(Diagram, FromTheInitialStateIsWhatARunGives) {
  Json document = swept(R"([{ "parameter": "/excitation/amplitude", "values": [3.0, 4.5] }])");
  document["friction"] = {{"static", 0.35}, {"kinetic", 0.30}};
  document["fluctuation"]["friction"] = {{"sigma", 0.03}};
  const Experiment experiment = experiment_from(document);
  const auto diagrams = bifurcation(experiment, 7);
  for (const DiagramStep& step : branch_of(diagrams[0], DiagramBranch::initial)) {
    const RealisationResult result = realise(experiment.conditions[step.condition], experiment.seed, 7);
    EXPECT_EQ(step.classification.mode, result.classification.mode);
    ASSERT_EQ(step.points.size(), 40U);
    for (std::size_t k = 0; k < 40; ++k) EXPECT_TRUE(have_same_bits(step.points[k], result.strobe[200 + k]));
  }
}

TEST(Diagram, IsOneForEachPointOfTheOtherEntriesByGrowingParameter) {
  const Experiment experiment =
      experiment_from(swept(R"([{ "parameter": "/excitation/amplitude", "from": 4.0, "to": 3.0, "step": -0.5 },
                                { "parameter": "/block/height_m", "values": [4.0, 3.9] }])"));
  const auto diagrams = diagrams_of(experiment);
  ASSERT_EQ(diagrams.size(), 2U);
  EXPECT_EQ(diagrams[0].conditions, (std::vector<std::size_t>{4, 2, 0}));
  EXPECT_EQ(diagrams[1].conditions, (std::vector<std::size_t>{5, 3, 1}));
}

TEST(Diagram, HasTheSameBytesForAnyNumberOfThreads) {
  Json document = swept(R"([{ "parameter": "/excitation/amplitude", "from": 3.0, "to": 5.0, "step": 0.5 },
                            { "parameter": "/friction/static", "values": [0.35, 0.4] }])");
  document["friction"] = {{"static", 0.35}, {"kinetic", 0.30}};
  document["fluctuation"]["friction"] = {{"sigma", 0.03}};
  const Experiment experiment = experiment_from(document);
  const auto text = [&experiment](unsigned threads) {
    return bifurcation_document().text(bifurcation_report(experiment, 0, drawn(experiment, threads)));
  };
  const std::string expected = text(1);
  for (const unsigned threads : {2U, 3U, 8U}) {
    EXPECT_EQ(text(threads), expected) << threads;
  }
}

TEST(Diagram, IsNotMadeWhereItWasAskedToStop) {
  const Experiment experiment = experiment_from(swept(R"([{ "parameter": "/block/height_m", "values": [4.0, 3.9] }])"));
  const auto stop_at_third = [](std::uint64_t done, std::uint64_t all) {
    EXPECT_EQ(all, 6U);
    return done == 3 ? Decision::stop : Decision::proceed;
  };
  EXPECT_THROW(static_cast<void>(bifurcation(experiment, 0, {.on_progress = stop_at_third})), base::Stopped);
}

std::string place_of_problem(const Json& document) {
  try {
    static_cast<void>(diagrams_of(experiment_from(document)));
  } catch (const base::InputError& error) {
    return error.problems().front().place;
  }
  return "none";
}

TEST(Diagram, NeedsASweptNumber) {
  EXPECT_EQ(place_of_problem(support::least_experiment()), "/sweep");
  EXPECT_EQ(place_of_problem(swept(R"([{ "parameter": "/formulation", "values": ["consistent"] }])")), "/sweep/0");
  EXPECT_EQ(place_of_problem(swept(R"([{ "parameter": "/block/height_m", "values": [4.0] }])")), "none");
}

}  // namespace
