// Multilevel splitting on chains whose probabilities are known.

#include <cmath>

#include <boost/math/distributions/normal.hpp>

#include "rocking/random/draws.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/splitting.hpp"
#include "support/false_alarms.hpp"

namespace {

using rocking::random::Draws;
using rocking::random::Source;
using rocking::rare::event_score;
using rocking::rare::find_levels;
using rocking::rare::ForEach;
using rocking::rare::number_of;
using rocking::rare::Pilot;
using rocking::rare::PilotEnd;
using rocking::rare::repeat;
using rocking::rare::Repetition;
using rocking::rare::SplittingPlan;
using rocking::rare::Stream;
using rocking::support::FalseAlarms;

const ForEach one_by_one = [](std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
};

/// A number from N(0, 1), drawn once; the event is that it exceeds `barrier`.
class GaussianTail {
 public:
  struct Particle {
    double number = 0.0;
    double work = 1.0;
  };
  GaussianTail(std::uint64_t seed, double barrier) : seed_(seed), barrier_(barrier) {}

  [[nodiscard]] double probability() const {
    return cdf(complement(boost::math::normal_distribution<double>(), barrier_));
  }
  [[nodiscard]] Particle start(const Stream& stream, double) const {
    return {.number = Draws(seed_, number_of(stream)).standard_normal(Source::tilt, 0)};
  }
  [[nodiscard]] Particle go_on(const Particle& parent, const Stream& stream, double level, double) const {
    constexpr std::uint64_t steps = 10;
    Particle particle{.number = parent.number, .work = steps};
    for (std::uint64_t i = 0; i < steps; ++i) {
      const double size = 0.5;
      const double next = std::sqrt(1.0 - size * size) * particle.number +
                          size * Draws(seed_, number_of(stream)).standard_normal(Source::tilt, i);
      if (value_of(next) >= level) particle.number = next;
    }
    return particle;
  }
  [[nodiscard]] double score(const Particle& particle) const { return value_of(particle.number); }
  [[nodiscard]] static double work(const Particle& particle) { return particle.work; }

 private:
  [[nodiscard]] double value_of(double number) const { return number > barrier_ ? event_score : number; }

  std::uint64_t seed_;
  double barrier_;
};

/// A chain in steps, drawn along the way. The event is that x exceeds a barrier within `steps`.
///
/// memory 1 and jumps of +-1: a symmetric walk from 0; P(max >= b) by the reflection principle. Scores are whole numbers
/// and tie. Otherwise x' = memory x + sqrt(1 - memory^2) z, Ornstein and Uhlenbeck's process at equal intervals.
class Chain {
 public:
  struct Particle {
    double x = 0.0;
    int step = 0;
    double score = 0.0;
    double work = 0.0;
  };
  struct Law {
    bool is_walk;
    double memory;
    double barrier;
    int steps;
  };
  Chain(std::uint64_t seed, const Law& law) : seed_(seed), law_(law) {}

  [[nodiscard]] Particle start(const Stream& stream, double target) const { return advanced({}, stream, target); }
  [[nodiscard]] Particle go_on(const Particle& parent, const Stream& stream, double, double target) const {
    return advanced(parent, stream, target);
  }
  [[nodiscard]] static double score(const Particle& particle) { return particle.score; }
  [[nodiscard]] static double work(const Particle& particle) { return particle.work; }

  [[nodiscard]] double probability() const { return law_.is_walk ? of_walk() : of_process(); }

 private:
  [[nodiscard]] Particle advanced(Particle particle, const Stream& stream, double target) const {
    const Draws draws(seed_, number_of(stream));
    particle.work = 0.0;
    while (particle.score < target && particle.step < law_.steps) {
      const auto index = static_cast<std::uint64_t>(particle.step++);
      if (law_.is_walk) {
        particle.x += draws.bits(Source::kinetic_friction, index) % 2 == 0 ? 1.0 : -1.0;
      } else {
        particle.x = law_.memory * particle.x + std::sqrt(1.0 - law_.memory * law_.memory) *
                                                    draws.standard_normal(Source::kinetic_friction, index);
      }
      particle.score = std::max(particle.score, particle.x >= law_.barrier ? event_score : particle.x);
      particle.work += 1.0 / law_.steps;
    }
    return particle;
  }

