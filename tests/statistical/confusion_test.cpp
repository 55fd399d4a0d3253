// Frequency of wrong labels on synthetic responses with known labels. The tables are in
// reports/evidence/classification-evidence.md; this program makes them. The seeds are fixed: no false alarm.

#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classify.hpp"
#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

struct Score {
  int series = 0;
  int wrong = 0;
  int unresolved = 0;
  int exponents = 0;
  std::map<std::string, int> classifications;

  void judge(const std::vector<Period>& periods, const ResponseMode& truth, const ExponentEstimate& exponent) {
    const auto estimate = [&] {
      ++exponents;
      return std::optional(exponent);
    };
    const Classification classification = classify({.periods = periods, .random = true, .resolution = 1e-7}, estimate);
    ++series;
    const bool open = classification.mode.kind == ResponseKind::unresolved;
    unresolved += open ? 1 : 0;
    wrong += !open && classification.mode != truth ? 1 : 0;
    ++classifications[open ? std::string(to_string(classification.reason.value())) : to_string(classification.mode)];
  }

  void print(const char* name) const {
    std::printf("| %s | %d | %d | %d | %d |", name, series, wrong, unresolved, exponents);
    for (const auto& [classification, count] : classifications) std::printf(" %s %d", classification.c_str(), count);
    std::printf(" |\n");
  }
};

std::string row(const char* what, int n, std::size_t count) {
  return std::string(what) + std::to_string(n) + ", N = " + std::to_string(count);
}

constexpr ExponentEstimate contracting{-0.2, 0.01};

// Separate clouds: the distance of any two is at least 7 scatters, mostly far more; the scatter is stretched by 0.5 to
// 3, the memory per cycle is anything up to what Housner's impact allows, with rotation by any angle; half of the
// series have 2 % strays at ten scatters.
Score separated(int n, std::size_t count, int series) {
  Score score;
  support::SplitMix draw(1000 * count + static_cast<std::uint64_t>(n));
  const double gap = n > 8 ? 0.12 : 0.2;
  const double widest = n > 8 ? 0.01 : 0.02;
  for (int k = 0; k < series; ++k) {
    const int m = 1 + draw.below(n + 1);
    support::Synthetic response = support::random_orbit(n, m, gap, draw);
    const double scatter = 4e-4 * std::pow(widest / 4e-4, draw.uniform());
    const double memory = std::pow(0.83 * draw.uniform(), 1.0 / n);
    response.wander = {scatter, draw.uniform(0.5, 3.0), memory, draw.uniform(0.0, std::numbers::pi),
                       draw.below(2) == 0 ? 0.0 : 0.02};
    score.judge(response.periods(count, draw), periodic(m, n), contracting);
  }
  return score;
}

TEST(Confusion, IsBelowOneInAThousandForCloudsApart) {
  Score all;
  for (const std::size_t count : {60U, 120U, 240U, 600U}) {
    Score of_count;
    for (int n = 1; n <= longest_period; ++n) {
      const Score score = separated(n, count, 250);
      score.print(row("clouds apart, n = ", n, count).c_str());
      of_count.series += score.series;
      of_count.unresolved += score.unresolved;
      all.series += score.series;
      all.wrong += score.wrong;
    }
    EXPECT_LT(of_count.unresolved, (count < 120 ? 0.08 : 0.02) * of_count.series) << count;
  }
  EXPECT_LT(all.wrong, 0.001 * all.series);
}

// The noise of a (1,1) response must not be taken for a longer period, whatever its memory.
TEST(Confusion, SplitsNoWideCloud) {
  for (const std::size_t count : {60U, 120U, 240U}) {
    Score score;
    support::SplitMix draw(count);
    for (int k = 0; k < 5000; ++k) {
      support::Synthetic response = support::random_orbit(1, 1, 0.0, draw);
      response.wander = {0.05, draw.uniform(0.5, 3.0), 0.83 * draw.uniform(), draw.uniform(0.0, std::numbers::pi), 0.0};
      score.judge(response.periods(count, draw), periodic(1, 1), contracting);
    }
    score.print(row("one wide cloud, n = ", 1, count).c_str());
    EXPECT_LE(score.wrong, 1);
    EXPECT_LT(score.unresolved, 0.01 * score.series);
  }
}

