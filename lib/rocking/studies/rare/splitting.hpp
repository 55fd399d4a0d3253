#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/random/draws.hpp"
#include "rocking/studies/rare/estimate.hpp"
#include "rocking/studies/rare/stream.hpp"

/// Multilevel splitting over any model of trajectories: a pilot run sets the levels, repetitions at these fixed levels
/// estimate the probability. lib/docs/rare.md.
namespace rocking::rare {

/// The score of a trajectory that had the event.
inline constexpr double event_score = std::numeric_limits<double>::infinity();

/// The steps of a kernel and the resources of a particle are the model's matter. Both functions depend on their
/// arguments alone. A particle ends when its score reaches `target`, or at the horizon.
///
/// start: a trajectory with the random numbers of the stream. go_on: from a trajectory that has reached `level`, one
/// with another past, future or both, whose law given that the level is reached is that of the parent. score: largest
/// score so far. work: simulated time spent by the call, a full trajectory being 1.
template <class Model>
concept SplittingModel = requires(const Model model, const typename Model::Particle& particle, const Stream& stream,
                                  double level) {
  { model.start(stream, level) } -> std::same_as<typename Model::Particle>;
  { model.go_on(particle, stream, level, level) } -> std::same_as<typename Model::Particle>;
  { model.score(particle) } -> std::same_as<double>;
  { model.work(particle) } -> std::same_as<double>;
};

struct SplittingPlan {
  std::uint64_t seed = 0;
  std::size_t particles = 500;  ///< of a repetition
  double fraction = 0.2;        ///< of the particles that the pilot run lets reach the next level
  std::size_t most_levels = 300;
};

/// Calls work(i) for each i < count, in any order and on several threads.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// Why a pilot run has ended.
enum class PilotEnd : std::uint8_t {
  reached,    ///< enough particles had the event
  no_higher,  ///< no particle got beyond its level
  too_many,   ///< of levels
};

/// Levels found by a pilot run. Its estimate is not used: it is biased where particles move by Markov chains.
struct Pilot {
  std::vector<double> levels;  ///< rising; without the event
  PilotEnd end = PilotEnd::reached;
  double work = 0.0;
};

namespace splitting {

/// The offspring i of `count` has the parent (i + offset) mod parents: each has as many as another, up to one.
[[nodiscard]] inline std::size_t parent_of(std::size_t i, std::size_t parents, std::uint64_t offset) {
  return (i + static_cast<std::size_t>(offset % parents)) % parents;
}

[[nodiscard]] inline std::uint64_t offset_of(std::uint64_t seed, const Stream& stage) {
  return random::Draws(seed, number_of(stage)).bits(random::Source::rare_choice, 0);
}

template <class Model>
struct Lineage {
  typename Model::Particle particle;
  std::size_t ancestor = 0;
};

template <SplittingModel Model>
class Run {
 public:
  using Lineages = std::vector<Lineage<Model>>;

  Run(const Model& model, const SplittingPlan& plan, std::uint64_t repetition, const ForEach& for_each)
      : model_(&model), plan_(&plan), repetition_(repetition), for_each_(&for_each) {}

  [[nodiscard]] Lineages first(double target) const {
    return made([&](std::size_t i) { return Lineage<Model>{model_->start(stream(0, i), target), i}; });
  }

  /// The particles of stage `stage` > 0.
  [[nodiscard]] Lineages next(const Lineages& parents, std::size_t stage, double level, double target) const {
    const std::uint64_t offset = offset_of(plan_->seed, stream(stage, last_particle));
    return made([&](std::size_t i) {
      const Lineage<Model>& parent = parents[parent_of(i, parents.size(), offset)];
      return Lineage<Model>{model_->go_on(parent.particle, stream(stage, i), level, target), parent.ancestor};
    });
  }

  [[nodiscard]] double work_of(const Lineages& all) const {
    double work = 0.0;
    for (const auto& one : all) work += model_->work(one.particle);
    return work;
  }

  void keep_those_at(double level, Lineages& all) const {
    std::erase_if(all, [&](const auto& one) { return !(model_->score(one.particle) >= level); });
  }

