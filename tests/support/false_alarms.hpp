#pragma once

// The account of false alarms. A statistical test can fail though nothing is wrong. Its seeds are fixed, so that it
// does so always or never; what is counted is the probability that it would with seeds picked blindly. Every comparison
// of a p-value or a score draws from the allowance of its test, and all allowances together stay below one in a
// million.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace rocking::support {

/// Of one comparison.
inline constexpr double false_alarm = 1e-10;
/// The size of a normal score is larger than this with that probability.
inline constexpr double largest_score = 6.466951;
/// Of all tests together, at most.
inline constexpr double all_false_alarms = 1e-6;

/// What one test may draw, in each of its instances.
struct Allowance {
  std::string_view test;
  int instances;
  int comparisons;
};

inline constexpr std::array allowances{
    Allowance{"Sampler.GivesEveryTestUniformPValuesOverManySeeds", 3, 16},
    Allowance{"Sampler.PassesEveryTestInALargeSample", 3, 19},
    Allowance{"Draws.OfNeighbouringNamesAreUncorrelated", 1, 5},
    Allowance{"Draws.FitTheLawAcrossRealisationsAndAcrossPairs", 1, 6},
    Allowance{"Draws.AreUniformWhereAskedToBe", 1, 1},
    Allowance{"TestsOfShape.AreAsFarOffInSmallSamplesAsTheirTableSays", 1, 4},
    Allowance{"TestsOfShape.KeepTheirWordAtTwentyThousand", 1, 2},
    Allowance{"Sabotage.TheSumOfTwelveUniformNumbersHasNoUniformPValues", 1, 1},
    Allowance{"Sabotage.ASpareThatIsTheFirstNumberWithASignOfItsOwnIsFoundOutBySquares", 1, 2},
    Allowance{"NormalCheck.ComparesWithTheStreamsThatItIsGiven", 1, 3},
    Allowance{"StoppingRule.LeavesAllIntervalsAtAllLooksAsGoodAsItPromises", 1, 1},
    Allowance{"ClampedKineticFriction.IsClampedAsOftenAsTheNormalLawSaysAndBrakesAccordingly", 1, 6},
    Allowance{"ClampedAmplitude.IsHeldAtZeroInHalfThePeriods", 1, 1},
    Allowance{"ClampedRestitution.IsHeldWithinItsBoundsInNearlyEveryImpact", 1, 1},
    Allowance{"ClampedEverything.LeavesARunThatIsOne", 1, 1},
};

constexpr int all_comparisons() {
  int sum = 0;
  for (const Allowance& allowance : allowances) sum += allowance.instances * allowance.comparisons;
  return sum;
}

static_assert(all_comparisons() * false_alarm < all_false_alarms);

/// The account of the test that makes it: it fails if more is drawn than it is allowed, or it is allowed nothing.
class FalseAlarms {
 public:
  FalseAlarms() {
    const auto& info = *::testing::UnitTest::GetInstance()->current_test_info();
    std::string suite = info.test_suite_name(), name = info.name();
    suite.erase(0, suite.rfind('/') + 1);  // instances are called All/Suite.Name/0
    name.erase(std::min(name.find('/'), name.size()));
    for (const Allowance& allowance : allowances) {
      if (allowance.test == suite + '.' + name) left_ = allowance.comparisons;
    }
  }

  /// What a p-value of something right must exceed.
  [[nodiscard]] double level() {
    EXPECT_GT(left_--, 0) << "this test has drawn more false alarms than tests/support/false_alarms.hpp allows it";
    return false_alarm;
  }

  /// What the size of a normal score of something right must not exceed.
  [[nodiscard]] double score() {
    static_cast<void>(level());
    return largest_score;
  }

 private:
  int left_ = 0;
};

}  // namespace rocking::support
