#pragma once

#include <memory>

#include "rocking/realisation/lockstep.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/studies/rare/committor.hpp"
#include "rocking/studies/rare/proposal.hpp"
#include "rocking/studies/rare/question.hpp"
#include "rocking/studies/rare/stream.hpp"

namespace rocking::rare {

/// What steers a run: the committor of a condition.
struct Guide {
  Committor committor;
  double least = 0.0;  ///< > 0: what h is taken to be where it is smaller

  /// max(h, least)^(7/8): a little less than h, since the grid has errors.
  [[nodiscard]] double score(std::int64_t k, const SectionPoint& point) const;
};

/// What the trajectories of one condition have in common. The condition must outlive it.
struct BlockPaths {
  const Condition* condition;
  std::uint64_t seed;
  ResponseEvent event;
  Halt halt;
  DrawnNumbers numbers = drawn_numbers(condition->scene);
  /// Called by any thread with the simulated time since it called last, in realisations to the horizon.
  std::function<void(double work)> on_work = {};

  [[nodiscard]] std::int64_t periods() const { return condition->horizon.periods(); }
  void note_work(double work) const {
    if (on_work) on_work(work);
  }
};

/// Whether the amplitude of the excitation is drawn again at each period.
[[nodiscard]] bool redraws_amplitude(const Scene& scene);

/// Where motions are a period after strobe point k, from each node of the grid, `samples` from each. Where the
/// amplitude of each period is drawn, a sample has a given one, at equal distances within six standard deviations of
/// its normal number; all else is drawn. `k` = 0 stands for every strobe point of a periodic excitation. On several
/// threads. Numbers drawn once come from the proposal; null: from their own law.
[[nodiscard]] Transitions transitions_of(const BlockPaths& paths, const SectionGrid& grid, std::int64_t k,
                                         std::size_t samples, unsigned threads, const Proposal* proposal = nullptr);

/// The trajectories of a condition in which all is drawn once. Models rare::PointModel.
class BlockPoints {
 public:
  /// Throws as Halt::check.
  explicit BlockPoints(const BlockPaths& paths) : paths_(&paths) {}

  [[nodiscard]] std::size_t dimensions() const { return paths_->numbers.once.size(); }
  /// What the threshold is compared with: the largest abs(Theta), or slip [m].
  [[nodiscard]] std::vector<double> scores(const std::vector<Point>& points) const;

 private:
  const BlockPaths* paths_;
};

/// What makes a trajectory with the event again, and its weight.
struct KeptPath {
  std::uint64_t number = 0;
  random::DrawHistory draws;
  double weight = 0.0;
};

/// How a population is made.
struct PopulationPlan {
  std::size_t particles = 0;
  std::uint64_t repetition = 0;
  const Guide* guide = nullptr;        ///< null: all scores are 1
  const Proposal* proposal = nullptr;  ///< of the numbers drawn once; null: their own law
  NormalLaw first_amplitude = {};      ///< with which that before strobe point 1 is drawn, if it is drawn each period
  bool keeps_paths = false;
  std::int64_t strobe_points = 1;  ///< to which motions run at first
};

/// Motions of a condition with draws along the way, from their start on. Models rare::Population.
class BlockPopulation {
 public:
  /// At the strobe point of the plan each. Functions throw as Halt::check. The paths and what the plan refers to must outlive it.
  BlockPopulation(const BlockPaths& paths, const PopulationPlan& plan);

  [[nodiscard]] std::size_t size() const { return particles_.size(); }
  [[nodiscard]] double likelihood_ratio(std::size_t i) const { return particles_[i].likelihood_ratio; }
  [[nodiscard]] Image::Fate fate(std::size_t i) const;
  [[nodiscard]] double score(std::int64_t k, std::size_t i);
  [[nodiscard]] double work() const { return work_; }
  /// The largest abs(Theta), abs(Theta') and abs(V) for which a score was asked while h was below 0.9.
  [[nodiscard]] const SectionPoint& reach() const { return reach_; }
  [[nodiscard]] SectionPoint point(std::size_t i) const;
  /// The normal number of its amplitude before strobe point 1.
  [[nodiscard]] double first_amplitude(std::size_t i) const;
  /// The numbers that particle i had drawn at first; empty without a proposal.
  [[nodiscard]] const Point& drawn_at_first(std::size_t i) const { return drawn_at_first_[i]; }
  void branch(std::size_t i, std::size_t parent, const Stream& stream);
  void leave(std::size_t i) { particles_[i].has_left = true; }
  void note_event(std::size_t i, double weight) {
    if (plan_.keeps_paths) kept_.push_back({particles_[i].number, *particles_[i].history, weight});
  }
  /// Those that had the event, in the order in which they left.
  [[nodiscard]] const std::vector<KeptPath>& kept() const { return kept_; }
  void advance();

 private:
  /// The draws of `number`, except those of its history, to which the motion refers.
  struct Particle {
    std::uint64_t number = 0;
    std::unique_ptr<random::DrawHistory> history;
    std::unique_ptr<StrobedMotion> motion;
    /// Factor of the scores for the numbers drawn once: their likelihood ratio to the power -3/4, since the event is
    /// likely where the proposal has much more than their own law.
    double first_score = 1.0;
    double likelihood_ratio = 1.0;  ///< of what was drawn last
    bool has_left = false;
  };

  [[nodiscard]] Particle begin(std::size_t i, SharedExcitation& excitation);
  [[nodiscard]] bool draw_amplitude(Particle& particle, std::int64_t period, const NormalLaw& law) const;
  void run(const std::vector<StrobedMotion*>& motions);

  const BlockPaths* paths_;
  PopulationPlan plan_;
  Lockstep lanes_;
  std::vector<Particle> particles_;
  std::vector<KeptPath> kept_;
  std::vector<Point> drawn_at_first_;
  SectionPoint reach_;
  std::int64_t strobe_point_ = 1;
  double work_ = 0.0;
};

}  // namespace rocking::rare
