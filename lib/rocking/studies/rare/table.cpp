#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "rocking/output/parameter_text.hpp"
#include "rocking/studies/rare/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;

look::Cell in_per_cent(const std::optional<double>& relative) {
  return number(relative ? std::optional(100.0 * *relative) : std::nullopt, 2, " %");
}

std::string warning_about(const RareEstimate& found) {
  switch (found.diagnosis) {
    case RareDiagnosis::none: return "";
    case RareDiagnosis::not_found:
      return "the last pilot run has not seen the event; the interval may be far off. Use more --particles";
    case RareDiagnosis::few_repetitions:
      return "finished in time: fewer repetitions than the 8 that an interval needs. Give more time, or fewer "
             "--particles";
    case RareDiagnosis::uneven:
      return "a tenth of the repetitions missed the event, or one has more than a third of the sum; the interval may "
             "be too narrow. Use more --particles";
  }
  return "";
}

std::string method_words(const RareEstimate& found) {
  const bool is_plain = found.method == RareMethod::plain_sampling;
  return is_plain ? "sampled plainly: the pilot runs, before the first repetition, expected no gain from steering" : "";
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

constexpr std::string_view unresolved_words =
    "motions that ended before their horizon without an answer; the upper end of the interval counts them as the event";

/// What is to be said of conditions: each remark once, with a letter that stands in the rows to which it applies.
class Remarks {
 public:
  /// The letters of these remarks, of which some are empty.
  std::string letters(std::initializer_list<std::string> remarks) {
    std::string letters;
    for (const std::string& remark : remarks) {
      if (remark.empty()) continue;
      const auto known = std::ranges::find(said_, remark);
      letters += static_cast<char>('a' + (known - said_.begin()));
      if (known == said_.end()) said_.push_back(remark);
    }
    return letters;
  }
  [[nodiscard]] std::string lines(bool has_letters) const {
    std::string text;
    for (std::size_t i = 0; i < said_.size(); ++i) {
      text += (has_letters ? std::string{static_cast<char>('a' + i), ':', ' '} : "") + said_[i] + ".\n";
    }
    return text;
  }
  [[nodiscard]] bool any() const { return !said_.empty(); }

 private:
  std::vector<std::string> said_;
};

/// A row for each suite; empty without any.
std::string suite_rows(const std::vector<RareSuite>& suites) {
  if (suites.empty()) return "";
  look::Table table = table_of(suites.front().parameters, {"records", "probability", "from", "to", "error"});
  table.title = "\nUnder one of the records of the suite, each of which is equally likely:\n";
  table.absent = "-";
  for (const RareSuite& suite : suites) {
    table.rows.push_back(row_of(
        suite.parameters, {look::whole(suite.records), number(suite.probability, 3), number(suite.interval.low, 3),
                           number(suite.interval.high, 3), in_per_cent(suite.relative_error)}));
  }
  return to_terminal(table);
}

}  // namespace

/// The least and the largest probability, of one record of a suite.
static std::string answer_of(const RareReport& report, const std::string& degrees) {
  std::vector<std::pair<double, std::string>> all;
  const auto add = [&all](const auto& parameters, std::optional<double> probability, const stats::Interval& interval) {
    const std::string place = values_of(parameters);
    all.emplace_back(probability.value_or(interval.high),
                     (probability ? plain_text(number(*probability, std::optional(interval), 3))
                                  : "at most " + significant(interval.high, 3)) +
                         (place.empty() ? "" : " at " + place));
  };
  for (const auto& suite : report.suites) add(suite.parameters, suite.probability, suite.interval);
  for (const auto& [parameters, confidence, found] : report.conditions) {
    if (report.suites.empty()) add(parameters, found.probability, found.interval);
  }
  const auto [least, most] = std::ranges::minmax(all);
  return "the block " + does(report.question.event) + degrees + " within the horizon with a probability of " +
         least.second + (all.size() == 1 ? "" : " to " + most.second) +
         (report.suites.empty() ? "" : " under a record of the suite") + ", with " +
         level_text(report.conditions.front().confidence) + " % confidence";
}

std::string rare_table(const RareReport& report, const std::string& degrees) {
  const auto& conditions = report.conditions;
  const bool are_several = conditions.size() > 1;
  const bool has_unresolved =
      std::ranges::any_of(conditions, [](const auto& one) { return one.estimate.unresolved > 0.0; });
  look::Table table = table_of(conditions.front().parameters, {"probability", "from", "to", "error", "repetitions",
                                                               "ancestors", "work", "plain sampling"});
  if (has_unresolved) add_columns(table, {"unresolved"});
  table.title = answer_of(report, degrees) + '\n';
  table.absent = "-";
  Remarks remarks;
  std::vector<std::string> letters;
  double highest = 0.0;  // confidence
  for (const auto& condition : conditions) {
    const RareEstimate& estimate = condition.estimate;
    highest = std::max(highest, condition.confidence);
    look::Row& row = table.rows.emplace_back(
        row_of(condition.parameters,
               {number(estimate.probability, 3), number(estimate.interval.low, 3), number(estimate.interval.high, 3),
                in_per_cent(estimate.relative_error), look::whole(estimate.repetitions.size()),
                look::whole(estimate.ancestors), number(estimate.work, 3), number(estimate.crude_work, 3)}));
    if (has_unresolved) row.push_back(number(estimate.unresolved, 3));
    letters.push_back(remarks.letters({method_words(estimate), end_of(estimate), warning_about(estimate)}));
  }
  if (are_several && remarks.any()) {
    add_columns(table, {"remarks"});
    for (std::size_t c = 0; c < conditions.size(); ++c)
      table.rows[c].push_back(letters[c].empty() ? look::Cell() : letters[c]);
  }
  table.notes = "from, to: interval with " + level_text(highest) +
                " % confidence; error: standard error over the probability; ancestors: first trajectories of\na "
                "repetition from which those with the event descend, median; work, plain sampling: simulated time in "
                "realisations\nto the horizon, by this method and by plain sampling for the same error.\n" +
                (has_unresolved ? "unresolved: probability of " + std::string(unresolved_words) + ".\n" : "") +
                remarks.lines(are_several);
  return to_terminal(table) + suite_rows(report.suites);
}

}  // namespace rocking
