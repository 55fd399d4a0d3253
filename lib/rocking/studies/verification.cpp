#include "rocking/studies/verification.hpp"

#include <algorithm>

#include "rocking/ensemble/pair_workers.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_listed = 10;

// All rows of an unknown version are compared, because they may have the same bits.
bool is_comparable(const Store& store, const RealisationKey& key) {
  if (!is_former_version(store.identity().results)) return true;
  const auto row = store.find(key);
  return row && store.has_current_bits(key, *row);
}

/// Every pair of the store with a row that can be compared, or `wanted` of them, evenly spaced.
class PairPicker {
 public:
  PairPicker(const Store& store, const std::optional<std::uint64_t>& sample) {
    std::vector<Pair> all;
    store.for_each_key([&](const RealisationKey& key) {
      if (!is_comparable(store, key)) {
        ++not_comparable_;
        return;
      }
      const Pair pair{.condition = static_cast<std::size_t>(key.condition), .first = key.realisation / 2 * 2};
      const bool known = !all.empty() && all.back().condition == pair.condition && all.back().first == pair.first;
      if (!known) all.push_back(pair);
    });
    const std::uint64_t wanted = sample ? std::min<std::uint64_t>((*sample + 1) / 2, all.size()) : all.size();
    for (std::uint64_t i = 0; i < wanted; ++i) pairs_.push_back(all[i * all.size() / wanted]);
  }

  [[nodiscard]] std::optional<Pair> next() {
    return place_ < pairs_.size() ? std::optional(pairs_[place_++]) : std::nullopt;
  }
  [[nodiscard]] std::uint64_t size() const { return pairs_.size(); }
  /// Rows of the whole store that cannot be compared.
  [[nodiscard]] std::uint64_t not_comparable() const { return not_comparable_; }

 private:
  std::vector<Pair> pairs_;
  std::size_t place_ = 0;
  std::uint64_t not_comparable_ = 0;
};

}  // namespace

Verification verify(const Experiment& experiment, const Store& store, const std::optional<std::uint64_t>& sample,
                    const RunOptions& options) {
  check_experiment(experiment);
  Verification verification;
  PairPicker picker(store, sample);
  verification.not_compared = picker.not_comparable();
  const auto compare = [&](const RealisationKey& key, const Summary& again) {
    const auto stored = store.find(key);
    if (!stored || !is_comparable(store, key)) return;
    ++verification.checked;
    const auto fields = differing_fields(*stored, again);
    if (fields.empty()) return;
    ++verification.different;
    verification.differences.push_back({key, fields});
  };
  std::uint64_t done = 0;
  run_pairs(experiment, options,
            {.next = [&] { return picker.next(); },
             .accept =
                 [&](const Pair& pair, const std::vector<Summary>& summaries) {
                   for (std::size_t i = 0; i < summaries.size(); ++i)
                     compare({pair.condition, pair.first + i}, summaries[i]);
                   if (options.on_progress) options.on_progress(++done, picker.size());
                 }});
  auto& list = verification.differences;
  std::sort(list.begin(), list.end(), [](const Difference& a, const Difference& b) { return a.key < b.key; });
  if (list.size() > most_listed) list.resize(most_listed);
  return verification;
}

}  // namespace rocking
