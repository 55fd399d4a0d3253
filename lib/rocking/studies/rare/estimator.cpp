#include "rocking/studies/rare/estimator.hpp"

#include <tuple>

#include "rocking/studies/rare/importance.hpp"
#include "rocking/studies/rare/twisted_run.hpp"
#include "rocking/studies/rare/typical_paths.hpp"

namespace rocking::rare {
namespace {

/// Of numbers that are drawn once.
class ImportanceEstimator final : public Estimator {
 public:
  ImportanceEstimator(const BlockPaths& paths, std::size_t particles)
      : paths_(&paths), points_(paths), plan_{.seed = paths.seed, .particles = particles}, search_(search()) {
    pilot_ = {.levels = search_.levels,
              .reached = search_.reached,
              .found_event = search_.end == SearchEnd::reached,
              .work = search_.work};
  }

  [[nodiscard]] RareMethod method() const override { return RareMethod::importance_sampling; }
  [[nodiscard]] const Pilot& pilot() const override { return pilot_; }
  [[nodiscard]] Repetition repeat(std::uint64_t repetition) const override {
    return repeat_importance(points_, plan_, search_.proposal, repetition);
  }
  [[nodiscard]] std::vector<KeptPath> paths_of(std::uint64_t repetition) const override {
    const std::vector<Point> points = points_of_repetition(plan_, search_.proposal, repetition);
    const std::vector<double> scores = points_.scores(points);
    std::vector<KeptPath> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (scores[i] != event_score) continue;
      kept.push_back({.number = 0,
                      .draws = given_draws(paths_->condition->scene, paths_->numbers.once, points[i]),
                      .weight = search_.proposal.likelihood_ratio(points[i])});
    }
    return kept;
  }

 private:
  [[nodiscard]] Search search() const {
    constexpr std::size_t least =
        10'000;  // particles: where the search misses a way to the event, the estimates have large errors
    ImportancePlan plan = plan_;
    plan.particles = std::max(plan.particles, least);
    return find_event(points_, plan, most_repetitions);
  }

  const BlockPaths* paths_;
  BlockPoints points_;
  ImportancePlan plan_;
  Search search_;
  Pilot pilot_;
};

/// Of numbers that are drawn along the way.
class TwistedEstimator final : public Estimator {
 public:
  TwistedEstimator(const BlockPaths& paths, std::size_t particles, unsigned threads)
      : paths_(&paths),
        particles_(particles),
        threads_(threads),
        plan_{.seed = paths.seed, .periods = paths.periods()},
        proposal_(paths.numbers.once.size()) {
    find_guide();
    if (is_plain_) sample_plainly();
  }

  [[nodiscard]] RareMethod method() const override {
    return is_plain_ ? RareMethod::plain_sampling : RareMethod::twisted_run;
  }
  [[nodiscard]] const Pilot& pilot() const override { return pilot_; }
  [[nodiscard]] Repetition repeat(std::uint64_t repetition) const override {
    BlockPopulation population(*paths_, plan_of(particles_, repetition));
    return TwistedRun(population, plan_, repetition).run();
  }
  [[nodiscard]] std::vector<KeptPath> paths_of(std::uint64_t repetition) const override {
    PopulationPlan keeping = plan_of(particles_, repetition);
    keeping.keeps_paths = true;
    BlockPopulation population(*paths_, keeping);
    static_cast<void>(TwistedRun(population, plan_, repetition).run());
    return population.kept();
  }
  [[nodiscard]] std::optional<CommittorMap> committor() const override {
    return guide_ ? std::optional(map_of(guide_->committor)) : std::nullopt;
  }

 private:
  static constexpr std::size_t pilot_particles = 1000;
  static constexpr std::size_t many = 25;  ///< of them with the event: the pilot runs would cost more than they gain
  static constexpr double margin = 1.05;

  [[nodiscard]] PopulationPlan plan_of(std::size_t particles, std::uint64_t repetition) const {
    return {.particles = particles,
            .repetition = repetition,
            .guide = guide_ ? &*guide_ : nullptr,
            .proposal = proposal(),
            .first_amplitude = first_amplitude_,
            .strobe_points = strobe_points_};
  }

  [[nodiscard]] const Proposal* proposal() const { return proposal_.dimensions() > 0 ? &proposal_ : nullptr; }

  /// From now on a repetition runs all particles by their own law to the horizon at once.
  void sample_plainly() {
    guide_.reset();
    first_amplitude_ = {};
    proposal_ = Proposal(proposal_.dimensions());
    plan_.periods = 1;
    strobe_points_ = paths_->periods();
  }

  /// Whether plain sampling would have a smaller variance in the same time as this run, which has the variance of its
  /// sums over first ancestors: these are nearly independent (Chan & Lai 2013).
  [[nodiscard]] static bool is_inferior(const Repetition& found, const TwistedRun<BlockPopulation>& run) {
    constexpr double cost = 2.0;  // of simulated time, since every particle stops in each period
    double squares = 0.0;
    double of_ancestor = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < run.found().size(); ++i) {
      of_ancestor += run.found()[i].weight;
      const bool is_last = i + 1 == run.found().size() || run.found()[i + 1].ancestor != run.found()[i].ancestor;
      if (!is_last) continue;
      squares += of_ancestor * of_ancestor;
      sum += of_ancestor;
      of_ancestor = 0.0;
    }
    return sum > 0.0 && cost * found.work * squares / (sum * sum) * found.estimate > 1.0;
  }

