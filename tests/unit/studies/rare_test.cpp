// Rare overturning: branches of motions, moves of numbers drawn once, and probabilities. With no false alarm: compared
// are bits, and numbers that are equal.

#include "rocking/studies/rare/rare.hpp"

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