// If deviations of a (1,3) response change sign from cycle to cycle and decay as slowly as Housner's impact allows,
// they look like a period doubling for a while. If there are few cycles, clouds must be far apart to be taken for six.
TEST(Confusion, TakesNoNoiseWithLongMemoryForADoubling) {
  for (const std::size_t count : {60U, 120U}) {
    Score score;
    support::SplitMix draw(37);
    for (int k = 0; k < 4000; ++k) {
      support::Synthetic response = support::random_orbit(3, 1, 0.2, draw);
      response.wander = {0.01, 2.0, 0.94, std::numbers::pi / 3.0 * draw.uniform(0.9, 1.1), 0.0};
      score.judge(response.periods(count, draw), periodic(1, 3), contracting);
    }
    score.print(row("near doubling, n = ", 3, count).c_str());
    EXPECT_LE(score.wrong, 4);
  }
}

// Two of three clouds coincide: the period is still three.
TEST(Confusion, DoesNotNeedAllCloudsApart) {
  Score score;
  support::SplitMix draw(3);
  for (int k = 0; k < 2000; ++k) {
    support::Synthetic response = support::random_orbit(3, 1, 0.2, draw);
    response.orbit[1] = response.orbit[0];
    response.orbit[1].tilt += draw.uniform(0.0, 0.03);
    response.wander = {0.02, 2.0, 0.9, draw.uniform(0.0, std::numbers::pi), 0.0};
    score.judge(response.periods(120, draw), periodic(1, 3), contracting);
  }
  score.print("(1,3), two of three clouds together");
  EXPECT_EQ(score.wrong, 0);
  EXPECT_LT(score.unresolved, 0.02 * score.series);
}

// Classification of a period doubling against its size in scatters: a splitting far below the noise cannot be detected.
TEST(Confusion, SeesADoublingOnceItIsLargerThanTheNoise) {
  for (const double size : {0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    Score score;
    support::SplitMix draw(17);
    for (int k = 0; k < 1000; ++k) {
      support::Synthetic response = support::random_orbit(2, 2, 0.0, draw);
      response.orbit[1] = response.orbit[0];
      response.orbit[1].tilt_rate += size * 0.03 * 2.0;
      response.wander = {0.03, 2.0, 0.4, draw.uniform(0.0, std::numbers::pi), 0.0};
      score.judge(response.periods(120, draw), periodic(2, 2), contracting);
    }
    char name[64];
    std::snprintf(name, sizeof name, "doubling of %.2f scatters", size);
    score.print(name);
    if (size >= 3.0) {
      EXPECT_LT(score.wrong, 0.01 * score.series) << size;
    }
    if (size >= 4.0) {
      EXPECT_EQ(score.wrong, 0) << size;
    }
    if (size >= 5.0) {
      EXPECT_LT(score.unresolved, 0.02 * score.series) << size;
    }
  }
}

TEST(Confusion, ClassifiesChaosAsChaoticHoweverItsPointsLie) {
  for (const double noise : {0.0, 0.002, 0.01}) {
    Score score;
    support::SplitMix draw(23);
    for (int series = 0; series < 1000; ++series) {
      double x = 0.1 * draw.uniform();
      double y = 0.1;
      std::vector<Period> periods;
      for (int k = 0; k < 170; ++k) {  // Henon's map
        const double next = 1.0 - 1.4 * x * x + y + noise * draw.normal();
        y = 0.3 * x;
        x = std::abs(next) > 1.35 ? 0.0 : next;
        if (k >= 50) periods.push_back({{0.4 * x, 0.8 * y, 0.0}, static_cast<std::uint16_t>(1 + draw.below(3)), true});
      }
      score.judge(periods, {ResponseKind::chaotic, 0, 0}, {0.42, 0.02});
    }
    score.print("Henon's map");
    EXPECT_EQ(score.wrong, 0);
    EXPECT_LT(score.unresolved, 0.02 * score.series);
  }
}

// Phase copies of a (1,3) response that change at random times: right is (1,3) if it lasted for all but 5 %, or
// unresolved.
TEST(Confusion, ClassifiesNoResponseThatJumpsBetweenItsPhases) {
  for (const int jumps : {1, 2, 5, 20}) {
    Score score;
    support::SplitMix draw(29);
    for (int series = 0; series < 1000; ++series) {
      support::Synthetic response = support::random_orbit(3, 1, 0.2, draw);
      response.wander = {0.01, 2.0, 0.5, 1.0, 0.0};
      auto periods = response.periods(120 + static_cast<std::size_t>(jumps), draw);
      for (int k = 0; k < jumps; ++k) periods.erase(periods.begin() + draw.below(static_cast<int>(periods.size())));
      score.judge(periods, periodic(1, 3), contracting);
    }
    score.print(("(1,3) with phase jumps: " + std::to_string(jumps)).c_str());
    EXPECT_EQ(score.wrong, 0);
    EXPECT_GT(score.unresolved, 0.8 * score.series);
  }
}

}  // namespace
}  // namespace rocking::section
