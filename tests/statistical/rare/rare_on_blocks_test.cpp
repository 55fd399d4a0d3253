// Rare probabilities of blocks are unbiased: compared with a closed form where numbers are drawn once, and with plain
// sampling where they are drawn along the way. A kernel that prefers high scores must fail both comparisons.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/block_model.hpp"
#include "rocking/studies/rare/splitting.hpp"
#include "support/excitation.hpp"
#include "support/false_alarms.hpp"

namespace {

using rocking::Condition;
using rocking::rare::BlockModel;
using rocking::rare::Event;
using rocking::rare::Stream;
using rocking::support::FalseAlarms;
using rocking::support::largest_score;

constexpr std::uint64_t run_seed = 0x2012;

/// A probability and its standard error.
struct Estimate {
  double mean = 0.0;
  double error = 0.0;
};

/// Of the difference of two estimates.
double score_of(const Estimate& a, const Estimate& b) { return (a.mean - b.mean) / std::hypot(a.error, b.error); }

template <class Model>
Estimate by_splitting(const Model& model, std::size_t particles, std::uint64_t repetitions) {
  const rocking::rare::ForEach one_by_one = [](std::size_t count, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
  };
  const rocking::rare::SplittingPlan plan{.seed = run_seed, .particles = particles};
  const auto pilot = rocking::rare::find_levels(model, plan, one_by_one);
  EXPECT_EQ(pilot.end, rocking::rare::PilotEnd::reached);
  EXPECT_GE(pilot.levels.size(), 2U) << "or it is plain sampling";
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= repetitions; ++i) {
    estimates.push_back(rocking::rare::repeat(model, plan, pilot.levels, i, one_by_one).estimate);
  }
  const auto found = rocking::stats::mean_of_repetitions(estimates, 0.95);
  return {found.mean, found.mean * found.relative_error.value()};
}

/// A kernel with a fault: of four offspring it takes the one with the highest score.
struct BestOfFour {
  using Particle = BlockModel::Particle;
  const BlockModel& model;

  [[nodiscard]] Particle start(const Stream& stream, double target) const { return model.start(stream, target); }
  [[nodiscard]] Particle go_on(const Particle& parent, const Stream& stream, double level, double target) const {
    Particle best = model.go_on(parent, stream, level, target);
    for (std::uint64_t i = 1; i < 4; ++i) {
      Stream other = stream;
      other.particle += i * (rocking::rare::particle_limit / 4);
      Particle one = model.go_on(parent, other, level, target);
      if (one.score > best.score) best = std::move(one);
    }
    return best;
  }
  [[nodiscard]] static double score(const Particle& particle) { return particle.score; }
  [[nodiscard]] static double work(const Particle& particle) { return particle.work; }
};

// A free block that stands with a random tilt rate Theta' overturns where its energy lifts it past balance:
// psi abs(Theta') > 2 sin(psi/2). The horizon, 4 pi in tau, leaves out those whose energy exceeds that
// of the balance by a share of less than about 4 exp(-4 pi), 1e-5: 1e-4 of the probability.
class FreeBlock {
 public:
  explicit FreeBlock(const rocking::Quantity& tilt_rate = rocking::Normal{.mean = 0.0, .sigma = sigma}) {
    rocking::support::harmonic(condition_.scene) = {.amplitude = 0.0, .frequency_ratio = 0.5, .phase = 0.0};
    condition_.scene.initial.tilt_rate = tilt_rate;
    condition_.horizon = {.transient_periods = 0, .sampled_periods = 1};
  }
  [[nodiscard]] BlockModel model() const { return {condition_, {.seed = run_seed, .event = {}}}; }
  /// The least abs(Theta') that overturns it.
  [[nodiscard]] static double threshold() {
    const double psi = std::atan(0.25);  // of the standard block, 1 m x 4 m
    return 2.0 * std::sin(0.5 * psi) / psi;
  }
  [[nodiscard]] static Estimate truth() { return {std::erfc(threshold() / sigma / std::numbers::sqrt2), 0.0}; }

 private:
  static constexpr double sigma = 0.33;
  Condition condition_;
};

