#include "rocking/experiment/cost_timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <optional>
#include <ranges>

#include "rocking/base/on_threads.hpp"
#include "rocking/experiment/cost_sample.hpp"
#include "rocking/experiment/realisation_crew.hpp"
#include "rocking/experiment/work.hpp"

namespace rocking::experiment {
namespace {

/// Several times as many as are advanced side by side on the widest lanes.
constexpr std::uint64_t most_in_round = 384;
constexpr int fewest_periods = 16;

int periods_of(const Horizon& horizon) { return horizon.transient_periods + horizon.sampled_periods; }

int longest_horizon(const Experiment& experiment) {
  const auto periods = [](const Condition& condition) { return periods_of(condition.horizon); };
  return std::ranges::max(experiment.conditions | std::views::transform(periods));
}

/// Parts of the horizon in proportion; something is sampled.
Horizon shortened(const Horizon& horizon, double share) {
  const auto part = [share](int periods) { return static_cast<int>(std::lround(share * periods)); };
  return {.transient_periods = part(horizon.transient_periods),
          .sampled_periods = std::max(1, part(horizon.sampled_periods))};
}

/// Of some realisations at one tolerance.
struct TimedPeriods {
  double seconds = 0.0;
  std::uint64_t periods = 0;
};

/// By tolerance.
struct Round {
  std::vector<TimedPeriods> tolerances;
  int periods = 0;  ///< of the longest horizon

  void add(const Round& other) {
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      tolerances[i].seconds += other.tolerances[i].seconds;
      tolerances[i].periods += other.tolerances[i].periods;
    }
  }
};

class Timekeeper {
 public:
  Timekeeper(const Experiment& experiment, std::span<const double> tolerances, const TimingPlan& plan,
             const RunOptions& options)
      : experiment_(&experiment),
        tolerances_(tolerances),
        plan_(&plan),
        options_(&options),
        sample_(experiment),
        threads_(std::max(1U, options.threads)),
        longest_(longest_horizon(experiment)) {
    std::uint64_t all = 0;
    for (const Condition& condition : experiment.conditions) all += effective_realisations(condition);
    in_round_ = std::clamp<std::uint64_t>(all / threads_, 1, most_in_round);
  }

  [[nodiscard]] CostTiming run() {
    base::on_threads(
        threads_, [this](unsigned thread) { keep(time_on(thread)); }, [] {});
    CostTiming timing{.seconds_per_period = {}, .realisations = in_round_, .periods = all_.periods};
    for (const auto& [seconds, periods] : all_.tolerances) {
      timing.seconds_per_period.push_back(periods == 0 ? 0.0 : seconds / static_cast<double>(periods));
    }
    return timing;
  }

 private:
  /// All rounds of the last length.
  [[nodiscard]] Round time_on(unsigned thread) const {
    Round last{.tolerances = std::vector<TimedPeriods>(tolerances_.size())};
    int periods = std::min(fewest_periods, longest_);
    for (std::uint64_t number = thread;; number += threads_) {
      const double left_before = plan_->seconds_left();
      const auto round = time_round(number, periods);
      if (!round) return last;
      if (last.periods == periods) {
        last.add(*round);
      } else {
        last = *round;
      }
      const double left = plan_->seconds_left();
      const int next = std::min(2 * periods, longest_);
      if ((left_before - left) * next / periods > left) return last;
      periods = next;
    }
  }

  [[nodiscard]] std::optional<Round> time_round(std::uint64_t number, int periods) const {
    Round round{.tolerances = {}, .periods = periods};
    for (const double tolerance : tolerances_) {
      std::vector<Condition> conditions = experiment_->conditions;
      for (Condition& condition : conditions) {
        condition.tolerance = tolerance;
        condition.horizon = shortened(condition.horizon, static_cast<double>(periods) / longest_);
      }
      const auto timed = time_realisations(conditions, number * in_round_);
      if (!timed) return std::nullopt;
      round.tolerances.push_back(*timed);
    }
    return round;
  }

  /// `first`: the first of them in the sample. Where that has an end, it begins anew.
  [[nodiscard]] std::optional<TimedPeriods> time_realisations(const std::vector<Condition>& conditions,
                                                              std::uint64_t first) const {
    TimedPeriods timed;
    const double before = plan_->processor_seconds();
    RealisationCrew crew(experiment_->seed, options_->lanes);
    for (std::uint64_t next = 0; next < in_round_ || !crew.is_idle();) {
      if (options_->stop_requested != nullptr && options_->stop_requested->load()) return std::nullopt;
      for (; next < in_round_ && crew.wants_more(); ++next) {
        const std::uint64_t place = first + next;
        const RealisationKey key = sample_.at(sample_.size() ? place % *sample_.size() : place);
        crew.start({&conditions[key.condition], key.realisation}, next);
      }
      for (const auto& [ticket, record] : crew.work()) timed.periods += record.strobe.size();
    }
    timed.seconds = plan_->processor_seconds() - before;
    return timed;
  }

  void keep(const Round& round) {
    const std::lock_guard lock(mutex_);
    if (all_.tolerances.empty()) {
      all_ = round;
      return;
    }
    all_.add(round);
    all_.periods = std::min(all_.periods, round.periods);
  }

  const Experiment* experiment_;
  std::span<const double> tolerances_;
  const TimingPlan* plan_;
  const RunOptions* options_;
  CostSample sample_;
  unsigned threads_;
  int longest_;
  std::uint64_t in_round_ = 0;
  std::mutex mutex_;
  Round all_;  ///< of all threads
};

}  // namespace

CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances, const TimingPlan& plan,
                     const RunOptions& options) {
  return Timekeeper(experiment, tolerances, plan, options).run();
}

}  // namespace rocking::experiment
