#include "rocking/experiment/pair_job.hpp"

#include <algorithm>
#include <utility>

namespace rocking::experiment {
namespace {

/// Realisations are alike but for their draws, so every so manieth is as good as one drawn at random.
bool is_repeated(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.repeat_every > 0 && number % condition.repeat_every == 0;
}

bool is_checked(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.label_check && number % condition.label_check->every == 0;
}

}  // namespace

PairJob::PairJob(const Experiment& experiment, const Pair& pair, std::uint64_t count)
    : pair_(pair), tighter_(experiment.conditions[pair.condition]), longer_(tighter_) {
  const Condition& condition = experiment.conditions[pair.condition];
  tighter_.tolerance = repeat_tolerance(condition.tolerance);
  // Sampled for longer after the same transient, with the same draws.
  if (condition.label_check) longer_.horizon.sampled_periods *= static_cast<int>(condition.label_check->times_longer);
  for (std::uint64_t number = pair.first; number < std::min(pair.first + 2, count); ++number) {
    add(Purpose::itself, condition, number);
    if (is_repeated(condition, number)) add(Purpose::repeat, tighter_, number);
    if (is_checked(condition, number)) add(Purpose::long_run, longer_, number);
  }
}

void PairJob::add(Purpose purpose, const Condition& condition, std::uint64_t realisation) {
  tasks_.push_back({.condition = &condition, .realisation = realisation});
  purposes_.push_back(purpose);
  records_.emplace_back();
  ++open_;
}

bool PairJob::accept(std::size_t task, Record record) {
  records_[task] = std::move(record);
  return --open_ == 0;
}

std::vector<Summary> PairJob::summaries() const {
  std::vector<Summary> summaries;
  std::vector<const Record*> records;
  for (std::size_t task = 0; task < tasks_.size(); ++task) {
    const Record& record = *records_[task];
    switch (purposes_[task]) {
      case Purpose::itself:
        records.push_back(&record);
        summaries.push_back(summarise(record, tasks_[task].realisation));
        break;
      case Purpose::repeat:
        summaries.back().repeat_mode = record.verdict.mode;
        summaries.back().repeat_parted = parting_period(*records.back(), record);
        break;
      case Purpose::long_run: summaries.back().long_mode = record.verdict.mode; break;
    }
  }
  if (records.size() == 2) summaries[0].parted_from_next = parting_period(*records[0], *records[1]);
  return summaries;
}

}  // namespace rocking::experiment
