// Sweeps: their points, the conditions that they make, and their faults.

#include "rocking/input/sweep.hpp"

#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/condition_family.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/restitution.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"

namespace {

using namespace rocking;
using support::example_experiment;
using support::with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Experiment read_with_sweep(const std::string& sweep) {
  return experiment_in(with(example_experiment(), "/sweep", sweep).dump());
}

std::vector<base::Problem> problems_with_sweep(const std::string& sweep) {
  try {
    static_cast<void>(read_with_sweep(sweep));
  } catch (const base::InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(Sweep, HasBothEndsAndNoRunningSum) {
  const auto experiment = experiment_in(example_experiment().dump());
  ASSERT_EQ(experiment.conditions.size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    const double expected =
        static_cast<double>(30 + i) / 10.0;  // 3.3 is read as the nearest double, and so is this quotient
    EXPECT_EQ(support::harmonic(experiment.conditions[i].scene).amplitude, expected);
    EXPECT_EQ(number_in(experiment.conditions[i].parameters[0].value), expected);
  }
  EXPECT_EQ(support::harmonic(experiment.conditions.back().scene).amplitude, 5.0);
}

std::vector<double> amplitudes_of(const std::string& range) {
  std::vector<double> amplitudes;
  const auto sweep = R"([{"parameter": "/excitation/amplitude", )" + range + "}]";
  for (const auto& condition : read_with_sweep(sweep).conditions) {
    amplitudes.push_back(mean_of(support::harmonic(condition.scene).amplitude));
  }
  return amplitudes;
}

TEST(Sweep, HasThePointsThatItsUserWouldWriteDown) {
  EXPECT_NE(1.0 + 7 * 0.1, 1.7) << "the case in point";
  EXPECT_THAT(amplitudes_of(R"("from": 1.0, "to": 1.8, "step": 0.1)"),
              ::testing::ElementsAre(1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8));
  EXPECT_THAT(amplitudes_of(R"("from": 0.7, "to": 0.1, "step": -0.2)"), ::testing::ElementsAre(0.7, 0.5, 0.3, 0.1));
  EXPECT_THAT(amplitudes_of(R"("from": 1.23e-7, "to": 1.26e-7, "step": 1e-9)"),
              ::testing::ElementsAre(1.23e-7, 1.24e-7, 1.25e-7, 1.26e-7));
}

TEST(Sweep, PassesThroughZeroExactly) {
  const auto sweep = R"([{"parameter": "/initial/tilt", "from": -0.3, "to": 0.3, "step": 0.1}])";
  const auto experiment = read_with_sweep(sweep);
  EXPECT_NE(-0.3 + 3 * 0.1, 0.0) << "the case in point";
  EXPECT_EQ(std::get<double>(experiment.conditions.at(3).scene.initial.tilt), 0.0);
}

TEST(Sweep, KeepsEveryBitOfItsEnds) {
  const auto points = amplitudes_of(R"("from": 0.3333333333333333, "to": 2.3333333333333335, "step": 1)");
  EXPECT_THAT(points, ::testing::ElementsAre(1.0 / 3.0, 1.33333333333, 7.0 / 3.0));
}

TEST(Sweep, MayRunDownwardsOrStandStill) {
  const auto down = read_with_sweep(R"([{"parameter": "/excitation/amplitude", "from": 5, "to": 3, "step": -0.5}])");
  ASSERT_EQ(down.conditions.size(), 5U);
  EXPECT_EQ(support::harmonic(down.conditions.back().scene).amplitude, 3.0);
  EXPECT_EQ(
      read_with_sweep(R"([{"parameter": "/excitation/amplitude", "from": 5, "to": 5, "step": 1}])").conditions.size(),
      1U);
}

TEST(Sweep, MakesAGridWhoseLastEntryVariesFastest) {
  const auto grid = read_with_sweep(
      R"([{"parameter": "/friction", "values": [{"static": 0.35, "kinetic": 0.3}, {"static": 0.4, "kinetic": 0.35}]},
                                        {"parameter": "/excitation/amplitude", "values": [1, 2, 3]}])");
  ASSERT_EQ(grid.conditions.size(), 6U);
  EXPECT_EQ(mean_static(*grid.conditions[2].scene.friction), 0.35);
  EXPECT_EQ(support::harmonic(grid.conditions[2].scene).amplitude, 3.0);
  EXPECT_EQ(mean_static(*grid.conditions[3].scene.friction), 0.4);
  EXPECT_EQ(support::harmonic(grid.conditions[3].scene).amplitude, 1.0);
  EXPECT_EQ(json_text_of(grid.conditions[3].parameters[0].value), R"({"static":0.4,"kinetic":0.35})");
  EXPECT_EQ(json_text_of(grid.conditions[3].parameters[1].value), "1.0");
}

TEST(Sweep, ChangesWhatFollowsFromTheValue) {
  const auto experiment = experiment_in(R"({"format": "rocking.experiment/1",
    "block": {"width_m": 1, "height_m": 4}, "excitation": {"amplitude": 2, "frequency_ratio": 10},
    "friction": {"static": 0.4, "kinetic": 0.3}, "fluctuation": {"friction": {"relative_sigma": 0.1}},
    "sweep": [{"parameter": "/formulation", "values": ["consistent", "as-printed", "as-plotted"]},
              {"parameter": "/friction/static", "values": [0.4, 0.8]}]})");
  ASSERT_EQ(experiment.conditions.size(), 6U);
  EXPECT_EQ(experiment.conditions[0].scene.slide_inertia, dynamics::SlideInertia::centroidal);
  EXPECT_EQ(experiment.conditions[2].scene.slide_inertia, dynamics::SlideInertia::edge);
  const Scene& as_printed = experiment.conditions[2].scene;
  const double e = mean_restitution(as_printed.restitution, dynamics::geometry_of(mean_block(as_printed)));
  EXPECT_NEAR(e, 1.0 - 1.5 / 17.0, 1e-15);
  EXPECT_EQ(experiment.conditions[4].scene.restitution, Restitution(0.0));
  EXPECT_EQ(experiment.conditions[4].scene.impact_slip_rule, dynamics::ImpactSlipRule::signed_ratio);
  EXPECT_DOUBLE_EQ(experiment.conditions[1].scene.fluctuation.static_friction, 0.08);
}

TEST(Sweep, GivesItsValuesTheirNames) {
  const std::string named =
      R"([{"parameter": "/excitation/amplitude", "values": [1, 2, 3], "names": ["low", "", "high"]}])";
  const auto experiment = read_with_sweep(named);
  std::vector<std::string> names;
  for (const Condition& condition : experiment.conditions) names.push_back(condition.parameters.front().name);
  EXPECT_THAT(names, ElementsAre("low", "", "high"));
  EXPECT_EQ(experiment.conditions[2].parameters.front(), (Parameter{"/excitation/amplitude", 3.0}));
  const auto again = experiment_in(experiment.canonical_text);
  EXPECT_EQ(again.canonical_text, experiment.canonical_text);
  EXPECT_EQ(again.conditions[2].parameters.front().name, "high");
  const auto extended = experiment_in(experiment.canonical_text, {.seed = {}, .realisations = {}, .levels = {2.5}});
  EXPECT_EQ(extended.conditions[2].parameters.front().name, "");
  EXPECT_EQ(extended.conditions[3].parameters.front().name, "high");
}

TEST(Sweep, OfBlocksWithAndWithoutAWallReadsBack) {
  const auto experiment = experiment_in(R"({"format": "rocking.experiment/1",
    "block": {"width_m": 1, "height_m": 4}, "excitation": {"amplitude": 2, "frequency_ratio": 10},
    "sweep": [{"parameter": "/block", "values": [{"width_m": 1, "height_m": 4},
      {"width_m": 1, "height_m": 4, "wall": {"side": "left", "rate_ratio": 0.5}}]}]})");
  ASSERT_EQ(experiment.conditions.size(), 2U);
  EXPECT_EQ(experiment.conditions[0].scene.restitution, Restitution(0.0));
  EXPECT_TRUE(experiment.conditions[1].scene.block.wall);
  EXPECT_EQ(experiment_in(experiment.canonical_text).conditions[1].scene, experiment.conditions[1].scene);
}

