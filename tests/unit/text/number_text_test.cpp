// Probabilities as text: none is rounded to 0 or to 1.

#include "rocking/text/number_text.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>

namespace {

using rocking::count_if_open;
using rocking::per_cent;

TEST(RateText, HasTwoDigitsOfEveryRate) {
  using rocking::rate_text;
  for (const auto& [rate, text] :
       {std::pair{0.0, "0"}, std::pair{5.03e-4, "5.0e-4"}, std::pair{9.96e-3, "0.010"}, std::pair{9.94e-3, "9.9e-3"},
        std::pair{0.5, "0.50"}, std::pair{0.998, "1.0"}, std::pair{24.4, "24"}, std::pair{263.4, "263"},
        std::pair{-2.03e-5, "-2.0e-5"}, std::pair{1.2e-300, "1.2e-300"}}) {
    EXPECT_EQ(rate_text(rate), text);
  }
}

TEST(PerCent, HasOneDigitAfterThePointWhereThatLeavesTwo) {
  EXPECT_EQ(per_cent(0.985), "98.5");
  EXPECT_EQ(per_cent(0.5), "50.0");
  EXPECT_EQ(per_cent(0.012), "1.2");
  EXPECT_EQ(per_cent(0.0, 2), "0.00");
  EXPECT_EQ(per_cent(0.12345, 2), "12.35");
}

TEST(PerCent, KeepsTwoSignificantDigitsOfASmallProbability) {
  EXPECT_EQ(per_cent({.low = 1.18e-4, .high = 2.12e-4}), "[0.012, 0.021]");
  EXPECT_EQ(per_cent(48.0 / 300000.0), "0.016");
  EXPECT_EQ(per_cent(0.0095), "0.95");
  EXPECT_EQ(per_cent(0.00999), "1.00");
  EXPECT_EQ(per_cent(5e-8), "0.0000050");
  EXPECT_EQ(per_cent(5.4e-9), "5.4e-07");
}

TEST(PerCent, KeepsTwoSignificantDigitsOfWhatIsMissingTo1) {
  EXPECT_EQ(per_cent(1.0 - 48.0 / 300000.0), "99.984");
  EXPECT_EQ(per_cent({.low = 0.9712, .high = 0.99988}), "[97.1, 99.988]");
  EXPECT_EQ(per_cent(0.9999998), "99.999980");
}

TEST(PerCent, WritesOnly0And1AsSuch) {
  EXPECT_EQ(per_cent(0.0), "0.0");
  EXPECT_EQ(per_cent(1.0), "100.0");
  EXPECT_EQ(per_cent(0.1 + 0.2 + 0.3 + 0.4 - 1e-16), "100.0") << "a sum of shares that rounding keeps from 1";
  for (double p = 0.5; p > 1e-11; p *= 0.37) {
    EXPECT_GT(std::stod(per_cent(p)), 0.0);
    EXPECT_LT(std::stod(per_cent(1.0 - p)), 100.0) << p;
    EXPECT_NEAR(std::stod(per_cent(p)), 100.0 * p, 5.0 * p) << "two digits";
    EXPECT_NEAR(100.0 - std::stod(per_cent(1.0 - p)), 100.0 * p, 5.0 * p + 1e-13);
  }
}

TEST(PerCent, TakesDifferences) {
  EXPECT_EQ(per_cent(-0.25), "-25.0");
  EXPECT_EQ(per_cent({.low = -1.2e-4, .high = 3.4e-4}), "[-0.012, 0.034]");
}

TEST(Count, IsShownWhereTenthsOfAPerCentLeaveItOpen) {
  for (std::uint64_t count = 1; count <= 1000; ++count) {
    EXPECT_EQ(count_if_open(count, 1000), "");
    EXPECT_EQ(std::llround(10.0 * std::stod(per_cent(static_cast<double>(count) / 1000.0))), count);
  }
  EXPECT_EQ(count_if_open(48, 300000), " (48)");
  EXPECT_EQ(count_if_open(0, 300000), "");
  EXPECT_EQ(rocking::count_legend(1000), "");
  EXPECT_EQ(rocking::count_legend(1001), "; (k): k realisations");
}

}  // namespace
