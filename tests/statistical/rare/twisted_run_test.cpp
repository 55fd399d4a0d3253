// Particle runs that a score steers, and importance sampling, on chains whose probabilities are known: unbiased,
// whatever the score or the proposal, and with intervals that cover.

#include "rocking/studies/rare/twisted_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/math/distributions/normal.hpp>

#include "rocking/random/draws.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/importance.hpp"
#include "support/false_alarms.hpp"

namespace {

using rocking::random::Draws;
using rocking::random::Source;
using rocking::rare::event_score;
using rocking::rare::Image;
using rocking::rare::number_of;
using rocking::rare::Point;
using rocking::rare::Repetition;
using rocking::rare::Stream;
using rocking::rare::TwistedPlan;
using rocking::rare::TwistedRun;
using rocking::support::FalseAlarms;

/// A chain whose event is that x reaches a barrier within a number of steps, from x = 0, with its probabilities
/// h(k, x) after k steps.
class Chain {
 public:
  virtual ~Chain() = default;
  [[nodiscard]] virtual double next(double x, const Draws& draws, std::uint64_t step) const = 0;
  [[nodiscard]] virtual double probability(std::int64_t k, double x) const = 0;
  [[nodiscard]] double barrier() const { return barrier_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }

 protected:
  Chain(double barrier, std::int64_t steps) : barrier_(barrier), steps_(steps) {}

 private:
  double barrier_;
  std::int64_t steps_;
};

/// Steps of +-1. The probabilities are sums, step by step.
class Walk final : public Chain {
 public:
  Walk(double barrier, std::int64_t steps)
      : Chain(barrier, steps), h_(static_cast<std::size_t>(steps + 1), std::vector<double>(width(), 0.0)) {
    for (std::int64_t k = steps; k >= 0; --k) {
      for (std::size_t i = 0; i < width(); ++i) {
        double& h = h_[static_cast<std::size_t>(k)][i];
        if (i + 1 == width()) {
          h = 1.0;
        } else if (k < steps && i > 0) {
          const auto& after = h_[static_cast<std::size_t>(k + 1)];
          h = 0.5 * (after[i - 1] + after[i + 1]);
        }
      }
    }
  }
  [[nodiscard]] double next(double x, const Draws& draws, std::uint64_t step) const override {
    return x + (draws.bits(Source::kinetic_friction, step) % 2 == 0 ? 1.0 : -1.0);
  }
  [[nodiscard]] double probability(std::int64_t k, double x) const override {
    const double place = x + static_cast<double>(steps());
    return place < 0.0 ? 0.0 : h_[static_cast<std::size_t>(k)][static_cast<std::size_t>(place)];
  }

 private:
  [[nodiscard]] std::size_t width() const {
    return static_cast<std::size_t>(barrier() + static_cast<double>(steps())) + 1;
  }

  std::vector<std::vector<double>> h_;
};

/// Ornstein and Uhlenbeck's process at equal intervals, x' = memory x + sqrt(1 - memory^2) z. The probabilities are
/// sums over a fine grid below the barrier.
class Process final : public Chain {
 public:
  Process(double barrier, std::int64_t steps) : Chain(barrier, steps) {
    const boost::math::normal_distribution<double> normal;
    h_.assign(static_cast<std::size_t>(steps + 1), std::vector<double>(cells, 0.0));
    std::vector<double> kernel(cells * cells);
    std::vector<double> over(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      over[i] = cdf(complement(normal, (barrier - memory * middle(i)) / sigma()));
      for (std::size_t j = 0; j < cells; ++j) {
        kernel[i * cells + j] = pdf(normal, (middle(j) - memory * middle(i)) / sigma()) / sigma() * cell();
      }
    }
    for (auto k = static_cast<std::size_t>(steps); k-- > 0;) {
      for (std::size_t i = 0; i < cells; ++i) {
        double sum = over[i];
        for (std::size_t j = 0; j < cells; ++j) sum += kernel[i * cells + j] * h_[k + 1][j];
        h_[k][i] = sum;
      }
    }
  }
  [[nodiscard]] double next(double x, const Draws& draws, std::uint64_t step) const override {
    return memory * x + sigma() * draws.standard_normal(Source::kinetic_friction, step);
  }
  [[nodiscard]] double probability(std::int64_t k, double x) const override {
    if (x >= barrier()) return 1.0;
    const double place = std::clamp((x - lowest) / cell() - 0.5, 0.0, static_cast<double>(cells) - 1.001);
    const auto i = static_cast<std::size_t>(place);
    const auto& h = h_[static_cast<std::size_t>(k)];
    return h[i] + (place - static_cast<double>(i)) * (h[i + 1] - h[i]);
  }

