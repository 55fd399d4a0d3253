#include <algorithm>
#include <cstddef>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// Tolerances below this one reach no more digits in double precision (reports/evidence/accuracy.md).
constexpr double finest_useful_tolerance = 1e-15;
constexpr std::size_t most_conditions_listed = 5;

/// `condition 1 (amplitude 4.2)`, and without parameters `the only condition`.
std::string condition_in_words(const Report& report, std::size_t condition) {
  const std::string values = values_of(report.conditions[condition].asked.parameters);
  if (values.empty() && report.conditions.size() == 1) return "the only condition";
  return "condition " + std::to_string(condition) + (values.empty() ? "" : " (" + values + ')');
}

/// The key and its value, or what is left if the tolerance is at the limit of double precision.
std::string tolerance_remedy(const Report& report) {
  double tightest = 1.0;
  for (const ReportedCondition& each : report.conditions) tightest = std::min(tightest, each.asked.tolerance);
  if (tightest <= finest_useful_tolerance) {
    return "/accuracy/tolerance is at the limit of double precision: these changes are due to rounding. Treat the "
           "share that changes as an uncertainty of every probability, in addition to its interval";
  }
  return "set /accuracy/tolerance to " + base::significant(std::max(finest_useful_tolerance, tightest / 100.0), 2) +
         " and run again";
}

Finding sensitivity(const Report& report) {
  Finding found{.name = std::string(tolerance_check), .rating = Rating::note};
  const auto& reruns = report.tolerance_sensitivity;
  if (!reruns) {
    found.text = "not measured: no realisation was rerun at another tolerance";
    return found;
  }
  if (reruns->noise == NumericalError::small) found.rating = Rating::fine;
  if (reruns->noise == NumericalError::not_small) {
    found.rating = Rating::look;
    found.remedy = tolerance_remedy(report);
  }
  found.text = std::to_string(reruns->flips.successes) + " of " + std::to_string(reruns->flips.trials) +
               " response modes change at a hundred times tighter tolerance " + per_cent(reruns->interval) + " %";
  if (reruns->noise == NumericalError::undecided) {
    found.remedy = "more reruns tell more: a smaller /accuracy/rerun_every";
  } else {
    found.text += std::string(reruns->noise == NumericalError::small ? "; small" : "; NOT small") +
                  " compared with the narrowest half-width, " + per_cent(reruns->half_width) + " %";
  }
  return found;
}

Finding unresolved(const Report& report) {
  const UnresolvedResponses found = unresolved_responses(report);
  const char* name = "unresolved responses";
  if (found.count == 0) return {.name = name, .rating = Rating::fine, .text = "every response is classified"};
  return {.name = name,
          .rating = found.largest_share > worrying_unresolved_share ? Rating::look : Rating::note,
          .text = std::to_string(found.count) + " of " + counted(realisations_of(report), "realisation") + " (" +
                  per_cent(found.share) + " %) are unresolved, most in " + condition_in_words(report, found.where) +
                  ": " + per_cent(found.largest_share) + " %",
          .remedy = unresolved_remedy(report)};
}

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

Finding enough(const Report& report) {
  std::string list;
  std::size_t number = 0;
  for (const auto& [asked, states_horizon, shaking, scale, floor, result] : report.conditions) {
    if (result.stopped_because != StoppedBecause::at_most_reached || ++number > most_conditions_listed || !asked.until)
      continue;
    const std::string values = values_of(asked.parameters);
    list += (list.empty() ? ": " : "; ") + (values.empty() ? "" : values + ", ") + shortfall(*asked.until, result);
  }
  if (number > most_conditions_listed) list += "; and " + std::to_string(number - most_conditions_listed) + " more";
  Finding found{.name = "enough realisations", .rating = Rating::fine};
  if (number > 0) {
    found.rating = Rating::look;
    found.text = "the wanted half-width was not reached in " + std::to_string(number) + " of " +
                 counted(report.conditions.size(), "condition") +
                 ", which have all the realisations that `at_most` allows" + list;
    found.remedy = "raise `at_most`, or accept a larger half-width";
  } else if (report.is_random()) {
    found.text = "the half-width of the widest interval is " + per_cent(widest_half_width(report)) + " %";
  } else {
    found.text = "nothing is random: one realisation of a condition is enough";
  }
  return found;
}

}  // namespace

std::vector<Finding> precision_findings(const Report& report) {
  return {sensitivity(report), unresolved(report), enough(report)};
}

}  // namespace rocking
