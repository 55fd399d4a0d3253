#include "rocking/ensemble/verification.hpp"

#include <algorithm>

#include "rocking/ensemble/pair_workers.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_listed = 10;

/// Every pair of the store, or about `sample` realisations in pairs, evenly spaced.
class PairPicker {
 public:
  PairPicker(const Store& store, const std::optional<std::uint64_t>& sample) {
    std::vector<Pair> all;
    store.for_each_key([&](const RealisationKey& key) {
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

 private:
  std::vector<Pair> pairs_;
  std::size_t place_ = 0;
};

}  // namespace

Verification verify(const Experiment& experiment, const Store& store, const std::optional<std::uint64_t>& sample,
                    const RunOptions& options) {
  check_experiment(experiment);
  Verification verification;
  PairPicker picker(store, sample);
  const auto compare = [&](const RealisationKey& key, const Summary& again) {
    const auto stored = store.find(key);
    if (!stored) return;
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
                   ++done;
                   if (options.on_progress) options.on_progress(done, picker.size());
                 },
             .left = [&] { return picker.size() - done; }});
  auto& list = verification.differences;
  std::sort(list.begin(), list.end(), [](const Difference& a, const Difference& b) { return a.key < b.key; });
  if (list.size() > most_listed) list.resize(most_listed);
  return verification;
}

}  // namespace rocking
