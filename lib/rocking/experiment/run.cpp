#include "rocking/experiment/run.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "rocking/experiment/record.hpp"
#include "rocking/experiment/reduce.hpp"

namespace rocking::experiment {
namespace {

/// One realisation in this many is repeated at another tolerance.
constexpr std::uint64_t repeat_every = 10;

/// A realisation of even number and the next one, of one condition: the unit of work. The two are compared while both
/// strobe records are at hand.
struct Pair {
  std::size_t condition;
  std::uint64_t first;
};

/// Runs pairs on any number of threads, in any order; keeps summaries by (condition, realisation) and reduces a condition
/// when its last pair is in. Nothing depends on who did what when.
class Campaign {
 public:
  Campaign(const Experiment& experiment, const RunOptions& options)
      : experiment_(&experiment), options_(&options), conditions_(experiment.conditions.size()) {
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      const std::uint64_t count = effective_realisations(experiment.conditions[i]);
      conditions_[i].count = count;
      all_ += count;
    }
  }

  [[nodiscard]] std::optional<ExperimentResult> run() {
    {
      std::vector<std::jthread> workers;
      for (unsigned i = 1; i < std::max(1U, options_->threads); ++i) workers.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (done_ < all_) return std::nullopt;
    ExperimentResult result;
    base::Sha256Builder digest;
    for (PerCondition& condition : conditions_) {
      digest.add(condition.digest);
      result.conditions.push_back(std::move(*condition.result));
    }
    result.digest = digest.finish();
    return result;
  }

 private:
  struct PerCondition {
    std::uint64_t count = 0;
    std::uint64_t done = 0;
    std::vector<Summary> summaries;  ///< only while the condition is being worked on
    Totals totals;
    base::Sha256 digest{};
    std::optional<ConditionResult> result;
  };

  void work() {
    try {
      while (const auto pair = next_pair()) accept(*pair, run_pair(*pair));
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  [[nodiscard]] std::optional<Pair> next_pair() {
    const std::lock_guard lock(mutex_);
    const bool asked_to_stop = options_->stop_requested != nullptr && options_->stop_requested->load();
    if (asked_to_stop || failure_) return std::nullopt;
    while (next_.condition < conditions_.size() && next_.first >= conditions_[next_.condition].count) {
      next_ = {.condition = next_.condition + 1, .first = 0};
    }
    if (next_.condition == conditions_.size()) return std::nullopt;
    const Pair pair = next_;
    next_.first += 2;
    return pair;
  }

  /// What comes of a pair.
  struct PairResult {
    std::vector<Summary> summaries;
    Totals totals;
  };

  [[nodiscard]] PairResult run_pair(const Pair& pair) const {
    const Condition& condition = experiment_->conditions[pair.condition];
    const std::uint64_t last = std::min(pair.first + 2, conditions_[pair.condition].count);
    std::vector<Record> records;
    PairResult result;
    std::vector<Summary>& summaries = result.summaries;
    for (std::uint64_t number = pair.first; number < last; ++number) {
      records.push_back(realise(condition, experiment_->seed, number));
      summaries.push_back(summarise(records.back(), number));
      result.totals.effort += records.back().effort;
      result.totals.clamps += records.back().clamps;
      if (is_random(condition.scene) && number % repeat_every == 0) {
        summaries.back().repeat = repeat(condition, records.back(), number);
      }
    }
    if (records.size() == 2) summaries[0].parted_from_next = parting_period(records[0], records[1]);
    return result;
  }

  [[nodiscard]] Summary::Repeat repeat(Condition condition, const Record& record, std::uint64_t number) const {
    condition.tolerance = repeat_tolerance(condition.tolerance);
    const Record other = realise(condition, experiment_->seed, number);
    return {.mode = other.verdict.mode, .parted = parting_period(record, other)};
  }

  void accept(const Pair& pair, PairResult result) {
    const std::lock_guard lock(mutex_);
    PerCondition& condition = conditions_[pair.condition];
    condition.summaries.resize(condition.count);
    std::move(result.summaries.begin(), result.summaries.end(),
              condition.summaries.begin() + static_cast<std::ptrdiff_t>(pair.first));
    condition.totals.effort += result.totals.effort;
    condition.totals.clamps += result.totals.clamps;
    condition.done += result.summaries.size();
    done_ += result.summaries.size();
    if (condition.done == condition.count) finish(pair.condition);
    if (options_->on_progress) options_->on_progress(done_, all_);
  }

  void finish(std::size_t index) {
    PerCondition& condition = conditions_[index];
    condition.result = reduce(experiment_->conditions[index], condition.summaries, condition.totals);
    base::Sha256Builder digest;
    for (const Summary& summary : condition.summaries) digest.add(summary.digest);
    condition.digest = digest.finish();
    condition.summaries = {};
  }

  const Experiment* experiment_;
  const RunOptions* options_;
  std::mutex mutex_;
  std::vector<PerCondition> conditions_;
  Pair next_{.condition = 0, .first = 0};
  std::uint64_t all_ = 0;
  std::uint64_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::uint64_t effective_realisations(const Condition& condition) {
  return is_random(condition.scene) ? condition.realisations : 1;
}

std::optional<ExperimentResult> run(const Experiment& experiment, const RunOptions& options) {
  return Campaign(experiment, options).run();
}

}  // namespace rocking::experiment