  /// The law of the walk that is stopped at the barrier, step by step.
  [[nodiscard]] double of_walk() const {
    const auto barrier = static_cast<std::size_t>(law_.barrier);
    const auto steps = static_cast<std::size_t>(law_.steps);
    std::vector<double> law(steps + barrier + 1, 0.0);  // place x + steps
    law[steps] = 1.0;
    for (std::size_t n = 0; n < steps; ++n) {
      std::vector<double> next(law.size(), 0.0);
      next.back() = law.back();
      for (std::size_t i = 0; i + 1 < law.size(); ++i) {
        if (law[i] == 0.0) continue;
        next[i - 1] += 0.5 * law[i];
        next[i + 1] += 0.5 * law[i];
      }
      law = std::move(next);
    }
    return law.back();
  }

  /// Sum of the flows over the barrier of the density below it, on a fine grid of which the midpoints count. The first
  /// step is from 0.
  [[nodiscard]] double of_process() const {
    constexpr int cells = 600;
    constexpr double lowest = -7.0;
    const boost::math::normal_distribution<double> normal;
    const double width = (law_.barrier - lowest) / cells;
    const double sigma = std::sqrt(1.0 - law_.memory * law_.memory);
    std::vector<double> kernel(static_cast<std::size_t>(cells) * cells);
    std::vector<double> over(cells);
    const auto middle = [&](int i) { return lowest + (i + 0.5) * width; };
    for (int i = 0; i < cells; ++i) {
      over[static_cast<std::size_t>(i)] = cdf(complement(normal, (law_.barrier - law_.memory * middle(i)) / sigma));
      for (int j = 0; j < cells; ++j) {
        kernel[static_cast<std::size_t>(i * cells + j)] =
            pdf(normal, (middle(j) - law_.memory * middle(i)) / sigma) / sigma * width;
      }
    }
    std::vector<double> mass(cells);
    for (int j = 0; j < cells; ++j) mass[static_cast<std::size_t>(j)] = pdf(normal, middle(j) / sigma) / sigma * width;
    double probability = cdf(complement(normal, law_.barrier / sigma));
    for (int n = 1; n < law_.steps; ++n) {
      std::vector<double> next(cells, 0.0);
      for (std::size_t i = 0; i < cells; ++i) {
        probability += mass[i] * over[i];
        for (std::size_t j = 0; j < cells; ++j) next[j] += mass[i] * kernel[i * cells + j];
      }
      mass = std::move(next);
    }
    return probability;
  }

  std::uint64_t seed_;
  Law law_;
};

template <class Model>
std::vector<double> estimates_of(const Model& model, const SplittingPlan& plan, std::uint64_t count) {
  const Pilot pilot = find_levels(model, plan, one_by_one);
  EXPECT_EQ(pilot.end, PilotEnd::reached);
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= count; ++i) {
    estimates.push_back(repeat(model, plan, pilot.levels, i, one_by_one).estimate);
  }
  return estimates;
}

/// The repetitions are unbiased: the mean of many is within the error of a t-test whose level is declared.
template <class Model>
void expect_unbiased(const Model& model, const SplittingPlan& plan, FalseAlarms& alarms) {
  const auto estimates = estimates_of(model, plan, 400);
  const auto mean = rocking::stats::mean_of_repetitions(estimates, 1.0 - alarms.level());
  ASSERT_TRUE(mean.interval);
  EXPECT_LE(mean.interval->low, model.probability()) << mean.mean;
  EXPECT_GE(mean.interval->high, model.probability()) << mean.mean;
  EXPECT_LE(*mean.relative_error, 0.1);
}

/// Intervals from 16 repetitions, each with levels of its own, cover nearly as often as they say.
template <class MakeModel>
void expect_coverage(MakeModel&& make, FalseAlarms& alarms) {
  constexpr std::uint64_t trials = 100;
  constexpr double least_coverage = 0.93;
  std::uint64_t covered = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto model = make(trial + 1000);
    const SplittingPlan plan{.seed = trial + 1000, .particles = 200};
    const auto mean = rocking::stats::mean_of_repetitions(estimates_of(model, plan, 16), 0.95);
    if (!mean.interval) continue;
    const double truth = model.probability();
    covered += mean.interval->low <= truth && truth <= mean.interval->high ? 1 : 0;
  }
  EXPECT_GE(rocking::stats::clopper_pearson({covered, trials}, 1.0 - 2.0 * alarms.level()).high, least_coverage)
      << covered;
}

TEST(Splitting, OfAGaussianTailIsUnbiased) {
  FalseAlarms alarms;
  for (const double barrier : {2.3, 4.75, 6.0}) {
    expect_unbiased(GaussianTail(7, barrier), {.seed = 7, .particles = 200}, alarms);
  }
}