  /// The reach of a run, and whether it saw the event.
  SectionPoint run_pilot(std::uint64_t number) {
    const std::uint64_t repetition = most_repetitions + number;
    BlockPopulation population(*paths_, plan_of(pilot_particles, repetition));
    TwistedRun run(population, plan_, repetition);
    const Repetition found = run.run();
    pilot_.work += found.work;
    pilot_.found_event = found.estimate > 0.0;
    pilot_ancestors_ = found.ancestors;
    is_plain_ = number == 0 ? found.ancestors >= many : is_inferior(found, run);
    if (proposal() != nullptr) collect(population, run);
    return population.reach();
  }

  /// The numbers drawn once of the first ancestors of those that had the event.
  void collect(const BlockPopulation& population, const TwistedRun<BlockPopulation>& run) {
    std::optional<std::size_t> last;
    for (const auto& [ancestor, weight] : run.found()) {
      if (ancestor == last) {
        found_.back().weight += weight;
      } else {
        found_.push_back({population.drawn_at_first(ancestor), weight});
      }
      last = ancestor;
    }
  }

  [[nodiscard]] double effective_number_found() const {
    double sum = 0.0;
    double squares = 0.0;
    for (const WeightedPoint& point : found_) {
      sum += point.weight;
      squares += point.weight * point.weight;
    }
    return sum > 0.0 ? sum / squares * sum : 0.0;
  }

  /// Fits the proposal to the numbers drawn once of those that had the event in some pilot runs, until these are many
  /// different ones: the law in use does well then.
  void find_proposal(const SectionPoint& reach, std::uint64_t number) {
    constexpr int rounds = 5;
    constexpr int runs = 8;
    constexpr double enough = 30.0;
    constexpr double least_width = 0.5;  // what is drawn along the way blurs where the event happens
    for (int round = 0; round < rounds; ++round) {
      found_.clear();
      for (int i = 0; i < runs; ++i) run_pilot(number++);
      if (effective_number_found() >= enough) break;
      proposal_ = found_.empty() ? Proposal::about_mean(proposal_.dimensions(), wide)
                                 : Proposal::fitted_to(std::move(found_), proposal_.dimensions(), least_width);
      make_guide(reach, true);
    }
  }

  static constexpr std::uint64_t coarse_grids = 3;
  static constexpr double wide = 2.0;  ///< of the law of numbers drawn once with which an event is sought
  static constexpr double least_reach = 0.1;

  /// How far motions go that have the event, by coarse grids.
  [[nodiscard]] SectionPoint find_reach(SectionPoint reach, std::uint64_t number) {
    for (std::uint64_t i = 0; i < coarse_grids; ++i) {
      make_guide(reach, false);
      const SectionPoint seen = run_pilot(number + i);
      const SectionPoint next{.tilt = std::max(least_reach, margin * seen.tilt),
                              .tilt_rate = std::max(least_reach, margin * seen.tilt_rate),
                              .slip_rate = margin * seen.slip_rate};
      const bool is_found = fits(next.tilt, reach.tilt) && fits(next.tilt_rate, reach.tilt_rate);
      reach = next;
      if (is_found) break;
    }
    return reach;
  }

  /// Coarse grids find the reach, a fine one steers the repetitions.
  void find_guide() {
    const SectionPoint seen = run_pilot(0);
    if (is_plain_) return;
    const SectionPoint farthest{.tilt = std::max(1.3, 1.5 * seen.tilt),
                                .tilt_rate = std::max(least_reach, 1.5 * seen.tilt_rate),
                                .slip_rate = 1.5 * seen.slip_rate};
    SectionPoint reach = find_reach(farthest, 1);
    if (proposal() != nullptr && !pilot_.found_event) {
      proposal_ = Proposal::about_mean(proposal_.dimensions(), wide);
      guide_.reset();
      reach = find_reach(farthest, coarse_grids + 2);
    }
    make_guide(reach, true);
    run_pilot(coarse_grids + 1);
    if (proposal() != nullptr) return find_proposal(reach, 2 * coarse_grids + 2);
    for (std::uint64_t i = 1; i <= new_grids && pilot_ancestors_ < few; ++i) draw_anew(farthest, new_grid_pilots * i);
  }

  static constexpr std::size_t few = 20;  ///< first ancestors in a pilot run: those of a good grid are 40 to 160
  static constexpr std::uint64_t new_grids = 3;
  static constexpr std::uint64_t new_grid_pilots = 100;  ///< numbers of the pilot runs of a grid that is drawn anew