TEST(Sweep, TellsForWhichOfItsValuesAConditionIsBad) {
  const auto problems = problems_with_sweep(R"([{"parameter": "/friction/kinetic", "values": [0.3, 0.4, -0.1]}])");
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].place, "/friction/static");
  EXPECT_THAT(problems[0].reason, HasSubstr("(where the sweep sets /friction/kinetic = 0.4)"));
  EXPECT_EQ(problems[1].place, "/friction/kinetic");
  EXPECT_EQ(problems[1].value, "-0.1");
}

struct BadSweep {
  const char* sweep;
  const char* place;
  const char* reason;
  const char* remedy;
};

void PrintTo(const BadSweep& bad, std::ostream* out) { *out << bad.sweep; }

class SweepFault : public ::testing::TestWithParam<BadSweep> {};

TEST_P(SweepFault, IsToldWithPlaceReasonAndRemedy) {
  const auto problems = problems_with_sweep(GetParam().sweep);
  ASSERT_EQ(problems.size(), 1U) << base::InputError(problems).what();
  EXPECT_EQ(problems[0].place, GetParam().place);
  EXPECT_THAT(problems[0].reason, HasSubstr(GetParam().reason));
  EXPECT_THAT(problems[0].remedy, HasSubstr(GetParam().remedy));
}

