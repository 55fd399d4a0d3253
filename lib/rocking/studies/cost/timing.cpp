#include "rocking/studies/cost/cost.hpp"

#include <algorithm>
#include <mutex>

#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/work_list.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/stats/quantile.hpp"
#include "rocking/studies/cost/measurement.hpp"

namespace rocking {
namespace {

/// A round measures the time of this many realisations, run together.
struct RoundSize {
  int periods;  ///< of the longest horizon; the others in proportion
  std::uint64_t realisations;

  [[nodiscard]] double work() const { return static_cast<double>(periods) * static_cast<double>(realisations); }
};

/// Enough to fill the widest lanes. With more realisations the partly filled lanes at the end of a round count less.
constexpr RoundSize smallest_round{.periods = 16, .realisations = 96};
constexpr std::uint64_t most_realisations = 768;
/// Rounds of a size on each thread; the median of three excludes a disturbance by other processes.
constexpr int wanted_rounds = 3;
/// Rounds of the largest size; more would not change the median much.
constexpr std::size_t most_rounds = 9;

int longest_horizon(const Experiment& experiment) {
  std::int64_t longest = 0;
  for (const Condition& condition : experiment.conditions) {
    longest = std::max(longest, condition.horizon.periods());
  }
  return static_cast<int>(longest);
}

/// Realisations per thread of the run.
std::uint64_t realisations_of(const Experiment& experiment, unsigned threads) {
  std::uint64_t all = 0;
  for (const Condition& condition : experiment.conditions) all += effective_realisations(condition);
  return std::max<std::uint64_t>(all / threads, 1);
}

class Timekeeper {
 public:
  Timekeeper(const Experiment& experiment, std::span<const double> tolerances, const TimingPlan& plan,
             const RunOptions& options)
      : experiment_(&experiment),
        tolerances_(tolerances),
        plan_(&plan),
        options_(&options),
        threads_(std::max(1U, options.threads)),
        sample_(experiment),
        largest_{longest_horizon(experiment), std::min(realisations_of(experiment, threads_), most_realisations)},
        size_(largest_),
        times_(tolerances.size()) {}

  [[nodiscard]] CostTiming run() {
    base::on_threads(
        threads_,
        [this](unsigned thread) {
          try {
            take_times(thread);
          } catch (const base::Stopped&) {
            // The rounds of this thread are incomplete, so none is kept.
          }
        },
        [] {});
    CostTiming timing{.seconds_per_period = {}, .realisations = size_.realisations, .periods = size_.periods};
    for (const std::vector<double>& times : times_) {
      timing.seconds_per_period.push_back(stats::lower_median(times).value_or(0.0));
    }
    return timing;
  }

 private:
  /// By tolerance.
  using Round = std::vector<double>;

  /// Runs rounds. They grow as long as there is time for some of the next size.
  void take_times(unsigned thread) {
    RoundSize size{.periods = std::min(smallest_round.periods, largest_.periods),
                   .realisations = std::min(smallest_round.realisations, largest_.realisations)};
    std::vector<Round> rounds;
    for (std::uint64_t number = thread;; number += threads_) {
      const double left_before = plan_->seconds_left();
      rounds.push_back(time_round(number, size));
      const double left = plan_->seconds_left();
      const double took = left_before - left;
      const RoundSize larger = larger_than(size);
      if (larger.work() > size.work() && wanted_rounds * took * larger.work() / size.work() <= left) {
        size = larger;
        rounds.clear();
      } else if (took > left || rounds.size() == most_rounds) {
        return keep(rounds, size);
      }
    }
  }

  /// The horizon grows first, because the omitted part of a horizon may take more time.
  [[nodiscard]] RoundSize larger_than(const RoundSize& size) const {
    if (size.periods < largest_.periods) return {std::min(2 * size.periods, largest_.periods), size.realisations};
    return {size.periods, std::min(2 * size.realisations, largest_.realisations)};
  }

  [[nodiscard]] Round time_round(std::uint64_t number, const RoundSize& size) const {
    Round round;
    for (const double tolerance : tolerances_) {
      std::vector<Condition> conditions = experiment_->conditions;
      for (Condition& condition : conditions) {
        condition.tolerance = tolerance;
        condition.horizon = shortened(condition.horizon, static_cast<double>(size.periods) / largest_.periods);
      }
      round.push_back(time_realisations(conditions, number * size.realisations, size.realisations));
    }
    return round;
  }

  /// Processor time per period of `count` realisations of the sample from `first` on; a finite sample is repeated.
  [[nodiscard]] double time_realisations(const std::vector<Condition>& conditions, std::uint64_t first,
                                         std::uint64_t count) const {
    std::uint64_t periods = 0;
    const double before = plan_->processor_seconds();
    RealisationScheduler scheduler(experiment_->seed, options_->lanes, options_->stop_requested);
    for (std::uint64_t next = 0; next < count || !scheduler.is_idle();) {
      options_->stop_requested.check();
      for (; next < count && scheduler.wants_more(); ++next) {
        const std::uint64_t index = first + next;
        const RealisationKey key = sample_.at(sample_.size() ? index % *sample_.size() : index);
        scheduler.start({&conditions[key.condition], key.realisation}, next);
      }
      for (const auto& [id, record] : scheduler.work()) periods += record.strobe.size();
    }
    const double seconds = plan_->processor_seconds() - before;
    return periods == 0 ? 0.0 : seconds / static_cast<double>(periods);
  }

  void keep(const std::vector<Round>& rounds, const RoundSize& size) {
    const std::lock_guard lock(mutex_);
    for (const Round& round : rounds) {
      for (std::size_t i = 0; i < round.size(); ++i) times_[i].push_back(round[i]);
    }
    if (size.work() < size_.work()) size_ = size;
  }

  const Experiment* experiment_;
  std::span<const double> tolerances_;
  const TimingPlan* plan_;
  const RunOptions* options_;
  unsigned threads_;
  CostSample sample_;
  RoundSize largest_;
  std::mutex mutex_;
  RoundSize size_;                          ///< the smallest size of the rounds kept
  std::vector<std::vector<double>> times_;  ///< of the rounds kept on all threads, for each tolerance
};

}  // namespace

CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances, const TimingPlan& plan,
                     const RunOptions& options) {
  check_experiment(experiment);
  return Timekeeper(experiment, tolerances, plan, options).run();
}

}  // namespace rocking