 private:
  static constexpr std::size_t cells = 400;
  static constexpr double memory = 0.9;
  static constexpr double lowest = -7.0;
  [[nodiscard]] static double sigma() { return std::sqrt(1.0 - memory * memory); }
  [[nodiscard]] double cell() const { return (barrier() - lowest) / static_cast<double>(cells); }
  [[nodiscard]] double middle(std::size_t i) const { return lowest + (static_cast<double>(i) + 0.5) * cell(); }

  std::vector<std::vector<double>> h_;
};

/// How likely the event is from x after k steps: > 0.
using Score = std::function<double(std::int64_t k, double x)>;

/// Particles of a chain (rare::Population).
class Particles {
 public:
  Particles(const Chain& chain, Score score, std::uint64_t seed, std::size_t count, std::uint64_t repetition)
      : chain_(&chain), score_(std::move(score)), seed_(seed), all_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      all_[i].number = number_of({.repetition = repetition, .stage = 0, .particle = i, .move = 0});
    }
    advance();
  }

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] static double likelihood_ratio(std::size_t) { return 1.0; }
  [[nodiscard]] Image::Fate fate(std::size_t i) const {
    return all_[i].x >= chain_->barrier() ? Image::Fate::event : Image::Fate::moves_on;
  }
  [[nodiscard]] double score(std::int64_t k, std::size_t i) const { return score_(k, all_[i].x); }
  [[nodiscard]] double work() const { return work_; }
  void branch(std::size_t i, std::size_t parent, const Stream& stream) {
    all_[i] = all_[parent];
    all_[i].number = number_of(stream);
  }
  void leave(std::size_t i) { all_[i].has_left = true; }
  void advance() {
    ++step_;
    for (Particle& one : all_) {
      if (one.has_left) continue;
      one.x = chain_->next(one.x, Draws(seed_, one.number), step_ - 1);
      work_ += 1.0 / static_cast<double>(chain_->steps());
    }
  }

 private:
  struct Particle {
    double x = 0.0;
    std::uint64_t number = 0;
    bool has_left = false;
  };

  const Chain* chain_;
  Score score_;
  std::uint64_t seed_;
  std::vector<Particle> all_;
  std::uint64_t step_ = 0;
  double work_ = 0.0;
};

template <class Swarm = Particles>
std::vector<double> estimates_of(const Chain& chain, const Score& score, std::uint64_t seed, std::uint64_t count) {
  const TwistedPlan plan{.seed = seed, .periods = chain.steps()};
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= count; ++i) {
    Swarm particles(chain, score, seed, 200, i);
    estimates.push_back(TwistedRun(particles, plan, i).run().estimate);
  }
  return estimates;
}

/// The mean of many is within the error of a t-test whose level is declared.
void expect_unbiased(const std::vector<double>& estimates, double truth, FalseAlarms& alarms, double largest_error) {
  const auto mean = rocking::stats::mean_of_repetitions(estimates, 1.0 - alarms.level());
  ASSERT_TRUE(mean.interval);
  EXPECT_LE(mean.interval->low, truth) << mean.mean;
  EXPECT_GE(mean.interval->high, truth) << mean.mean;
  EXPECT_LE(*mean.relative_error, largest_error);
}

Score exact(const Chain& chain) {
  return [&chain](std::int64_t k, double x) { return std::max(chain.probability(k, x), 1e-300); };
}
/// As a grid with few nodes would give it, at a wrong time.
Score coarse(const Chain& chain, double cell) {
  return [&chain, cell](std::int64_t k, double x) {
    const std::int64_t other = std::max<std::int64_t>(0, k - 3);
    return std::pow(std::max(chain.probability(other, cell * std::floor(x / cell)), 1e-14), 0.8);
  };
}
/// That of another barrier, on the other side.
Score wrong(const Chain& chain) {
  return [&chain](std::int64_t, double x) { return 1.0 + 0.05 * std::max(0.0, chain.barrier() - x); };
}

constexpr std::uint64_t repetitions = 400;