INSTANTIATE_TEST_SUITE_P(
    All, SweepFault,
    ::testing::Values(
        BadSweep{"[]", "/sweep", "at least one entry", "omit \"sweep\""},
        BadSweep{"{}", "/sweep", "must be a list", "omit"}, BadSweep{"[3]", "/sweep/0", "must be an object", "{"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "values": []}])", "/sweep/0/values", "at least one", "["},
        BadSweep{R"([{"values": [1]}])", "/sweep/0/parameter", "is missing", "/excitation/amplitude"},
        BadSweep{R"([{"parameter": "/excitation/amplitud", "values": [1]}])", "/sweep/0/parameter",
                 "is not a value of this file", "/excitation/amplitude"},
        BadSweep{R"([{"parameter": "", "values": [1]}])", "/sweep/0/parameter", "is not a value of this file", ""},
        BadSweep{R"([{"parameter": 3, "values": [1]}])", "/sweep/0/parameter", "must be text", "quotes"},
        BadSweep{R"([{"parameter": "excitation", "values": [1]}])", "/sweep/0/parameter", "is not a value of this file",
                 ""},
        BadSweep{R"([{"parameter": "amplitude", "values": [1]}])", "/sweep/0/parameter", "is not a value of this file",
                 "did you mean \"/excitation/amplitude\"?"},
        BadSweep{R"([{"parameter": "x", "values": [1]}])", "/sweep/0/parameter", "is not a value of this file",
                 "such as \"/excitation/amplitude"},
        BadSweep{R"([{"parameter": "/seed", "values": [1]}])", "/sweep/0/parameter", "is not a value of this file", ""},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 2, "step": 0.3}])", "/sweep/0/step",
                 "does not divide", "1.9"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 2, "step": -0.5}])", "/sweep/0/step",
                 "leads away", "sign"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 2, "step": 0}])", "/sweep/0/step",
                 "must not be 0", "omit"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 2}])", "/sweep/0/step", "is missing",
                 "add"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "values": [1]}])", "/sweep/0/values", "excludes",
                 "keep one"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "values": [1, 2], "names": ["low"]}])", "/sweep/0/names",
                 "one for each of the 2 values", "[\"batteries high\""},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "values": [1, 2], "names": ["low", 2]}])", "/sweep/0/names",
                 "list of texts", "["},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "values": [1, 2], "names": ["low", "low"]}])",
                 "/sweep/0/names", "has \"low\" twice", "of its own"},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 2, "step": 1, "names": ["a", "b"]}])",
                 "/sweep/0/names", "is not a key", ""},
        BadSweep{R"([{"parameter": "/excitation/amplitude", "from": 0, "to": 1, "step": 1e-9}])", "/sweep/0/step",
                 "1000000", "larger"},
        BadSweep{
            R"([{"parameter": "/excitation/amplitude", "from": 1, "to": 10, "step": 0.001}, {"parameter": "/block/width_m", "from": 1, "to": 2, "step": 0.001}])",
            "/sweep", "1000000", "fewer"},
        BadSweep{
            R"([{"parameter": "/friction", "values": [{"static": 1, "kinetic": 1}]}, {"parameter": "/friction/static", "values": [1]}])",
            "/sweep/1/parameter", "also swept", "keep one"}));

