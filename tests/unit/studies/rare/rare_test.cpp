// Rare overturning: populations of motions, the committor, and proposals. With no false alarm: compared are bits, and
// numbers that are equal up to a known error.

#include "rocking/studies/rare/rare.hpp"

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/rare/block_paths.hpp"
#include "rocking/studies/rare/committor.hpp"
#include "rocking/studies/rare/importance.hpp"
#include "rocking/studies/rare/typical_paths.hpp"
#include "support/rare_scenes.hpp"

namespace {

using rocking::Condition;
using rocking::rare_probabilities;
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
using rocking::support::rare::drawn_once;
using rocking::support::rare::fluctuating;

constexpr std::uint64_t rare_seed = 0x2012;

BlockPaths paths_of(const Condition& condition) {
  return {.condition = &condition, .seed = rare_seed, .event = {rocking::EventName::tilt, 0.9}, .halt = {}};
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

// The amplitude of a period is drawn before the strobe point at its beginning: a branch there draws it again.
TEST(BlockPopulation, BranchesDrawTheAmplitudeOfTheComingPeriod) {
  Condition condition = fluctuating();
  condition.scene.friction.reset();
  condition.scene.fluctuation = {.amplitude = 0.6};
  const BlockPaths paths = paths_of(condition);
  BlockPopulation population(paths, {.particles = 2, .repetition = 1});
  population.branch(1, 0, {.repetition = 1, .stage = 1, .particle = 1, .move = 0});
  EXPECT_EQ(population.point(1).tilt, population.point(0).tilt);
  population.advance();
  EXPECT_NE(population.point(1).tilt, population.point(0).tilt);
}

// To the horizon at once: what the motions have at the last strobe point.
TEST(BlockPopulation, RunsToTheStrobePointOfItsPlan) {
  const Condition condition = fluctuating();
  const BlockPaths paths = paths_of(condition);
  BlockPopulation by_periods(paths, {.particles = 20, .repetition = 1});
  run_to_horizon(by_periods, paths);
  const BlockPopulation at_once(paths, {.particles = 20, .repetition = 1, .strobe_points = paths.periods()});
  for (std::size_t i = 0; i < at_once.size(); ++i) {
    EXPECT_EQ(at_once.fate(i), by_periods.fate(i));
    if (at_once.fate(i) != Image::Fate::moves_on) continue;
    EXPECT_EQ(at_once.point(i).tilt, by_periods.point(i).tilt);
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

// Two of three samples have the event, the third does not: the mean of the numbers of the two, and their scatter.
TEST(Committor, TellsTheAmplitudesWithWhichTheEventHappens) {
  const SectionGrid grid({.inner = 1.0, .outer = 2.0, .inner_cells = 1, .outer_cells = 1},
                         {.inner = 1.0, .outer = 2.0, .inner_cells = 1, .outer_cells = 1});
  Transitions some{.weights = {0.5, 0.3, 0.2}, .images = {}, .amplitudes = {-1.0, 1.0, 3.0}};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    some.images.push_back({.fate = Image::Fate::ends, .point = {}});
    some.images.push_back({.fate = Image::Fate::event, .point = {}});
    some.images.push_back({.fate = Image::Fate::event, .point = {}});
  }
  const Committor committor(grid, {&some, 1}, 3);
  const auto law = committor.amplitude(1, {0.4, -0.2});
  EXPECT_NEAR(law.mean, (0.3 * 1.0 + 0.2 * 3.0) / 0.5, 1e-5);
  EXPECT_NEAR(law.width, std::sqrt(0.3 * 0.2 / 0.25 * 4.0 + 0.09), 1e-5);
  EXPECT_EQ(committor.amplitude(3, {}).width, 1.0) << "at the end nothing happens any more";
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

// The event is certain where Theta' is near its upper end, and impossible elsewhere.
TEST(CommittorMap, HasRowsByRisingTiltRate) {
  const rocking::rare::SectionAxis axis{.inner = 1.0, .outer = 2.0, .inner_cells = 10, .outer_cells = 2};
  const SectionGrid grid(axis, axis);
  Transitions ends{.weights = {1.0}, .images = {}};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const bool has_event = grid.node(i).tilt_rate > 0.45;
    ends.images.push_back({.fate = has_event ? Image::Fate::event : Image::Fate::ends, .point = {}});
  }
  const rocking::rare::CommittorMap map = rocking::rare::map_of(Committor(grid, {&ends, 1}, 4));
  EXPECT_DOUBLE_EQ(map.tilt, 1.15);
  EXPECT_NEAR(map.tilt_rate, 1.15, 1e-12);
  ASSERT_EQ(map.rows.size(), 61U);
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    const double tilt_rate = map.tilt_rate * (static_cast<double>(row) / 30.0 - 1.0);
    ASSERT_EQ(map.rows[row].size(), 61U);
    if (tilt_rate > 0.4 && tilt_rate < 0.5) continue;  // within a cell
    for (const double h : map.rows[row]) EXPECT_EQ(h, tilt_rate > 0.45 ? 1.0 : 0.0) << row;
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

// Offspring of Markov chains lie close to each other: by them alone every width would be too small.
TEST(Proposal, IsWideEnoughForFreshPointsBetweenTheOthers) {
  std::vector<rocking::rare::WeightedPoint> twins;
  std::vector<rocking::rare::WeightedPoint> between;
  for (int i = -2; i <= 2; ++i) {
    const double x = 1.5 * i;
    twins.push_back({{x}, 1.0});
    twins.push_back({{x + 1e-6}, 1.0});
    between.push_back({{x + 0.75}, 1.0});
  }
  const auto by_themselves = rocking::rare::Proposal::fitted_to(twins, 1);
  const auto by_fresh_ones = rocking::rare::Proposal::fitted_to(twins, between, 1);
  for (const double x : {-2.25, -0.75, 0.75}) {
    EXPECT_LT(by_fresh_ones.likelihood_ratio({x}), 0.5 * by_themselves.likelihood_ratio({x})) << x;
  }
}

TEST(RareProbabilities, AreRefusedWhereNothingIsRandom) {
  Condition condition = fluctuating();
  condition.scene.fluctuation = {};
  EXPECT_THROW(static_cast<void>(rare_probabilities(
                   {.title = "", .seed = rare_seed, .conditions = {condition}, .canonical_text = "{}"}, {})),
               rocking::base::InputError);
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