// The scores are whole numbers: many particles tie.
TEST(Splitting, OfAWalkIsUnbiasedWhereScoresTie) {
  FalseAlarms alarms;
  for (const double barrier : {26.0, 40.0}) {
    expect_unbiased(Chain(8, {.is_walk = true, .memory = 1.0, .barrier = barrier, .steps = 100}),
                    {.seed = 8, .particles = 200}, alarms);
  }
}

TEST(Splitting, OfOrnsteinAndUhlenbecksProcessIsUnbiased) {
  FalseAlarms alarms;
  for (const double barrier : {3.5, 6.0}) {
    expect_unbiased(Chain(9, {.is_walk = false, .memory = 0.9, .barrier = barrier, .steps = 30}),
                    {.seed = 9, .particles = 200}, alarms);
  }
}

TEST(Splitting, HasIntervalsThatCover) {
  FalseAlarms alarms;
  expect_coverage([](std::uint64_t seed) { return GaussianTail(seed, 4.75); }, alarms);
  expect_coverage(
      [](std::uint64_t seed) { return Chain(seed, {.is_walk = true, .memory = 1.0, .barrier = 40.0, .steps = 100}); },
      alarms);
}

TEST(Splitting, SaysThatAnEventCannotBeReached) {
  const Chain model(3, {.is_walk = true, .memory = 1.0, .barrier = 20.0, .steps = 10});
  const SplittingPlan plan{.seed = 3, .particles = 100};
  const Pilot pilot = find_levels(model, plan, one_by_one);
  EXPECT_EQ(pilot.end, PilotEnd::no_higher);
  EXPECT_EQ(pilot.levels.back(), 10.0);
  const Repetition repetition = repeat(model, plan, pilot.levels, 1, one_by_one);
  EXPECT_EQ(repetition.estimate, 0.0);
  EXPECT_EQ(repetition.ancestors, 0U);
}

TEST(Splitting, IsPlainSamplingWhereTheEventIsFrequent) {
  const Chain model(4, {.is_walk = true, .memory = 1.0, .barrier = 2.0, .steps = 40});
  const SplittingPlan plan{.seed = 4, .particles = 100};
  const Pilot pilot = find_levels(model, plan, one_by_one);
  EXPECT_TRUE(pilot.levels.empty());
  const Repetition repetition = repeat(model, plan, pilot.levels, 1, one_by_one);
  EXPECT_EQ(repetition.reached, std::vector<double>{repetition.estimate});
  EXPECT_EQ(static_cast<double>(repetition.ancestors), 100.0 * repetition.estimate);
  EXPECT_LE(repetition.work, 100.0 + 1e-9);
}

// Offspring: each parent has as many as another, up to one.
TEST(Splitting, SharesTheParticlesEvenlyAmongParents) {
  for (std::size_t parents = 1; parents <= 7; ++parents) {
    std::vector<std::size_t> children(parents, 0);
    for (std::size_t i = 0; i < 20; ++i) ++children[rocking::rare::splitting::parent_of(i, parents, 12345678901)];
    EXPECT_LE(std::ranges::max(children) - std::ranges::min(children), 1U);
  }
}

TEST(RepeatedEstimate, IsTheMeanWithStudentsIntervalOfItsLogarithm) {
  const std::vector<double> estimates{1e-9, 2e-9, 3e-9};
  const auto mean = rocking::stats::mean_of_repetitions(estimates, 0.95);
  EXPECT_DOUBLE_EQ(mean.mean, 2e-9);
  ASSERT_TRUE(mean.relative_error && mean.interval);
  EXPECT_NEAR(*mean.relative_error, 0.5 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(std::log(mean.interval->high / 2e-9), 0.95 / std::sqrt(2.0 * 0.975 * 0.025) * 0.5 / std::sqrt(3.0),
              1e-12);
  EXPECT_NEAR(mean.interval->low * mean.interval->high, 4e-18, 1e-30);
}

TEST(RepeatedEstimate, HasNoIntervalWithoutTheEventOrFromOneEstimate) {
  EXPECT_FALSE(rocking::stats::mean_of_repetitions(std::vector<double>{0.0, 0.0}, 0.95).interval);
  EXPECT_FALSE(rocking::stats::mean_of_repetitions(std::vector<double>{0.1}, 0.95).interval);
}

}  // namespace
