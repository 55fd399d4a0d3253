// Which realisations of a run belong to a run of another length.

#include "rocking/ensemble/extension.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocking {
namespace {

using ::testing::ElementsAre;

/// One random condition, and one in which nothing is random.
Experiment experiment_of(std::uint64_t realisations) {
  Condition random;
  random.scene.initial.tilt = Uniform{.low = 0.0, .high = 0.5};
  random.realisations = realisations;
  Condition still;
  still.realisations = realisations;
  random.parameters = {{"/excitation/pga_g", 0.2}};
  still.parameters = {{"/excitation/pga_g", 0.4}};
  return {.title = "", .seed = 7, .conditions = {random, still}, .canonical_text = ""};
}

Store empty_store() { return Store::in_memory({.experiment = "", .code = "", .files = "", .shard = {}}); }

/// Numbers of the realisations of the random condition that are copied, of those from 0 to `stored` - 1.
std::vector<std::uint64_t> copied(std::uint64_t stored, std::uint64_t before, std::uint64_t after) {
  Store former = empty_store();
  for (std::uint64_t k = 0; k < stored; ++k) former.add({.condition = 0, .realisation = k}, {});
  former.add({.condition = 1, .realisation = 0}, {});
  Store into = empty_store();
  copy_common_realisations(former, experiment_of(before), experiment_of(after), into);
  std::vector<std::uint64_t> numbers;
  std::uint64_t of_still = 0;
  into.for_each_key([&](const RealisationKey& key) {
    if (key.condition == 0) numbers.push_back(key.realisation);
    of_still += key.condition;
  });
  EXPECT_EQ(of_still, 1U) << "a condition in which nothing is random stays as it is";
  return numbers;
}

TEST(Extension, KeepsEveryRealisationThatHasItsNeighbour) {
  EXPECT_THAT(copied(4, 4, 9), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(copied(3, 9, 12), ElementsAre(0, 1, 2)) << "an unfinished run, whose next pair is not complete";
}

TEST(Extension, LeavesOutTheLastOneOfAnOddNumber) {
  EXPECT_THAT(copied(5, 5, 9), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(copied(1, 1, 2), ElementsAre());
  EXPECT_THAT(copied(5, 5, 5), ElementsAre(0, 1, 2, 3, 4)) << "it has no neighbour there either";
}

TEST(Extension, LeavesOutWhatAShorterRunDoesNotHave) {
  EXPECT_THAT(copied(8, 8, 4), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(copied(4, 8, 3), ElementsAre(0, 1)) << "realisation 2 has no neighbour there";
}

TEST(Extension, KeepsTheRealisationsOfAConditionWhoseNumberChanges) {
  Store former = empty_store();
  for (std::uint64_t k = 0; k < 2; ++k) former.add({.condition = 0, .realisation = k}, {});
  Experiment more = experiment_of(2);
  Condition between = more.conditions[0];
  between.parameters.front().value = 0.3;
  more.conditions.insert(more.conditions.begin(), between);
  Store into = empty_store();
  copy_common_realisations(former, experiment_of(2), more, into);
  std::vector<std::uint64_t> conditions;
  into.for_each_key([&](const RealisationKey& key) { conditions.push_back(key.condition); });
  EXPECT_THAT(conditions, ElementsAre(1, 1));
}

TEST(MostStoredRealisations, CountsTheLargestNumberOfACondition) {
  Store store = empty_store();
  EXPECT_EQ(most_stored_realisations(store), 0U);
  store.add({.condition = 1, .realisation = 6}, {});
  store.add({.condition = 0, .realisation = 2}, {});
  EXPECT_EQ(most_stored_realisations(store), 7U);
}

}  // namespace
}  // namespace rocking