/// A block whose friction, restitution and amplitude are drawn along the way, by normal or other laws, in time or for
/// each place; the event is a peak tilt.
class ShakenBlock {
 public:
  explicit ShakenBlock(const rocking::FluctuationLaws& laws = {}, double correlation = 0.0,
                       std::optional<double> refresh_slip_m = {}) {
    rocking::support::harmonic(condition_.scene) = {.amplitude = 4.2, .frequency_ratio = 6.0, .phase = 0.0};
    condition_.scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
    condition_.scene.fluctuation = {.static_friction = 0.03,
                                    .kinetic_friction = 0.03,
                                    .refreshes_per_period = 20,
                                    .refresh_slip_m = refresh_slip_m,
                                    .restitution = 0.02,
                                    .amplitude = 0.6,
                                    .laws = laws,
                                    .friction_correlation = correlation};
    condition_.horizon = {.transient_periods = 3, .sampled_periods = 5};
  }
  [[nodiscard]] BlockModel model() const { return {condition_, {.seed = run_seed, .event = event}}; }
  [[nodiscard]] Estimate plain() const {
    constexpr std::uint64_t realisations = 40'000;
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < realisations; ++i) {
      count += rocking::realise(condition_, run_seed, i).peaks.tilt > *event.peak_tilt ? 1 : 0;
    }
    constexpr auto n = static_cast<double>(realisations);
    const double share = static_cast<double>(count) / n;
    return {share, std::sqrt(share * (1.0 - share) / n)};
  }

 private:
  static constexpr Event event{.peak_tilt = 0.75};
  Condition condition_;
};

TEST(RareOnBlocks, IsUnbiasedForNumbersThatAreDrawnOnce) {
  FalseAlarms alarms;
  const FreeBlock block;
  const Estimate found = by_splitting(block.model(), 100, 120);
  EXPECT_LT(std::abs(score_of(found, FreeBlock::truth())), alarms.score()) << found.mean;
  EXPECT_LT(found.error, 0.1 * found.mean);
}

// Laws that are functions of a normal number, and of a uniform one, with their probability of exceeding a number.
TEST(RareOnBlocks, IsUnbiasedForOtherLaws) {
  FalseAlarms alarms;
  const double least = FreeBlock::threshold();
  const double variance = std::log1p(0.12 * 0.12 / (0.4 * 0.4));
  const double score = (std::log(least / 0.4) + 0.5 * variance) / std::sqrt(variance);
  const auto above = [](double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); };
  const double end = 1.05;
  const double part = above(least / 0.33) - above(end / 0.33);
  const std::vector<std::pair<rocking::Quantity, double>> laws{
      {rocking::Lognormal{.mean = 0.4, .sigma = 0.12}, above(score)},
      {rocking::Triangular{.low = 0.0, .mode = 0.1, .high = end}, (end - least) * (end - least) / (end * (end - 0.1))},
      {rocking::Normal{.mean = 0.0, .sigma = 0.33, .between = rocking::Reach{0.0, end}},
       part / (0.5 - above(end / 0.33))}};
  for (const auto& [law, probability] : laws) {
    const FreeBlock block(law);
    const Estimate found = by_splitting(block.model(), 100, 80);
    EXPECT_LT(std::abs(score_of(found, {probability, 0.0})), alarms.score()) << found.mean << ' ' << probability;
    EXPECT_LT(found.error, 0.25 * found.mean);
  }
}

TEST(RareOnBlocks, IsUnbiasedForNumbersThatAreDrawnAlongTheWay) {
  FalseAlarms alarms;
  using enum rocking::FluctuationLaw;
  const rocking::FluctuationLaws others{
      .static_friction = lognormal, .kinetic_friction = uniform, .restitution = uniform, .amplitude = lognormal};
  for (const ShakenBlock& block : {ShakenBlock(), ShakenBlock(others, 0.8), ShakenBlock({}, 0.5, 0.005)}) {
    const Estimate found = by_splitting(block.model(), 60, 60);
    const Estimate plain = block.plain();
    EXPECT_LT(std::abs(score_of(found, plain)), alarms.score()) << found.mean << ' ' << plain.mean;
    EXPECT_LT(std::hypot(found.error / found.mean, plain.error / plain.mean), 0.15);
  }
}

TEST(RareOnBlocks, IsFoundOutWhereTheKernelPrefersHighScores) {
  const FreeBlock free;
  const BlockModel of_free = free.model();
  const Estimate found = by_splitting(BestOfFour{of_free}, 100, 50);
  EXPECT_GT(score_of(found, FreeBlock::truth()), largest_score);
  const ShakenBlock shaken;
  const BlockModel of_shaken = shaken.model();
  const Estimate other = by_splitting(BestOfFour{of_shaken}, 60, 30);
  EXPECT_GT(score_of(other, shaken.plain()), largest_score);
}

}  // namespace
