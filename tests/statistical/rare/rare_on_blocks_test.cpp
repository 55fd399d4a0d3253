// Rare probabilities of blocks are unbiased: compared with a closed form where numbers are drawn once, and with plain
// sampling where they are drawn along the way. A run with wrong weights must fail the comparison.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/estimator.hpp"
#include "rocking/studies/rare/twisted_run.hpp"
#include "support/excitation.hpp"
#include "support/false_alarms.hpp"

namespace {

using rocking::Condition;
using rocking::EventName;
using rocking::ResponseEvent;
using rocking::rare::BlockPaths;
using rocking::rare::BlockPopulation;
using rocking::rare::Committor;
using rocking::rare::Guide;
using rocking::rare::Image;
using rocking::rare::Proposal;
using rocking::rare::SectionGrid;
using rocking::rare::Stream;
using rocking::rare::Transitions;
using rocking::rare::TwistedPlan;
using rocking::rare::TwistedRun;
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

/// A condition and the event in it.
struct Question {
  Condition condition;
  ResponseEvent event;

  [[nodiscard]] BlockPaths paths() const {
    return {.condition = &condition, .seed = run_seed, .event = event, .halt = {}};
  }
};

Estimate mean_of(const std::vector<double>& estimates) {
  const auto found = rocking::stats::mean_of_repetitions(estimates, 0.95);
  return {found.mean, found.mean * found.relative_error.value()};
}

/// By the estimator of `rocking rare`, after its pilot runs.
Estimate estimated(const Question& question, std::size_t particles, std::uint64_t repetitions) {
  const BlockPaths paths = question.paths();
  const auto estimator = rocking::rare::estimator_of(paths, particles, 1);
  EXPECT_TRUE(estimator->pilot().found_event);
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= repetitions; ++i) estimates.push_back(estimator->repeat(i).estimate);
  return mean_of(estimates);
}

Estimate plain(const Question& question) {
  constexpr std::uint64_t realisations = 40'000;
  std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < realisations; ++i) {
    count += rocking::realise(question.condition, run_seed, i).peaks.tilt > question.event.threshold ? 1 : 0;
  }
  constexpr auto n = static_cast<double>(realisations);
  const double share = static_cast<double>(count) / n;
  return {share, std::sqrt(share * (1.0 - share) / n)};
}

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
  [[nodiscard]] Question question() const { return {condition_, {}}; }
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
Question shaken_block(const rocking::FluctuationLaws& laws = {}, double correlation = 0.0,
                      std::optional<double> refresh_slip_m = {}) {
  Question question{.condition = {}, .event = {EventName::tilt, 0.75}};
  rocking::Scene& scene = question.condition.scene;
  rocking::support::harmonic(scene) = {.amplitude = 4.2, .frequency_ratio = 6.0, .phase = 0.0};
  scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
  scene.fluctuation = {.static_friction = 0.03,
                       .kinetic_friction = 0.03,
                       .refreshes_per_period = 20,
                       .refresh_slip_m = refresh_slip_m,
                       .restitution = 0.02,
                       .amplitude = 0.6,
                       .laws = laws,
                       .friction_correlation = correlation};
  question.condition.horizon = {.transient_periods = 3, .sampled_periods = 5};
  return question;
}

/// As shaken_block, and the width and the phase are drawn once.
Question block_of_random_size() {
  Question question = shaken_block();
  question.condition.scene.block.width = rocking::Normal{.mean = 1.0, .sigma = 0.05};
  rocking::support::harmonic(question.condition.scene).phase = rocking::Uniform{.low = 0.0, .high = 6.28};
  return question;
}

TEST(RareOnBlocks, IsUnbiasedForNumbersThatAreDrawnOnce) {
  FalseAlarms alarms;
  const FreeBlock block;
  const Estimate found = estimated(block.question(), 100, 120);
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
    const Estimate found = estimated(block.question(), 100, 80);
    EXPECT_LT(std::abs(score_of(found, {probability, 0.0})), alarms.score()) << found.mean << ' ' << probability;
    EXPECT_LT(found.error, 0.25 * found.mean);
  }
}

TEST(RareOnBlocks, IsUnbiasedForNumbersThatAreDrawnAlongTheWay) {
  FalseAlarms alarms;
  using enum rocking::FluctuationLaw;
  const rocking::FluctuationLaws others{
      .static_friction = lognormal, .kinetic_friction = uniform, .restitution = uniform, .amplitude = lognormal};
  const Question with_size_and_phase = block_of_random_size();
  for (const Question& question :
       {shaken_block(), shaken_block(others, 0.8), shaken_block({}, 0.5, 0.005), with_size_and_phase}) {
    const Estimate found = estimated(question, 60, 120);
    const Estimate other = plain(question);
    EXPECT_LT(std::abs(score_of(found, other)), alarms.score()) << found.mean << ' ' << other.mean;
    EXPECT_LT(std::hypot(found.error / found.mean, other.error / other.mean), 0.15);
  }
}