TEST(TwistedRun, OfAWalkIsUnbiasedWhateverTheScore) {
  FalseAlarms alarms;
  const Walk likely(26.0, 100);
  const Walk rare(40.0, 100);
  expect_unbiased(estimates_of(rare, exact(rare), 8, repetitions), rare.probability(0, 0.0), alarms, 0.03);
  expect_unbiased(estimates_of(rare, coarse(rare, 8.0), 8, repetitions), rare.probability(0, 0.0), alarms, 0.05);
  expect_unbiased(estimates_of(likely, wrong(likely), 8, repetitions), likely.probability(0, 0.0), alarms, 0.1);
}

TEST(TwistedRun, OfOrnsteinAndUhlenbecksProcessIsUnbiased) {
  FalseAlarms alarms;
  const Process likely(3.5, 30);
  const Process rare(6.0, 30);
  expect_unbiased(estimates_of(likely, exact(likely), 9, repetitions), likely.probability(0, 0.0), alarms, 0.03);
  expect_unbiased(estimates_of(rare, coarse(rare, 0.5), 9, repetitions), rare.probability(0, 0.0), alarms, 0.25);
}

/// A fault: every second particle becomes a hundredth heavier in each step.
class HeavyParticles : public Particles {
 public:
  using Particles::Particles;
  [[nodiscard]] static double likelihood_ratio(std::size_t i) { return i % 2 == 0 ? 1.0 : 1.01; }
};

TEST(TwistedRun, IsFoundOutWhereTheWeightsAreWrong) {
  const Walk chain(40.0, 100);
  const auto estimates = estimates_of<HeavyParticles>(chain, coarse(chain, 8.0), 8, repetitions);
  const auto mean = rocking::stats::mean_of_repetitions(estimates, 1.0 - rocking::support::false_alarm);
  EXPECT_GT(mean.interval->low, chain.probability(0, 0.0));
}

TEST(TwistedRun, IsPlainSamplingWhereAllScoresAreOne) {
  const Walk chain(10.0, 40);
  const TwistedPlan plan{.seed = 4, .periods = chain.steps(), .least_effective = 0.0};
  Particles particles(
      chain, [](std::int64_t, double) { return 1.0; }, 4, 100, 1);
  const Repetition repetition = TwistedRun(particles, plan, 1).run();
  EXPECT_NEAR(static_cast<double>(repetition.ancestors), 100.0 * repetition.estimate, 1e-9);
  EXPECT_GT(repetition.ancestors, 0U);
  EXPECT_LE(repetition.work, 100.0 + 1e-9);
}

TEST(SystematicOffspring, AreInProportionUpToOne) {
  const std::vector<double> values{0.0, 1.0, 2.5, 0.0, 6.5, 0.0};
  for (const double u : {0.0, 0.3, 0.999}) {
    const auto offspring = rocking::rare::systematic_offspring(values, 40, u);
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_LT(std::abs(offspring[i] - 4.0 * values[i]), 1.0) << u;
      sum += offspring[i];
    }
    EXPECT_EQ(sum, 40U);
  }
}

/// A vector of standard normal numbers; the event is that their sum over sqrt(d) exceeds a barrier (rare::PointModel).
class GaussianTail {
 public:
  explicit GaussianTail(double barrier) : barrier_(barrier) {}

  [[nodiscard]] static std::size_t dimensions() { return 3; }
  [[nodiscard]] std::vector<double> scores(const std::vector<Point>& points) const {
    std::vector<double> scores;
    for (const Point& p : points) {
      const double sum = (p[0] + p[1] + p[2]) / std::sqrt(3.0);
      scores.push_back(sum > barrier_ ? event_score : sum);
    }
    return scores;
  }
  [[nodiscard]] double probability() const {
    return cdf(complement(boost::math::normal_distribution<double>(), barrier_));
  }

 private:
  double barrier_;
};

std::vector<double> estimates_of(const GaussianTail& model, std::uint64_t seed, std::uint64_t count) {
  const rocking::rare::ImportancePlan plan{.seed = seed, .particles = 200};
  const auto search = rocking::rare::find_event(model, plan, rocking::rare::repetition_limit - 1);
  EXPECT_EQ(search.end, rocking::rare::SearchEnd::reached);
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= count; ++i) {
    estimates.push_back(rocking::rare::repeat_importance(model, plan, search.proposal, i).estimate);
  }
  return estimates;
}

TEST(ImportanceSampling, OfAGaussianTailIsUnbiased) {
  FalseAlarms alarms;
  for (const double barrier : {2.3, 4.75, 6.0}) {
    const GaussianTail model(barrier);
    expect_unbiased(estimates_of(model, 7, repetitions), model.probability(), alarms, 0.02);
  }
}

