// A block whose width and height are drawn: from the laws that were asked for, once a realisation, and otherwise the
// same realisation as that of a block of this size.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include "rocking/lanes/kernels.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/restitution.hpp"
#include "support/excitation.hpp"
#include "support/false_alarms.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t block_seed = 0xb10c;

dynamics::Block block_of(const Scene& scene, std::uint64_t realisation) {
  return start_of(scene, random::Draws(block_seed, realisation)).block;
}

double score(double sum, double mean, double variance, int n) { return (sum - n * mean) / std::sqrt(n * variance); }

TEST(RandomBlock, HasTheMomentsOfItsLaws) {
  Scene scene;
  scene.block = {.width = Uniform{0.4, 1.0}, .height = Normal{4.0, 0.25}};
  constexpr int n = 20'000;
  double width = 0.0;
  double width_squares = 0.0;
  double height = 0.0;
  double height_squares = 0.0;
  double products = 0.0;
  for (int i = 0; i < n; ++i) {
    const dynamics::Block block = block_of(scene, static_cast<std::uint64_t>(i));
    const double u = (block.width - 0.7) / 0.3;  // uniform on [-1, 1)
    const double z = (block.height - 4.0) / 0.25;
    width += u;
    width_squares += u * u;
    height += z;
    height_squares += z * z;
    products += u * z;
  }
  support::FalseAlarms alarms;
  for (const double s :
       {score(width, 0.0, 1.0 / 3.0, n), score(width_squares, 1.0 / 3.0, 4.0 / 45.0, n), score(height, 0.0, 1.0, n),
        score(height_squares, 1.0, 2.0, n), score(products, 0.0, 1.0 / 3.0, n)}) {
    EXPECT_LT(std::abs(s), alarms.score());
  }
}

/// Conditions with a block of random size, and everything else that is drawn.
std::vector<Condition> random_blocks() {
  Condition harmonic;
  harmonic.scene.block = {.width = Uniform{0.5, 1.5}, .height = Normal{4.0, 0.3}};
  support::harmonic(harmonic.scene) = {.amplitude = 6.0, .frequency_ratio = 10.0, .phase = Uniform{0.0, 6.0}};
  harmonic.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  harmonic.scene.fluctuation = {
      .static_friction = 0.03, .kinetic_friction = 0.03, .restitution = 0.02, .amplitude = 0.2};
  harmonic.scene.initial.tilt = Uniform{-0.4, 0.4};
  harmonic.horizon = {.transient_periods = 20, .sampled_periods = 20};
  Condition jy25 = harmonic;
  jy25.scene.restitution = Jy25Restitution{};
  Condition recorded = harmonic;
  GroundMotion motion{.samples = {}, .has_vertical = false};
  for (int i = 0; i < 200; ++i) motion.samples.push_back({0.05 * i, 0.5 * std::sin(0.4 * i) * std::sin(0.03 * i), 0.0});
  recorded.scene.excitation = support::recorded_by(motion, 4.0);
  recorded.scene.fluctuation.amplitude = 0.0;
  recorded.horizon = {.transient_periods = 0, .sampled_periods = 25};
  Condition physical = harmonic;
  support::harmonic(physical.scene).physical_amplitude = PhysicalAmplitude{0.45, AccelerationUnit::gravity};
  support::harmonic(physical.scene).physical_frequency = PhysicalFrequency{0.4, FrequencyUnit::period_s};
  physical.scene.restitution = RateRatio{0.985};
  physical.scene.fluctuation.restitution = 0.002;
  physical.scene.fluctuation.amplitude = 0.05;
  return {harmonic, jy25, recorded, physical};
}

/// The same with the size that a realisation draws.
Condition of_fixed_size(Condition condition, std::uint64_t realisation) {
  Scene& scene = condition.scene;
  const double mean_p = dynamics::geometry_of(mean_block(scene)).frequency_parameter;
  const dynamics::Block block = block_of(scene, realisation);
  scene.block = {.width = block.width, .height = block.height, .gravity = block.gravity};
  if (std::holds_alternative<Jy25Restitution>(scene.restitution))
    scene.restitution = mean_restitution(scene.restitution, dynamics::geometry_of(block));
  auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded != nullptr) recorded->frequency_ratio *= mean_p / dynamics::geometry_of(block).frequency_parameter;
  return condition;
}