/// By runs that this guide steers, with numbers drawn once from a proposal.
Estimate steered(const Question& question, const Guide& guide, std::uint64_t repetitions,
                 const Proposal* proposal = nullptr) {
  const BlockPaths paths = question.paths();
  const TwistedPlan plan{.seed = run_seed, .periods = paths.periods()};
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= repetitions; ++i) {
    BlockPopulation population(paths, {.particles = 60, .repetition = i, .guide = &guide, .proposal = proposal});
    estimates.push_back(TwistedRun(population, plan, i).run().estimate);
  }
  return mean_of(estimates);
}

/// A grid with a few nodes.
SectionGrid few_nodes() {
  return {{.inner = 0.6, .outer = 0.8, .inner_cells = 2, .outer_cells = 1},
          {.inner = 1.0, .outer = 2.0, .inner_cells = 2, .outer_cells = 1}};
}

Guide guide_of(const Transitions& transitions, const BlockPaths& paths) {
  return {.committor = Committor(few_nodes(), {&transitions, 1}, paths.periods()), .least = 1e-3};
}

// Also one that takes motions for other ones: mirrored in Theta alone, and half as fast.
TEST(RareOnBlocks, IsUnbiasedWhateverTheErrorOfTheGrid) {
  FalseAlarms alarms;
  const Question question = shaken_block();
  const BlockPaths paths = question.paths();
  Transitions transitions = rocking::rare::transitions_of(paths, few_nodes(), 0, 9, 1);
  const Guide coarse = guide_of(transitions, paths);
  for (Image& image : transitions.images) image.point = {-image.point.tilt, 0.5 * image.point.tilt_rate, 0.0};
  const Guide wrong = guide_of(transitions, paths);
  const Estimate other = plain(question);
  for (const Guide* guide : {&coarse, &wrong}) {
    const Estimate found = steered(question, *guide, 200);
    EXPECT_LT(std::abs(score_of(found, other)), alarms.score()) << found.mean << ' ' << other.mean;
    EXPECT_LT(std::hypot(found.error / found.mean, other.error / other.mean), 0.2);
  }
}

// One that is too wide, and one that is where the event is not more likely.
TEST(RareOnBlocks, IsUnbiasedWhateverTheProposalOfNumbersDrawnOnce) {
  FalseAlarms alarms;
  const Question question = block_of_random_size();
  const BlockPaths paths = question.paths();
  const std::size_t dimensions = paths.numbers.once.size();
  ASSERT_EQ(dimensions, 2U);
  const Proposal wide = Proposal::about_mean(dimensions, 1.5);
  const Proposal wrong = Proposal::fitted_to({{{1.0, -1.0}, 1.0}, {{1.5, -0.5}, 2.0}}, dimensions, 0.8);
  const Estimate other = plain(question);
  for (const Proposal* proposal : {&wide, &wrong}) {
    const Guide guide = guide_of(rocking::rare::transitions_of(paths, few_nodes(), 0, 9, 1, proposal), paths);
    const Estimate found = steered(question, guide, 300, proposal);
    EXPECT_LT(std::abs(score_of(found, other)), alarms.score()) << found.mean << ' ' << other.mean;
    EXPECT_LT(std::hypot(found.error / found.mean, other.error / other.mean), 0.2);
  }
}

/// A fault: the draws of each period count half as much again.
class TooHeavy {
 public:
  explicit TooHeavy(BlockPopulation& population) : population_(&population) {}
  [[nodiscard]] std::size_t size() const { return population_->size(); }
  [[nodiscard]] double likelihood_ratio(std::size_t i) const { return 1.5 * population_->likelihood_ratio(i); }
  [[nodiscard]] Image::Fate fate(std::size_t i) const { return population_->fate(i); }
  [[nodiscard]] double work() const { return population_->work(); }
  [[nodiscard]] double score(std::int64_t k, std::size_t i) const { return population_->score(k, i); }
  void branch(std::size_t i, std::size_t parent, const Stream& stream) { population_->branch(i, parent, stream); }
  void leave(std::size_t i) { population_->leave(i); }
  void advance() { population_->advance(); }

 private:
  BlockPopulation* population_;
};

TEST(RareOnBlocks, IsFoundOutWhereWeightsAreWrong) {
  const Question question = shaken_block();
  const BlockPaths paths = question.paths();
  const TwistedPlan plan{.seed = run_seed, .periods = paths.periods()};
  const Guide guide = guide_of(rocking::rare::transitions_of(paths, few_nodes(), 0, 9, 1), paths);
  std::vector<double> estimates;
  for (std::uint64_t i = 1; i <= 500; ++i) {
    BlockPopulation population(paths, {.particles = 60, .repetition = i, .guide = &guide});
    TooHeavy faulty(population);
    estimates.push_back(TwistedRun(faulty, plan, i).run().estimate);
  }
  EXPECT_GT(score_of(mean_of(estimates), plain(question)), largest_score);
}

}  // namespace
