#include "rocking/experiment/work.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/experiment/record.hpp"

namespace rocking::experiment {
namespace {

/// Realisations are alike but for their draws, so every so manieth is as good as one drawn at random.
bool is_repeated(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.repeat_every > 0 && number % condition.repeat_every == 0;
}

bool is_checked(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.label_check && number % condition.label_check->every == 0;
}

/// The mode by a run that is sampled for longer, after the same transient, with the same draws.
section::ResponseMode mode_in_the_long_run(Condition condition, std::uint64_t seed, std::uint64_t number) {
  condition.horizon.sampled_periods *= static_cast<int>(condition.label_check->times_longer);
  return realise(condition, seed, number).verdict.mode;
}

}  // namespace

double repeat_tolerance(double tolerance) { return std::max(1e-16, tolerance / 100.0); }

std::uint64_t effective_realisations(const Condition& condition) {
  return is_random(condition.scene) ? condition.realisations : 1;
}

std::vector<Summary> run_pair(const Experiment& experiment, const Pair& pair, std::uint64_t count) {
  const Condition& condition = experiment.conditions[pair.condition];
  Condition tighter = condition;
  tighter.tolerance = repeat_tolerance(condition.tolerance);
  std::vector<Record> records;
  std::vector<Summary> summaries;
  for (std::uint64_t number = pair.first; number < std::min(pair.first + 2, count); ++number) {
    records.push_back(realise(condition, experiment.seed, number));
    summaries.push_back(summarise(records.back(), number));
    if (is_repeated(condition, number)) {
      const Record repeat = realise(tighter, experiment.seed, number);
      summaries.back().repeat_mode = repeat.verdict.mode;
      summaries.back().repeat_parted = parting_period(records.back(), repeat);
    }
    if (is_checked(condition, number)) {
      summaries.back().long_mode = mode_in_the_long_run(condition, experiment.seed, number);
    }
  }
  if (records.size() == 2) summaries[0].parted_from_next = parting_period(records[0], records[1]);
  return summaries;
}

WorkList::WorkList(const Experiment& experiment, const std::optional<Shard>& shard) : shard_(shard) {
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    const Condition& condition = experiment.conditions[i];
    ROCKING_EXPECT(!shard || !condition.until);  // a part cannot know when the whole has enough
    conditions_.push_back({.target = {}, .first_pair = pairs, .next = 0, .done_count = 0, .done = {}});
    set_target(i, first_target(condition));
    pairs += (effective_realisations(condition) + 1) / 2;
  }
}

bool WorkList::is_ours(const RealisationKey& key) const {
  return !shard_ || shard_->has(conditions_[key.condition].first_pair + key.realisation / 2);
}

void WorkList::set_target(std::size_t condition, const Target& target) {
  PerCondition& changed = conditions_[condition];
  for (std::uint64_t k = changed.target.realisations; k < target.realisations; ++k)
    all_ += is_ours({condition, k}) ? 1 : 0;
  changed.target = target;
  changed.done.resize(target.realisations);
}

void WorkList::mark_done(const RealisationKey& key) {
  ROCKING_EXPECT(key.condition < conditions_.size());
  PerCondition& condition = conditions_[key.condition];
  ROCKING_EXPECT(key.realisation < condition.target.realisations);
  if (!is_ours(key) || condition.done[key.realisation]) return;
  condition.done[key.realisation] = true;
  ++condition.done_count;
  ++done_;
}

bool WorkList::wants_look(std::size_t condition) const {
  const PerCondition& asked = conditions_[condition];
  return !asked.target.is_final && asked.done_count == asked.target.realisations;
}

bool WorkList::is_complete() const {
  const auto is_final = [](const PerCondition& condition) { return condition.target.is_final; };
  return done_ == all_ && std::all_of(conditions_.begin(), conditions_.end(), is_final);
}

bool WorkList::is_done(const Pair& pair) const {
  const PerCondition& condition = conditions_[pair.condition];
  const bool has_second = pair.first + 1 < condition.target.realisations;
  return condition.done[pair.first] && (!has_second || condition.done[pair.first + 1]);
}

std::optional<Pair> WorkList::take_from(std::size_t condition) {
  PerCondition& asked = conditions_[condition];
  while (asked.next < asked.target.realisations) {
    const Pair pair{.condition = condition, .first = asked.next};
    asked.next += 2;
    if (is_ours({condition, pair.first}) && !is_done(pair)) return pair;
  }
  return std::nullopt;
}

std::optional<Pair> WorkList::take() {
  for (std::size_t i = first_open_; i < conditions_.size(); ++i) {
    if (const auto pair = take_from(i)) return pair;
    if (i == first_open_ && conditions_[i].target.is_final) ++first_open_;
  }
  return std::nullopt;
}

}  // namespace rocking::experiment
