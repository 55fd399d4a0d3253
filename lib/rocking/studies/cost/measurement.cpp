#include "rocking/studies/cost/measurement.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/group_scheduler.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {
namespace {

std::size_t reversed_bits(std::size_t number, std::size_t bits) {
  std::size_t reversed = 0;
  for (std::size_t i = 0; i < bits; ++i) reversed |= ((number >> i) & 1U) << (bits - 1 - i);
  return reversed;
}

}  // namespace

CostSample::CostSample(const Experiment& experiment) {
  const std::size_t conditions = experiment.conditions.size();
  const auto bits = static_cast<std::size_t>(std::bit_width(conditions - 1));
  for (std::size_t i = 0; i < std::bit_ceil(conditions); ++i) {
    const std::size_t condition = reversed_bits(i, bits);
    if (condition >= conditions) continue;
    all_.push_back(condition);
    if (is_random(experiment.conditions[condition].scene)) random_.push_back(condition);
  }
}

std::optional<std::uint64_t> CostSample::size() const {
  if (random_.empty()) return all_.size();
  return std::nullopt;
}

RealisationKey CostSample::at(std::uint64_t index) const {
  if (index < all_.size()) return {.condition = all_[index], .realisation = index};
  ROCKING_EXPECT(!random_.empty());
  return {.condition = random_[(index - all_.size()) % random_.size()], .realisation = index};
}

namespace {

double largest_of(const section::StrobePoint& point) {
  return std::max({std::abs(point.tilt), std::abs(point.tilt_rate), std::abs(point.slip_rate)});
}

/// A realisation in progress at all tolerances. It must not move, because its runs point into it.
class MeasurementInProgress {
 public:
  MeasurementInProgress(const Condition& condition, std::span<const double> tolerances, std::uint64_t index,
                        const RealisationKey& key)
      : index_(index), key_(key), conditions_(tolerances.size(), condition), results_(tolerances.size()) {
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      conditions_[i].tolerance = tolerances[i];
      runs_.push_back({.condition = &conditions_[i], .realisation = key.realisation});
    }
    open_ = runs_.size();
  }
  MeasurementInProgress(const MeasurementInProgress&) = delete;
  MeasurementInProgress& operator=(const MeasurementInProgress&) = delete;

  /// Index in the sample.
  [[nodiscard]] std::uint64_t index() const { return index_; }
  [[nodiscard]] std::span<const RequestedRun> runs() const { return runs_; }

  bool accept(std::size_t run, RealisationResult result) {
    results_[run] = std::move(result);
    return --open_ == 0;
  }

  /// Once all is accepted.
  [[nodiscard]] MeasuredRealisation measured() const {
    MeasuredRealisation measured{.key = key_, .runs = {}};
    const RealisationResult& reference = results_.back();
    for (const RealisationResult& result : results_) {
      ToleranceRun& run = measured.runs.emplace_back();
      run.mode = result.classification.mode;
      run.periods = result.strobe.size();
      run.steps = result.operations.steps;
      if (&result == &reference) break;
      run.error = error_beside(result, reference);
      run.diverged = divergence_period(result, reference).has_value();
    }
    return measured;
  }

 private:
  std::uint64_t index_;
  RealisationKey key_;
  std::vector<Condition> conditions_;  ///< by tolerance
  std::vector<RequestedRun> runs_;
  std::vector<RealisationResult> results_;
  std::size_t open_ = 0;
};

class CostWorkers {
 public:
  CostWorkers(const Experiment& experiment, const CostPlan& plan, const RunOptions& options)
      : experiment_(&experiment), plan_(&plan), options_(&options), sample_(experiment) {
    all_ = std::min(plan.sample, sample_.size().value_or(plan.sample));
  }

  [[nodiscard]] std::vector<MeasuredRealisation> run() {
    base::on_threads(
        options_->threads, [this](unsigned) { work(); }, [this] { has_failed_ = true; });
    if (options_->stop_requested.is_made()) return {};
    return std::move(measured_);
  }

 private:
  void work() {
    GroupScheduler<MeasurementInProgress> scheduler(experiment_->seed, options_->lanes, options_->stop_requested);
    try {
      work_with(scheduler);
    } catch (const base::Stopped&) {
      // run() looks at the request itself.
    }
  }

  void work_with(GroupScheduler<MeasurementInProgress>& scheduler) {
    while (true) {
      while (scheduler.wants_more()) {
        const auto index = next(scheduler.is_idle());
        if (!index) break;
        const RealisationKey key = sample_.at(*index);
        scheduler.start(std::make_unique<MeasurementInProgress>(experiment_->conditions[key.condition],
                                                                plan_->tolerances, *index, key));
      }
      if (scheduler.is_idle() || has_failed_ || options_->stop_requested.is_made()) return;
      for (const auto& group : scheduler.work()) accept(*group);
    }
  }

  // Realisations in progress are finished when there are enough. So a busy thread takes more only while their number is
  // small compared with those done.
  [[nodiscard]] std::optional<std::uint64_t> next(bool is_idle) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t taken = measured_.size();
    if (taken == all_ || (taken > 0 && plan_->is_enough && plan_->is_enough())) return std::nullopt;
    if (!is_idle && 2 * (taken - done_) > done_) return std::nullopt;
    measured_.emplace_back();
    return taken;
  }

  void accept(const MeasurementInProgress& group) {
    MeasuredRealisation measured = group.measured();
    const std::lock_guard lock(mutex_);
    measured_[group.index()] = std::move(measured);
    ++done_;
    if (options_->on_progress) options_->on_progress(done_, all_);
  }

  const Experiment* experiment_;
  const CostPlan* plan_;
  const RunOptions* options_;
  CostSample sample_;
  std::uint64_t all_ = 0;
  std::mutex mutex_;
  std::vector<MeasuredRealisation> measured_;  ///< those taken, in the order of the sample
  std::uint64_t done_ = 0;
  std::atomic<bool> has_failed_ = false;
};

}  // namespace

std::optional<double> error_beside(const RealisationResult& result, const RealisationResult& reference) {
  const auto most = static_cast<std::size_t>(cost_error_periods);
  const std::size_t common = std::min({most, result.strobe.size(), reference.strobe.size()});
  double error = 0.0;
  double motion = 0.0;
  for (std::size_t k = 0; k < common; ++k) {
    error = std::max(error, distance(result.strobe[k], reference.strobe[k]));
    motion = std::max(motion, largest_of(reference.strobe[k]));
  }
  if (motion == 0.0) return std::nullopt;
  return error;
}

std::vector<MeasuredRealisation> measure_cost(const Experiment& experiment, const CostPlan& plan,
                                              const RunOptions& options) {
  check_experiment(experiment);
  ROCKING_EXPECT(plan.sample > 0);
  ROCKING_EXPECT(plan.tolerances.size() >= 3);
  ROCKING_EXPECT(std::ranges::is_sorted(plan.tolerances, std::ranges::greater_equal{}));
  return CostWorkers(experiment, plan, options).run();
}

}  // namespace rocking