  /// Another reach by other pilot runs, which stays in force where its grid has more first ancestors.
  void draw_anew(const SectionPoint& farthest, std::uint64_t number) {
    std::optional<Guide> guide = std::move(guide_);
    const auto before = std::tuple(first_amplitude_, is_plain_, pilot_.found_event, pilot_ancestors_);
    make_guide(find_reach(farthest, number), true);
    run_pilot(number + coarse_grids);
    if (pilot_ancestors_ > std::get<std::size_t>(before)) return;
    guide_ = std::move(guide);
    std::tie(first_amplitude_, is_plain_, pilot_.found_event, pilot_ancestors_) = before;
  }

  /// Fine within the reach, and coarse from there to where a falling block has overturned.
  [[nodiscard]] SectionGrid grid_of(const SectionPoint& reach, bool is_fine) const {
    constexpr double half_pi = 0x1.921fb54442d18p+0;
    const double overturned = half_pi / dynamics::geometry_of(mean_block(paths_->condition->scene)).shape_angle;
    constexpr double least_slip_rate = 1e-3;
    const bool slips = reach.slip_rate > least_slip_rate;
    const std::size_t inner = !is_fine ? 12 : slips ? 17 : 34;
    const std::size_t outer = !is_fine || slips ? 3 : 6;
    const double farthest =
        paths_->event.name == EventName::tilt ? std::min(overturned, paths_->event.threshold) : overturned;
    return {{.inner = reach.tilt,
             .outer = std::max(farthest, 1.2 * reach.tilt),
             .inner_cells = inner,
             .outer_cells = outer},
            {.inner = reach.tilt_rate, .outer = 3.0 * reach.tilt_rate, .inner_cells = inner, .outer_cells = outer},
            slips ? std::optional(SectionAxis{.inner = reach.slip_rate,
                                              .outer = 2.0 * reach.slip_rate,
                                              .inner_cells = is_fine ? 4U : 2U,
                                              .outer_cells = 1})
                  : std::nullopt};
  }

  [[nodiscard]] static bool fits(double wanted, double reach) { return wanted <= reach && wanted >= 0.7 * reach; }

  void make_guide(const SectionPoint& reach, bool is_fine) {
    const bool is_periodic = periods_of_base(paths_->condition->scene) == 1;
    const SectionGrid grid = grid_of(reach, is_periodic && is_fine);
    const std::size_t samples = is_periodic && redraws_amplitude(paths_->condition->scene) ? 17 : 8;
    std::vector<Transitions> transitions;
    const std::int64_t last = is_periodic ? 1 : std::max<std::int64_t>(1, paths_->periods() - 1);
    for (std::int64_t k = 1; k <= last; ++k) {
      transitions.push_back(transitions_of(*paths_, grid, is_periodic ? 0 : k, samples, threads_, proposal()));
    }
    pilot_.work +=
        static_cast<double>(grid.size() * samples * transitions.size()) / static_cast<double>(paths_->periods());
    guide_.reset();
    guide_.emplace(
        Guide{.committor = Committor(grid, transitions, paths_->periods(), [this] { paths_->halt.check(); })});
    guide_->least = least_score();
  }

  /// A part of the mean of h over the beginnings of trajectories; from these also the law of their amplitudes.
  [[nodiscard]] double least_score() {
    constexpr double part = 0.03;
    constexpr double smallest = 1e-30;
    first_amplitude_ = {.mean = 0.0, .width = 2.5};
    BlockPopulation population(*paths_, plan_of(pilot_particles, most_repetitions));
    pilot_.work += population.work();
    double mean = 0.0;
    NormalFit fit;
    for (std::size_t i = 0; i < population.size(); ++i) {
      const double of_once = proposal() == nullptr ? 1.0 : proposal_.likelihood_ratio(population.drawn_at_first(i));
      const bool is_over = population.fate(i) == Image::Fate::event;
      const double h =
          population.likelihood_ratio(i) / of_once * (is_over ? 1.0 : guide_->committor(1, population.point(i)));
      mean += h;
      fit.add(h, population.first_amplitude(i));
    }
    first_amplitude_ = fit.law();
    return std::max(smallest, part * mean / static_cast<double>(population.size()));
  }

  const BlockPaths* paths_;
  std::size_t particles_;
  unsigned threads_;
  TwistedPlan plan_;
  std::optional<Guide> guide_;
  std::int64_t strobe_points_ = 1;    ///< as that of PopulationPlan
  bool is_plain_ = false;             ///< what the last pilot run says
  NormalLaw first_amplitude_;         ///< with which it is drawn
  Proposal proposal_;                 ///< of the numbers drawn once
  std::size_t pilot_ancestors_ = 0;   ///< first ancestors in the last pilot run
  std::vector<WeightedPoint> found_;  ///< those of pilot runs that had the event
  Pilot pilot_;
};

}  // namespace

RareMethod method_of(const Scene& scene) {
  return drawn_numbers(scene).along_the_way ? RareMethod::twisted_run : RareMethod::importance_sampling;
}

std::unique_ptr<Estimator> estimator_of(const BlockPaths& paths, std::size_t particles, unsigned threads) {
  if (paths.numbers.along_the_way) return std::make_unique<TwistedEstimator>(paths, particles, threads);
  return std::make_unique<ImportanceEstimator>(paths, particles);
}

}  // namespace rocking::rare
