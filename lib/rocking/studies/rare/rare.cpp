#include "rocking/studies/rare/rare.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "rocking/base/many_parts.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/estimator.hpp"
#include "rocking/studies/rare/summarise.hpp"
#include "rocking/studies/rare/typical_paths.hpp"

namespace rocking {
namespace {

using rare::most_repetitions;
using rare::Repetition;

/// With fewer repetitions the interval is wide, whatever their spread.
constexpr std::size_t least_repetitions = 16;
/// Of importance sampling that has seen the event: rare large weights make intervals from fewer too short
/// (reports/evidence/rare.md).
constexpr std::size_t least_with_weights = 64;
/// Of the first `count`.
std::vector<double> estimates_of(const std::vector<Repetition>& repetitions, std::size_t count) {
  std::vector<double> estimates;
  for (std::size_t i = 0; i < count; ++i) estimates.push_back(repetitions[i].estimate);
  return estimates;
}

class ConditionStudy {
 public:
  ConditionStudy(const Experiment& experiment, std::size_t place, const RareQuestion& question,
                 const RareSettings& settings)
      : condition_(&experiment.conditions[place]),
        place_(place),
        question_(&question),
        settings_(&settings),
        share_(static_cast<double>(place + 1) / static_cast<double>(experiment.conditions.size())),
        paths_{.condition = condition_,
               .seed = seed_of(*condition_, experiment.seed),
               .event = question.event,
               .halt = {settings.stop, settings.elapsed_seconds, question.seconds}} {
    if (settings.on_progress) paths_.on_work = [this](double work) { note_work(work); };
  }

  /// Called as RareSettings::keep, with what is known of this condition.
  using Keep = std::function<void(const std::function<RareEstimate()>& so_far)>;

  [[nodiscard]] RareEstimate estimate(const Keep& keep) {
    try {
      begin();
      if (earlier() != nullptr) repetitions() = earlier()->repetitions;
      expect_up_to(least_with_event());
      for (std::size_t planned = least_repetitions; planned > 0; planned = planned_after(planned)) {
        if (planned > repetitions().size() && !repeat_up_to(planned, keep)) break;
      }
    } catch (const rare::TimeIsUp&) {
      result_.end = RareEnd::out_of_time;
    } catch (const base::Stopped&) {
      result_.end = RareEnd::stopped;
    }
    if (!estimator_) return not_begun(result_.end);
    find_paths();
    summarise(result_);
    if (settings_->on_progress) settings_->on_progress(place_, work_done_, work_done_);
    return std::move(result_);
  }

  /// What is known without the pilot runs: the earlier estimate, which may be as precise as is asked now.
  [[nodiscard]] RareEstimate not_begun(RareEnd why) {
    result_ = earlier() != nullptr ? *earlier() : RareEstimate();
    if (repetitions().empty()) {
      result_.interval = {0.0, 1.0};
      result_.diagnosis = RareDiagnosis::few_repetitions;
    }
    if (result_.method != RareMethod::plain_sampling) result_.method = rare::method_of(condition_->scene);
    end_with_present(why);
    const bool is_complete = result_.end == RareEnd::precise || result_.end == RareEnd::most_repetitions;
    if (!is_complete) result_.paths.clear();
    return std::move(result_);
  }

  /// What follows from the repetitions of `earlier`, of which about `sample` are made again; their number.
  [[nodiscard]] std::pair<RareEstimate, std::size_t> again(const RareEstimate& earlier, std::size_t sample) {
    begin();
    repetitions() = earlier.repetitions;
    const std::size_t count = std::min(sample, repetitions().size());
    expect_up_to(repetitions().size() + count);
    std::atomic<std::size_t> next = 0;
    base::on_threads(
        settings_->threads,
        [&](unsigned) {
          for (std::size_t i = next++; i < count; i = next++) {
            const std::size_t place = i * repetitions().size() / count;
            repetitions()[place] = estimator_->repeat(place + 1);
          }
        },
        [&] { next = count; });
    end_with_present(earlier.end == RareEnd::stopped ? RareEnd::stopped : RareEnd::out_of_time);
    if (!earlier.paths.empty()) {
      try {
        find_paths();
      } catch (const base::InputError&) {
        // The earlier repetitions are others; without paths the estimate differs.
      }
    }
    summarise(result_);
    return {std::move(result_), count};
  }

