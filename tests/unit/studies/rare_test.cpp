// Rare overturning: populations of motions, the committor, and probabilities. With no false alarm: compared are bits, and
// numbers that are equal up to a known error.

#include "rocking/studies/rare/rare.hpp"

#include <atomic>

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/rare/block_paths.hpp"
#include "rocking/studies/rare/committor.hpp"
#include "rocking/studies/rare/importance.hpp"

namespace {

using rocking::Condition;
using rocking::Experiment;
using rocking::rare_probabilities;
using rocking::RareEstimate;
using rocking::random::Source;
using rocking::rare::BlockPaths;
using rocking::rare::BlockPoints;
using rocking::rare::BlockPopulation;
using rocking::rare::Committor;
using rocking::rare::event_score;
using rocking::rare::Image;
using rocking::rare::number_of;
using rocking::rare::SectionGrid;
using rocking::rare::SectionPoint;
using rocking::rare::Transitions;

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

BlockPaths paths_of(const Condition& condition) {
  return {.condition = &condition, .seed = rare_seed, .event = {.peak_tilt = 0.9}, .halt = {}};
}

void run_to_horizon(BlockPopulation& population, const BlockPaths& paths) {
  for (std::int64_t k = 1; k < paths.periods(); ++k) population.advance();
}

TEST(BlockPopulation, HasTheFateOfPlainRealisations) {
  const Condition condition = fluctuating();
  const BlockPaths paths = paths_of(condition);
  BlockPopulation population(paths, {.particles = 60, .repetition = 1});
  run_to_horizon(population, paths);
  int events = 0;
  for (std::uint64_t i = 0; i < population.size(); ++i) {
    const std::uint64_t number = number_of({.repetition = 1, .stage = 0, .particle = i, .move = 0});
    const auto plain = rocking::realise(condition, rare_seed, number);
    EXPECT_EQ(population.fate(i) == Image::Fate::event, plain.peaks.tilt > 0.9) << i;
    if (plain.termination != rocking::dynamics::Termination::reached_horizon) continue;
    if (population.fate(i) == Image::Fate::event) {
      ++events;  // it was not advanced any more
    } else {
      EXPECT_EQ(population.point(i).tilt, plain.strobe.back().tilt) << i;
      EXPECT_EQ(population.point(i).tilt_rate, plain.strobe.back().tilt_rate) << i;
    }
  }
  EXPECT_GT(events, 0);
  EXPECT_LE(population.work(), 60.0);
  EXPECT_GT(population.work(), 30.0);
}

TEST(BlockPopulation, BranchesShareThePastAndNotTheFuture) {
  const Condition condition = fluctuating();
  const BlockPaths paths = paths_of(condition);
  BlockPopulation population(paths, {.particles = 10, .repetition = 1});
  population.advance();
  population.advance();
  const std::uint64_t stage = 3;
  for (std::size_t i = 5; i < 10; ++i) {
    population.branch(i, i - 5, {.repetition = 1, .stage = stage, .particle = i, .move = 0});
  }
  for (std::size_t i = 5; i < 10; ++i) EXPECT_EQ(population.point(i).tilt, population.point(i - 5).tilt);
  population.advance();
  for (std::size_t i = 5; i < 10; ++i) {
    EXPECT_NE(population.point(i).tilt, population.point(i - 5).tilt) << "a branch draws anew";
    const std::uint64_t number = number_of({.repetition = 1, .stage = 0, .particle = i - 5, .move = 0});
    const auto plain = rocking::realise(condition, rare_seed, number);
    EXPECT_EQ(population.point(i - 5).tilt, plain.strobe.at(3).tilt) << "the parent does not";
  }
}

TEST(BlockPoints, HaveTheScoresOfRealisationsWithTheseNumbers) {
  const Condition condition = drawn_once();
  const BlockPaths paths = paths_of(condition);
  const BlockPoints points(paths);
  ASSERT_EQ(points.dimensions(), 2U);
  std::vector<rocking::rare::Point> given;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const rocking::random::Draws draws(rare_seed, i);
    const double share = draws.uniform(Source::tilt, 0);
    given.push_back(
        {draws.standard_normal(Source::block_width, 0), rocking::base::normal_quantile_of_tail(1.0 - share)});
  }
  const std::vector<double> scores = points.scores(given);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const double peak = rocking::realise(condition, rare_seed, i).peaks.tilt;
    if (peak > 0.9) {
      EXPECT_EQ(scores[i], event_score) << i;
    } else {
      EXPECT_NEAR(scores[i], peak, 1e-6) << i;
    }
  }
}

TEST(SectionGrid, GivesALinearFunctionExactly) {
  const SectionGrid grid({.inner = 1.0, .outer = 4.0, .inner_cells = 5, .outer_cells = 2},
                         {.inner = 2.0, .outer = 3.0, .inner_cells = 3, .outer_cells = 1},
                         rocking::rare::SectionAxis{.inner = 0.5, .outer = 1.0, .inner_cells = 2, .outer_cells = 1});
  std::vector<double> values(grid.size());
  const auto linear = [](const SectionPoint& p) { return 2.0 * p.tilt - 3.0 * p.tilt_rate + 0.5 * p.slip_rate; };
  bool has_rest = false;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const SectionPoint node = grid.node(i);
    values[i] = linear(node);
    has_rest = has_rest || (node.tilt == 0.0 && node.tilt_rate == 0.0 && node.slip_rate == 0.0);
  }
  EXPECT_TRUE(has_rest);
  for (const SectionPoint& p : {SectionPoint{0.3, -1.7, 0.2}, {-3.9, 2.9, -0.9}, {1.5, 0.0, 0.0}, {4.0, -3.0, 1.0}}) {
    EXPECT_NEAR(grid.interpolated(values, grid.place(p)), linear(p), 1e-5);
  }
  EXPECT_NEAR(grid.interpolated(values, grid.place({9.0, 0.0, 0.0})), 8.0, 1e-5) << "the edge";
}

