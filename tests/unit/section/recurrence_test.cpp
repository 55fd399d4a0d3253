#include "rocking/section/recurrence.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

using support::point_accuracy;

std::vector<Period> noise_free(int n, int m, std::size_t count, std::uint64_t seed) {
  support::SplitMix draw(seed);
  return support::random_orbit(n, m, 0.05, draw).periods(count, draw);
}

/// Points that converge to an orbit by a factor per period.
std::vector<Period> converging(std::vector<Period> periods, double size, double factor) {
  for (Period& period : periods) {
    period.point.tilt += size;
    size *= factor;
  }
  return periods;
}

TEST(FindRecurrence, FindsEveryPeriodUpToTwelve) {
  for (int n = 1; n <= longest_period; ++n) {
    for (int m = 1; m <= n; ++m) {
      const auto classification = find_recurrence(noise_free(n, m, 120, 7), point_accuracy).classification;
      ASSERT_TRUE(classification) << n;
      EXPECT_EQ(classification->mode, periodic(m, n)) << to_string(classification->mode);
      EXPECT_EQ(classification->reason, Reason::points_coincide);
      EXPECT_FALSE(classification->in_transient);
      EXPECT_GE(classification->margin, 1.0);
    }
  }
}

TEST(FindRecurrence, DoesNotCountAChatterThatTheEndCuts) {
  std::vector<Period> periods = noise_free(3, 1, 120, 7);
  periods.back().impacts += 40;
  const auto mode = [&](std::size_t unfinished) {
    return find_recurrence(periods, point_accuracy, {}, unfinished).classification.value().mode;
  };
  EXPECT_EQ(mode(0).kind, ResponseKind::unresolved);
  EXPECT_EQ(mode(1), periodic(1, 3));
  EXPECT_EQ(mode(57), periodic(1, 3));
  EXPECT_EQ(mode(58).kind, ResponseKind::unresolved) << "no whole cycle is left";
}

TEST(FindRecurrence, SaysNothingOfAPeriodOfThirteen) {
  const Recurrence found = find_recurrence(noise_free(13, 5, 120, 7), point_accuracy);
  EXPECT_FALSE(found.classification);
  EXPECT_TRUE(found.candidates.empty());
}

TEST(FindRecurrence, TellsADoublingOfAThousandResolutions) {
  std::vector<Period> periods = noise_free(1, 1, 120, 7);
  for (std::size_t k = 0; k < periods.size(); k += 2) periods[k].point.tilt_rate += 1e3 * point_accuracy;
  EXPECT_EQ(find_recurrence(periods, point_accuracy).classification->mode, periodic(2, 2));
}

TEST(FindRecurrence, DoesNotMindErrorsOfTheSizeOfTheResolution) {
  support::SplitMix draw(3);
  std::vector<Period> periods = noise_free(3, 1, 120, 7);
  for (Period& period : periods) period.point.tilt += point_accuracy * draw.uniform(-1.0, 1.0);
  EXPECT_EQ(find_recurrence(periods, point_accuracy).classification->mode, periodic(1, 3));
}

TEST(FindRecurrence, SeesTheSlipRateOfABlockThatOnlySlides) {
  std::vector<Period> periods(120);
  for (std::size_t k = 0; k < periods.size(); ++k) periods[k] = {{0.0, 0.0, k % 2 == 0 ? 0.1 : 0.2}, 0, true};
  EXPECT_EQ(find_recurrence(periods, point_accuracy).classification->mode, periodic(0, 2));
}

TEST(FindRecurrence, LeavesWhatStillConvergesToTheOrbit) {
  for (const double factor : {0.7, 0.9, -0.9, 0.99}) {
    for (const int n : {1, 3}) {
      const Recurrence found = find_recurrence(converging(noise_free(n, 1, 120, 7), 0.5, factor), point_accuracy);
      const bool has_arrived = factor == 0.7;
      EXPECT_EQ(found.classification.has_value(), has_arrived) << factor;
      if (!has_arrived) {
        EXPECT_EQ(found.candidates, std::vector{n}) << factor;
      }
    }
  }
}

// On a spiral that turns by nearly a sixth in each period the points after six periods are close long before those after one.
TEST(FindRecurrence, DoesNotNameTheTurnOfASlowSpiral) {
  for (const int turn : {2, 3, 6, 11}) {
    std::vector<Period> periods;
    double size = 1e-7;
    for (int k = 0; k < 120; ++k, size *= 0.999) {
      const double angle = 2.0 * std::numbers::pi * k / turn;
      periods.push_back({{0.3 + size * std::cos(angle), size * std::sin(angle), 0.0}, 2, true});
    }
    const Recurrence found = find_recurrence(periods, 1e-9);
    EXPECT_FALSE(found.classification) << turn;
    EXPECT_EQ(found.candidates, std::vector{turn});
  }
}

TEST(FindRecurrence, DoesNotTakeAPowerLawForConvergence) {
  std::vector<Period> periods = noise_free(1, 1, 120, 7);
  for (std::size_t k = 0; k < periods.size(); ++k) periods[k].point.tilt += 3.0 / static_cast<double>(500 + k);
  const Recurrence found = find_recurrence(periods, point_accuracy);
  EXPECT_FALSE(found.classification);
  EXPECT_TRUE(found.candidates.empty());
}

TEST(FindRecurrence, DoesNotNameAnOrbitWhoseImpactsAreIrregular) {
  std::vector<Period> periods = noise_free(1, 1, 120, 7);
  periods[100].impacts = 4;
  EXPECT_EQ(find_recurrence(periods, point_accuracy).classification->reason, Reason::impacts_irregular);
}

TEST(FindRecurrence, SaysNothingOfALogisticMap) {
  std::vector<Period> periods;
  double x = 0.3;
  for (int k = 0; k < 600; ++k) {
    x = 3.9 * x * (1.0 - x);
    periods.push_back({{x, 0.0, 0.0}, 2, true});
  }
  for (std::size_t first = 0; first + 120 <= periods.size(); first += 7) {
    const Recurrence found = find_recurrence(std::span(periods).subspan(first, 120), point_accuracy);
    EXPECT_FALSE(found.classification) << first;
  }
}

}  // namespace
}  // namespace rocking::section
