#pragma once

#include <algorithm>
#include <concepts>
#include <numeric>

#include "rocking/random/draws.hpp"
#include "rocking/studies/rare/committor.hpp"
#include "rocking/studies/rare/question.hpp"
#include "rocking/studies/rare/stream.hpp"

/// A sequential Monte Carlo run whose particles advance one period at a time, over any model of trajectories.
/// lib/docs/rare.md.
namespace rocking::rare {

/// Trajectories that stand at strobe point 1 at first. likelihood_ratio: of what particle i has drawn in the start or
/// the last advance; 1 where that is drawn by its own law. fate: what has happened to it up to now. score: > 0, how
/// likely the event still is from strobe point k on; any function of the past leaves the estimate unbiased. branch:
/// particle i becomes another future of `parent`, with new random numbers. leave: it is not advanced any more. advance:
/// one period, of all that have neither ended nor left. work: simulated time so far, a full trajectory being 1.
template <class P>
concept Population = requires(P& population, const P& constant, std::size_t i, std::int64_t k, const Stream& stream) {
  { constant.size() } -> std::same_as<std::size_t>;
  { constant.likelihood_ratio(i) } -> std::same_as<double>;
  { constant.fate(i) } -> std::same_as<Image::Fate>;
  { population.score(k, i) } -> std::same_as<double>;
  { constant.work() } -> std::same_as<double>;
  population.branch(i, i, stream);
  population.leave(i);
  population.advance();
};

struct TwistedPlan {
  std::uint64_t seed = 0;
  std::int64_t periods = 1;      ///< strobe points
  double least_effective = 0.7;  ///< of the particles; with fewer they are resampled
};

/// Offspring of particles with these scores times weights, `count` in all: systematic resampling, by which particle i
/// has count v_i/sum(v) of them in the mean. `u` from [0, 1).
[[nodiscard]] inline std::vector<std::uint32_t> systematic_offspring(const std::vector<double>& values,
                                                                     std::size_t count, double u) {
  double total = 0.0;
  for (const double value : values) total += value;
  std::vector<std::uint32_t> offspring(values.size(), 0);
  double sum = 0.0;
  std::size_t given = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0.0)) continue;
    last = i;
    sum += values[i];
    while (given < count && (static_cast<double>(given) + u) * total < sum * static_cast<double>(count)) {
      ++offspring[i];
      ++given;
    }
  }
  offspring[last] += static_cast<std::uint32_t>(count - given);  // what rounding has left
  return offspring;
}

/// One repetition. The weight w_i of a particle is such that sum w_i f(path i) is an unbiased estimate of E f;
/// particles that have the event leave with their weight, and the estimate is the sum of these. Where the effective
/// number of particles by v_i = w_i score_i, (sum v)^2/sum v^2, falls below a share of them, they are resampled in
/// proportion to v. Sources: Del Moral (2004); Whiteley & Lee (2014), Annals of Statistics 42, 115-141.
template <Population P>
class TwistedRun {
 public:
  TwistedRun(P& population, const TwistedPlan& plan, std::uint64_t repetition)
      : population_(&population),
        plan_(&plan),
        repetition_(repetition),
        weights_(population.size()),
        scores_(population.size()),
        values_(population.size()),
        ancestors_(population.size()) {
    std::ranges::fill(weights_, 1.0);  // sums are divided at the end, so that those of whole numbers are exact
    std::iota(ancestors_.begin(), ancestors_.end(), std::size_t{0});
  }

  /// A particle that had the event, with its weight: the first of its ancestors.
  struct Found {
    std::size_t ancestor = 0;
    double weight = 0.0;
  };
  [[nodiscard]] const std::vector<Found>& found() const { return found_; }

  [[nodiscard]] Repetition run() {
    for (std::int64_t k = 1; collect() && k < plan_->periods; ++k) {
      if (weigh(k) < plan_->least_effective * static_cast<double>(weights_.size())) resample(k);
      population_->advance();
    }
    result_.estimate /= static_cast<double>(weights_.size());
    result_.unresolved /= static_cast<double>(weights_.size());
    std::ranges::sort(found_, {}, &Found::ancestor);
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (i == 0 || found_[i].ancestor != found_[i - 1].ancestor) ++result_.ancestors;
    }
    result_.work = population_->work();
    return result_;
  }

 private:
  /// Takes out what had the event or cannot have it any more. Whether any particle is left.
  bool collect() {
    bool is_any_left = false;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (weights_[i] == 0.0) continue;
      weights_[i] *= population_->likelihood_ratio(i);
      const Image::Fate fate = population_->fate(i);
      if (fate == Image::Fate::moves_on) {
        is_any_left = true;
        continue;
      }
      if (fate == Image::Fate::event) {
        if constexpr (requires { population_->note_event(i, weights_[i]); }) population_->note_event(i, weights_[i]);
        result_.estimate += weights_[i];
        found_.push_back({ancestors_[i], weights_[i]});
      } else {
        result_.unresolved += weights_[i];
      }
      weights_[i] = 0.0;
      population_->leave(i);
    }
    return is_any_left;
  }

  /// The effective number of particles.
  double weigh(std::int64_t k) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      scores_[i] = weights_[i] > 0.0 ? population_->score(k, i) : 0.0;
      values_[i] = weights_[i] * scores_[i];
      sum += values_[i];
    }
    for (const double value : values_) squares += (value / sum) * (value / sum);
    total_ = sum;
    return 1.0 / squares;
  }

  void resample(std::int64_t k) {
    const Stream stream = stream_of(k, last_particle);
    const double u = random::Draws(plan_->seed, number_of(stream)).uniform(random::Source::rare_choice, 0);
    const std::vector<std::uint32_t> offspring = systematic_offspring(values_, weights_.size(), u);
    const double mean = total_ / static_cast<double>(weights_.size());
    std::size_t free = 0;
    for (std::size_t parent = 0; parent < offspring.size(); ++parent) {
      for (std::uint32_t copy = 1; copy < offspring[parent]; ++copy) {
        while (offspring[free] > 0) ++free;
        population_->branch(free, parent, stream_of(k, free));
        ancestors_[free] = ancestors_[parent];
        weights_[free] = mean / scores_[parent];
        ++free;
      }
    }
    for (std::size_t i = 0; i < offspring.size(); ++i) {
      if (offspring[i] > 0) weights_[i] = mean / scores_[i];
    }
  }

  [[nodiscard]] Stream stream_of(std::int64_t k, std::size_t particle) const {
    const auto number = static_cast<std::uint64_t>(k);
    return {.repetition = repetition_, .stage = number / move_limit, .particle = particle, .move = number % move_limit};
  }

  P* population_;
  const TwistedPlan* plan_;
  std::uint64_t repetition_;
  std::vector<double> weights_;
  std::vector<double> scores_;
  std::vector<double> values_;
  double total_ = 0.0;
  std::vector<std::size_t> ancestors_;
  std::vector<Found> found_;
  Repetition result_;
};

}  // namespace rocking::rare
