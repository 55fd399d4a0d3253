// Correlated deviations of static and kinetic friction (lib/docs/model.md, section 5).

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/scene_coefficients.hpp"
#include "support/excitation.hpp"
#include "support/false_alarms.hpp"

namespace rocking {
namespace {

/// Static friction after each of several stops, and kinetic friction just after it.
struct Pair {
  double at_rest;
  double sliding;
};

std::vector<Pair> pairs_under(const Fluctuation& fluctuation, std::uint64_t& clamped) {
  Scene scene;
  support::harmonic(scene).frequency_ratio = 10.0;
  scene.friction = Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3};
  scene.fluctuation = fluctuation;
  std::vector<Pair> pairs;
  for (std::uint64_t realisation = 0; realisation < 400; ++realisation) {
    SceneCoefficients coefficients(scene, random::Draws(11, realisation));
    dynamics::Clock clock(10.0, 0.0);
    for (int stop = 0; stop < 10; ++stop) {
      // Twice in one interval of the grid: after a stop the kinetic friction follows the new static one at once.
      if (stop % 2 == 0) clock.advance(clock.period_length() / 130.0);
      const double sliding = coefficients.kinetic_friction(clock);
      pairs.push_back({coefficients.static_friction(), sliding});
      coefficients.stop();
    }
    clamped += coefficients.clamps().all();
  }
  return pairs;
}

double correlation_of(const std::vector<Pair>& pairs) {
  double at_rest = 0.0, sliding = 0.0;
  for (const Pair& pair : pairs) {
    at_rest += pair.at_rest / static_cast<double>(pairs.size());
    sliding += pair.sliding / static_cast<double>(pairs.size());
  }
  double both = 0.0, first = 0.0, second = 0.0;
  for (const Pair& pair : pairs) {
    both += (pair.at_rest - at_rest) * (pair.sliding - sliding);
    first += (pair.at_rest - at_rest) * (pair.at_rest - at_rest);
    second += (pair.sliding - sliding) * (pair.sliding - sliding);
  }
  return both / std::sqrt(first * second);
}

TEST(CorrelatedFriction, MovesTogetherAndIsNeverClampedWithOne) {
  for (const FluctuationLaw law : {FluctuationLaw::normal, FluctuationLaw::lognormal, FluctuationLaw::uniform}) {
    std::uint64_t clamped = 0;
    Fluctuation fluctuation{.static_friction = 0.03, .kinetic_friction = 0.03, .friction_correlation = 1.0};
    fluctuation.laws.static_friction = fluctuation.laws.kinetic_friction = law;
    const auto pairs = pairs_under(fluctuation, clamped);
    EXPECT_EQ(clamped, 0U);
    EXPECT_GT(correlation_of(pairs), 0.998);
    if (law != FluctuationLaw::normal) continue;
    for (const Pair& pair : pairs) EXPECT_NEAR(pair.at_rest - pair.sliding, 0.05, 1e-15);
  }
}

TEST(CorrelatedFriction, HasTheCorrelationThatIsAskedFor) {
  support::FalseAlarms alarms;
  for (const double correlation : {-0.6, 0.0, 0.5}) {
    std::uint64_t clamped = 0;
    // Small deviations, so that none is clamped.
    const auto pairs = pairs_under(
        {.static_friction = 0.005, .kinetic_friction = 0.005, .friction_correlation = correlation}, clamped);
    EXPECT_EQ(clamped, 0U);
    // Kinetic friction is drawn anew for every second pair only: 2000 independent ones.
    EXPECT_NEAR(correlation_of(pairs), correlation, alarms.score() / std::sqrt(2000.0));
  }
}

}  // namespace
}  // namespace rocking
