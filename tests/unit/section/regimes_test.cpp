// Responses that change within the window: their classification.

#include "rocking/section/classify.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t window = 120;

std::vector<Period> response(int n, int m, double scatter, std::uint64_t seed, std::size_t count = window) {
  support::SplitMix draw(seed);
  support::Synthetic made = support::random_orbit(n, m, 0.2, draw);
  made.wander = {scatter, 2.0, 0.5, 1.0, 0.0};
  return made.periods(count, draw);
}

/// `count` periods of one response, then the other one to the end of the window.
std::vector<Period> first_then(const std::vector<Period>& one, std::size_t count, const std::vector<Period>& other) {
  std::vector<Period> periods(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(count));
  periods.insert(periods.end(), other.begin() + static_cast<std::ptrdiff_t>(count), other.end());
  return periods;
}

/// The same (1,n) response, which omits a period at each of the given places.
std::vector<Period> with_jumps(int n, double scatter, std::uint64_t seed, const std::vector<int>& places) {
  auto periods = response(n, 1, scatter, seed, window + places.size());
  for (const int place : places) periods.erase(periods.begin() + place);
  return periods;
}

Classification classification_of(const std::vector<Period>& periods, ExponentEstimate exponent = {-0.2, 0.01}) {
  return classify({.periods = periods, .random = true, .resolution = 1e-7}, [&] { return exponent; });
}

TEST(LateSettling, IsClassifiedByTheLastPartAndSaysHowLongThatHeld) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const std::size_t change : {20U, 35U, 55U}) {
      const auto periods = first_then(response(3, 3, 0.02, seed), change, response(1, 1, 3e-4, 1000 + seed));
      const Classification classification = classification_of(periods);
      ASSERT_EQ(classification.mode, periodic(1, 1))
          << seed << ' ' << change << ' ' << to_string(classification.reason.value());
      // The longest of 7/8 ... 4/8 of the window that begins after the change, or a few strays before it.
      EXPECT_LE(classification.held, static_cast<double>(window - change + 6) / window) << seed << ' ' << change;
      EXPECT_GE(classification.held, static_cast<double>(window - change - 15) / window) << seed << ' ' << change;
    }
  }
}

TEST(LateSettling, IsNotClassifiedWhereTheLastPartIsLessThanHalf) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto periods = first_then(response(3, 3, 1e-3, seed), 70, response(1, 1, 3e-4, 1000 + seed));
    const Classification classification = classification_of(periods);
    EXPECT_EQ(classification.reason, Reason::changed_regime) << seed;
    EXPECT_TRUE(classification.in_transient);
    EXPECT_EQ(classification.held, 0.0);
  }
}

TEST(LateSettling, IsNotClassifiedByLessThanHalfOfALongWindow) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto periods = first_then(response(3, 3, 1e-3, seed, 240), 140, response(1, 1, 3e-4, 1000 + seed, 240));
    EXPECT_EQ(classification_of(periods).mode.kind, ResponseKind::unresolved) << seed;
  }
}

// Part of a window with wide clouds may look steady by chance.
TEST(LateSettling, IsNotClassifiedByWideClouds) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto periods = first_then(response(3, 3, 1e-3, seed), 40, response(1, 1, 0.03, 1000 + seed));
    EXPECT_TRUE(classification_of(periods).held == 0.0 || classification_of(periods).held == 1.0) << seed;
  }
}

TEST(LateSettling, NeedsANegativeExponent) {
  const auto periods = first_then(response(3, 3, 0.02, 1), 40, response(1, 1, 3e-4, 2));
  EXPECT_EQ(classification_of(periods).mode, periodic(1, 1));
  EXPECT_EQ(classification_of(periods, {0.0, 0.01}).mode.kind, ResponseKind::unresolved);
  EXPECT_NE(classification_of(periods, {0.2, 0.01}).mode, periodic(1, 1));
}

