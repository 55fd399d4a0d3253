// Results that processes exchange: every field arrives, long runs included.

#include "rocking/ensemble/summary_bytes.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/store/difference.hpp"

namespace rocking {
namespace {

using ::testing::IsEmpty;

constexpr section::ResponseMode third{.kind = section::ResponseKind::periodic, .rocks = 1, .periods = 3};
constexpr section::ResponseMode chaos{.kind = section::ResponseKind::chaotic};

/// A realisation that settled, was left, and has a long run of these windows.
Summary settled(std::uint64_t number, const std::vector<std::pair<section::ResponseMode, std::uint64_t>>& windows) {
  Summary summary;
  summary.mode = third;
  summary.margin = 1.0 / static_cast<double>(number + 3);
  summary.digest = base::sha256(std::to_string(number));
  summary.horizon_mode = section::ResponseMode{};
  summary.observed_periods = 1000 + static_cast<std::int64_t>(number);
  summary.settling_period = 860;
  summary.left_period = 980;
  summary.left_to = chaos;
  section::ModeCounts& counts = summary.long_run.emplace();
  for (const auto& [mode, count] : windows) counts[mode] = count;
  return summary;
}

/// A realisation of a run without `until_classified`.
Summary fixed(std::uint64_t number) {
  Summary summary;
  summary.mode = chaos;
  summary.digest = base::sha256(std::to_string(number));
  summary.diverged_from_next = 17;
  summary.overturned_side = dynamics::Side::right;
  summary.exponent = 0.125;
  summary.exponent_error = 0.5;
  return summary;
}

std::vector<PairOutcome> some_outcomes() {
  return {{.pair = {.condition = 2, .first = 4},
           .summaries = {settled(4, {{third, 12}, {section::ResponseMode{}, 3}, {chaos, 1}}), settled(5, {})}},
          {.pair = {.condition = 0, .first = 0}, .summaries = {fixed(0), fixed(1)}},
          {.pair = {.condition = 3, .first = 8}, .summaries = {settled(8, {{chaos, 4'000'000'000ULL}})}}};
}

TEST(SummaryBytes, GiveBackEveryFieldOfLongRunsAndOfOthers) {
  const std::vector<PairOutcome> sent = some_outcomes();
  const std::vector<PairOutcome> received = outcomes_from(to_bytes(sent));
  ASSERT_EQ(received.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    EXPECT_EQ(received[i].pair.condition, sent[i].pair.condition);
    EXPECT_EQ(received[i].pair.first, sent[i].pair.first);
    ASSERT_EQ(received[i].summaries.size(), sent[i].summaries.size());
    for (std::size_t k = 0; k < sent[i].summaries.size(); ++k) {
      const Summary& before = sent[i].summaries[k];
      const Summary& after = received[i].summaries[k];
      EXPECT_THAT(differing_fields(before, after), IsEmpty()) << i << ' ' << k;
      // differing_fields passes over what rows of earlier layouts lack.
      EXPECT_EQ(after.long_run, before.long_run);
      EXPECT_EQ(after.horizon_mode, before.horizon_mode);
      EXPECT_EQ(after.observed_periods, before.observed_periods);
      EXPECT_EQ(after.settling_period, before.settling_period);
      EXPECT_EQ(after.left_period, before.left_period);
      EXPECT_EQ(after.left_to, before.left_to);
    }
  }
}

TEST(SummaryBytes, GiveBackPairs) {
  const std::vector<Pair> sent{{.condition = 1, .first = 6}, {.condition = 7, .first = 1ULL << 40U}};
  const std::vector<Pair> received = pairs_from(to_bytes(sent));
  ASSERT_EQ(received.size(), 2U);
  EXPECT_EQ(received[1].condition, 7U);
  EXPECT_EQ(received[1].first, 1ULL << 40U);
}

TEST(SummaryBytes, ThatEndTooEarlyAreRefused) {
  const Bytes whole = to_bytes(some_outcomes());
  std::size_t refused = 0;
  for (std::size_t length = 1; length < whole.size(); ++length) {
    try {
      static_cast<void>(outcomes_from(std::span(whole).first(length)));
    } catch (const std::length_error&) {
      ++refused;
    }
  }
  EXPECT_EQ(refused, whole.size() - 1 - 2) << "only after the first and after the second outcome may a message end";
}

}  // namespace
}  // namespace rocking
