#include "rocking/experiment/cost_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "rocking/base/error.hpp"
#include "rocking/experiment/cost_sample.hpp"

namespace rocking::experiment {
namespace {

double largest_of(const section::StrobePoint& point) {
  return std::max({std::abs(point.tilt), std::abs(point.tilt_rate), std::abs(point.slip_rate)});
}

double distance(const section::StrobePoint& a, const section::StrobePoint& b) {
  return largest_of({a.tilt - b.tilt, a.tilt_rate - b.tilt_rate, a.slip_rate - b.slip_rate});
}

class CostWorkers {
 public:
  CostWorkers(const Experiment& experiment, const CostPlan& plan, const CostTools& tools, const RunOptions& options)
      : experiment_(&experiment), plan_(&plan), tools_(&tools), options_(&options), sample_(experiment) {
    all_ = std::min(plan.sample, sample_.size().value_or(plan.sample));
  }

  [[nodiscard]] std::vector<MeasuredRealisation> run() {
    {
      std::vector<std::jthread> others;
      for (unsigned i = 1; i < std::max(1U, options_->threads); ++i) others.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    return std::move(measured_);
  }

 private:
  void work() {
    try {
      while (const auto index = next()) accept(*index, measure(sample_.at(*index)));
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  // What has been handed out is finished, so that those measured are always the first ones.
  [[nodiscard]] std::optional<std::uint64_t> next() {
    const std::lock_guard lock(mutex_);
    const bool asked_to_stop = options_->stop_requested != nullptr && options_->stop_requested->load();
    if (failure_ || measured_.size() == all_ || (asked_to_stop && !measured_.empty())) return std::nullopt;
    measured_.emplace_back();
    return measured_.size() - 1;
  }

  void accept(std::uint64_t index, MeasuredRealisation realisation) {
    const std::lock_guard lock(mutex_);
    measured_[index] = std::move(realisation);
    ++done_;
    if (options_->on_progress) options_->on_progress(done_, all_);
  }

  [[nodiscard]] MeasuredRealisation measure(const RealisationKey& key) const {
    Condition condition = experiment_->conditions[key.condition];
    MeasuredRealisation measured{.key = key, .runs = std::vector<ToleranceRun>(plan_->tolerances.size())};
    std::optional<Record> reference;
    for (std::size_t i = plan_->tolerances.size(); i-- > 0;) {
      condition.tolerance = plan_->tolerances[i];
      ToleranceRun& run = measured.runs[i];
      const double before = tools_->processor_seconds();
      Record record = tools_->realise(condition, experiment_->seed, key.realisation);
      run.seconds = tools_->processor_seconds() - before;
      run.mode = record.verdict.mode;
      run.periods = record.strobe.size();
      run.steps = record.effort.steps;
      if (reference) {
        run.error = error_beside(record, *reference);
        run.parted = parting_period(record, *reference).has_value();
      } else {
        reference = std::move(record);
      }
    }
    return measured;
  }

  const Experiment* experiment_;
  const CostPlan* plan_;
  const CostTools* tools_;
  const RunOptions* options_;
  CostSample sample_;
  std::uint64_t all_ = 0;
  std::mutex mutex_;
  std::vector<MeasuredRealisation> measured_;
  std::uint64_t done_ = 0;
  std::exception_ptr failure_;
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
                                              const CostTools& tools, const RunOptions& options) {
  ROCKING_EXPECT(plan.sample > 0);
  ROCKING_EXPECT(plan.tolerances.size() >= 3);
  ROCKING_EXPECT(std::ranges::is_sorted(plan.tolerances, std::ranges::greater_equal{}));
  return CostWorkers(experiment, plan, tools, options).run();
}

}  // namespace rocking::experiment
