// The experiment with all defaults: equal for equal experiments, and complete.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/text/files.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"

namespace {

using namespace rocking;
using support::example_experiment;
using support::least_experiment;
using support::with;

std::string canonical(const Json& document) { return experiment_in(document.dump()).canonical_text; }

TEST(CanonicalText, IsItsOwnCanonicalText) {
  for (
      const Json& document :
      {example_experiment(), least_experiment(),
       with(example_experiment(), "/sweep",
            R"([{"parameter": "/formulation", "values": ["as-printed", "consistent"]}])"),
       with(
           example_experiment(), "/sweep",
           R"([{"parameter": "/block/height_m", "values": [4, 3e0]}, {"parameter": "/realisations", "from": 10, "to": 30, "step": 10}])"),
       with(least_experiment(), "/realisations", R"({"until": {"at_most": 900, "half_width": 2e-2}})"),
       with(least_experiment(), "/realisations",
            R"json({"until": {"at_most": 900, "mode": "(1,3)", "relative_half_width": 0.1}})json"),
       with(least_experiment(), "/initial/tilt", R"({"normal": {"mean": 0.1, "sigma": 0.01}})")}) {
    const std::string once = canonical(document);
    EXPECT_EQ(canonical(Json::parse(once)), once);
  }
}

TEST(CanonicalText, DoesNotDependOnSpelling) {
  const std::string spelled_otherwise = R"({"seed": 8210, "confidence": 95e-2, "realisations": 2e2,
    "sweep": [{"step": 0.1, "to": 5, "from": 3, "parameter": "/excitation/amplitude"}],
    "accuracy": {"tolerance": 0.1e-9}, "fluctuation": {"friction": {"sigma": 3e-2}},
    "friction": {"kinetic": 0.3, "static": 0.35},
    "excitation": {"frequency_ratio": 10, "amplitude": 4.20}, "block": {"height_m": 4, "width_m": 1},
    "title": "Does the same shaking give the same rocking?", "format": "rocking.experiment/1"})";
  EXPECT_EQ(experiment_in(spelled_otherwise).canonical_text, canonical(example_experiment()));
}

TEST(CanonicalText, WritesEveryDefaultOut) {
  EXPECT_EQ(
      canonical(least_experiment()),
      R"({"format":"rocking.experiment/1","title":"","block":{"width_m":1.0,"height_m":4.0,"gravity_m_s2":9.81},)"
      R"("formulation":"consistent","slide_inertia":"centroidal","restitution":0.0,"impact_slip_rule":"absolute",)"
      R"("excitation":{"kind":"harmonic","amplitude":4.2,"frequency_ratio":10.0,"phase_rad":0.0},)"
      R"("initial":{"tilt":0.0,"tilt_rate":0.0},"horizon":{"transient_periods":500,"sampled_periods":120},)"
      R"("accuracy":{"tolerance":1e-13,"rerun_every":10},"realisations":1,"confidence":0.95,"seed":"0x0"})");
}

TEST(GoneKey, IsRefusedWithWhatToDoInstead) {
  const auto remedy_of = [](const Json& document) {
    try {
      (void)experiment_in(document.dump());
    } catch (const base::InputError& error) {
      return error.problems().at(0).remedy;
    }
    return std::string("none");
  };
  EXPECT_THAT(remedy_of(with(least_experiment(), "/accuracy/repeat_every", "3")), testing::HasSubstr("rerun_every"));
  EXPECT_THAT(remedy_of(with(least_experiment(), "/check_labels", R"({"every": 2})")), testing::HasSubstr("backed_by"));
}

TEST(CanonicalText, NamesTheOptionsOfAFormulation) {
  const Json printed = Json::parse(canonical(with(least_experiment(), "/formulation", "\"as-printed\"")));
  EXPECT_EQ(printed["slide_inertia"], "edge");
  EXPECT_EQ(printed["restitution"], "jy25");
  EXPECT_EQ(printed["impact_slip_rule"], "signed");
  const Json mixed =
      Json::parse(canonical(with(with(least_experiment(), "/formulation", "\"as-printed\""), "/restitution", "0.5")));
  EXPECT_EQ(mixed["restitution"], 0.5);
  EXPECT_EQ(mixed["slide_inertia"], "edge");
}

TEST(CanonicalText, HoldsWhatTheFlagsSay) {
  const auto experiment = experiment_in(example_experiment().dump(), {.seed = "17", .realisations = "3"});
  EXPECT_EQ(experiment.seed, 17U);
  EXPECT_EQ(experiment.conditions[0].realisations, 3U);
  const Json written = Json::parse(experiment.canonical_text);
  EXPECT_EQ(written["seed"], "0x11");
  EXPECT_EQ(written["realisations"], 3);
}

TEST(CanonicalText, KeepsEveryBitOfANumber) {
  for (const double amplitude : {4.2, 1.0 / 3.0, 0x1.fffffffffffffp1, 5e-324, 123456.789012345678}) {
    const auto document = with(least_experiment(), "/excitation/amplitude", Json(amplitude).dump());
    const auto experiment = experiment_in(canonical(document));
    EXPECT_EQ(support::harmonic(experiment.conditions[0].scene).amplitude, amplitude);
  }
}

TEST(Seed, MeansTheSameHoweverItIsWritten) {
  constexpr std::uint64_t largest = ~std::uint64_t{0};
  for (const std::string text :
       {"\"0xffffffffffffffff\"", "\"0xFFFFFFFFFFFFFFFF\"", "\"18446744073709551615\"", "18446744073709551615"}) {
    EXPECT_EQ(experiment_in(with(least_experiment(), "/seed", text).dump()).seed, largest) << text;
  }
}

TEST(Fluctuation, IsSharedByBothFrictionsUnderOneName) {
  const auto scene = experiment_in(example_experiment().dump()).conditions[0].scene;
  EXPECT_EQ(scene.fluctuation.static_friction, 0.03);
  EXPECT_EQ(scene.fluctuation.kinetic_friction, 0.03);
  EXPECT_EQ(scene.fluctuation.refreshes_per_period, 200);
  EXPECT_EQ(scene.fluctuation.restitution, 0.0);
}

TEST(Fluctuation, MayBeSetForEachFrictionByItself) {
  const auto document = with(example_experiment(), "/fluctuation", R"({"static_friction": {"sigma": 0.01},
    "kinetic_friction": {"relative_sigma": 0.1, "refreshes_per_period": 50}, "amplitude": {"relative_sigma": 0.5}})");
  const auto scene = experiment_in(document.dump()).conditions[0].scene;
  EXPECT_EQ(scene.fluctuation.static_friction, 0.01);
  EXPECT_DOUBLE_EQ(scene.fluctuation.kinetic_friction, 0.03);
  EXPECT_EQ(scene.fluctuation.refreshes_per_period, 50);
  EXPECT_EQ(scene.fluctuation.amplitude, 0.5 * mean_of(support::harmonic(scene).amplitude));
}

}  // namespace
