#include "rocking/section/classify.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

/// An exponent source that counts its calls.
struct CountedExponent {
  std::optional<ExponentEstimate> estimate;
  int calls = 0;

  Classification classification_of(const std::vector<Period>& periods, bool random) {
    return classify({.periods = periods, .random = random, .resolution = 1e-7}, [this] {
      ++calls;
      return estimate;
    });
  }
};

constexpr ExponentEstimate clearly_negative{-0.2, 0.01};
constexpr ExponentEstimate clearly_positive{0.2, 0.01};

std::vector<Period> noisy(int n, int m, double scatter, std::uint64_t seed) {
  support::SplitMix draw(seed);
  support::Synthetic response = support::random_orbit(n, m, 0.2, draw);
  response.wander = {scatter, 2.0, 0.5, 1.0, 0.0};
  return response.periods(120, draw);
}

std::vector<Period> logistic(double parameter) {
  std::vector<Period> periods;
  double x = 0.3;
  for (int k = 0; k < 620; ++k) {
    x = parameter * x * (1.0 - x);
    if (k >= 500) periods.push_back({{x, 1.0 - x, 0.0}, 2, true});
  }
  return periods;
}

TEST(Classify, ClassifiesWhatNeverMovedAsRest) {
  const std::vector<Period> periods(120);
  for (const bool random : {false, true}) {
    CountedExponent exponent;
    EXPECT_EQ(exponent.classification_of(periods, random).mode.kind, ResponseKind::rest);
    EXPECT_EQ(exponent.calls, 0);
  }
}

TEST(Classify, DoesNotCallASingleStirRest) {
  std::vector<Period> periods(120);
  periods[60].moved = true;
  CountedExponent exponent{clearly_negative};
  EXPECT_EQ(exponent.classification_of(periods, true).mode.kind, ResponseKind::unresolved);
}

TEST(Classify, AsksForNoExponentWhereThePointsSpeak) {
  CountedExponent exponent{clearly_positive};
  EXPECT_EQ(exponent.classification_of(noisy(3, 1, 0.0, 1), false).mode, periodic(1, 3));
  EXPECT_EQ(exponent.classification_of(noisy(3, 1, 1e-4, 1), true).mode, periodic(1, 3));
  EXPECT_EQ(exponent.classification_of(noisy(1, 1, 1e-4, 1), true).mode, periodic(1, 1));
  EXPECT_EQ(exponent.calls, 0);
}

TEST(Classify, LetsTheExponentDecideOnWideClouds) {
  const auto periods = noisy(1, 1, 0.05, 1);
  struct Case {
    std::optional<ExponentEstimate> estimate;
    ResponseMode mode;
    Reason reason;
  };
  for (const Case& c : {Case{clearly_negative, periodic(1, 1), Reason::contracting_clouds},
                        Case{clearly_positive, {ResponseKind::chaotic, 0, 0}, Reason::positive_exponent},
                        Case{ExponentEstimate{0.02, 0.01}, {}, Reason::exponent_unclear},
                        Case{ExponentEstimate{-0.02, 0.01}, {}, Reason::exponent_unclear},
                        Case{ExponentEstimate{0.001, 0.0}, {}, Reason::exponent_unclear},
                        Case{std::nullopt, {}, Reason::exponent_unclear}}) {
    CountedExponent exponent{c.estimate};
    const Classification classification = exponent.classification_of(periods, true);
    EXPECT_EQ(classification.mode, c.mode);
    EXPECT_EQ(classification.reason, c.reason) << to_string(classification.reason.value());
    EXPECT_EQ(exponent.calls, 1);
  }
}

TEST(Classify, ClassifiesALogisticMapAsChaoticOnlyIfItsExponentIsPositive) {
  CountedExponent positive{clearly_positive};
  EXPECT_EQ(positive.classification_of(logistic(3.9), false).mode.kind, ResponseKind::chaotic);
  EXPECT_EQ(positive.calls, 1);
  CountedExponent negative{clearly_negative};
  EXPECT_EQ(negative.classification_of(logistic(3.9), false).reason, Reason::not_periodic);
}

TEST(Classify, FindsThePeriodsOfTheLogisticMap) {
  CountedExponent exponent;
  EXPECT_EQ(exponent.classification_of(logistic(2.8), false).mode, periodic(1, 1));
  EXPECT_EQ(exponent.classification_of(logistic(3.2), false).mode, periodic(2, 2));
  EXPECT_EQ(exponent.classification_of(logistic(3.5), false).mode, periodic(4, 4));
  EXPECT_EQ(exponent.classification_of(logistic(3.55), false).mode, periodic(8, 8));
  EXPECT_EQ(exponent.classification_of(logistic(3.83), false).mode, periodic(3, 3));
  EXPECT_EQ(exponent.calls, 0);
}

TEST(Classify, DistinguishesResponsesOfEqualPeriodByTheirRocks) {
  CountedExponent exponent;
  for (const int m : {1, 2, 3, 4})
    EXPECT_EQ(exponent.classification_of(noisy(3, m, 1e-4, 9), true).mode, periodic(m, 3));
}

