#include <algorithm>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/studies/rare/result.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

std::string event_words(const RareQuestion& question) {
  if (!question.event.peak_tilt) return "the block overturns within the horizon";
  return "the largest abs(Theta) within the horizon exceeds " + significant(*question.event.peak_tilt, 6);
}

std::string percentage(const std::optional<double>& relative) {
  return relative ? significant(100.0 * *relative, 2) + " %" : "-";
}

std::string warning_about(const RareEstimate& found) {
  switch (found.diagnosis) {
    case RareDiagnosis::none: return "";
    case RareDiagnosis::not_found:
      return "the last pilot run has not seen the event; the interval may be far off. Use more --particles";
    case RareDiagnosis::few_repetitions:
      return "finished in time: " + counted(found.repetitions.size(), "repetition") +
             ". An interval needs 8. Give more time, or fewer --particles";
    case RareDiagnosis::uneven:
      return "a tenth of the repetitions missed the event, or one has more than a third of the sum; the interval may "
             "be "
             "too narrow. Use more --particles";
  }
  return "";
}

std::string end_of(const RareEstimate& found) {
  switch (found.end) {
    case RareEnd::precise: return "";
    case RareEnd::out_of_time: return "the time was up before the relative error was reached";
    case RareEnd::stopped: return "it was stopped before the relative error was reached; the same command goes on";
    case RareEnd::never_seen: return "no repetition saw the event";
    case RareEnd::most_repetitions:
      return "the largest number of repetitions was made before the relative error was reached";
  }
  return "";
}

std::string unresolved_words(const RareEstimate& found) {
  if (found.unresolved == 0.0) return "";
  return "motions that ended before their horizon without an answer have the probability " +
         significant(found.unresolved, 3) + "; the upper end of the interval counts them as the event";
}

/// A row for each suite; empty without any.
std::string suite_rows(const std::vector<RareSuite>& suites) {
  if (suites.empty()) return "";
  TextRow heading;
  for (const Parameter& parameter : suites.front().parameters) heading.push_back(last_key(parameter.pointer));
  for (const char* name : {"records", "probability", "from", "to", "error"}) heading.emplace_back(name);
  std::vector<TextRow> rows{heading};
  for (const RareSuite& suite : suites) {
    TextRow row;
    for (const Parameter& parameter : suite.parameters) row.push_back(short_value(parameter));
    row.insert(row.end(), {std::to_string(suite.records), suite.probability ? significant(*suite.probability, 3) : "-",
                           significant(suite.interval.low, 3), significant(suite.interval.high, 3),
                           percentage(suite.relative_error)});
    rows.push_back(std::move(row));
  }
  return "\nUnder one of the records of the suite, each of which is equally likely:\n\n" + aligned(rows);
}

}  // namespace

std::string rare_table(const RareReport& report) {
  const auto& conditions = report.conditions;
  TextRow heading;
  for (const Parameter& parameter : conditions.front().parameters) heading.push_back(last_key(parameter.pointer));
  for (const char* name : {"probability", "from", "to", "error", "repetitions", "work", "plain sampling"}) {
    heading.emplace_back(name);
  }
  std::vector<TextRow> rows{heading};
  std::string notes;
  double highest = 0.0;  // confidence
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const RareEstimate& estimate = conditions[c].estimate;
    highest = std::max(highest, conditions[c].confidence);
    TextRow row;
    for (const Parameter& parameter : conditions[c].parameters) row.push_back(short_value(parameter));
    row.insert(row.end(),
               {estimate.probability ? significant(*estimate.probability, 3) : "-",
                significant(estimate.interval.low, 3), significant(estimate.interval.high, 3),
                percentage(estimate.relative_error), std::to_string(estimate.repetitions.size()),
                significant(estimate.work, 3), estimate.crude_work ? significant(*estimate.crude_work, 3) : "-"});
    rows.push_back(std::move(row));
    for (const std::string& note : {end_of(estimate), warning_about(estimate), unresolved_words(estimate)}) {
      if (note.empty()) continue;
      notes += (conditions.size() > 1 ? "condition " + std::to_string(c) + ": " : "") + note + ".\n";
    }
  }
  return "Probability that " + event_words(report.question) + ".\n\n" + aligned(rows) + "from, to: interval with " +
         level_text(highest) +
         " % confidence; error: standard error over the probability; work, plain sampling: simulated\ntime in "
         "realisations to the horizon, by this method and by plain sampling for the same error.\n" +
         notes + suite_rows(report.suites);
}

}  // namespace rocking
