// What a realisation draws once: from which source, limited to what, and what it is in force for.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/restitution.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using random::Source;
using support::least_experiment;
using support::with;

const random::Draws draws_once(0x2012, 5);

Scene scene_with_laws() {
  Scene scene;
  support::harmonic(scene) = {.amplitude = Lognormal{4.0, 0.4}, .frequency_ratio = Uniform{8.0, 12.0}};
  scene.restitution = Triangular{0.1, 0.2, 0.4};
  scene.friction =
      Friction{.static_coefficient = Normal{0.5, 0.05}, .kinetic_coefficient = Values{.values = {0.3, 0.4}}};
  return scene;
}

TEST(DrawnOnce, HasASourceOfItsOwnForEachNumber) {
  Scene scene = scene_with_laws();
  support::harmonic(scene).vertical = VerticalHarmonic{};
  std::set<Source> sources;
  std::set<std::string_view> places;
  for_each_quantity(scene, [&](const QuantityPlace& what, Quantity& quantity) {
    EXPECT_TRUE(sources.insert(what.source).second) << what.name;
    EXPECT_TRUE(places.insert(what.place).second) << what.name;
    EXPECT_FALSE(is_drawn_along_the_way(what.source));
    quantity = Uniform{0.1, 0.2};
  });
  EXPECT_EQ(sources.size(), 15U)
      << "two lengths, restitution, three of the shaking and of its vertical part, two of friction, four of the start";
  EXPECT_EQ(start_of(scene, draws_once).draws, 15U);
}

TEST(DrawnOnce, IsInForceForTheWholeRealisation) {
  const Scene asked = scene_with_laws();
  const Start start = start_of(asked, draws_once);
  EXPECT_EQ(start.draws, 5U);
  const auto harmonic = std::get<Harmonic>(start.scene.excitation);
  EXPECT_EQ(mean_of(harmonic.amplitude),
            Lognormal({4.0, 0.4}).at(draws_once.standard_normal(Source::excitation_size, 0)));
  EXPECT_EQ(mean_of(harmonic.frequency_ratio), 8.0 + 4.0 * draws_once.uniform(Source::excitation_frequency, 0));
  EXPECT_EQ(mean_static(*start.scene.friction),
            0.5 + 0.05 * draws_once.standard_normal(Source::mean_static_friction, 0));
  EXPECT_EQ(mean_kinetic(*start.scene.friction),
            draws_once.uniform(Source::mean_kinetic_friction, 0) < 0.5 ? 0.3 : 0.4);

  Condition condition;
  condition.scene = asked;
  const Beginning beginning = begin_realisation(condition, draws_once, start, Strobe::poincare, 1);
  SceneCoefficients coefficients = beginning.coefficients;
  EXPECT_EQ(beginning.clock.frequency(), mean_of(harmonic.frequency_ratio));
  EXPECT_EQ(coefficients.amplitude(beginning.clock), mean_of(harmonic.amplitude));
  EXPECT_EQ(coefficients.static_friction(), mean_static(*start.scene.friction));
  EXPECT_EQ(coefficients.restitution(), mean_of(std::get<Quantity>(start.scene.restitution)));
  coefficients.stop();
  EXPECT_EQ(coefficients.static_friction(), mean_static(*start.scene.friction));
}

TEST(DrawnOnce, IsTheMeanOfWhatFluctuatesAroundIt) {
  Scene scene = scene_with_laws();
  scene.fluctuation.static_friction = 0.01;
  const Start start = start_of(scene, draws_once);
  const SceneCoefficients coefficients(start.scene, draws_once, start.geometry);
  EXPECT_EQ(coefficients.static_friction(),
            mean_static(*start.scene.friction) + 0.01 * draws_once.standard_normal(Source::static_friction, 0));
}

TEST(DrawnOnce, GivesKineticFrictionByItsRatio) {
  Scene scene = scene_with_laws();
  scene.friction->kinetic_ratio = 0.8;
  const Start start = start_of(scene, draws_once);
  EXPECT_EQ(mean_kinetic(*start.scene.friction), 0.8 * mean_static(*start.scene.friction));
  EXPECT_EQ(start.draws, 4U) << "the coefficient itself is not drawn";
}