 private:
  [[nodiscard]] std::vector<Repetition>& repetitions() { return result_.repetitions; }
  [[nodiscard]] const RareEstimate* earlier() const {
    return place_ < question_->earlier.size() ? &question_->earlier[place_] : nullptr;
  }

  /// Why no more repetitions were made than there are, `otherwise` if more are wanted.
  void end_with_present(RareEnd otherwise) {
    std::size_t planned = least_repetitions;
    while (planned > 0 && planned <= repetitions().size()) planned = planned_after(planned);
    if (planned > 0) result_.end = otherwise;
  }

  void note_work(double work) {
    const std::lock_guard lock(work_mutex_);
    work_done_ += work;
    settings_->on_progress(place_, work_done_, work_expected_ > 0.0 ? std::max(work_done_, work_expected_) : 0.0);
  }

  /// That the repetitions go on up to this number.
  void expect_up_to(std::size_t count) {
    double of_one = static_cast<double>(question_->particles);
    if (!repetitions().empty()) {
      of_one = 0.0;
      for (const Repetition& each : repetitions()) of_one += each.work / static_cast<double>(repetitions().size());
    }
    const std::lock_guard lock(work_mutex_);
    work_expected_ = work_done_ + of_one * static_cast<double>(count - std::min(count, repetitions().size()));
  }

  void begin() {
    estimator_ = estimator_of(paths_, question_->particles, settings_->threads);
    result_.method = estimator_->method();
    result_.levels = estimator_->pilot().levels;
    result_.reached = estimator_->pilot().reached;
    result_.pilot_work = estimator_->pilot().work;
    result_.committor = estimator_->committor();
  }

  /// If there is time.
  void find_paths() {
    if (result_.end != RareEnd::precise && result_.end != RareEnd::most_repetitions) return;
    try {
      result_.paths = rare::typical_paths(paths_, *estimator_, repetitions());
    } catch (const rare::TimeIsUp&) {
      // They are left out.
    } catch (const base::Stopped&) {
      result_.end = RareEnd::stopped;
    }
  }

  /// How many repetitions are wanted after the first `planned`; 0 if no more are, for the reason that it notes.
  [[nodiscard]] std::size_t planned_after(std::size_t planned) {
    const auto so_far = stats::mean_of_repetitions(estimates_of(repetitions(), planned), condition_->confidence);
    const double error = so_far.relative_error.value_or(0.0);
    const bool is_precise = error <= question_->relative_error;
    result_.end = !so_far.relative_error ? RareEnd::never_seen
                  : is_precise           ? RareEnd::precise
                                         : RareEnd::most_repetitions;
    if (!is_precise) {
      if (planned == most_repetitions - 1) return 0;
      constexpr double at_most_times = 4.0;  // the spread is known roughly at first
      const double times = 1.05 * (error / question_->relative_error) * (error / question_->relative_error);
      expect_up_to(std::max(more_than(planned, times), least_with_event()));
      return std::max(more_than(planned, std::min(at_most_times, times)), least_with_event());
    }
    return error > 0.0 && planned < least_with_event() ? least_with_event() : 0;
  }

  [[nodiscard]] std::size_t least_with_event() const {
    return result_.method == RareMethod::importance_sampling ? least_with_weights : least_repetitions;
  }

  /// The numbers do not depend on how many were made earlier.
  [[nodiscard]] static std::size_t more_than(std::size_t planned, double times) {
    constexpr double most = most_repetitions - 1;
    const double wanted = std::min(most, std::ceil(static_cast<double>(planned) * times));
    return std::min<std::size_t>(most_repetitions - 1, std::max(planned + 1, static_cast<std::size_t>(wanted)));
  }

