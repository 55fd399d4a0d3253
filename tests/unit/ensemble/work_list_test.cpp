// Work of a run: pairs, shards, what remains.

#include "rocking/ensemble/work_list.hpp"

#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace rocking {
namespace {

/// Conditions with 5, 1 (nothing random) and 4 realisations.
Experiment three_conditions() {
  Experiment question;
  for (const std::uint64_t realisations : {5U, 9U, 4U}) {
    Condition condition;
    condition.realisations = realisations;
    if (realisations != 9) condition.scene.initial.tilt = Uniform{.low = 0.0, .high = 0.1};
    question.conditions.push_back(condition);
  }
  return question;
}

using Pairs = std::set<std::pair<std::size_t, std::uint64_t>>;

Pairs drained(WorkList work) {
  Pairs pairs;
  while (const auto pair = work.take()) EXPECT_TRUE(pairs.emplace(pair->condition, pair->first).second);
  return pairs;
}

TEST(WorkList, HasEveryPairOnce) {
  const WorkList work(three_conditions(), {});
  EXPECT_EQ(work.all(), 10U);
  EXPECT_EQ(drained(work), (Pairs{{0, 0}, {0, 2}, {0, 4}, {1, 0}, {2, 0}, {2, 2}}));
}

TEST(WorkList, IsCutIntoShardsWithoutGapOrOverlap) {
  for (const std::uint64_t parts : {1U, 2U, 3U, 7U}) {
    Pairs together;
    std::uint64_t realisations = 0;
    for (std::uint64_t part = 1; part <= parts; ++part) {
      const WorkList work(three_conditions(), Shard{.part = part, .parts = parts});
      realisations += work.all();
      for (const auto& pair : drained(work)) EXPECT_TRUE(together.insert(pair).second);
    }
    EXPECT_EQ(together, drained(WorkList(three_conditions(), {})));
    EXPECT_EQ(realisations, 10U);
  }
}

TEST(WorkList, LeavesOutWhatIsDone) {
  WorkList work(three_conditions(), {});
  for (const RealisationKey key : {RealisationKey{0, 0}, {0, 1}, {0, 4}, {2, 2}}) work.mark_done(key);
  EXPECT_EQ(work.done(), 4U);
  EXPECT_EQ(drained(work), (Pairs{{0, 2}, {1, 0}, {2, 0}, {2, 2}})) << "half a pair is no pair";
}

TEST(WorkList, CountsNoRealisationTwice) {
  WorkList work(three_conditions(), {});
  for (int i = 0; i < 3; ++i) work.mark_done({0, 3});
  EXPECT_EQ(work.done(), 1U);
  EXPECT_FALSE(work.is_complete());
}

TEST(WorkList, CountsNothingOfOthersShards) {
  WorkList work(three_conditions(), Shard{.part = 1, .parts = 2});
  const std::uint64_t all = work.all();
  for (std::uint64_t number = 0; number < 5; ++number) work.mark_done({0, number});
  work.mark_done({1, 0});
  for (std::uint64_t number = 0; number < 4; ++number) work.mark_done({2, number});
  EXPECT_EQ(work.done(), all);
  EXPECT_TRUE(work.is_complete());
}

}  // namespace
}  // namespace rocking
