// The default horizon under a base motion that ends.

#include "rocking/scene/defaults.hpp"
#include "rocking/scene/restitution.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace rocking {
namespace {

// Hops of a slender block take 2 artanh(u), with u = 0.999, 0.999 delta, ...; the sine pulse takes one period.
TEST(PeriodsUntilRest, CoverTheHopsOfASlenderBlockFromJustBelowItsBalance) {
  for (const double width : {0.2, 0.3, 0.5, 1.0, 1.5, 2.0}) {
    Scene scene;
    scene.block = {.width = width, .height = 4.0};
    scene.excitation = Pulse{.amplitude = 1.0, .frequency_ratio = 2.0 * std::numbers::pi};
    const double psi = std::atan(width / 4.0);
    const double delta =
        1.0 - 1.5 * (1.0 + mean_restitution(scene.restitution, dynamics::geometry_of(mean_block(scene)))) *
                  std::sin(psi) * std::sin(psi);
    double time = 0.0;
    for (double u = 0.999; u > 1e-12; u *= delta) time += 2.0 * std::atanh(u);
    const auto periods = static_cast<double>(periods_until_rest(scene));
    EXPECT_GE(periods, 1.0 + time) << width;
    EXPECT_LE(periods, 1.0 + 2.0 * time + 10.0) << width;
  }
}

}  // namespace
}  // namespace rocking
