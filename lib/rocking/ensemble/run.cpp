#include "rocking/ensemble/run.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "rocking/ensemble/pair_workers.hpp"
#include "rocking/ensemble/reduction.hpp"
#include "rocking/ensemble/work_list.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// Number of strobe periods after which rows are made durable if the caller does not decide
/// (RunOptions::commit_is_due). The slowest scenes need a few seconds for it on two cores, so that writing takes a
/// small share of the time.
constexpr std::uint64_t periods_between_commits = 1U << 17U;

// After a failure the finished rows are kept if possible. The first failure is the one to report.
void commit_if_possible(Store& store) {
  try {
    store.close_up();
  } catch (const std::exception&) {
  }
}

// Looks at a condition as often as its stopping rule requires.
void look(const Experiment& experiment, const Store& store, WorkList& work, std::size_t condition) {
  while (work.wants_look(condition)) {
    const Target& target = work.target(condition);
    const ModeTally modes = store.mode_counts(condition, target.realisations);
    work.set_target(condition, next_target(experiment.conditions[condition], target, modes));
  }
}

WorkList work_left(const Experiment& experiment, const Store& store) {
  WorkList work(experiment, store.identity().shard);
  store.for_each_key([&](const RealisationKey& key) {
    if (key.condition >= experiment.conditions.size()) return;
    look(experiment, store, work, key.condition);
    if (key.realisation < work.target(key.condition).realisations) work.mark_done(key);
  });
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) look(experiment, store, work, i);
  return work;
}

/// Of the threads, those that find work: a realisation keeps one busy. Their start takes longer than a short realisation.
unsigned busy_threads(const WorkList& work, std::size_t conditions, unsigned threads) {
  for (std::size_t i = 0; i < conditions; ++i) {
    if (!work.target(i).is_final) return threads;
  }
  const std::uint64_t left = std::max<std::uint64_t>(1, work.all() - work.done());
  return static_cast<unsigned>(std::min<std::uint64_t>(threads, left));
}

/// Puts results of pairs into the store and makes them durable from time to time.
class Journal {
 public:
  Journal(const Experiment& experiment, Store& store, const RunOptions& options)
      : experiment_(&experiment), store_(&store), options_(&options) {}

  void add(const Pair& pair, const std::vector<Summary>& summaries) {
    for (std::size_t i = 0; i < summaries.size(); ++i) store_->add({pair.condition, pair.first + i}, summaries[i]);
    const Horizon& horizon = experiment_->conditions[pair.condition].horizon;
    const std::int64_t periods = horizon.periods();
    uncommitted_ += summaries.size() * static_cast<std::uint64_t>(periods);
    if (options_->commit_is_due ? !options_->commit_is_due() : uncommitted_ < periods_between_commits) return;
    store_->commit();
    uncommitted_ = 0;
  }

 private:
  const Experiment* experiment_;
  Store* store_;
  const RunOptions* options_;
  std::uint64_t uncommitted_ = 0;
};

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

RunEnd run(const Experiment& experiment, Store& store, const RunOptions& options) {
  check_experiment(experiment);
  check_strobe(experiment);
  WorkList work = work_left(experiment, store);
  Journal journal(experiment, store, options);
  if (options.on_progress && !work.is_complete()) options.on_progress(work.done(), work.all());
  const PairFlow flow{.next = [&] { return work.take(); },
                      .accept =
                          [&](const Pair& pair, const std::vector<Summary>& summaries) {
                            journal.add(pair, summaries);
                            for (std::size_t i = 0; i < summaries.size(); ++i)
                              work.mark_done({pair.condition, pair.first + i});
                            look(experiment, store, work, pair.condition);
                            if (options.on_realisations) options.on_realisations(pair.condition, summaries);
                            if (options.on_progress) options.on_progress(work.done(), work.all());
                          },
                      .left = [&] { return (work.all() - work.done() + 1) / 2; }};
  try {
    if (options.pair_runner) {
      options.pair_runner(experiment, options, flow);
    } else {
      RunOptions busy = options;
      busy.threads = busy_threads(work, experiment.conditions.size(), options.threads);
      run_pairs(experiment, busy, flow);
    }
  } catch (...) {
    commit_if_possible(store);
    throw;
  }
  store.close_up();
  return work.is_complete() ? RunEnd::complete : RunEnd::stopped;
}

Completeness completeness(const Experiment& experiment, const Store& store) {
  const WorkList work = work_left(experiment, store);
  return {.done = work.done(), .all = work.all()};
}

std::vector<RealisationKey> missing_realisations(const Experiment& experiment, const Store& store) {
  return work_left(experiment, store).missing();
}

std::optional<ExperimentResult> result_of(const Experiment& experiment, const Store& store, const base::ManyParts& how,
                                          const Store::UseOfRow& also) {
  std::vector<Reduction> reductions(experiment.conditions.begin(), experiment.conditions.end());
  store.for_each_side_by_side(how, [&](const RealisationKey& key, const Summary& summary) {
    how.stop.check();
    if (key.condition >= reductions.size()) {
      throw sqlite::UnusableFile("the store has a row of condition " + std::to_string(key.condition) +
                                 ", which is not in its experiment");
    }
    Reduction& reduction = reductions[key.condition];
    if (key.realisation == reduction.realisations()) reduction.add(summary);  // else an earlier one is missing
    if (also) also(key, summary);
  });
  ExperimentResult result;
  base::Sha256Builder digest;
  for (std::size_t i = 0; i < reductions.size(); ++i) {
    how.stop.check();
    if (!reductions[i].is_complete()) return std::nullopt;
    digest.add(reductions[i].digest());
    result.conditions.push_back(reductions[i].result());
  }
  result.digest = digest.finish();
  result.tolerance_sensitivity = tolerance_sensitivity(result.conditions, highest_confidence(experiment));
  return result;
}

std::optional<ExperimentResult> run(const Experiment& experiment, const RunOptions& options) {
  Store store =
      Store::in_memory({.experiment = experiment.canonical_text, .code = "", .files = "", .shard = std::nullopt});
  if (run(experiment, store, options) == RunEnd::stopped) return std::nullopt;
  return result_of(experiment, store);
}

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
