// Threads that run the pairs of an experiment.

#include "rocking/ensemble/pair_workers.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// A base acceleration below that of uplift: the block stays at rest, and no lane is needed for it.
Experiment block_at_rest(std::uint64_t realisations) {
  Condition condition;
  condition.scene.block = {.width = 1.0, .height = 4.0};
  condition.scene.restitution = 0.9;
  condition.scene.excitation = Harmonic{.amplitude = 0.1, .frequency_ratio = 10.0, .phase = Uniform{0.0, 6.28}};
  condition.horizon = {.transient_periods = 5, .sampled_periods = 5};
  condition.realisations = realisations;
  Experiment experiment;
  experiment.conditions = {condition};
  check_experiment(experiment);
  return experiment;
}

TEST(PairWorkers, AcceptTheResultsOfABlockThatNeverMovesBeforeTheyTakeMore) {
  const Experiment experiment = block_at_rest(2000);
  RunOptions options;
  options.threads = 2;
  std::uint64_t taken = 0;
  std::uint64_t accepted = 0;
  std::uint64_t most_waiting = 0;
  run_pairs(experiment, options,
            {.next = [&]() -> std::optional<Pair> {
               if (2 * taken == 2000) return std::nullopt;
               most_waiting = std::max(most_waiting, ++taken - accepted);
               return Pair{.condition = 0, .first = 2 * (taken - 1)};
             },
             .accept =
                 [&](const Pair&, const std::vector<Summary>& summaries) {
                   EXPECT_TRUE(std::ranges::all_of(summaries, [](const Summary& s) { return !s.left_ground; }));
                   ++accepted;
                 },
             .left = [&] { return 1000 - accepted; }});
  EXPECT_EQ(accepted, 1000U);
  EXPECT_LE(most_waiting, 2 * options.threads) << "one of each thread, and one on its way to accept()";
}

/// The same with an excitation that makes the block rock, so that a thread has several pairs in progress.
Experiment rocking_block(std::uint64_t realisations) {
  Experiment experiment = block_at_rest(realisations);
  std::get<Harmonic>(experiment.conditions[0].scene.excitation).amplitude = 3.0;
  return experiment;
}

TEST(PairWorkers, NeverTakeMoreThanTheirShareOfWhatIsLeft) {
  constexpr std::uint64_t realisations = 40;
  const Experiment experiment = rocking_block(realisations);
  RunOptions options;
  options.threads = 4;
  std::uint64_t taken = 0;
  std::uint64_t left = realisations / 2;
  std::map<std::thread::id, std::uint64_t> open;
  std::uint64_t most_open = 0;
  run_pairs(experiment, options,
            {.next = [&]() -> std::optional<Pair> {
               if (2 * taken == realisations) return std::nullopt;
               const std::uint64_t here = ++open[std::this_thread::get_id()];
               most_open = std::max(most_open, here);
               EXPECT_LT((here - 1) * options.threads, left);
               return Pair{.condition = 0, .first = 2 * taken++};
             },
             .accept =
                 [&](const Pair&, const std::vector<Summary>&) {
                   --open[std::this_thread::get_id()];
                   --left;
                 },
             .left = [&] { return left; }});
  EXPECT_EQ(left, 0U);
  EXPECT_GT(most_open, 1U) << "lanes are to be filled";
}

}  // namespace
}  // namespace rocking
