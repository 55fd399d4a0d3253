#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "rocking/studies/rare/proposal.hpp"
#include "rocking/studies/rare/question.hpp"
#include "rocking/studies/rare/stream.hpp"

/// Importance sampling of numbers that are drawn once, over any model: a subset simulation finds where the event
/// happens, repetitions draw from a law fitted to that. lib/docs/rare.md.
namespace rocking::rare {

/// The score of a trajectory that had the event.
inline constexpr double event_score = std::numeric_limits<double>::infinity();
/// That of one that ended before its horizon without an answer.
inline constexpr double unresolved_score = -std::numeric_limits<double>::infinity();

/// scores: of the trajectories with these numbers, each to its horizon: how near it came to the event, event_score if
/// it had it, unresolved_score if it ended before. They depend on the point alone.
template <class Model>
concept PointModel = requires(const Model& model, const std::vector<Point>& points) {
  { model.dimensions() } -> std::same_as<std::size_t>;
  { model.scores(points) } -> std::same_as<std::vector<double>>;
};

struct ImportancePlan {
  std::uint64_t seed = 0;
  std::size_t particles = 500;  ///< of a repetition
};

/// Why a search has ended.
enum class SearchEnd : std::uint8_t {
  reached,    ///< enough particles had the event
  no_higher,  ///< no particle got beyond its level
  too_many,   ///< of levels
};

/// Where the event happens.
struct Search {
  std::vector<double> levels;   ///< of the score, rising; without the event
  std::vector<double> reached;  ///< share of the particles at each level, and the event last
  SearchEnd end = SearchEnd::reached;
  Proposal proposal;
  double work = 0.0;  ///< realisations
};

namespace importance {

inline constexpr double fraction = 0.2;  ///< of the particles that reach the next level
inline constexpr std::size_t most_levels = 300;
inline constexpr std::uint64_t chain_steps = 3;
inline constexpr int refinements = 4;

struct Population {
  std::vector<Point> points;
  std::vector<double> scores;
};

template <PointModel Model>
class Searcher {
 public:
  Searcher(const Model& model, const ImportancePlan& plan, std::uint64_t repetition)
      : model_(&model), plan_(&plan), repetition_(repetition) {}

  [[nodiscard]] Search search() {
    Search search{.levels = {}, .reached = {}, .end = SearchEnd::reached, .proposal = Proposal(model_->dimensions())};
    Population all = drawn_from(search.proposal);
    double level = -event_score;
    for (;;) {
      const std::optional<double> next = next_level(all.scores, level);
      if (!next || search.levels.size() == most_levels) {
        search.end = next ? SearchEnd::too_many : SearchEnd::no_higher;
        search.reached.push_back(0.0);
        break;
      }
      level = *next;
      keep_those_at(level, all);
      search.reached.push_back(static_cast<double>(all.points.size()) / static_cast<double>(plan_->particles));
      if (level == event_score) break;
      search.levels.push_back(level);
      all = offspring(all, level);
    }
    // Without a level the event is frequent, and its own law does well.
    if (search.end == SearchEnd::reached && !search.levels.empty()) search.proposal = refined(all);
    search.work = work_;
    return search;
  }

 private:
  [[nodiscard]] Population drawn_from(const Proposal& proposal) {
    ++stage_;
    Population all;
    for (std::size_t i = 0; i < plan_->particles; ++i) all.points.push_back(proposal.draw(draws(i, 0)));
    all.scores = scored(all.points);
    return all;
  }

  [[nodiscard]] std::vector<double> scored(const std::vector<Point>& points) {
    work_ += static_cast<double>(points.size());
    return model_->scores(points);
  }

  [[nodiscard]] random::Draws draws(std::size_t particle, std::uint64_t move) const {
    return {plan_->seed, number_of({.repetition = repetition_, .stage = stage_, .particle = particle, .move = move})};
  }

  /// The score that a fraction reaches, above `level`; where scores tie, the lowest above; absent if none is above.
  [[nodiscard]] static std::optional<double> next_level(std::vector<double> scores, double level) {
    std::ranges::sort(scores, std::greater<>());
    const auto rank = static_cast<std::size_t>(fraction * static_cast<double>(scores.size()));
    if (scores[rank] > level) return scores[rank];
    const auto above = std::ranges::find_if(scores.rbegin(), scores.rend(), [&](double s) { return s > level; });
    return above == scores.rend() ? std::nullopt : std::optional(*above);
  }

  static void keep_those_at(double level, Population& all) {
    Population kept;
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      if (!(all.scores[i] >= level)) continue;
      kept.points.push_back(std::move(all.points[i]));
      kept.scores.push_back(all.scores[i]);
    }
    all = std::move(kept);
  }