TEST(DrawnOnce, IsLimitedWhereItsLawHasNoBounds) {
  Scene scene;
  scene.friction = Friction{.static_coefficient = Normal{0.1, 1.0}, .kinetic_coefficient = Normal{0.1, 1.0}};
  scene.restitution = Normal{0.0, 2.0};
  support::harmonic(scene).amplitude = Normal{0.5, 1.0};
  Clamps all;
  for (std::uint64_t realisation = 0; realisation < 200; ++realisation) {
    const Start start = start_of(scene, random::Draws(1, realisation));
    EXPECT_GE(mean_static(*start.scene.friction), 0.0);
    EXPECT_GE(mean_kinetic(*start.scene.friction), 0.0);
    EXPECT_GE(size_of(start.scene.excitation), 0.0);
    const double e = mean_of(std::get<Quantity>(start.scene.restitution));
    EXPECT_TRUE(least_restitution <= e && e <= largest_restitution);
    all += start.clamps;
  }
  for (const std::uint64_t count : {all.static_at_zero, all.kinetic_at_zero, all.restitution, all.amplitude_at_zero}) {
    EXPECT_GT(count, 20U);
    EXPECT_LT(count, 180U);
  }
}

TEST(DrawnOnce, KeepsAMeasuredRatioWithinPossibleRestitutions) {
  Scene scene;
  scene.friction = Friction{.static_coefficient = 0.4, .kinetic_coefficient = 0.35};
  scene.restitution = RateRatio{Normal{0.9, 0.2}};
  std::uint64_t limited = 0;
  double least = 0.0, largest = 0.0;
  for (std::uint64_t realisation = 0; realisation < 200; ++realisation) {
    const Start start = start_of(scene, random::Draws(1, realisation));
    const double e = mean_restitution(start.scene.restitution, start.geometry);
    least = std::min(least, e);
    largest = std::max(largest, e);
    limited += start.clamps.restitution;
  }
  EXPECT_GT(limited, 20U);
  EXPECT_NEAR(least, least_restitution, 1e-12);
  EXPECT_NEAR(largest, largest_restitution, 1e-12);
}

// In the units of each block; a law without bounds gives no negative amplitude.
TEST(DrawnOnce, GivesTheVerticalMotionOfEachBlock) {
  Condition condition;
  condition.scene = scene_with_laws();
  condition.scene.block.width = Uniform{0.9, 1.1};
  support::harmonic(condition.scene).vertical =
      VerticalHarmonic{.amplitude = Normal{1.0, 0.8}, .frequency_ratio = 20.0, .phase = Uniform{-9.0, 9.0}};
  for (std::uint64_t realisation = 0; realisation < 50; ++realisation) {
    const random::Draws own(1, realisation);
    const Start start = start_of(condition.scene, own);
    const dynamics::VerticalSine sine = begin_realisation(condition, own, start, Strobe::poincare, 1).shaking.vertical;
    const double amplitude = std::max(0.0, 1.0 + 0.8 * own.standard_normal(Source::vertical_size, 0));
    EXPECT_EQ(sine.amplitude, amplitude * start.geometry.shape_angle);
    const double phase = -9.0 + 18.0 * own.uniform(Source::vertical_phase, 0);
    EXPECT_NEAR(std::sin(sine.phase), std::sin(phase), 1e-14);
    EXPECT_TRUE(0.0 <= sine.phase && sine.phase < 6.2832);
    EXPECT_NEAR(sine.cycles / sine.periods, 20.0 / mean_of(std::get<Harmonic>(start.scene.excitation).frequency_ratio),
                1e-14);
  }
}

TEST(DrawnOnce, GivesEachEdgeItsRatioFromItsOwnSource) {
  Scene scene;
  scene.restitution = RateRatio{.value = Normal{0.92, 0.01}, .right = Uniform{0.93, 0.95}};
  const Start start = start_of(scene, draws_once);
  EXPECT_EQ(start.draws, 2U);
  const auto ratio = std::get<RateRatio>(start.scene.restitution);
  EXPECT_EQ(mean_of(ratio.value), Normal({0.92, 0.01}).at(draws_once.standard_normal(Source::mean_restitution, 0)));
  EXPECT_EQ(mean_of(*ratio.right), Uniform({0.93, 0.95}).at(draws_once.uniform(Source::mean_right_restitution, 0)));
  scene.restitution = RateRatio{.value = Normal{0.92, 0.01}};
  EXPECT_EQ(start_of(scene, draws_once).scene.restitution, Restitution(RateRatio{ratio.value}))
      << "the number of the left edge keeps the draws of the only number";
}

