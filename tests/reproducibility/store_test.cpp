// Stopped and resumed, divided and merged: the same rows and the same result.

#include <atomic>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/ensemble/run.hpp"
#include "rocking/store/difference.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Experiment three_conditions() {
  Experiment question;
  question.seed = 0x2012;
  for (const double amplitude : {3.6, 4.5, 9.0}) {
    Condition condition = support::shaken(amplitude, Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3});
    condition.scene.fluctuation.static_friction = 0.03;
    condition.scene.fluctuation.kinetic_friction = 0.03;
    condition.scene.fluctuation.refreshes_per_period = 20;
    condition.horizon = {.transient_periods = 20, .sampled_periods = 50};
    condition.realisations = 13;
    question.conditions.push_back(condition);
  }
  return question;
}

const Identity whole{.experiment = "", .code = "", .files = "", .shard = {}};

RunOptions threads(unsigned count) { return {.threads = count, .on_progress = {}, .stop_requested = nullptr}; }

Store undisturbed() {
  Store store = Store::in_memory(whole);
  EXPECT_EQ(run(three_conditions(), store, threads(1)), RunEnd::complete);
  return store;
}

Store shard(std::uint64_t part, std::uint64_t parts) {
  Store store = Store::in_memory({.experiment = "", .code = "", .files = "", .shard = Shard{part, parts}});
  EXPECT_EQ(run(three_conditions(), store, threads(2)), RunEnd::complete);
  return store;
}

void expect_same_rows(const Store& a, const Store& b) {
  std::uint64_t rows_of_a = 0;
  std::uint64_t rows_of_b = 0;
  a.for_each([&](const RealisationKey& key, const Summary& summary) {
    ++rows_of_a;
    const auto other = b.find(key);
    ASSERT_TRUE(other.has_value()) << key.condition << ' ' << key.realisation;
    EXPECT_THAT(differing_fields(summary, *other), IsEmpty());
  });
  b.for_each_key([&rows_of_b](const RealisationKey&) { ++rows_of_b; });
  EXPECT_EQ(rows_of_a, rows_of_b);
}

TEST(StoredRun, IsTheSameWithAnyNumberOfThreads) {
  const Store alone = undisturbed();
  for (const unsigned count : {2U, 7U, 16U}) {
    Store together = Store::in_memory(whole);
    ASSERT_EQ(run(three_conditions(), together, threads(count)), RunEnd::complete);
    expect_same_rows(alone, together);
  }
}

TEST(StoredRun, IsTheSameWhereverItWasStoppedAndResumed) {
  const Store alone = undisturbed();
  for (const std::uint64_t first_stop : {1U, 2U, 5U, 20U, 38U}) {
    Store store = Store::in_memory(whole);
    std::uint64_t stops = 0;
    RunEnd end = RunEnd::stopped;
    while (end == RunEnd::stopped) {
      std::atomic<bool> stop{false};
      std::uint64_t calls = 0;
      const auto watch = [&](std::uint64_t, std::uint64_t) { stop = ++calls >= first_stop + stops; };
      end = run(three_conditions(), store, {.threads = 2, .on_progress = watch, .stop_requested = &stop});
      ASSERT_LT(++stops, 50U);
    }
    expect_same_rows(alone, store);
    EXPECT_EQ(result_of(three_conditions(), store)->digest, result_of(three_conditions(), alone)->digest);
  }
}

TEST(StoredRun, HasNoResultUntilNothingIsMissing) {
  const Store part = shard(1, 2);
  EXPECT_FALSE(result_of(three_conditions(), part).has_value());
  EXPECT_TRUE(result_of(three_conditions(), undisturbed()).has_value());
}

TEST(Shards, GiveTheWholeInAnyOrder) {
  const Store alone = undisturbed();
  for (const std::vector<std::uint64_t>& order : {std::vector<std::uint64_t>{1, 2, 3}, {3, 1, 2}, {2, 3, 1}}) {
    Store together = Store::in_memory(whole);
    for (const std::uint64_t part : order) EXPECT_THAT(merge(together, shard(part, 3)), IsEmpty());
    expect_same_rows(alone, together);
  }
}

TEST(Shards, MayOverlapWhereTheyAgree) {
  Store together = Store::in_memory(whole);
  EXPECT_THAT(merge(together, shard(1, 2)), IsEmpty());
  EXPECT_THAT(merge(together, shard(1, 3)), IsEmpty());
  EXPECT_THAT(merge(together, shard(2, 2)), IsEmpty());
  expect_same_rows(undisturbed(), together);
}

TEST(Shards, AreToldWhereTheyDisagree) {
  const Store alone = undisturbed();
  Store other = undisturbed();
  Summary changed = other.find({1, 4}).value();
  changed.digest = base::sha256("another");
  ++changed.operations.steps;
  other.add({1, 4}, changed);
  Store together = Store::in_memory(whole);
  EXPECT_THAT(merge(together, alone), IsEmpty());
  const auto conflicts = merge(together, other);
  ASSERT_EQ(conflicts.size(), 1U);
  EXPECT_EQ(conflicts[0].key, (RealisationKey{1, 4}));
  EXPECT_THAT(conflicts[0].fields, ElementsAre("digest", "steps"));
}

TEST(Verification, FindsEveryRealisationThatIsNotWhatTheProgramGives) {
  Store store = undisturbed();
  EXPECT_EQ(verify(three_conditions(), store, {}, threads(2)).different, 0U);
  for (const RealisationKey key : {RealisationKey{0, 12}, {2, 1}}) {
    Summary changed = store.find(key).value();
    changed.mode = section::periodic(5, 7);
    store.add(key, changed);
  }
  const Verification found = verify(three_conditions(), store, {}, threads(2));
  EXPECT_EQ(found.checked, 39U);
  ASSERT_EQ(found.different, 2U);
  EXPECT_EQ(found.differences[0].key, (RealisationKey{0, 12}));
  EXPECT_EQ(found.differences[1].key, (RealisationKey{2, 1}));
  EXPECT_THAT(found.differences[0].fields, ElementsAre("mode"));
}

TEST(Verification, TakesASampleFromTheWholeExperiment) {
  const Store store = undisturbed();
  for (const std::uint64_t sample : {1U, 6U, 17U}) {
    const Verification found = verify(three_conditions(), store, sample, threads(2));
    EXPECT_GE(found.checked, sample);
    EXPECT_LE(found.checked, sample + 1);
    EXPECT_EQ(found.different, 0U);
  }
  EXPECT_EQ(verify(three_conditions(), store, 1000, threads(2)).checked, 39U);
}

}  // namespace
}  // namespace rocking
