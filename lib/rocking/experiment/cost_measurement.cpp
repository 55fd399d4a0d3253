#include "rocking/experiment/cost_measurement.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/on_threads.hpp"
#include "rocking/experiment/cost_sample.hpp"
#include "rocking/experiment/job_crew.hpp"

namespace rocking::experiment {
namespace {

double largest_of(const section::StrobePoint& point) {
  return std::max({std::abs(point.tilt), std::abs(point.tilt_rate), std::abs(point.slip_rate)});
}

double distance(const section::StrobePoint& a, const section::StrobePoint& b) {
  return largest_of({a.tilt - b.tilt, a.tilt_rate - b.tilt_rate, a.slip_rate - b.slip_rate});
}

/// A realisation under way at all tolerances. Stays where it is: its tasks point into it.
class CostJob {
 public:
  CostJob(const Condition& condition, std::span<const double> tolerances, std::uint64_t index,
          const RealisationKey& key)
      : index_(index), key_(key), conditions_(tolerances.size(), condition), records_(tolerances.size()) {
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      conditions_[i].tolerance = tolerances[i];
      tasks_.push_back({.condition = &conditions_[i], .realisation = key.realisation});
    }
    open_ = tasks_.size();
  }
  CostJob(const CostJob&) = delete;
  CostJob& operator=(const CostJob&) = delete;

  /// In the sample.
  [[nodiscard]] std::uint64_t index() const { return index_; }
  [[nodiscard]] std::span<const Task> tasks() const { return tasks_; }

  bool accept(std::size_t task, Record record) {
    records_[task] = std::move(record);
    return --open_ == 0;
  }

  /// Once all is accepted.
  [[nodiscard]] MeasuredRealisation measured() const {
    MeasuredRealisation measured{.key = key_, .runs = {}};
    const Record& reference = records_.back();
    for (const Record& record : records_) {
      ToleranceRun& run = measured.runs.emplace_back();
      run.mode = record.verdict.mode;
      run.periods = record.strobe.size();
      run.steps = record.effort.steps;
      if (&record == &reference) break;
      run.error = error_beside(record, reference);
      run.parted = parting_period(record, reference).has_value();
    }
    return measured;
  }

 private:
  std::uint64_t index_;
  RealisationKey key_;
  std::vector<Condition> conditions_;  ///< by tolerance
  std::vector<Task> tasks_;
  std::vector<Record> records_;
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
    JobCrew<CostJob> crew(experiment_->seed, options_->lanes, options_->stop_requested);
    try {
      work_with(crew);
    } catch (const base::Stopped&) {
      // run() looks at the request itself.
    }
  }

  void work_with(JobCrew<CostJob>& crew) {
    while (true) {
      while (crew.wants_more()) {
        const auto index = next(crew.is_idle());
        if (!index) break;
        const RealisationKey key = sample_.at(*index);
        crew.start(std::make_unique<CostJob>(experiment_->conditions[key.condition], plan_->tolerances, *index, key));
      }
      if (crew.is_idle() || has_failed_ || options_->stop_requested.is_made()) return;
      for (const auto& job : crew.work()) accept(*job);
    }
  }

  // What is under way is finished when there are enough. So a thread that has something to do takes more only while that is
  // little beside what is done.
  [[nodiscard]] std::optional<std::uint64_t> next(bool is_idle) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t taken = measured_.size();
    if (taken == all_ || (taken > 0 && plan_->is_enough && plan_->is_enough())) return std::nullopt;
    if (!is_idle && 2 * (taken - done_) > done_) return std::nullopt;
    measured_.emplace_back();
    return taken;
  }

  void accept(const CostJob& job) {
    MeasuredRealisation measured = job.measured();
    const std::lock_guard lock(mutex_);
    measured_[job.index()] = std::move(measured);
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

std::optional<double> error_beside(const Record& record, const Record& reference) {
  const auto most = static_cast<std::size_t>(cost_error_periods);
  const std::size_t common = std::min({most, record.strobe.size(), reference.strobe.size()});
  double error = 0.0;
  double motion = 0.0;
  for (std::size_t k = 0; k < common; ++k) {
    error = std::max(error, distance(record.strobe[k], reference.strobe[k]));
    motion = std::max(motion, largest_of(reference.strobe[k]));
  }
  if (motion == 0.0) return std::nullopt;
  return error;
}

std::vector<MeasuredRealisation> measure_cost(const Experiment& experiment, const CostPlan& plan,
                                              const RunOptions& options) {
  ROCKING_EXPECT(plan.sample > 0);
  ROCKING_EXPECT(plan.tolerances.size() >= 3);
  ROCKING_EXPECT(std::ranges::is_sorted(plan.tolerances, std::ranges::greater_equal{}));
  return CostWorkers(experiment, plan, options).run();
}

}  // namespace rocking::experiment
