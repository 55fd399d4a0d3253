// Incidence and rates of leaving, from realisations whose ends are known.

#include "rocking/ensemble/settling_tally.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rocking {
namespace {

using section::ResponseKind;
using section::ResponseMode;

constexpr ResponseMode one_three{.kind = ResponseKind::periodic, .rocks = 1, .periods = 3};
constexpr int sampled = 50;

Condition condition_with(int held_windows) {
  Condition condition;
  condition.horizon = {.transient_periods = 100, .sampled_periods = sampled, .until_classified = UntilClassified{}};
  condition.horizon.until_classified->at_most_periods = 1000;
  condition.horizon.until_classified->held_windows = held_windows;
  condition.horizon.until_classified->watch_windows = 2;
  return condition;
}

Summary settled(ResponseMode mode, std::int64_t at, std::int64_t observed) {
  Summary summary;
  summary.mode = mode;
  summary.horizon_mode = ResponseMode{};
  summary.settling_period = at;
  summary.observed_periods = observed;
  return summary;
}

Summary censored(std::int64_t observed) {
  Summary summary;
  summary.horizon_mode = ResponseMode{};
  summary.observed_periods = observed;
  return summary;
}

SettlingResult result_of(const SettlingTally& tally, int held_windows) {
  return tally.result(condition_with(held_windows), {}, 0);
}

// Held from 200 on and confirmed at 300; then watched for two windows.
TEST(SettlingTally, CountsTheWatchedPeriodsFromTheLastHeldWindow) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 400));
  Summary left = settled(one_three, 250, 400);
  left.left_period = 400;
  left.left_to = ResponseMode{.kind = ResponseKind::chaotic};
  tally.add(left);
  const Leaving leaving = result_of(tally, 3).leaving.at(one_three);
  EXPECT_EQ(leaving.watched_periods, 100U + 50U);
  EXPECT_EQ(leaving.left, 1U);
  EXPECT_EQ(result_of(tally, 1).leaving.at(one_three).watched_periods, 200U + 150U);
}

TEST(SettlingTally, HasNoRateOfWhatIsNotWatchedOrCannotBeLeft) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 300));
  tally.add(settled({.kind = ResponseKind::overturned}, 120, 120));
  EXPECT_TRUE(result_of(tally, 3).leaving.empty());
}

// The second is at risk only until 350, since what appears later cannot be held for three windows. With the risk until
// 450 the curve would end at 2/3.
TEST(SettlingTally, CensorsBeforeTheWindowsThatCannotBeHeld) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 300));
  tally.add(censored(450));
  tally.add(settled(one_three, 400, 500));
  EXPECT_DOUBLE_EQ(result_of(tally, 3).incidence.at(one_three).back().estimate, 1.0);
  EXPECT_NEAR(result_of(tally, 1).incidence.at(one_three).back().estimate, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(result_of(tally, 3).censored, 1U);
}

/// The realisations of a set of tests/oracles/survival_incidence.R: settled in one of its events, or censored midway.
SettlingTally tally_from(const nlohmann::json& known) {
  SettlingTally tally;
  for (std::size_t i = 0; i < known["event"].size(); ++i) {
    const auto observed = known["observed"][i].get<std::int64_t>();
    const auto event = known["event"][i].get<std::int32_t>();
    tally.add(event > 0 ? settled({.kind = ResponseKind::periodic, .rocks = event, .periods = 1},
                                  known["settling"][i].get<std::int64_t>(), observed)
                        : censored(observed));
  }
  return tally;
}

// Observations with different limits, and some stopped anywhere before.
TEST(SettlingTally, AgreesWithSurvfitWhereObservationsEndMidway) {
  const auto oracle = nlohmann::json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/survival_incidence.json"));
  ASSERT_EQ(oracle["windowed"].size(), 3U);
  for (const auto& known : oracle["windowed"]) {
    SCOPED_TRACE(known["name"].get<std::string>());
    ASSERT_EQ(known["window"], sampled);
    const SettlingResult result = result_of(tally_from(known), known["held"]);
    ASSERT_EQ(result.incidence.size(), known["events"]);
    const auto ends = known["event"].get<std::vector<int>>();
    EXPECT_EQ(result.censored, static_cast<std::uint64_t>(std::ranges::count(ends, 0)));
    for (std::int32_t event = 1; event <= known["events"]; ++event) {
      const auto& theirs = known["curves"][static_cast<std::size_t>(event - 1)];
      const auto& curve = result.incidence.at({.kind = ResponseKind::periodic, .rocks = event, .periods = 1});
      std::size_t next = 0;
      double last = 0.0;
      for (std::size_t at = 0; at < theirs["times"].size(); ++at) {
        const double estimate = theirs["estimate"][at];
        if (estimate == last) continue;  // theirs also has the times of the other events and of censoring
        ASSERT_LT(next, curve.size());
        EXPECT_EQ(curve[next].time, theirs["times"][at]);
        EXPECT_NEAR(curve[next].estimate, estimate, 1e-10) << "at " << curve[next].time;
        EXPECT_NEAR(std::sqrt(curve[next].variance), theirs["standard_error"][at].get<double>(), 1e-10);
        last = estimate;
        ++next;
      }
      EXPECT_EQ(next, curve.size());
    }
  }
}

}  // namespace
}  // namespace rocking