TEST(ImportanceSampling, SaysThatAnEventCannotBeReached) {
  class Impossible {
   public:
    [[nodiscard]] static std::size_t dimensions() { return 1; }
    [[nodiscard]] static std::vector<double> scores(const std::vector<Point>& points) {
      return std::vector<double>(points.size(), 1.0);
    }
  };
  const auto search = rocking::rare::find_event(Impossible(), {.seed = 1, .particles = 50}, 1);
  EXPECT_EQ(search.end, rocking::rare::SearchEnd::no_higher);
  EXPECT_EQ(search.reached.back(), 0.0);
  EXPECT_EQ(rocking::rare::repeat_importance(Impossible(), {.seed = 1, .particles = 50}, search.proposal, 2).estimate,
            0.0);
}

/// Intervals from 16 repetitions cover nearly as often as they say.
template <class Estimates>
void expect_coverage(Estimates&& estimates, double truth, FalseAlarms& alarms) {
  constexpr std::uint64_t trials = 300;
  constexpr double least_coverage = 0.93;
  std::uint64_t covered = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto mean = rocking::stats::mean_of_repetitions(estimates(trial + 1000), 0.95);
    covered += mean.interval && mean.interval->low <= truth && truth <= mean.interval->high ? 1 : 0;
  }
  EXPECT_GE(rocking::stats::clopper_pearson({covered, trials}, 1.0 - 2.0 * alarms.level()).high, least_coverage)
      << covered;
  EXPECT_GE(covered, trials * 90 / 100);
}

TEST(RareIntervals, CoverTheProbabilityOfChains) {
  FalseAlarms alarms;
  const Walk walk(40.0, 100);
  expect_coverage([&](std::uint64_t seed) { return estimates_of(walk, coarse(walk, 8.0), seed, 16); },
                  walk.probability(0, 0.0), alarms);
  const GaussianTail tail(4.75);
  expect_coverage([&](std::uint64_t seed) { return estimates_of(tail, seed, 16); }, tail.probability(), alarms);
}

/// Lognormal numbers of mean 1, as many as `rocking rare` would make repetitions for an error of 10 %.
std::vector<double> lognormal_until_precise(double sigma, std::uint64_t seed) {
  const Draws draws(seed, 0);
  std::vector<double> estimates;
  for (std::size_t planned = 16; planned > 0;) {
    while (estimates.size() < planned) {
      const double z = draws.standard_normal(Source::amplitude, estimates.size());
      estimates.push_back(std::exp(sigma * (z - 0.5 * sigma)));
    }
    const double error = rocking::stats::mean_of_repetitions(estimates, 0.95).relative_error.value();
    const double times = std::min(4.0, 1.05 * (error / 0.1) * (error / 0.1));
    planned = error <= 0.1 ? 0 : std::max(planned + 1, static_cast<std::size_t>(static_cast<double>(planned) * times));
  }
  return estimates;
}

// As at a probability of 2e-8 (reports/evidence/rare.md).
TEST(RareIntervals, CoverAlsoWhereASmallErrorEndsTheRepetitions) {
  FalseAlarms alarms;
  expect_coverage([&](std::uint64_t seed) { return lognormal_until_precise(1.25, seed); }, 1.0, alarms);
}

// Of the points half have no answer, and no score leads to them.
TEST(ImportanceSampling, KeepsThePointsWithoutAnAnswerApart) {
  class HalfOpen {
   public:
    [[nodiscard]] static std::size_t dimensions() { return 1; }
    [[nodiscard]] static std::vector<double> scores(const std::vector<Point>& points) {
      std::vector<double> scores;
      for (const Point& p : points) {
        scores.push_back(p[0] < 0.0 ? rocking::rare::unresolved_score : p[0] > 1.0 ? event_score : p[0]);
      }
      return scores;
    }
  };
  const rocking::rare::ImportancePlan plan{.seed = 3, .particles = 400};
  const auto search = rocking::rare::find_event(HalfOpen(), plan, 1);
  ASSERT_EQ(search.end, rocking::rare::SearchEnd::reached);
  const rocking::rare::Proposal own(1);
  const Repetition found = rocking::rare::repeat_importance(HalfOpen(), plan, own, 2);
  // Six standard deviations of a share of 400: a false alarm has the probability 2e-9.
  EXPECT_NEAR(found.unresolved, 0.5, 6.0 * 0.5 / 20.0);
  EXPECT_NEAR(found.estimate, 0.1587, 6.0 * 0.366 / 20.0);
}

}  // namespace