// A motion that stays in its node, and has the event with probability 1/4 in each period.
TEST(Committor, IsTheProbabilityOfTheEventByTheHorizon) {
  const SectionGrid grid({.inner = 1.0, .outer = 2.0, .inner_cells = 1, .outer_cells = 1},
                         {.inner = 1.0, .outer = 2.0, .inner_cells = 1, .outer_cells = 1});
  Transitions stays{.weights = {0.25, 0.75}, .images = {}};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    stays.images.push_back({.fate = Image::Fate::event, .point = {}});
    stays.images.push_back({.fate = Image::Fate::moves_on, .point = grid.node(i)});
  }
  for (const std::int64_t periods : {2, 5, 3000}) {
    const Committor committor(grid, {&stays, 1}, periods);
    EXPECT_EQ(committor(periods, {}), 0.0);
    for (const std::int64_t k : {std::int64_t{1}, periods - 1}) {
      const double remaining = static_cast<double>(periods - k);
      // Beyond 1024 periods h is kept for every third number of them.
      const double kept = periods == 3000 ? 3.0 * std::floor(remaining / 3.0) : remaining;
      EXPECT_NEAR(committor(k, {0.4, -0.2}), 1.0 - std::pow(0.75, kept), 1e-5) << periods << ' ' << k;
    }
  }
}

TEST(Proposal, HasADensityThatIsOneInAll) {
  const rocking::rare::Proposal proposal = rocking::rare::Proposal::fitted_to(
      {{{1.0, 2.0}, 1.0}, {{1.5, 2.5}, 2.0}, {{-2.0, 0.0}, 1.0}, {{0.2, 1.0}, 0.0}}, 2);
  double sum = 0.0;
  double inverse = 0.0;
  constexpr int count = 20'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const rocking::rare::Point point = proposal.draw({rare_seed, i});
    const double ratio = proposal.likelihood_ratio(point);
    EXPECT_LE(ratio, 10.0 + 1e-9);
    sum += ratio;
    const rocking::random::Draws own(rare_seed, i);
    inverse +=
        1.0 / proposal.likelihood_ratio({own.standard_normal(Source::tilt, 0), own.standard_normal(Source::tilt, 1)});
  }
  EXPECT_NEAR(sum / count, 1.0, 0.1);      // the law itself
  EXPECT_NEAR(inverse / count, 1.0, 0.3);  // and back
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
  EXPECT_EQ(one.work, three.work);
}

// A block that always reaches the tilt: 1, and no error.
TEST(RareProbabilities, AreOneWhereTheEventIsCertain) {
  const auto found = rare_probabilities(experiment_of(drawn_once()), {.event = {.peak_tilt = 0.0}}, {.particles = 20});
  EXPECT_EQ(found.front().probability, 1.0);
  EXPECT_EQ(found.front().interval.high, 1.0);
}

// A clock that advances at each look.
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
      // Each thread sees the end a few times in each condition.
      EXPECT_LE(looks.count, seconds + 1.0 + 4.0 * 3.0 * threads) << share;
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

TEST(RareProbabilities, GoOnFromEarlierRepetitions) {
  for (const Condition& condition : {fluctuating(), drawn_once()}) {
    const Experiment experiment = experiment_of(condition);
    const rocking::RareQuestion question{.event = {.peak_tilt = 0.6}, .relative_error = 0.05};
    const RareEstimate all = rare_probabilities(experiment, question, {.particles = 20}).front();
    rocking::RareSettings settings{.particles = 20};
    settings.earlier = {{all.repetitions.begin(), all.repetitions.begin() + 5}};
    const RareEstimate resumed = rare_probabilities(experiment, question, settings).front();
    EXPECT_EQ(resumed.probability, all.probability);
    EXPECT_EQ(resumed.repetitions.size(), all.repetitions.size());
    EXPECT_EQ(resumed.work, all.work);
  }
}

TEST(DrawnNumbers, FollowFromWhatTheSceneDraws) {
  const auto numbers = rocking::rare::drawn_numbers(drawn_once().scene);
  EXPECT_EQ(numbers.once, (std::vector<Source>{Source::block_width, Source::tilt}));
  EXPECT_FALSE(numbers.along_the_way);
  const auto others = rocking::rare::drawn_numbers(fluctuating().scene);
  EXPECT_TRUE(others.once.empty());
  EXPECT_TRUE(others.along_the_way);
  Condition pulse = drawn_once();
  pulse.scene.excitation = rocking::Pulse{.amplitude = 3.0, .frequency_ratio = 3.0};
  pulse.scene.fluctuation.amplitude = 0.2;
  const auto scaled = rocking::rare::drawn_numbers(pulse.scene);
  EXPECT_EQ(scaled.once.back(), Source::amplitude);
  EXPECT_FALSE(scaled.along_the_way);
}

}  // namespace
