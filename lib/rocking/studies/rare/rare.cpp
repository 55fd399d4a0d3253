#include "rocking/studies/rare/rare.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/base/on_threads.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/rare/block_model.hpp"
#include "rocking/studies/rare/splitting.hpp"

namespace rocking {
namespace {

using rare::BlockModel;
using rare::Repetition;

/// With fewer repetitions the interval is wide, whatever their spread.
constexpr std::size_t least_repetitions = 16;
/// Before the share of a condition in the time counts. An interval from fewer has not been tested.
constexpr std::size_t repetitions_at_any_rate = 8;
constexpr std::size_t most_repetitions = 20'000;

RareMethod method_of(const Scene& scene) {
  return rare::moves_of(scene).along_the_way ? RareMethod::both : RareMethod::markov_chain;
}

rare::ForEach on(unsigned threads) {
  return [threads](std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    base::on_threads(
        threads,
        [&](unsigned) {
          for (std::size_t i = next++; i < count; i = next++) work(i);
        },
        [&] { next = count; });
  };
}

std::vector<double> estimates_of(const std::vector<Repetition>& repetitions) {
  std::vector<double> estimates;
  for (const Repetition& repetition : repetitions) estimates.push_back(repetition.estimate);
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
        halt_(settings.stop, settings.elapsed_seconds, settings.seconds),
        share_(static_cast<double>(place + 1) / static_cast<double>(experiment.conditions.size())),
        model_(*condition_, {.seed = experiment.seed, .event = question.event, .score = settings.score}, halt_),
        plan_{.seed = experiment.seed, .particles = settings.particles} {}

  [[nodiscard]] RareEstimate estimate() {
    result_.method = method_of(condition_->scene);
    rare::Pilot pilot;
    try {
      pilot = rare::find_levels(model_, plan_, on(settings_->threads));
      levels_ = result_.levels = pilot.levels;
      result_.pilot_work = pilot.work;
      repeat_until_precise();
    } catch (const rare::TimeIsUp&) {
      result_.end = RareEnd::out_of_time;
    }
    summarise(pilot);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<Repetition>& repetitions() { return result_.repetitions; }

  void repeat_until_precise() {
    std::size_t planned = least_repetitions;
    for (;;) {
      if (!repeat_up_to(planned)) {
        result_.end = RareEnd::out_of_time;
        return;
      }
      const auto so_far = stats::mean_of_repetitions(estimates_of(repetitions()), condition_->confidence);
      if (!so_far.relative_error) {
        result_.end = RareEnd::never_seen;
        return;
      }
      const double ratio = *so_far.relative_error / question_->relative_error;
      if (ratio <= 1.0) return;
      if (planned == most_repetitions) {
        result_.end = RareEnd::most_repetitions;
        return;
      }
      // The spread is known roughly at first: at most four times as many at once.
      const double wanted = static_cast<double>(planned) * std::min(4.0, 1.05 * ratio * ratio);
      planned = std::min(most_repetitions, std::max(planned + 1, static_cast<std::size_t>(std::ceil(wanted))));
    }
  }

  /// Makes repetitions until there are `count`; false if the time was up before. Those after one that was not finished
  /// are left out: long repetitions tend to have large estimates, and without them the mean would be too small.
  [[nodiscard]] bool repeat_up_to(std::size_t count) {
    const std::size_t from = repetitions().size();
    std::vector<std::optional<Repetition>> slots(count - from);
    std::atomic<std::size_t> next = 0;
    std::size_t done = from;
    std::mutex mutex;
    try {
      base::on_threads(
          settings_->threads,
          [&](unsigned) {
            for (std::size_t i = next++; i < slots.size(); i = next++) {
              if (from + i >= repetitions_at_any_rate && halt_.ends_within(longest_, share_)) return;
              const double start = halt_.elapsed();
              slots[i] = rare::repeat(model_, plan_, levels_, from + i + 1, on(1));
              const std::lock_guard lock(mutex);
              longest_ = std::max<double>(longest_, halt_.elapsed() - start);
              if (settings_->on_progress) settings_->on_progress(place_, ++done, count);
            }
          },
          [&] { next = slots.size(); });
    } catch (const rare::TimeIsUp&) {
      // What is finished counts.
    }
    for (auto& slot : slots) {
      if (!slot) return false;
      repetitions().push_back(*std::move(slot));
    }
    return true;
  }

  void summarise(const rare::Pilot& pilot) {
    if (repetitions().size() < repetitions_at_any_rate) return summarise_few();
    const auto estimate = stats::mean_of_repetitions(estimates_of(repetitions()), condition_->confidence);
    result_.probability = estimate.mean;
    result_.relative_error = estimate.relative_error;
    result_.work = pilot.work;
    result_.reached.assign(levels_.size() + 1, 0.0);
    for (const Repetition& repetition : repetitions()) {
      result_.work += repetition.work;
      for (std::size_t i = 0; i < repetition.reached.size(); ++i) result_.reached[i] += repetition.reached[i];
    }
    for (double& share : result_.reached) share /= static_cast<double>(repetitions().size());
    if (estimate.interval) {
      result_.interval = {estimate.interval->low, std::min(1.0, estimate.interval->high)};
    } else {
      result_.interval = {0.0, bound_from_levels()};
    }
    if (estimate.relative_error && *estimate.relative_error > 0.0) {
      result_.crude_work =
          (1.0 - estimate.mean) / (estimate.mean * *estimate.relative_error * *estimate.relative_error);
    }
    diagnose(pilot);
  }

  void summarise_few() {
    result_.diagnosis = RareDiagnosis::few_repetitions;
    result_.interval = {0.0, 1.0};
    result_.work = result_.pilot_work;
    for (const Repetition& repetition : repetitions()) result_.work += repetition.work;
    if (repetitions().empty()) return;
    result_.probability = stats::mean_of_repetitions(estimates_of(repetitions()), condition_->confidence).mean;
  }

  /// Who had the event has reached every level: the upper end of the interval for the highest level that enough
  /// repetitions have reached. 1 without such a level.
  [[nodiscard]] double bound_from_levels() {
    for (std::size_t level = levels_.size(); level > 0; --level) {
      std::vector<double> estimates;
      bool all = true;
      for (const Repetition& repetition : repetitions()) {
        double estimate = 1.0;
        for (std::size_t i = 0; i < level; ++i) {
          estimate *= i < repetition.reached.size() ? repetition.reached[i] : 0.0;
        }
        all = all && estimate > 0.0;
        estimates.push_back(estimate);
      }
      const auto bound = stats::mean_of_repetitions(estimates, condition_->confidence);
      if (all && bound.interval) return std::min(1.0, bound.interval->high);
    }
    const double trials = static_cast<double>(repetitions().size() * plan_.particles);
    return stats::clopper_pearson({.successes = 0, .trials = static_cast<std::uint64_t>(trials)},
                                  condition_->confidence)
        .high;
  }

  void diagnose(const rare::Pilot& pilot) {
    std::vector<std::size_t> ancestors;
    double largest = 0.0;
    double sum = 0.0;
    for (const Repetition& repetition : repetitions()) {
      if (repetition.ancestors > 0) ancestors.push_back(repetition.ancestors);
      largest = std::max(largest, repetition.estimate);
      sum += repetition.estimate;
    }
    std::ranges::sort(ancestors);
    if (!ancestors.empty()) {
      result_.least_ancestors = ancestors.front();
      const std::size_t n = ancestors.size();
      result_.median_ancestors = 0.5 * static_cast<double>(ancestors[n / 2] + ancestors[(n - 1) / 2]);
    }
    if (pilot.end != rare::PilotEnd::reached) {
      result_.diagnosis = RareDiagnosis::no_levels;
    } else if (ancestors.size() < repetitions().size() || 3.0 * largest > sum) {
      result_.diagnosis = RareDiagnosis::uneven;
    } else if (result_.median_ancestors < 10.0) {
      result_.diagnosis = RareDiagnosis::few_ancestors;
    }
  }

  const Condition* condition_;
  std::size_t place_;
  const RareQuestion* question_;
  const RareSettings* settings_;
  rare::Halt halt_;
  double share_;  ///< of the time for this condition and those before it
  BlockModel model_;
  rare::SplittingPlan plan_;
  std::vector<double> levels_;
  std::atomic<double> longest_ = 0.0;  ///< time of a repetition so far [s]
  RareEstimate result_;
};

}  // namespace

std::string_view rare::to_string(Score score) {
  switch (score) {
    case Score::tilt: return "tilt";
    case Score::energy: return "energy";
  }
  return "";
}

std::string_view to_string(RareEnd end) {
  switch (end) {
    case RareEnd::precise: return "precise";
    case RareEnd::out_of_time: return "out_of_time";
    case RareEnd::never_seen: return "never_seen";
    case RareEnd::most_repetitions: return "most_repetitions";
  }
  return "";
}

std::string_view to_string(RareDiagnosis diagnosis) {
  switch (diagnosis) {
    case RareDiagnosis::none: return "none";
    case RareDiagnosis::no_levels: return "no_levels";
    case RareDiagnosis::few_repetitions: return "few_repetitions";
    case RareDiagnosis::few_ancestors: return "few_ancestors";
    case RareDiagnosis::uneven: return "uneven";
  }
  return "";
}

std::string_view to_string(RareMethod method) {
  switch (method) {
    case RareMethod::markov_chain: return "markov_chain";
    case RareMethod::both: return "splitting_and_markov_chain";
  }
  return "";
}

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

std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                             const RareSettings& settings) {
  check_rare(experiment);
  std::vector<RareEstimate> estimates;
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    estimates.push_back(ConditionStudy(experiment, i, question, settings).estimate());
  }
  return estimates;
}

}  // namespace rocking
