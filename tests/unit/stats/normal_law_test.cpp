// Functions of the normal law that have a fast or an extended form, against values of 40 digits (mpmath).

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

TEST(MillsRatio, HasItsKnownValues) {
  for (const auto& [z, ratio] : std::initializer_list<std::array<double, 2>>{{0.0, 1.2533141373155002512},
                                                                             {1.0, 0.65567954241879847154},
                                                                             {3.0, 0.30459029871010329573},
                                                                             {10.0, 0.099028596471731921395},
                                                                             {24.999, 0.039937897213692587171},
                                                                             {25.0, 0.039936304769535592529},
                                                                             {40.0, 0.024984404205720571147},
                                                                             {1e3, 0.000999999000002999985}}) {
    EXPECT_NEAR(mills_ratio(z), ratio, 5e-13 * ratio) << z;
  }
  EXPECT_EQ(mills_ratio(std::numeric_limits<double>::infinity()), 0.0);
}

TEST(LogNormalProbability, HasItsKnownValues) {
  for (const auto& [z, value, slope] :
       std::initializer_list<std::array<double, 3>>{{-30.0, -454.32124395634319711, 30.033259667433677037},
                                                    {-16.5, -139.85093887528520398, 16.560168798984088461},
                                                    {-15.99, -131.53482567290724506, 16.052059188615046233},
                                                    {-7.3, -29.56976992201126309, 7.4322704352970081926},
                                                    {-1.01, -1.8563130623431784288, 1.5331501328895348299},
                                                    {0.0, -0.69314718055994530942, 0.79788456080286535588},
                                                    {0.37, -0.43957723484892193052, 0.5782139643023476311},
                                                    {2.9, -0.0018675560981809211237, 0.0059636594949805500767},
                                                    {6.2, -2.8231580374417855348e-10, 1.7937839084704972771e-9}}) {
    const LogNormalProbability found = log_normal_probability(z);
    // Below -16 log_normal_cdf itself has the error that its test states.
    const double tolerance = z < -16.0 ? 4e-13 : 1e-13;
    EXPECT_NEAR(found.value, value, tolerance * (1.0 + std::abs(value))) << z;
    EXPECT_NEAR(found.slope, slope, (z < -16.0 ? 2e-10 : 1e-13) * (1.0 + slope)) << z;
  }
  const LogNormalProbability far = log_normal_probability(9.5);
  EXPECT_NEAR(far.value / std::log1p(-normal_cdf(-9.5)), 1.0, 1e-3);
  EXPECT_GT(far.slope, 0.0);
}

TEST(LogNormalProbability, OfManyPlacesHasTheBitsOfEach) {
  constexpr std::array places{0.3, -20.0, 9.5, 2.0, -16.0, 9.0};
  std::array<LogNormalProbability, places.size()> found{};
  log_normal_probabilities(places, found);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(found[i].value, log_normal_probability(places[i]).value) << places[i];
    EXPECT_EQ(found[i].slope, log_normal_probability(places[i]).slope) << places[i];
  }
  EXPECT_TRUE(std::isnan(log_normal_probability(std::nan("")).value));
}

TEST(LogNormalProbability, HasNoStepsWhereItsFormsMeet) {
  for (int i = -16 * 64 - 64; i <= 10 * 64; ++i) {
    const double z = i / 64.0;
    const LogNormalProbability below = log_normal_probability(std::nextafter(z, -100.0));
    const LogNormalProbability above = log_normal_probability(z);
    EXPECT_NEAR(below.value, above.value, 2e-13 * (1.0 + std::abs(above.value))) << z;
    EXPECT_NEAR(below.slope, above.slope, 2e-13 * (1.0 + above.slope)) << z;
  }
}

}  // namespace
}  // namespace rocking::stats