TEST(SweptValue, IsWhatStandsInTheFile) {
  for (const char* text : {"4.0", "0.1", "1e+300", "3", "-7", "18446744073709551615", "\"jy25\"", "true", "[1,2.5]",
                           R"({"rate_ratio":0.9})"}) {
    EXPECT_EQ(json_text_of(swept_value(Json::parse(text))), text);
  }
  EXPECT_EQ(number_in(swept_value(Json(4.5))), 4.5);
  EXPECT_EQ(number_in(swept_value(Json(3))), 3.0);
  EXPECT_EQ(number_in(swept_value(Json("4.5"))), std::nullopt);
  EXPECT_EQ(number_in(swept_value(Json::parse("[4.5]"))), std::nullopt);
}

TEST(Sweep, OfRealisationsExcludesTheFlag) {
  const auto document = with(example_experiment(), "/sweep", R"([{"parameter": "/realisations", "values": [10, 20]}])");
  EXPECT_EQ(experiment_in(document.dump()).conditions[1].realisations, 20U);
  EXPECT_THROW(static_cast<void>(experiment_in(document.dump(), {.seed = {}, .realisations = "5"})), base::InputError);
}

std::vector<std::string> numbers_of(const Json& document) {
  std::vector<std::string> pointers;
  const Json flat = document.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (value.is_number()) pointers.push_back(pointer);
  }
  return pointers;
}

/// A file with every number that a condition may have, and another one with those that exclude these.
const std::vector<std::string> with_every_number{
    R"({"block": {"width_m": 1.0, "height_m": {"normal": {"mean": 4.0, "sigma": 0.01, "between": [3.5, 4.5]}}},
        "restitution": 0.1, "excitation": {"amplitude": 4.2, "frequency_ratio": 10.0, "phase_rad": 0.1},
        "friction": {"static": 0.35, "kinetic": 0.30},
        "fluctuation": {"friction": {"sigma": 0.03, "correlation": 0.5, "refreshes_per_period": 100},
                        "restitution": {"sigma": 0.01}, "amplitude": {"sigma": 0.1}},
        "initial": {"tilt": 0.1, "tilt_rate": 0.2, "slip_rate": 0.3},
        "horizon": {"until_classified": {"at_most_periods": 10000, "held_windows": 3, "watch_windows": 4,
                                         "long_run_every": 5, "exponent_pause": 6}},
        "realisations": 10})",
    R"({"block": {"width_m": {"uniform": [0.9, 1.1]}, "height_m": 4.0, "gravity_m_s2": 9.7},
        "restitution": {"rate_ratio": 0.9}, "excitation": {"amplitude_g": 1.2, "frequency_hz": 3.0},
        "friction": {"static": 0.35, "kinetic": {"ratio": 0.8}},
        "fluctuation": {"static_friction": {"sigma": 0.03},
                        "kinetic_friction": {"sigma": 0.02, "refresh_slip_m": 0.01}},
        "realisations": {"until": {"half_width": 0.05, "at_most": 1000}}})",
    R"({"block": {"width_m": 1.0, "height_m": 4.0},
        "excitation": {"kind": "pulse", "shape": "sine", "amplitude_m_s2": 12.0, "period_s": 0.5},
        "realisations": {"until": {"relative_half_width": 0.2, "mode": "overturned", "at_most": 1000}}})"};

