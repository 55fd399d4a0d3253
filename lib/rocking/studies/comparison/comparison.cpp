#include "rocking/studies/comparison/study.hpp"

#include <algorithm>
#include <utility>

#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using section::ResponseMode;

/// Realisations by their modes in the first and in the second run.
using Table = std::map<std::pair<ResponseMode, ResponseMode>, std::uint64_t>;

void add_statistics(ModeComparison& mode, double confidence) {
  const stats::PairedCounts& counts = mode.counts;
  const auto trials = static_cast<double>(counts.trials());
  mode.in_first = static_cast<double>(counts.both + counts.first_only) / trials;
  mode.in_second = static_cast<double>(counts.both + counts.second_only) / trials;
  mode.difference = stats::paired_difference(counts);
  mode.score = stats::paired_difference_score(counts, confidence);
  mode.exact = stats::paired_difference_exact(counts, confidence);
  mode.test = stats::mcnemar(counts);
  mode.variance_reduction = stats::variance_reduction(counts).factor;
}

ConditionComparison compared(const Table& table, double confidence) {
  ConditionComparison result;
  result.confidence = confidence;
  for (const auto& [modes, count] : table) {
    result.realisations += count;
    if (modes.first != modes.second) result.changed.counts.successes += count;
    result.modes[modes.first];
    result.modes[modes.second];
  }
  result.changed.counts.trials = result.realisations;
  result.changed.interval = stats::clopper_pearson(result.changed.counts, confidence);
  for (auto& [mode, comparison] : result.modes) {
    stats::PairedCounts& counts = comparison.counts;
    for (const auto& [modes, count] : table) {
      const bool in_first = modes.first == mode;
      const bool in_second = modes.second == mode;
      (in_first && in_second ? counts.both
       : in_first            ? counts.first_only
       : in_second           ? counts.second_only
                             : counts.neither) += count;
    }
    add_statistics(comparison, confidence);
  }
  return result;
}

}  // namespace

std::optional<base::Problem> why_not_comparable(const ComparedRun& first, const ComparedRun& second) {
  const auto& one = first.experiment.conditions;
  const auto& other = second.experiment.conditions;
  if (first.experiment.seed != second.experiment.seed) {
    return base::Problem{
        "/seed", "",
        first.name + " and " + second.name +
            " have different seeds, so no common random numbers; run one of them again with the seed of the other",
        ""};
  }
  if (one.size() != other.size()) {
    return base::Problem{"/sweep", "",
                         first.name + " has " + counted(one.size(), "condition") + ", " + second.name + " has " +
                             counted(other.size(), "condition") + "; compare runs with the same number of conditions",
                         ""};
  }
  const auto [of_first, of_second] =
      std::ranges::mismatch(one, other, {}, &Condition::record_stream, &Condition::record_stream);
  if (of_first == one.end()) return std::nullopt;
  return base::Problem{"/excitation/suite", "",
                       "condition " + std::to_string(of_first - one.begin()) + " of " + first.name + " and of " +
                           second.name +
                           " has different records of a suite, so no common random numbers; compare runs with the same "
                           "records in the same order",
                       ""};
}

std::vector<ConditionComparison> compare(const Store& first, const Store& second, std::span<const double> confidences) {
  std::vector<Table> tables(confidences.size());
  first.for_each([&](const RealisationKey& key, const Summary& summary) {
    if (key.condition >= tables.size()) return;
    if (const auto other = second.find(key)) ++tables[key.condition][{summary.mode, other->mode}];
  });
  std::vector<ConditionComparison> result;
  for (std::size_t i = 0; i < tables.size(); ++i) result.push_back(compared(tables[i], confidences[i]));
  return result;
}

std::size_t number_of_tests(std::span<const ConditionComparison> conditions) {
  std::size_t tests = 0;
  for (const ConditionComparison& condition : conditions) tests += condition.modes.size();
  return tests;
}

Comparison compare(const StoredRun& first, const StoredRun& second) {
  const Experiment& experiment = first.experiment;
  if (auto found = why_not_comparable({experiment, "the first run"}, {second.experiment, "the second run"})) {
    throw base::InputError(std::move(*found));
  }
  std::vector<double> confidences;
  for (const Condition& condition : experiment.conditions) confidences.push_back(condition.confidence);
  return comparison_of(with_text(experiment), with_text(second.experiment),
                       compare(store_of(first.run), store_of(second.run), confidences));
}

}  // namespace rocking