TEST(DrawnOnce, KeepsTheRatioOfEachEdgeWithinWhatIsPossibleThere) {
  Scene scene;
  scene.block.mass = GivenEdges{.edges = {0.3, 0.6}, .centre_height = 1.6, .radius_of_gyration = 0.9};
  scene.friction = Friction{.static_coefficient = 0.4, .kinetic_coefficient = 0.35};
  for (const bool are_two : {false, true}) {
    scene.restitution = RateRatio{.value = Normal{0.9, 0.3}};
    if (are_two) scene.restitution = RateRatio{.value = Normal{0.9, 0.3}, .right = Normal{0.9, 0.3}};
    std::uint64_t limited = 0;
    for (std::uint64_t realisation = 0; realisation < 200; ++realisation) {
      const Start start = start_of(scene, random::Draws(1, realisation));
      limited += start.clamps.restitution;
      for (const double side : {1.0, -1.0}) {
        const double e = mean_restitution(start.scene.restitution, start.geometry, side);
        EXPECT_TRUE(least_restitution - 1e-12 <= e && e <= largest_restitution + 1e-12) << e << " " << side;
      }
    }
    EXPECT_GT(limited, 20U);
  }
}

// With every number drawn, a realisation is that of the scene with these numbers written in it.
TEST(DrawnOnce, GivesTheBitsOfTheSceneWithTheseNumbers) {
  Condition drawn;
  drawn.scene = scene_with_laws();
  drawn.scene.friction->kinetic_coefficient = Values{.values = {0.25, 0.3}};  // below every static one: else refused
  drawn.horizon = {.transient_periods = 20, .sampled_periods = 20};
  for (std::uint64_t realisation = 0; realisation < 5; ++realisation) {
    Condition written = drawn;
    written.scene = start_of(drawn.scene, random::Draws(3, realisation)).scene;
    EXPECT_EQ(realise(drawn, 3, realisation).strobe.size(), realise(written, 3, realisation).strobe.size());
    EXPECT_EQ(realise(drawn, 3, realisation).strobe.back().tilt, realise(written, 3, realisation).strobe.back().tilt);
  }
}

TEST(DrawnOnce, IsReadFromEveryPlaceAndWrittenBack) {
  Json document = with(least_experiment(), "/friction", R"({"static": 0.5, "kinetic": {"ratio": 0.9}})");
  const std::vector<std::pair<std::string, std::string>> laws{
      {"/friction/static", R"({"lognormal": {"mean": 0.5, "sigma": 0.1}})"},
      {"/friction/static", R"({"normal": {"mean": 0.5, "sigma": 0.1, "between": [0.3, 0.8]}})"},
      {"/friction/static", R"({"triangular": [0.4, 0.5, 0.6]})"},
      {"/friction/static", R"({"values": [0.4, 0.5], "weights": [1, 3]})"},
      {"/friction/kinetic", R"({"uniform": [0.4, 0.5]})"},
      {"/restitution", R"({"uniform": [0.1, 0.2]})"},
      {"/restitution", R"({"rate_ratio": {"uniform": [0.92, 0.95]}})"},
      {"/restitution", R"({"rate_ratio": [0.93, {"uniform": [0.92, 0.95]}]})"},
      {"/initial", R"({"tilt_rad": {"uniform": [0.0, 0.1]}, "tilt_rate_rad_s": 0.1, "slip_m": 0.2, "slip_rate": 0.0})"},
      {"/excitation/amplitude", R"({"lognormal": {"mean": 4, "sigma": 1}})"},
      {"/excitation/frequency_ratio", R"({"uniform": [8, 12]})"}};
  for (const auto& [place, law] : laws) {
    const Json changed = with(document, place, law);
    const Experiment experiment = experiment_in(changed.dump());
    EXPECT_TRUE(is_random(experiment.conditions.front().scene)) << place << law;
    const Json canonical = Json::parse(experiment.canonical_text);
    EXPECT_EQ(canonical.at(Json::json_pointer(place)), Json::parse(law)) << place;
    EXPECT_EQ(experiment_in(experiment.canonical_text).canonical_text, experiment.canonical_text);
  }
}

}  // namespace
}  // namespace rocking