  /// Makes repetitions until there are `count`; false if it had to end before. Those after one that was not finished
  /// are left out: long repetitions tend to have large estimates, and without them the mean would be too small.
  [[nodiscard]] bool repeat_up_to(std::size_t count, const Keep& keep) {
    const std::size_t from = repetitions().size();
    std::vector<std::optional<Repetition>> slots(count - from);
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    const std::function<RareEstimate()> so_far = [&] {
      RareEstimate found = result_;
      found.end = RareEnd::stopped;
      for (auto slot = slots.begin(); slot != slots.end() && *slot; ++slot) found.repetitions.push_back(**slot);
      summarise(found);
      return found;
    };
    result_.end = RareEnd::out_of_time;
    const rare::Halt& halt = paths_.halt;
    try {
      base::on_threads(
          settings_->threads,
          [&](unsigned) {
            for (std::size_t i = next++; i < slots.size(); i = next++) {
              if (from + i >= rare::least_with_interval && halt.ends_within(longest_, share_)) return;
              const double start = halt.elapsed();
              const Repetition found = estimator_->repeat(from + i + 1);
              const std::lock_guard lock(mutex);
              slots[i] = found;
              longest_ = std::max<double>(longest_, halt.elapsed() - start);
              if (keep) keep(so_far);
            }
          },
          [&] { next = slots.size(); });
    } catch (const rare::TimeIsUp&) {
      // What is finished counts.
    } catch (const base::Stopped&) {
      result_.end = RareEnd::stopped;
    }
    for (auto& slot : slots) {
      if (!slot) return false;
      repetitions().push_back(*std::move(slot));
    }
    return true;
  }

  void summarise(RareEstimate& result) const {
    rare::summarise_repetitions(result, condition_->confidence, question_->particles);
    if (result.repetitions.size() < rare::least_with_interval) {
      result.diagnosis = RareDiagnosis::few_repetitions;
    } else {
      diagnose(result);
    }
  }

  void diagnose(RareEstimate& result) const {
    std::size_t seen = 0;  // repetitions with the event
    double largest = 0.0;
    double sum = 0.0;
    for (const Repetition& repetition : result.repetitions) {
      seen += repetition.ancestors > 0 ? 1 : 0;
      largest = std::max(largest, repetition.estimate);
      sum += repetition.estimate;
    }
    if (!estimator_->pilot().found_event) {
      result.diagnosis = RareDiagnosis::not_found;
    } else if (10 * seen <= 9 * result.repetitions.size() || 3.0 * largest > sum) {
      result.diagnosis = RareDiagnosis::uneven;
    }
  }

  const Condition* condition_;
  std::size_t place_;
  const RareQuestion* question_;
  const RareSettings* settings_;
  double share_;  ///< of the time for this condition and those before it
  rare::BlockPaths paths_;
  std::unique_ptr<rare::Estimator> estimator_;
  std::atomic<double> longest_ = 0.0;  ///< time of a repetition so far [s]
  std::mutex work_mutex_;
  double work_done_ = 0.0;      ///< simulated time, in realisations
  double work_expected_ = 0.0;  ///< in all; 0: not known yet
  RareEstimate result_;
};

}  // namespace

void check_rare(const Experiment& experiment) {
  check_experiment(experiment);
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    if (is_random(experiment.conditions[i].scene)) continue;
    throw base::InputError({"/fluctuation", "",
                            "nothing is random in condition " + std::to_string(i) +
                                ": the event happens or does not, and one realisation tells",
                            "use `rocking run`, or add a `fluctuation` or a law"});
  }
}

std::vector<RareEstimate> rare_estimates(const Experiment& experiment, const RareQuestion& question,
                                         const RareSettings& settings) {
  check_rare(experiment);
  std::vector<RareEstimate> estimates;
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    ConditionStudy::Keep keep;
    if (settings.keep) {
      keep = [&](const std::function<RareEstimate()>& present) {
        settings.keep([&] {
          std::vector<RareEstimate> all = estimates;
          all.push_back(present());
          while (all.size() < experiment.conditions.size()) {
            all.push_back(ConditionStudy(experiment, all.size(), question, settings).not_begun(RareEnd::stopped));
          }
          return all;
        });
      };
    }
    estimates.push_back(ConditionStudy(experiment, i, question, settings).estimate(keep));
  }
  return estimates;
}

RareRerun rare_estimates_again(const Experiment& experiment, const RareQuestion& question, const RareSettings& settings,
                               std::size_t sample) {
  check_rare(experiment);
  const std::vector<RareEstimate>& earlier = question.earlier;
  ROCKING_EXPECT(earlier.size() == experiment.conditions.size());
  const std::size_t of_each = (sample + earlier.size() - 1) / earlier.size();
  RareRerun all;
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i].repetitions.empty()) {
      all.estimates.push_back(earlier[i]);
      continue;
    }
    auto [estimate, count] = ConditionStudy(experiment, i, question, settings).again(earlier[i], of_each);
    all.estimates.push_back(std::move(estimate));
    all.repetitions += count;
  }
  return all;
}

}  // namespace rocking
