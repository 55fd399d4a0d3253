#include "rocking/ensemble/work_list.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking {
double rerun_tolerance(double tolerance) { return std::max(1e-16, tolerance / 100.0); }

WorkList::WorkList(const Experiment& experiment, const std::optional<Shard>& shard) : shard_(shard) {
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    const Condition& condition = experiment.conditions[i];
    ROCKING_EXPECT(!shard ||
                   !condition.until);  // a shard cannot know when the whole experiment has enough realisations
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

std::vector<RealisationKey> WorkList::missing() const {
  std::vector<RealisationKey> keys;
  for (std::size_t condition = 0; condition < conditions_.size(); ++condition) {
    const std::vector<bool>& done = conditions_[condition].done;
    for (std::size_t realisation = 0; realisation < done.size(); ++realisation) {
      const RealisationKey key{condition, realisation};
      if (!done[realisation] && is_ours(key)) keys.push_back(key);
    }
  }
  return keys;
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

}  // namespace rocking