  /// As many as there are particles, from parents that have reached the level, by Markov chain steps that keep the law
  /// given that.
  [[nodiscard]] Population offspring(const Population& parents, double level) {
    ++stage_;
    Population all;
    for (std::size_t i = 0; i < plan_->particles; ++i) {
      all.points.push_back(parents.points[i % parents.points.size()]);
      all.scores.push_back(parents.scores[i % parents.points.size()]);
    }
    for (std::uint64_t step = 1; step <= chain_steps; ++step) {
      std::vector<Point> candidates;
      for (std::size_t i = 0; i < all.points.size(); ++i) {
        candidates.push_back(moved(all.points[i], draws(i, step)));
      }
      const std::vector<double> scores = scored(candidates);
      for (std::size_t i = 0; i < all.points.size(); ++i) {
        if (!(scores[i] >= level)) continue;
        all.points[i] = std::move(candidates[i]);
        all.scores[i] = scores[i];
      }
    }
    return all;
  }

  /// A step of size 1, 1/2, ..., 2^-7, each as likely as another (preconditioned Crank-Nicolson): no size has to be
  /// tuned, and far steps remain possible.
  [[nodiscard]] static Point moved(const Point& from, const random::Draws& draws) {
    double size = 1.0;
    for (std::uint64_t k = draws.bits(random::Source::rare_choice, 0) % 8; k > 0; --k) size *= 0.5;
    Point to(from.size());
    draws.standard_normals(random::Source::rare_choice, 2, to);
    for (std::size_t d = 0; d < to.size(); ++d) to[d] = std::sqrt(1.0 - size * size) * from[d] + size * to[d];
    return to;
  }

  /// Fitted to points that had the event, and again to these and the weighted ones that each fit gives: a fit to the
  /// last ones alone would lose parts of the event that it has not seen. Each set counts as much as another.
  [[nodiscard]] Proposal refined(const Population& with_event) {
    std::vector<WeightedPoint> points;
    for (const Point& point : with_event.points) points.push_back({point, 1.0});
    make_total_one(points);
    Proposal proposal = Proposal::fitted_to(points, model_->dimensions());
    for (int i = 0; i < refinements; ++i) {
      std::vector<WeightedPoint> fresh = weighted_points_of(proposal);
      constexpr std::size_t least = 20;  // hits; a fit to fewer is worse than the one before
      if (fresh.size() < least) break;
      make_total_one(fresh);
      proposal = Proposal::fitted_to(points, fresh, model_->dimensions());
      points.insert(points.end(), fresh.begin(), fresh.end());
    }
    return proposal;
  }

  /// Points drawn from the proposal that have the event.
  [[nodiscard]] std::vector<WeightedPoint> weighted_points_of(const Proposal& proposal) {
    const Population all = drawn_from(proposal);
    std::vector<WeightedPoint> points;
    for (std::size_t k = 0; k < all.points.size(); ++k) {
      if (all.scores[k] != event_score) continue;
      points.push_back({all.points[k], proposal.likelihood_ratio(all.points[k])});
    }
    return points;
  }

  static void make_total_one(std::vector<WeightedPoint>& points) {
    double total = 0.0;
    for (const WeightedPoint& point : points) total += point.weight;
    for (WeightedPoint& point : points) point.weight /= total;
  }

  const Model* model_;
  const ImportancePlan* plan_;
  std::uint64_t repetition_;
  std::uint64_t stage_ = 0;
  double work_ = 0.0;
};

}  // namespace importance

/// Subset simulation (Au & Beck 2001) to the event: the particles that reach a level are the parents of the next ones.
template <PointModel Model>
[[nodiscard]] Search find_event(const Model& model, const ImportancePlan& plan, std::uint64_t repetition) {
  return importance::Searcher<Model>(model, plan, repetition).search();
}

/// What a repetition draws from the proposal.
[[nodiscard]] inline std::vector<Point> points_of_repetition(const ImportancePlan& plan, const Proposal& proposal,
                                                             std::uint64_t repetition) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < plan.particles; ++i) {
    points.push_back(
        proposal.draw({plan.seed, number_of({.repetition = repetition, .stage = 0, .particle = i, .move = 0})}));
  }
  return points;
}

/// One repetition: the mean likelihood ratio of those drawn from the proposal that have the event. Unbiased, whatever
/// the proposal.
template <PointModel Model>
[[nodiscard]] Repetition repeat_importance(const Model& model, const ImportancePlan& plan, const Proposal& proposal,
                                           std::uint64_t repetition) {
  const std::vector<Point> points = points_of_repetition(plan, proposal, repetition);
  const std::vector<double> scores = model.scores(points);
  Repetition result;
  result.work = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (scores[i] == unresolved_score) result.unresolved += proposal.likelihood_ratio(points[i]);
    if (scores[i] != event_score) continue;
    ++result.ancestors;
    result.estimate += proposal.likelihood_ratio(points[i]);
  }
  result.estimate /= static_cast<double>(points.size());
  result.unresolved /= static_cast<double>(points.size());
  return result;
}

}  // namespace rocking::rare
