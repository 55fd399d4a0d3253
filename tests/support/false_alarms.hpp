#pragma once

// Account of false alarms. A statistical test can fail although nothing is wrong. Its seeds are fixed, so that it fails
// always or never; counted is the probability that it fails with random seeds. Every comparison of a p-value or a score
// uses part of the allowance of its test. All allowances together stay below one in a million.

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>

#include <boost/math/special_functions/erf.hpp>
#include <gtest/gtest.h>

namespace rocking::support {

/// False-alarm probability of one comparison.
inline constexpr double false_alarm = 1e-10;
/// The absolute value of a normal score exceeds this with that probability.
inline const double largest_score = std::numbers::sqrt2 * boost::math::erfc_inv(false_alarm);
/// Largest false-alarm probability of all tests together.
inline constexpr double all_false_alarms = 1e-6;

/// Number of comparisons that a test may make, in each of its instances.
struct Allowance {
  std::string_view test;
  int instances;
  int comparisons;
};

inline constexpr std::array allowances{
    Allowance{"Sampler.GivesEveryTestUniformPValuesOverManySeeds", 3, 16},
    Allowance{"Sampler.PassesEveryTestInALargeSample", 3, 19},
    Allowance{"Draws.OfNeighbouringSourcesAreUncorrelated", 1, 5},
    Allowance{"Draws.FitTheLawAcrossRealisationsAndAcrossPairs", 1, 6},
    Allowance{"Draws.AreUniformWhereAskedToBe", 1, 1},
    Allowance{"BinomialDraws.HaveTheExactProbabilities", 1, 9},
    Allowance{"TestsOfShape.AreAsFarOffInSmallSamplesAsTheirTableSays", 1, 4},
    Allowance{"TestsOfShape.KeepTheirWordAtTwentyThousand", 1, 2},
    Allowance{"Sabotage.TheSumOfTwelveUniformNumbersHasNoUniformPValues", 1, 1},
    Allowance{"Sabotage.ASpareThatIsTheFirstNumberWithASignOfItsOwnIsFoundOutBySquares", 1, 2},
    Allowance{"NormalCheck.ComparesWithTheStreamsThatItIsGiven", 1, 3},
    Allowance{"StoppingRule.LeavesAllIntervalsAtAllLooksAsGoodAsItPromises", 1, 4},
    Allowance{"ClampedKineticFriction.IsClampedAsOftenAsTheNormalLawSaysAndBrakesAccordingly", 1, 6},
    Allowance{"ClampedAmplitude.IsHeldAtZeroInHalfThePeriods", 1, 1},
    Allowance{"ClampedRestitution.IsHeldWithinItsBoundsInNearlyEveryImpact", 1, 1},
    Allowance{"ClampedEverything.LeavesARunThatIsOne", 1, 1},
    Allowance{"Basins.OfTwoResponsesCoexistInThePublishedFractions", 1, 2},
    Allowance{"RandomBlock.HasTheMomentsOfItsLaws", 1, 5},
    Allowance{"QuantileEstimate.CoversTheTruthInSamplesAlsoWhereSomeValuesLieBeyond", 1, 12},
    Allowance{"RandomBlock.OverturnsAsOftenAsAQuadratureOfItsLawsSays", 1, 1},
    Allowance{"FragilityIntervals.CoverTheTruthAsOftenAsTheDocumentsSay", 1, 40},
    Allowance{"FragilityIntervalsOfIndependentOutcomes.AreTooNarrowSoThisTestCanSee", 1, 1},
    Allowance{"FragilityTest.RejectsATrueLawAsOftenAsTheDocumentsSay", 1, 6},
    Allowance{"FragilityTest.RejectsTwoCapacitiesThatALognormalFunctionCannotDescribe", 1, 2},
    Allowance{"FragilityCurves.StateNothingFalseMoreOftenThanTheDocumentsSay", 1, 16},
    Allowance{"TwistedRun.OfAWalkIsUnbiasedWhateverTheScore", 1, 3},
    Allowance{"TwistedRun.OfOrnsteinAndUhlenbecksProcessIsUnbiased", 1, 2},
    Allowance{"ImportanceSampling.OfAGaussianTailIsUnbiased", 1, 3},
    Allowance{"RareIntervals.CoverTheProbabilityOfChains", 1, 2},
    Allowance{"RareIntervals.CoverAlsoWhereASmallErrorEndsTheRepetitions", 1, 1},
    Allowance{"RareOnBlocks.IsUnbiasedForNumbersThatAreDrawnOnce", 1, 1},
    Allowance{"RareOnBlocks.IsUnbiasedForOtherLaws", 1, 3},
    Allowance{"RareOnBlocks.IsUnbiasedForNumbersThatAreDrawnAlongTheWay", 1, 4},
    Allowance{"RareOnBlocks.IsUnbiasedWhateverTheErrorOfTheGrid", 1, 2},
    Allowance{"RareOnBlocks.IsUnbiasedWhateverTheProposalOfNumbersDrawnOnce", 1, 2},
    Allowance{"CorrelatedFriction.HasTheCorrelationThatIsAskedFor", 1, 3},
    Allowance{"RandomNumbers.OfLawsAlongTheWayAreTested", 1, 8},
    Allowance{"MeanShare.CoversTheShareOfSemiMarkovProcessesAsOftenAsTheDocumentsSay", 1, 3},
    Allowance{"InferredIntervals.CoverTheTruthAsOftenAsTheySay", 1, 4},
    Allowance{"InferredIntervals.CoverTheTruthAlsoWhereTestsAreAsManyAsRealisations", 1, 1},
    Allowance{"InferredFit.HasAPValueThatIsAboutUniform", 1, 4},
    Allowance{"InferredFit.HasAPValueThatIsNotMuchTooLargeWhereTestsAreAsManyAsRealisations", 1, 1},
    Allowance{"SuiteIntervals.CoverTheTruthInRunsOfTheProgram", 1, 2},
    Allowance{"SuiteIntervalsWithCommonNumbers.AreTooNarrowSoThisTestCanSee", 1, 2},
    Allowance{"SurfaceFit.FindsTheCoefficientsOfALargeSuite", 1, 4},
    Allowance{"SurfaceTests.HavePValuesThatAreAboutUniformWhereThereIsNothing", 1, 4},
    Allowance{"RateByShares.IsCoveredWithMediansWithinAndAboveTheLevels", 1, 9},
};

constexpr int all_comparisons() {
  int sum = 0;
  for (const Allowance& allowance : allowances) sum += allowance.instances * allowance.comparisons;
  return sum;
}

static_assert(all_comparisons() * false_alarm < all_false_alarms);

/// The account of the test that creates it. It fails if the test makes more comparisons than allowed, or has no
/// allowance.
class FalseAlarms {
 public:
  FalseAlarms() {
    const auto& info = *::testing::UnitTest::GetInstance()->current_test_info();
    std::string suite = info.test_suite_name(), name = info.name();
    suite.erase(0, suite.rfind('/') + 1);  // instances have names such as All/Suite.Name/0
    name.erase(std::min(name.find('/'), name.size()));
    for (const Allowance& allowance : allowances) {
      if (allowance.test == suite + '.' + name) left_ = allowance.comparisons;
    }
  }

  /// A p-value that is not a fault must exceed this.
  [[nodiscard]] double level() {
    EXPECT_GT(left_--, 0) << "this test has drawn more false alarms than tests/support/false_alarms.hpp allows it";
    return false_alarm;
  }

  /// The absolute value of a normal score that is not a fault must not exceed this.
  [[nodiscard]] double score() {
    static_cast<void>(level());
    return largest_score;
  }

 private:
  int left_ = 0;
};

}  // namespace rocking::support
