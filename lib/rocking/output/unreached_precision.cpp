#include "rocking/output/run_table.hpp"

#include <algorithm>
#include <cstddef>

#include "rocking/base/error.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_unreached_listed = 5;

double half_width_of(const ModeEstimate& mode) {
  const stats::Interval& interval = mode.probability.quoted();
  return 0.5 * (interval.high - interval.low);
}

/// The mode whose interval kept the condition from stopping; absent if it is one that did not occur.
const ModeEstimate* decisive_mode(const Until& until, const ConditionResult& result) {
  ROCKING_EXPECT(!result.modes.empty());
  if (!until.mode) return &*std::ranges::max_element(result.modes, {}, half_width_of);
  const auto found = std::ranges::find(result.modes, *until.mode, &ModeEstimate::mode);
  return found == result.modes.end() ? nullptr : &*found;
}

/// `overturned: 2.3 % instead of 2 %`
std::string shortfall(const Until& until, const ConditionResult& result) {
  const ModeEstimate* mode = decisive_mode(until, result);
  const double wanted = until.relative_half_width ? *until.relative_half_width : *until.half_width;
  const std::string of_wanted = " instead of " + significant(100.0 * wanted, 3) + " %";
  if (mode == nullptr) return to_string(*until.mode) + ": did not occur";
  if (!until.relative_half_width) {
    return to_string(mode->mode) + ": " + significant(100.0 * half_width_of(*mode), 3) + " %" + of_wanted;
  }
  if (mode->probability.counts.successes == 0) return to_string(mode->mode) + ": did not occur";
  const double reached = half_width_of(*mode) / mode->probability.estimate;
  return to_string(mode->mode) + ": " + significant(100.0 * reached, 3) + " % of the estimate" + of_wanted;
}

}  // namespace

std::string unreached_precision(const Experiment& experiment, const Report& report) {
  std::string list;
  std::size_t number = 0;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Condition& condition = experiment.conditions[i];
    const ConditionResult& result = report.conditions[i].result;
    if (result.stopped_because != StoppedBecause::at_most_reached || !condition.until) continue;
    if (++number > most_unreached_listed) continue;
    const std::string name = values_of(condition.parameters);
    list += "  " + (name.empty() ? "" : name + "; ") + shortfall(*condition.until, result) + '\n';
  }
  if (number == 0) return "";
  if (number > most_unreached_listed) list += "  and " + std::to_string(number - most_unreached_listed) + " more\n";
  return "the wanted half-width was not reached in " + std::to_string(number) + " of " +
         counted(report.conditions.size(), "condition") + ", which have all the realisations that `at_most` allows:\n" +
         list + "raise `at_most`, or accept a larger half-width\n";
}

}  // namespace rocking
