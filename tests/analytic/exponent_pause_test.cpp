// until_classified.exponent_pause: windows in which the exponent counts as unclear and is not computed.

#include <cstdint>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t pause_seed = 0x2012;
constexpr std::uint64_t pause_realisations = 12;

/// Most responses slip on for hundreds of periods, with an exponent near zero.
Condition slipping(int pause) {
  Condition condition;
  condition.scene.block = {.width = 1.0, .height = 4.0, .gravity = 9.81};
  condition.scene.excitation = Harmonic{.amplitude = 6.0, .frequency_ratio = 10.0};
  condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
  condition.tolerance = 1e-8;
  condition.horizon = {.transient_periods = 40, .sampled_periods = 60};
  condition.horizon.until_classified = UntilClassified{.at_most_periods = 400, .exponent_pause = pause};
  return condition;
}

TEST(ExponentPause, SavesExponentsAndLeavesTheFixedHorizonAsItIs) {
  std::uint64_t of_all = 0;
  std::uint64_t of_some = 0;
  for (std::uint64_t realisation = 0; realisation < pause_realisations; ++realisation) {
    const RealisationResult all = realise(slipping(0), pause_seed, realisation);
    const RealisationResult some = realise(slipping(2), pause_seed, realisation);
    EXPECT_EQ(some.settling->horizon_mode, all.settling->horizon_mode) << realisation;
    EXPECT_LE(some.operations.exponent_periods, all.operations.exponent_periods) << realisation;
    of_all += all.operations.exponent_periods;
    of_some += some.operations.exponent_periods;
  }
  EXPECT_LT(3 * of_some, 2 * of_all) << "most exponents stay unclear, and two windows follow without one";
}

constexpr std::uint64_t longest_run = 8 * 60;  ///< [periods]

// An exponent that stayed unclear is not computed again within the pause.
TEST(ExponentPause, OfManyWindowsLeavesTheExponentOfTheFixedHorizonOnly) {
  std::uint64_t with_exponent = 0;
  for (std::uint64_t realisation = 0; realisation < pause_realisations; ++realisation) {
    Condition fixed = slipping(0);
    fixed.horizon.until_classified.reset();
    const RealisationResult before = realise(fixed, pause_seed, realisation);
    const bool is_unresolved = before.classification.mode.kind == section::ResponseKind::unresolved;
    if (!is_unresolved || before.operations.exponent_periods < longest_run) continue;
    ++with_exponent;
    const RealisationResult after = realise(slipping(100), pause_seed, realisation);
    EXPECT_EQ(after.operations.exponent_periods, before.operations.exponent_periods) << realisation;
    EXPECT_GT(after.settling->observed_periods, 100) << realisation;
  }
  EXPECT_GT(with_exponent, 1U);
}

}  // namespace
}  // namespace rocking
