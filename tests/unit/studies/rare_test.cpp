// Rare overturning: branches of motions, moves of numbers drawn once, and probabilities. With no false alarm: compared
// are bits, and numbers that are equal.

#include "rocking/studies/rare/rare.hpp"

#include <atomic>

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/rare/block_model.hpp"
#include "rocking/studies/rare/splitting.hpp"

namespace {

using rocking::Condition;
using rocking::Experiment;
using rocking::rare_probabilities;
using rocking::RareEstimate;
using rocking::random::Source;
using rocking::rare::BlockModel;
using rocking::rare::event_score;
using rocking::rare::number_of;
using rocking::rare::Stream;

constexpr std::uint64_t rare_seed = 0x2012;

Condition fluctuating() {
  Condition condition;
  rocking::Harmonic shaking;
  shaking.amplitude = 4.2;
  shaking.frequency_ratio = 6.0;
  condition.scene.excitation = shaking;
  condition.scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
  condition.scene.fluctuation = {.static_friction = 0.03,
                                 .kinetic_friction = 0.03,
                                 .refreshes_per_period = 20,
                                 .restitution = 0.02,
                                 .amplitude = 0.6};
  condition.horizon = {.transient_periods = 5, .sampled_periods = 10};
  return condition;
}

Condition drawn_once() {
  Condition condition = fluctuating();
  condition.scene.friction.reset();
  condition.scene.fluctuation = {};
  condition.scene.block.width = rocking::Normal{.mean = 1.0, .sigma = 0.05};
  condition.scene.initial.tilt = rocking::Uniform{.low = -0.3, .high = 0.3};
  return condition;
}

BlockModel model_of(const Condition& condition, int chain_steps) {
  return {condition, {.seed = rare_seed, .event = {}, .score = rocking::rare::Score::tilt, .chain_steps = chain_steps}};
}

TEST(RareModel, StartsWithTheBitsOfAPlainRealisation) {
  for (const Condition& condition : {fluctuating(), drawn_once()}) {
    for (std::uint64_t i = 0; i < 5; ++i) {
      const Stream stream{.repetition = 1, .stage = 0, .particle = i, .move = 0};
      const auto particle = model_of(condition, 0).start(stream, event_score);
      const auto plain = rocking::realise(condition, rare_seed, number_of(stream));
      EXPECT_EQ(particle.motion->peaks().tilt / particle.motion->setting().block.shape_angle, plain.peaks.tilt);
      EXPECT_EQ(particle.motion->termination(), plain.termination);
      EXPECT_NEAR(particle.work, 1.0, 0.1);
    }
  }
}

// A motion run again from the start with the history of a branched one has the branch's bits: nothing before the branch
// is drawn anew, and everything after it.
TEST(RareModel, BranchesWithoutAChangeOfThePast) {
  const Condition condition = fluctuating();
  const BlockModel model = model_of(condition, 0);
  int branched = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Stream stream{.repetition = 1, .stage = 0, .particle = i, .move = 0};
    const double level = 0.7 * model.start(stream, event_score).score;
    const auto parent = model.start(stream, level);
    if (parent.motion->ended()) continue;
    ++branched;
    const Stream other{.repetition = 1, .stage = 1, .particle = i, .move = 0};
    const auto child = model.go_on(parent, other, level, event_score);
    ASSERT_EQ(child.history->branches.size(), 1U);
    const auto again = model.replay(child);
    EXPECT_EQ(again.score, child.score);
    EXPECT_EQ(again.motion->state().tilt, child.motion->state().tilt);
    EXPECT_EQ(again.motion->state().tilt_rate, child.motion->state().tilt_rate);
    EXPECT_EQ(again.motion->state().slip, child.motion->state().slip);
    EXPECT_EQ(again.motion->clock().tau(), child.motion->clock().tau());
    const auto unbranched = model.start(stream, event_score);
    EXPECT_NE(unbranched.motion->state().tilt, child.motion->state().tilt);
  }
  EXPECT_GT(branched, 10);
}

TEST(RareModel, MovesNumbersDrawnOnceAndKeepsTheLevel) {
  const Condition condition = drawn_once();
  const BlockModel model = model_of(condition, 3);
  int moved = 0;
  for (std::uint64_t i = 0; i < 30; ++i) {
    const Stream stream{.repetition = 1, .stage = 0, .particle = i, .move = 0};
    const double level = 0.5 * std::min(2.0, model.start(stream, event_score).score);
    const auto parent = model.start(stream, level);
    ASSERT_EQ(parent.history->given.size(), 2U);
    const auto child = model.go_on(parent, {.repetition = 1, .stage = 1, .particle = i, .move = 0}, level, level);
    EXPECT_GE(child.score, level);
    const double tilt = child.history->given[1].number;
    EXPECT_GE(tilt, 0.0);
    EXPECT_LT(tilt, 1.0);
    moved += tilt != parent.history->given[1].number ? 1 : 0;
  }
  EXPECT_GT(moved, 10);
}