 private:
  [[nodiscard]] Stream stream(std::size_t stage, std::size_t particle) const {
    return {.repetition = repetition_, .stage = stage, .particle = particle, .move = 0};
  }

  template <class Make>
  [[nodiscard]] Lineages made(Make&& make) const {
    std::vector<std::optional<Lineage<Model>>> slots(plan_->particles);
    (*for_each_)(slots.size(), [&](std::size_t i) { slots[i].emplace(make(i)); });
    Lineages all;
    all.reserve(slots.size());
    for (auto& slot : slots) all.push_back(*std::move(slot));
    return all;
  }

  const Model* model_;
  const SplittingPlan* plan_;
  std::uint64_t repetition_;
  const ForEach* for_each_;
};

/// The score that `fraction` of the particles reach, above `level`; absent if no score is above.
template <SplittingModel Model>
[[nodiscard]] std::optional<double> next_level(const Model& model, const typename Run<Model>::Lineages& all,
                                               double level, double fraction) {
  std::vector<double> scores;
  for (const auto& one : all) scores.push_back(model.score(one.particle));
  std::ranges::sort(scores, std::greater<>());
  const auto rank = static_cast<std::size_t>(fraction * static_cast<double>(scores.size()));
  if (scores[rank] > level) return scores[rank];
  // Ties: the lowest score above the level.
  const auto above = std::ranges::find_if(scores.rbegin(), scores.rend(), [&](double s) { return s > level; });
  return above == scores.rend() ? std::nullopt : std::optional(*above);
}

}  // namespace splitting

/// Runs particles to their horizon, takes the score that `fraction` of them reach for the next level, and goes on from
/// those that reach it, until that share has the event. Each stage is computed again up to its level.
template <SplittingModel Model>
[[nodiscard]] Pilot find_levels(const Model& model, const SplittingPlan& plan, const ForEach& for_each) {
  const splitting::Run<Model> run(model, plan, 0, for_each);
  Pilot pilot;
  typename splitting::Run<Model>::Lineages parents;
  double level = -event_score;
  for (std::size_t stage = 0; stage <= plan.most_levels; ++stage) {
    const auto particles = [&](double target) {
      auto all = stage == 0 ? run.first(target) : run.next(parents, stage, level, target);
      pilot.work += run.work_of(all);
      return all;
    };
    const auto next = splitting::next_level(model, particles(event_score), level, plan.fraction);
    pilot.end = next ? PilotEnd::reached : PilotEnd::no_higher;
    if (!next || *next == event_score) return pilot;
    auto reached = particles(*next);
    run.keep_those_at(*next, reached);
    parents = std::move(reached);
    level = *next;
    pilot.levels.push_back(level);
  }
  pilot.end = PilotEnd::too_many;
  return pilot;
}

/// Repetition number `repetition` > 0 at these levels. Independent of the others, given the levels.
template <SplittingModel Model>
[[nodiscard]] Repetition repeat(const Model& model, const SplittingPlan& plan, const std::vector<double>& levels,
                                std::uint64_t repetition, const ForEach& for_each) {
  const splitting::Run<Model> run(model, plan, repetition, for_each);
  Repetition result;
  double estimate = 1.0;
  typename splitting::Run<Model>::Lineages particles;
  for (std::size_t stage = 0; stage <= levels.size(); ++stage) {
    const double target = stage < levels.size() ? levels[stage] : event_score;
    particles = stage == 0 ? run.first(target) : run.next(particles, stage, levels[stage - 1], target);
    result.work += run.work_of(particles);
    run.keep_those_at(target, particles);
    const double share = static_cast<double>(particles.size()) / static_cast<double>(plan.particles);
    result.reached.push_back(share);
    estimate *= share;
    if (particles.empty()) return result;
  }
  std::vector<std::size_t> ancestors;
  for (const auto& one : particles) ancestors.push_back(one.ancestor);
  std::ranges::sort(ancestors);
  const auto end = std::unique(ancestors.begin(), ancestors.end());
  result.ancestors = static_cast<std::size_t>(end - ancestors.begin());
  result.estimate = estimate;
  return result;
}

}  // namespace rocking::rare
