#include "rocking/output/fragility_words.hpp"

#include <cmath>

#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

std::string_view word_of(stats::FragilityOutcome outcome) {
  using stats::FragilityOutcome;
  switch (outcome) {
    case FragilityOutcome::fitted: return "fitted";
    case FragilityOutcome::never_happened: return "never_happened";
    case FragilityOutcome::always_happened: return "always_happened";
    case FragilityOutcome::separated: return "separated";
    case FragilityOutcome::does_not_rise: return "does_not_rise";
    case FragilityOutcome::no_scatter: return "no_scatter";
    case FragilityOutcome::rejected: return "rejected";
    case FragilityOutcome::not_monotone: return "not_monotone";
    case FragilityOutcome::too_little: break;
  }
  return "too_little";
}

std::string words_of(const FragilityEvent& event) {
  return event.peak_tilt ? "a peak tilt above " + significant(*event.peak_tilt, 6) : "overturning";
}

std::string column_of(const FragilityEvent& event) {
  return event.peak_tilt ? "tilt > " + significant(*event.peak_tilt, 6) : "overturned";
}

Json event_json(const FragilityEvent& event) {
  if (!event.peak_tilt) return "overturned";
  return {{"peak_tilt", *event.peak_tilt}};
}

Json open_interval_json(const stats::Interval& interval) {
  return Json::array({interval.low, std::isfinite(interval.high) ? Json(interval.high) : Json()});
}

std::string interval_in_words(const stats::Interval& interval) {
  return '[' + significant(interval.low, 3) + ", " +
         (std::isfinite(interval.high) ? significant(interval.high, 3) : "unbounded") + ']';
}

std::string bounded_in_words(const stats::Bounded& bounded) {
  return significant(bounded.value, 3) + ' ' + interval_in_words(bounded.interval);
}

std::string heading_of_curve(const Experiment& experiment, const std::vector<Parameter>& others) {
  std::string heading = experiment.title;
  for (const Parameter& parameter : others) {
    heading += (heading.empty() ? "" : "; ") + parameter.pointer.substr(1) + ' ' + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

}  // namespace rocking
