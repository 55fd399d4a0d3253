// Threads that run the pairs of an experiment.

#include "rocking/ensemble/pair_workers.hpp"

#include <algorithm>
#include <cstdint>
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
                 }});
  EXPECT_EQ(accepted, 1000U);
  EXPECT_LE(most_waiting, 2 * options.threads) << "one of each thread, and one on its way to accept()";
}

}  // namespace
}  // namespace rocking