TEST(RandomBlock, HasTheBitsOfABlockOfThatSize) {
  for (const Condition& condition : random_blocks()) {
    for (std::uint64_t realisation = 0; realisation < 12; ++realisation) {
      const RealisationResult drawn = realise(condition, block_seed, realisation);
      const RealisationResult fixed = realise(of_fixed_size(condition, realisation), block_seed, realisation);
      EXPECT_EQ(digest_of(drawn, 0), digest_of(fixed, 0)) << realisation;
      EXPECT_EQ(drawn.operations.steps, fixed.operations.steps);
      EXPECT_EQ(drawn.operations.initial_draws, fixed.operations.initial_draws + 2);
      EXPECT_EQ(to_string(drawn.classification.mode), to_string(fixed.classification.mode));
    }
    EXPECT_NE(block_of(condition.scene, 0).width, block_of(condition.scene, 1).width);
    EXPECT_NE(block_of(condition.scene, 0).height, block_of(condition.scene, 1).height);
  }
}

// Realisations of a condition are started one after another, so that they would share the knots of the ground motion if
// their blocks were equal.
TEST(RandomBlock, HasInLanesTheBitsThatItHasAlone) {
  const std::vector<Condition> conditions = random_blocks();
  constexpr std::uint64_t each = 16;
  RealisationScheduler scheduler(block_seed, lanes::available_kernels().back());
  std::vector<RealisationScheduler::Finished> finished;
  for (std::size_t id = 0; id < conditions.size() * each || !scheduler.is_idle();) {
    while (id < conditions.size() * each && scheduler.wants_more()) {
      scheduler.start({.condition = &conditions[id / each], .realisation = id % each}, id);
      ++id;
    }
    for (auto& one : scheduler.work()) finished.push_back(std::move(one));
  }
  ASSERT_EQ(finished.size(), conditions.size() * each);
  for (const auto& [id, result] : finished) {
    const auto alone = realise(conditions[id / each], block_seed, id % each);
    EXPECT_EQ(digest_of(result, 0), digest_of(alone, 0)) << id;
    EXPECT_EQ(result.operations.initial_draws, alone.operations.initial_draws);
  }
}

// A ground motion is in seconds, and so is a physical period. Each block is run until the same second, whatever its p.
TEST(RandomBlock, KeepsThePhysicalStrobeInSeconds) {
  const Condition recorded = random_blocks()[2];
  const double mean_p = dynamics::geometry_of(mean_block(recorded.scene)).frequency_parameter;
  const Condition in_seconds = random_blocks()[3];
  Condition in_hertz = in_seconds;
  support::harmonic(in_hertz.scene).physical_frequency = PhysicalFrequency{3.2, FrequencyUnit::hertz};
  for (const auto& [condition, expected] : {std::pair{recorded, 2.0 * std::numbers::pi / 4.0 / mean_p},
                                            std::pair{in_seconds, 0.4}, std::pair{in_hertz, 1.0 / 3.2}}) {
    for (std::uint64_t realisation = 0; realisation < 20; ++realisation) {
      const random::Draws draws(block_seed, realisation);
      const Start start = start_of(condition.scene, draws);
      const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 1);
      const double seconds = beginning.clock.period_length() / start.geometry.frequency_parameter;
      EXPECT_NEAR(seconds, expected, 8.0 * 0x1p-52 * seconds);  // eight roundings
    }
  }
}

// The base acceleration over g, A_h psi, and its standard deviation are those that were asked for.
TEST(RandomBlock, MeetsTheSamePhysicalAcceleration) {
  Condition condition = random_blocks()[3];
  for (const auto& [unit, value] :
       {std::pair{AccelerationUnit::gravity, 0.45}, std::pair{AccelerationUnit::m_s2, 0.45 * 9.81}}) {
    support::harmonic(condition.scene).physical_amplitude = PhysicalAmplitude{value, unit};
    for (const double sigma : {0.0, value / 9.0}) {
      condition.scene.fluctuation.amplitude = sigma;
      for (std::uint64_t realisation = 0; realisation < 20; ++realisation) {
        const random::Draws draws(block_seed, realisation);
        const Start start = start_of(condition.scene, draws);
        Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 1);
        const double z = sigma > 0.0 ? draws.standard_normal(random::Source::amplitude, 0) : 0.0;
        const double acceleration = beginning.coefficients.amplitude(beginning.clock) * start.geometry.shape_angle;
        EXPECT_NEAR(acceleration, std::max(0.0, 0.45 * (1.0 + z / 9.0)), 16.0 * 0x1p-52);  // sixteen roundings
      }
    }
  }
}