Experiment experiment_of(const Condition& condition) {
  return {.title = "", .seed = rare_seed, .conditions = {condition}, .canonical_text = "{}"};
}

TEST(RareProbabilities, AreTheSameOnAnyNumberOfThreads) {
  const Experiment experiment = experiment_of(fluctuating());
  const auto on = [&](unsigned threads) {
    return rare_probabilities(experiment, {.event = {.peak_tilt = 0.4}, .relative_error = 0.5},
                              {.particles = 20, .threads = threads})
        .front();
  };
  const RareEstimate one = on(1);
  const RareEstimate three = on(3);
  EXPECT_EQ(one.probability, three.probability);
  EXPECT_EQ(one.levels, three.levels);
  EXPECT_EQ(one.work, three.work);
}

// A block that always reaches the tilt: 1, and no error.
TEST(RareProbabilities, AreOneWhereTheEventIsCertain) {
  const auto found = rare_probabilities(experiment_of(drawn_once()), {.event = {.peak_tilt = 0.0}}, {.particles = 20});
  EXPECT_EQ(found.front().probability, 1.0);
  EXPECT_EQ(found.front().interval.high, 1.0);
}

// A clock that advances at each look: the study does so at least every 64 steps of each motion.
struct Looks {
  std::atomic<int> count{0};
  rocking::RareSettings settings(double seconds, unsigned threads) {
    return {.particles = 20, .threads = threads, .seconds = seconds, .elapsed_seconds = [this] {
              return static_cast<double>(count++);
            }};
  }
};

TEST(RareTimeLimit, HoldsForAllConditionsTogetherAndKeepsWhatIsFinished) {
  Experiment experiment = experiment_of(fluctuating());
  experiment.conditions.assign(3, experiment.conditions.front());
  const rocking::RareQuestion question{.event = {.peak_tilt = 0.4}, .relative_error = 0.05};
  Looks unhurried;
  const auto all = rare_probabilities(experiment, question, unhurried.settings(1e9, 1));
  for (const unsigned threads : {1U, 3U}) {
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.3, 0.5, 0.9}) {
      Looks looks;
      const double seconds = share * unhurried.count;
      const auto found = rare_probabilities(experiment, question, looks.settings(seconds, threads));
      // Each thread sees the end once in each condition, after a repetition also a second time.
      EXPECT_LE(looks.count, seconds + 1.0 + 3.0 * 3.0 * threads) << share;
      ASSERT_EQ(found.size(), 3U);
      // Several threads may look a tenth less often in all, and then finish.
      if (threads == 1 || share < 0.9) EXPECT_EQ(found.back().end, rocking::RareEnd::out_of_time) << share;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& repetitions = found[i].repetitions;
        for (std::size_t k = 0; k < repetitions.size(); ++k) {
          EXPECT_EQ(repetitions[k].estimate, all[i].repetitions.at(k).estimate) << share << ", condition " << i;
        }
        EXPECT_EQ(found[i].probability.has_value(), !repetitions.empty()) << share;
        const bool is_whole = found[i].interval.low == 0.0 && found[i].interval.high == 1.0;
        EXPECT_EQ(is_whole, repetitions.size() < 8) << share << ", " << repetitions.size();
        EXPECT_EQ(found[i].diagnosis == rocking::RareDiagnosis::few_repetitions, repetitions.size() < 8) << share;
      }
    }
  }
}

TEST(RareProbabilities, AreRefusedWhereNothingIsRandom) {
  Condition condition = fluctuating();
  condition.scene.fluctuation = {};
  EXPECT_THROW(static_cast<void>(rare_probabilities(experiment_of(condition), {}, {})), rocking::base::InputError);
}

TEST(RareMoves, FollowFromWhatTheSceneDraws) {
  const auto moves = rocking::rare::moves_of(drawn_once().scene);
  EXPECT_EQ(moves.once, (std::vector<Source>{Source::block_width, Source::tilt}));
  EXPECT_FALSE(moves.along_the_way);
  const auto others = rocking::rare::moves_of(fluctuating().scene);
  EXPECT_TRUE(others.once.empty());
  EXPECT_TRUE(others.along_the_way);
  Condition pulse = drawn_once();
  pulse.scene.excitation = rocking::Pulse{.amplitude = 3.0, .frequency_ratio = 3.0};
  pulse.scene.fluctuation.amplitude = 0.2;
  const auto scaled = rocking::rare::moves_of(pulse.scene);
  EXPECT_EQ(scaled.once.back(), Source::amplitude);
  EXPECT_FALSE(scaled.along_the_way);
}

}  // namespace