TEST(ConditionMaker, SetsEveryNumberAsIfTheExperimentWereReadAnew) {
  std::size_t compared = 0;
  for (const std::string& text : with_every_number) {
    Json document = Json::parse(text);
    document["format"] = "rocking.experiment/1";
    const Experiment experiment = experiment_in(document.dump());
    const ConditionMaker family(experiment);
    for (const std::string& pointer : numbers_of(Json::parse(experiment.canonical_text))) {
      const double number = family.number(pointer).value();
      std::size_t allowed = 0;
      for (const double value : {number + 1.0, number * 1.01, number * 0.99, 0.0, -1.0, 1e9}) {
        std::optional<Condition> right;
        try {
          right = family.read({{pointer, value}});
        } catch (const base::InputError&) {
        }
        const auto found = family.set({{pointer, value}});
        EXPECT_TRUE(found == right) << pointer << " = " << value;
        allowed += right ? 1 : 0;
      }
      EXPECT_GE(allowed, 1U) << pointer;
      compared += allowed;
    }
  }
  EXPECT_GE(compared, 100U);
}

// Two of one law among them: the law has both.
TEST(ConditionMaker, SetsTwoNumbersAsIfTheExperimentWereReadAnew) {
  std::size_t compared = 0;
  for (const std::string& text : with_every_number) {
    Json document = Json::parse(text);
    document["format"] = "rocking.experiment/1";
    const Experiment experiment = experiment_in(document.dump());
    const ConditionMaker family(experiment);
    const auto pointers = numbers_of(Json::parse(experiment.canonical_text));
    for (auto one = pointers.begin(); std::next(one) != pointers.end(); ++one) {
      const std::string& other = *std::next(one);
      const std::vector<Parameter> values{{*one, 1.001 * family.number(*one).value()},
                                          {other, 0.999 * family.number(other).value()}};
      std::optional<Condition> right;
      try {
        right = family.read(values);
      } catch (const base::InputError&) {
        continue;
      }
      EXPECT_TRUE(family.set(values) == right) << *one << ' ' << other;
      ++compared;
    }
  }
  EXPECT_GE(compared, 20U);
}

TEST(ConditionMaker, ReadsTheExperimentWhereMoreFollowsFromANumber) {
  const Json relative = with(example_experiment(), "/fluctuation/friction", R"({"relative_sigma": 0.1})");
  const Json pulse = with(with(with(example_experiment(), "/fluctuation", "{}"), "/excitation",
                               R"({"kind": "pulse", "shape": "sine", "amplitude": 4, "frequency_ratio": 9})"),
                          "/sweep", R"([{"parameter": "/block/width_m", "values": [1, 2]}])");
  for (const auto& [document, pointer] :
       {std::pair(relative, "/friction/static"), std::pair(support::without(pulse, "horizon"), "/block/width_m")}) {
    const ConditionMaker family(experiment_in(document.dump()));
    const std::vector<Parameter> values{{pointer, 0.7}};
    EXPECT_FALSE(family.set(values));
    EXPECT_FALSE(family(values) == family({{pointer, 0.8}}));
    EXPECT_TRUE(family(values) == family.read(values));
  }
}

TEST(ConditionMaker, TellsWhatIsWrongAsTheReaderDoes) {
  const ConditionMaker family(experiment_in(example_experiment().dump()));
  try {
    static_cast<void>(family({{"/friction/static", 0.2}}));
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_EQ(error.problems().front().place, "/friction/static");
    EXPECT_THAT(error.problems().front().reason, HasSubstr("is below the kinetic coefficient, 0.3"));
  }
}

}  // namespace