// The measured ratio of the tilt rates, delta = 1 - 1.5 (1 + e) sin^2(psi), and its standard deviation.
TEST(RandomBlock, LosesTheMeasuredShareInAnImpact) {
  Condition condition = random_blocks()[3];
  for (const double sigma : {0.0, 0.001}) {
    condition.scene.fluctuation.restitution = sigma;
    for (std::uint64_t realisation = 0; realisation < 20; ++realisation) {
      const random::Draws draws(block_seed, realisation);
      const Start start = start_of(condition.scene, draws);
      Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 1);
      const double e = beginning.coefficients.restitution();
      const double z = sigma > 0.0 ? draws.standard_normal(random::Source::restitution, 0) : 0.0;
      if (e == -0.999 || e == 1.0) continue;  // clamped
      const double sine = start.geometry.sine;
      EXPECT_NEAR(1.0 - 1.5 * (1.0 + e) * sine * sine, 0.985 - sigma * z, 16.0 * 0x1p-52);  // sixteen roundings
    }
  }
}

TEST(RandomBlock, IsTruncatedToTheBoundsAndCountsIt) {
  Condition condition;
  condition.scene.block.width = Normal{least_length, 1e-3};
  condition.scene.block.height = Normal{largest_length, 1.0};
  condition.horizon = {.transient_periods = 0, .sampled_periods = 1};
  std::uint64_t counted = 0;
  for (std::uint64_t realisation = 0; realisation < 200; ++realisation) {
    const random::Draws draws(block_seed, realisation);
    const double below = draws.standard_normal(random::Source::block_width, 0) < 0.0 ? 1 : 0;
    const double above = draws.standard_normal(random::Source::block_height, 0) > 0.0 ? 1 : 0;
    const Start start = start_of(condition.scene, draws);
    EXPECT_EQ(start.clamps.length_at_bound, static_cast<std::uint64_t>(below + above));
    EXPECT_EQ(start.block.width == least_length, below == 1.0);
    EXPECT_EQ(start.block.height == largest_length, above == 1.0);
    counted += start.clamps.length_at_bound;
  }
  EXPECT_GT(counted, 100U);
  const Start first = start_of(condition.scene, random::Draws(block_seed, 0));
  EXPECT_EQ(realise(condition, block_seed, 0).clamps.length_at_bound, first.clamps.length_at_bound);
}

TEST(RandomBlock, MakesASceneRandom) {
  Scene scene;
  EXPECT_FALSE(is_random(scene));
  scene.block.height = Normal{4.0, 0.1};
  EXPECT_TRUE(is_random(scene));
  scene.block = {.width = Uniform{1.0, 2.0}};
  EXPECT_TRUE(is_random(scene));
}

TEST(RandomBlock, StandsInItsTrajectory) {
  const Condition condition = random_blocks()[0];
  const dynamics::Block drawn = block_of(condition.scene, 3);
  const Trajectory trajectory = trajectory_of(condition, block_seed, 3, 1);
  EXPECT_EQ(trajectory.block.width, drawn.width);
  EXPECT_EQ(trajectory.block.height, drawn.height);
}

// Without shaking and friction, a block that stands with the tilt rate Theta' = 0.98 overturns where its kinetic energy
// lifts it past balance: theta'^2/2 > 1 - cos(psi), that is 0.98 psi > 2 sin(psi/2). Theta' is in units of psi of the
// realisation's own block, so that this depends on its shape alone: psi > psi_0, B > H tan(psi_0).
TEST(RandomBlock, OverturnsAsOftenAsAQuadratureOfItsLawsSays) {
  constexpr double rate = 0.98;
  double low = 0.1;
  double high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (rate * middle > 2.0 * std::sin(0.5 * middle) ? high : low) = middle;
  }
  const double threshold = std::tan(low);
  Condition condition;
  condition.scene.block = {.width = Uniform{0.5, 1.2}, .height = Normal{1.0, 0.1}};
  support::harmonic(condition.scene) = {.amplitude = 0.0, .frequency_ratio = 0.05, .phase = 0.0};
  condition.scene.initial.tilt_rate = rate;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 1};
  constexpr int n = 2'000;
  int overturned = 0;
  for (std::uint64_t realisation = 0; realisation < n; ++realisation) {
    const dynamics::Block block = block_of(condition.scene, realisation);
    const bool falls = realise(condition, block_seed, realisation).termination == dynamics::Termination::overturned;
    EXPECT_EQ(falls, block.width > threshold * block.height) << block.width << ' ' << block.height;
    overturned += falls ? 1 : 0;
  }
  const auto density = [&](double z) {
    const double wider = std::clamp((1.2 - threshold * (1.0 + 0.1 * z)) / 0.7, 0.0, 1.0);
    return wider * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
  };
  const double p = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(density, -8.0, 8.0, 10, 1e-10);
  support::FalseAlarms alarms;
  EXPECT_LT(std::abs(score(overturned, p, p * (1.0 - p), n)), alarms.score()) << overturned << " of " << n << ", " << p;
  EXPECT_GT(p, 0.3);
  EXPECT_LT(p, 0.9);
}

}  // namespace
}  // namespace rocking