TEST(Classify, ClassifiesNoisySlidingByItsSlipRate) {
  support::SplitMix draw(4);
  std::vector<Period> periods;
  for (int k = 0; k < 120; ++k) periods.push_back({{0.0, 0.0, 0.1 + 0.01 * draw.normal()}, 0, true});
  CountedExponent exponent{clearly_negative};
  EXPECT_EQ(exponent.classification_of(periods, true).mode, periodic(0, 1));
  for (std::size_t k = 0; k < periods.size(); k += 3) periods[k].moved = false;
  EXPECT_EQ(exponent.classification_of(periods, true).reason, Reason::impacts_irregular);
}

TEST(Classify, IsNotDeceivedByAJumpBetweenPhaseCopies) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    auto periods = noisy(3, 1, 1e-3, seed);
    periods.erase(periods.begin() + 20 + static_cast<std::ptrdiff_t>(seed % 80));
    CountedExponent exponent{clearly_negative};
    const Classification classification = exponent.classification_of(periods, true);
    const bool by_the_last_copy = classification.mode == periodic(1, 3) && classification.held < 1.0;
    EXPECT_TRUE(by_the_last_copy || classification.mode.kind == ResponseKind::unresolved) << seed;
  }
}

TEST(Classify, SaysThatADriftingResponseHasNotSettled) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto periods = noisy(1, 1, 0.01, seed);
    for (std::size_t k = 0; k < periods.size(); ++k) periods[k].point.tilt += 0.002 * static_cast<double>(k);
    CountedExponent exponent{clearly_negative};
    const Classification classification = exponent.classification_of(periods, true);
    EXPECT_EQ(classification.mode.kind, ResponseKind::unresolved) << seed;
    EXPECT_TRUE(classification.in_transient) << seed << ' ' << to_string(classification.reason.value());
  }
}

TEST(Classify, SaysThatADriftingSubharmonicHasNotSettled) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto periods = noisy(3, 1, 0.01, seed);
    for (std::size_t k = 0; k < periods.size(); ++k) periods[k].point.tilt += 0.003 * static_cast<double>(k);
    CountedExponent exponent{clearly_negative};
    const Classification classification = exponent.classification_of(periods, true);
    EXPECT_EQ(classification.mode.kind, ResponseKind::unresolved) << seed;
    EXPECT_TRUE(classification.in_transient) << seed << ' ' << to_string(classification.reason.value());
  }
}

TEST(Classify, SeesAShiftInMidWindowThatTheNoiseNearlyHides) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    support::SplitMix draw(seed);
    support::Synthetic response = support::random_orbit(1, 1, 0.0, draw);
    response.wander = {0.02, 2.0, 0.0, 0.0, 0.0};
    auto periods = response.periods(240, draw);
    for (std::size_t k = 120; k < 240; ++k) periods[k].point.tilt += 5.0 * 0.02;
    CountedExponent exponent{clearly_negative};
    const Classification classification = exponent.classification_of(periods, true);
    EXPECT_TRUE(classification.reason == Reason::not_stationary || classification.reason == Reason::changed_regime)
        << seed;
    EXPECT_TRUE(classification.in_transient) << seed;
  }
}

TEST(Classify, ClassifiesAResponseOfFewBurstsButNotOfMany) {
  const auto with_bursts = [](int every) {
    auto periods = noisy(1, 1, 0.005, 1);
    support::SplitMix draw(3);
    for (int k = 3; k < 110; k += 1 + draw.below(2 * every)) periods[static_cast<std::size_t>(k)].point.tilt += 0.3;
    return periods;
  };
  CountedExponent exponent{clearly_negative};
  EXPECT_EQ(exponent.classification_of(with_bursts(30), true).mode, periodic(1, 1));
  EXPECT_EQ(exponent.classification_of(with_bursts(10), true).mode.kind, ResponseKind::unresolved);
}

TEST(Classify, SaysSoIfTheResponseBecomesAnotherOneAtTheEnd) {
  auto periods = noisy(1, 1, 0.001, 1);
  const auto other = noisy(3, 1, 0.001, 5);
  std::copy(other.end() - 5, other.end(), periods.end() - 5);
  CountedExponent exponent{clearly_negative};
  EXPECT_EQ(exponent.classification_of(periods, true).reason, Reason::not_stationary);
}

TEST(Classify, WantsEnoughPoints) {
  CountedExponent exponent{clearly_negative};
  auto periods = noisy(1, 1, 0.0, 1);
  periods.resize(47);
  EXPECT_EQ(exponent.classification_of(periods, true).reason, Reason::too_few_points);
  EXPECT_EQ(exponent.classification_of(periods, false).mode, periodic(1, 1));
  periods.resize(23);
  EXPECT_EQ(exponent.classification_of(periods, false).reason, Reason::too_few_points);
  EXPECT_EQ(exponent.classification_of({}, false).reason, Reason::too_few_points);
  EXPECT_EQ(exponent.calls, 0);
}

TEST(Reason, IsFoundByItsName) {
  for (std::size_t i = 0; i < reason_names.size(); ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_FALSE(to_string(reason).empty()) << i;
    EXPECT_EQ(reason_named(to_string(reason)), reason);
  }
  EXPECT_EQ(to_string(Reason::never_moved), "never_moved");
  EXPECT_EQ(to_string(Reason::too_few_points), "too_few_points");
  EXPECT_EQ(to_string(Reason::out_of_order), "out_of_order");
  EXPECT_EQ(to_string(Reason::impacts_irregular), "impacts_irregular");
  EXPECT_FALSE(reason_named("").has_value());
  EXPECT_FALSE(reason_named("bored").has_value());
}

}  // namespace
}  // namespace rocking::section