// A drift so slow that half of the window does not show it is still a drift: no regime began.
TEST(LateSettling, IsNotSeenInASteadyDrift) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const double drift : {1e-4, 3e-4, 1e-3, 3e-3}) {
      auto periods = response(1, 1, 1e-3, seed);
      for (std::size_t k = 0; k < window; ++k) periods[k].point.tilt += drift * static_cast<double>(k);
      const Classification classification = classification_of(periods);
      EXPECT_TRUE(classification.mode.kind == ResponseKind::unresolved || classification.held == 1.0)
          << seed << ' ' << drift;
    }
  }
}

TEST(PhaseJump, IsClassifiedByTheLastPhaseCopyOrRecognisedAsAJump) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const int place : {20, 40, 55, 75, 85, 100}) {
      const Classification classification = classification_of(with_jumps(3, 1e-3, seed, {place}));
      if (place < 60) {
        EXPECT_EQ(classification.mode, periodic(1, 3)) << seed << ' ' << place;
        EXPECT_LT(classification.held, 1.0) << seed << ' ' << place;
      } else {
        EXPECT_EQ(classification.reason, Reason::phase_jump) << seed << ' ' << place;
        EXPECT_FALSE(classification.in_transient) << seed << ' ' << place;
      }
    }
  }
}

// Two phase copies, and parts of the window that begin at odd periods.
TEST(PhaseJump, IsSeenBetweenTwoCopiesAsWell) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Classification classification = classification_of(with_jumps(2, 3e-4, seed, {40}));
    EXPECT_EQ(classification.mode, periodic(1, 2)) << seed;
    EXPECT_EQ(classification.held, 0.625) << seed;
  }
}

TEST(PhaseJump, IsNotWhatAChangeToAnotherResponseIs) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto periods = first_then(response(3, 1, 1e-3, seed), 80, response(3, 1, 1e-3, 1000 + seed));
    EXPECT_EQ(classification_of(periods).reason, Reason::changed_regime) << seed;
  }
}

TEST(Interruption, IsRecognisedInJumpsThatComeTimeAndAgain) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Classification classification = classification_of(with_jumps(3, 2e-3, seed, {10, 31, 47, 66, 85, 103}));
    EXPECT_EQ(classification.reason, Reason::interrupted) << seed;
    EXPECT_EQ(classification.mode.kind, ResponseKind::unresolved);
  }
}

TEST(Interruption, IsRecognisedInBursts) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto periods = response(1, 1, 2e-3, seed);
    support::SplitMix draw(seed);
    for (std::size_t start = 5; start < window; start += 20) {
      for (std::size_t k = start; k < start + 4; ++k) periods[k].point.tilt += draw.uniform(0.2, 0.4);
    }
    EXPECT_EQ(classification_of(periods).reason, Reason::interrupted) << seed;
  }
}

TEST(Interruption, IsNotSeenInOneBurst) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto periods = response(1, 1, 0.004, seed);
    for (std::size_t k = 10; k < 30; ++k) periods[k].point.tilt += k % 2 == 0 ? 0.6 : -0.6;
    EXPECT_NE(classification_of(periods).reason, Reason::interrupted) << seed;
  }
}

TEST(Interruption, IsNotSeenInASlowTurn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    support::SplitMix draw(seed);
    const double turn = draw.uniform(0.3, 3.0);
    std::vector<Period> periods;
    for (std::size_t k = 0; k < window; ++k) {
      const auto wave = base::sin_cos(turn * static_cast<double>(k));
      periods.push_back({{0.3 + 0.2 * wave.cosine, 0.4 * wave.sine, 0.0}, 2, true});
    }
    EXPECT_NE(classification_of(periods, {0.0, 0.01}).reason, Reason::interrupted) << turn;
  }
}

TEST(Regimes, AreNotLookedForWhereTheWholeIsOne) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    EXPECT_EQ(classification_of(response(3, 1, 1e-3, seed)).held, 1.0) << seed;
}

}  // namespace
}  // namespace rocking::section
