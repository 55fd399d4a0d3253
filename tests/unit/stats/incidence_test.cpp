#include "rocking/stats/incidence.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rocking::stats {
namespace {

EndOfObservation ended(std::int64_t time, std::optional<std::size_t> event) { return {.time = time, .event = event}; }

TEST(CumulativeIncidence, IsTheShareWithItsExactIntervalWithoutCensoring) {
  const EventTally tally{{ended(3, 0), 4}, {ended(5, 1), 3}, {ended(9, 0), 5}};
  const auto curve = cumulative_incidence(tally, 0, 0.95);
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_EQ(curve[0].time, 3);
  EXPECT_EQ(curve[1].time, 9);
  for (const auto& [point, successes] : {std::pair{curve[0], 4U}, std::pair{curve[1], 9U}}) {
    const double share = successes / 12.0;
    EXPECT_NEAR(point.estimate, share, 1e-15);
    EXPECT_NEAR(point.variance, share * (1.0 - share) / 12.0, 1e-15);
    const Interval exact = clopper_pearson({.successes = successes, .trials = 12}, 0.95);
    EXPECT_NEAR(point.pointwise.low, exact.low, 1e-12);
    EXPECT_NEAR(point.pointwise.high, exact.high, 1e-12);
    EXPECT_NEAR(point.simultaneous.low, std::max(0.0, share - std::sqrt(std::log(40.0) / 24.0)), 1e-15);
  }
}

// Aalen and Johansen by hand: F_A(1) = 1/4, S = 3/4; one is censored; F_B(3) = 3/4 * 1/2, S = 3/8; F_A(4) = 1/4 + 3/8.
TEST(CumulativeIncidence, FollowsAalenAndJohansenWhereAnObservationIsCensored) {
  const EventTally tally{{ended(1, 0), 1}, {ended(2, std::nullopt), 1}, {ended(3, 1), 1}, {ended(4, 0), 1}};
  const auto first = cumulative_incidence(tally, 0, 0.9);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_DOUBLE_EQ(first[0].estimate, 0.25);
  EXPECT_DOUBLE_EQ(first[1].estimate, 0.625);
  const auto second = cumulative_incidence(tally, 1, 0.9);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_DOUBLE_EQ(second[0].estimate, 0.375);
}

// With one kind of event the variance is that of Greenwood (1926): S^2 sum d/(n (n - d)).
TEST(CumulativeIncidence, HasGreenwoodsVarianceForOneKindOfEvent) {
  const EventTally tally{{ended(1, 0), 2}, {ended(2, std::nullopt), 3}, {ended(3, 0), 1}, {ended(4, std::nullopt), 4}};
  const auto curve = cumulative_incidence(tally, 0, 0.95);
  ASSERT_EQ(curve.size(), 2U);
  const double survival = 0.8 * 0.8;
  EXPECT_NEAR(curve[1].estimate, 1.0 - survival, 1e-15);
  EXPECT_NEAR(curve[1].variance, survival * survival * (2.0 / (10.0 * 8.0) + 1.0 / (5.0 * 4.0)), 1e-15);
}

EventTally tally_from(const nlohmann::json& known) {
  EventTally tally;
  for (std::size_t i = 0; i < known["time"].size(); ++i) {
    const auto event = known["event"][i].get<std::size_t>();
    ++tally[ended(known["time"][i], event == 0 ? std::nullopt : std::optional(event - 1))];
  }
  return tally;
}

TEST(CumulativeIncidence, AgreesWithSurvfitOfTheSurvivalPackage) {
  const auto oracle = nlohmann::json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/survival_incidence.json"));
  ASSERT_EQ(oracle["sets"].size(), 4U);
  for (const auto& known : oracle["sets"]) {
    SCOPED_TRACE(known["name"].get<std::string>());
    const EventTally tally = tally_from(known);
    for (std::size_t event = 0; event < known["events"]; ++event) {
      const auto& theirs = known["curves"][event];
      std::size_t compared = 0;
      for (const Incidence& ours : cumulative_incidence(tally, event, 0.95)) {
        const auto found = std::find(theirs["times"].begin(), theirs["times"].end(), ours.time);
        ASSERT_NE(found, theirs["times"].end());
        const auto at = static_cast<std::size_t>(found - theirs["times"].begin());
        EXPECT_NEAR(ours.estimate, theirs["estimate"][at].get<double>(), 1e-10) << "at " << ours.time;
        EXPECT_NEAR(std::sqrt(ours.variance), theirs["standard_error"][at].get<double>(), 1e-10) << "at " << ours.time;
        ++compared;
      }
      EXPECT_GT(compared, 0U);
    }
  }
}

// Garwood's (1936) limits for 0 and 5 events at 95 %.
TEST(PoissonRateInterval, IsTheExactOne) {
  EXPECT_EQ(poisson_rate_interval(0, 2.0, 0.95).low, 0.0);
  EXPECT_NEAR(poisson_rate_interval(0, 2.0, 0.95).high, -std::log(0.025) / 2.0, 1e-12);
  EXPECT_NEAR(poisson_rate_interval(5, 1.0, 0.95).low, 1.6235, 5e-5);
  EXPECT_NEAR(poisson_rate_interval(5, 1.0, 0.95).high, 11.6683, 5e-5);
}

}  // namespace
}  // namespace rocking::stats
