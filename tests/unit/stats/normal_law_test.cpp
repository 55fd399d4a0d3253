// Mills' ratio against values of 40 digits (mpmath).

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
    EXPECT_NEAR(mills_ratio(z), ratio, 2e-13 * ratio) << z;
  }
  EXPECT_EQ(mills_ratio(std::numeric_limits<double>::infinity()), 0.0);
}

}  // namespace
}  // namespace rocking::stats
