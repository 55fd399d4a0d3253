#include "rocking/experiment/comparison.hpp"

#include <utility>

namespace rocking::experiment {
namespace {

using section::ResponseMode;

/// How often which mode of the first run met which of the second.
using Table = std::map<std::pair<ResponseMode, ResponseMode>, std::uint64_t>;

ConditionComparison compared(const Table& table) {
  ConditionComparison result;
  for (const auto& [modes, count] : table) {
    result.realisations += count;
    if (modes.first != modes.second) result.changed.successes += count;
    result.modes[modes.first];
    result.modes[modes.second];
  }
  result.changed.trials = result.realisations;
  for (auto& [mode, counts] : result.modes) {
    for (const auto& [modes, count] : table) {
      const bool in_first = modes.first == mode;
      const bool in_second = modes.second == mode;
      (in_first && in_second ? counts.both
       : in_first            ? counts.first_only
       : in_second           ? counts.second_only
                             : counts.neither) += count;
    }
  }
  return result;
}

}  // namespace

std::vector<ConditionComparison> compare(const Store& first, const Store& second, std::size_t conditions) {
  std::vector<Table> tables(conditions);
  first.for_each([&](const RealisationKey& key, const Summary& summary) {
    if (key.condition >= conditions) return;
    if (const auto other = second.find(key)) ++tables[key.condition][{summary.mode, other->mode}];
  });
  std::vector<ConditionComparison> result;
  for (const Table& table : tables) result.push_back(compared(table));
  return result;
}

}  // namespace rocking::experiment
