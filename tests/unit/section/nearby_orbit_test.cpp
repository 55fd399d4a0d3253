#include "rocking/section/nearby_orbit.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classify.hpp"
#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

constexpr StrobePoint centre{.tilt = 0.3, .tilt_rate = -0.2};

/// The linear map about a fixed point that shrinks deviations by `modulus` and turns them by `turns` of a circle.
struct Spiral {
  double modulus;
  double turns;

  [[nodiscard]] std::complex<double> multiplier(int periods) const {
    return std::polar(std::pow(modulus, periods), 2.0 * std::numbers::pi * turns * periods);
  }

  [[nodiscard]] std::vector<Period> points(double size, int count, double noise = 0.0, std::uint64_t seed = 1) const {
    support::SplitMix draw(seed);
    std::vector<Period> periods;
    std::complex<double> z = size;
    for (int k = 0; k < count; ++k) {
      periods.push_back({{centre.tilt + z.real(), centre.tilt_rate + z.imag(), 0.0}, 2, true});
      z = multiplier(1) * z + noise * std::complex<double>(draw.normal(), draw.normal());
    }
    return periods;
  }

  /// Finds the fixed point, whatever it is asked for.
  [[nodiscard]] OrbitSource source() const {
    return [*this](const StrobePoint&, int) {
      const std::complex<double> m = multiplier(1);
      return NearbyOrbit{.points = {centre},
                         .impacts = 2,
                         .moved = true,
                         .decay = -std::log(modulus),
                         .derivative = {{{m.real(), -m.imag(), 0.0}, {m.imag(), m.real(), 0.0}, {0.0, 0.0, 0.0}}}};
    };
  }
};

constexpr double resolution = 1e-9;

Classification classified(const std::vector<Period>& periods, bool random, const OrbitSource& source, double exponent) {
  return classify({.periods = periods, .random = random, .resolution = resolution, .find_orbit = source}, [exponent] {
    return std::optional(ExponentEstimate{.exponent = exponent, .standard_error = 0.1 * std::abs(exponent)});
  });
}

TEST(NearbyOrbit, GivesASlowSpiralThePeriodOfItsOrbit) {
  for (const double turns : {1.0 / 6.0, 0.334, 0.4999, 2.0 / 11.0}) {
    const Spiral spiral{.modulus = 0.985, .turns = turns};
    const Classification found = classified(spiral.points(0.02, 120), false, spiral.source(), std::log(0.985));
    EXPECT_EQ(found.mode, periodic(1, 1)) << turns;
    EXPECT_EQ(found.reason, Reason::stable_orbit);
    EXPECT_TRUE(found.in_transient);
  }
}

TEST(NearbyOrbit, GivesNoLabelToASlowSpiralWhoseOrbitIsNotFound) {
  const Spiral spiral{.modulus = 0.985, .turns = 1.0 / 6.0};
  const OrbitSource none = [](const StrobePoint&, int) { return std::optional<NearbyOrbit>(); };
  for (const OrbitSource& source : {OrbitSource{}, none}) {
    EXPECT_EQ(classified(spiral.points(1e-6, 120), false, source, -0.015).mode.kind, ResponseKind::unresolved);
  }
}

TEST(NearbyOrbit, IsSoughtWhereverItIsApproached) {
  int approached = 0;
  int not_sought = 0;
  for (const double modulus : {0.7, 0.9, 0.97, 0.995}) {
    for (const double size : {1e-3, 0.05, 0.3, 2.0}) {
      for (int twelfths = 0; twelfths <= 12; ++twelfths) {
        for (const int count : {60, 120, 480}) {
          const Spiral spiral{.modulus = modulus, .turns = twelfths / 12.0};
          const auto points = spiral.points(size, count);
          const bool is_sought = may_approach_orbit(points, 1, resolution, Thresholds{});
          if (!is_sought) ++not_sought;
          if (!approached_orbit(points, 1, spiral.source(), resolution, Thresholds{})) continue;
          ++approached;
          EXPECT_TRUE(is_sought) << modulus << ", " << size << ", " << twelfths << "/12, " << count;
        }
      }
    }
  }
  EXPECT_GT(approached, 100);
  EXPECT_GT(not_sought, 20);
}

TEST(NearbyOrbit, IsNotApproachedByWhatTurnsAboutItForEver) {
  const Spiral believed{.modulus = 0.98, .turns = 1.0 / 3.0};
  for (const double modulus : {1.0, 0.998}) {
    const Spiral motion{.modulus = modulus, .turns = 1.0 / 3.0};
    EXPECT_FALSE(approached_orbit(motion.points(0.01, 120), 1, believed.source(), resolution, {})) << modulus;
  }
  EXPECT_TRUE(approached_orbit(believed.points(0.01, 120), 1, believed.source(), resolution, {}));
}

TEST(NearbyOrbit, IsNotApproachedFromFarOrAlongAnotherWay) {
  const Spiral spiral{.modulus = 0.98, .turns = 0.31};
  const Spiral another{.modulus = 0.98, .turns = 0.21};
  EXPECT_FALSE(approached_orbit(spiral.points(1.0, 120), 1, spiral.source(), resolution, {}));
  EXPECT_FALSE(approached_orbit(another.points(0.01, 120), 1, spiral.source(), resolution, {}));
}

TEST(NearbyOrbit, ThatRepelsGivesNoLabel) {
  const Spiral spiral{.modulus = 1.001, .turns = 0.31};
  EXPECT_FALSE(approached_orbit(spiral.points(1e-10, 120), 1, spiral.source(), resolution, {}));
}

// Noise keeps a slow spiral turning; within a window it keeps its phase, and looks like several clouds.
TEST(NearbyOrbit, TellsOneNoisyCloudThatTurnsFromSeveral) {
  int right = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Spiral spiral{.modulus = 0.983, .turns = 4.0 / 11.0};
    const auto points = spiral.points(0.0, 60, 1e-3, seed);
    const Classification without = classified(points, true, {}, std::log(0.983));
    EXPECT_EQ(without.mode.kind == ResponseKind::periodic && without.mode.periods > 1, false) << seed;
    const Classification with = classified(points, true, spiral.source(), std::log(0.983));
    EXPECT_TRUE(with.mode == periodic(1, 1) || with.mode.kind == ResponseKind::unresolved) << seed;
    if (with.mode == periodic(1, 1)) ++right;
  }
  EXPECT_GE(right, 60);
}

}  // namespace
}  // namespace rocking::section
