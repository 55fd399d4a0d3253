// The answer of a report in one sentence, which terminal, page and sheet tell in the same words.

#include <algorithm>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// What is told of a curve.
struct Told {
  const CurveRun* run;
  const CurveSubject* subject;
  const AnnualRate* rate;   ///< null: there is none
  std::string sentence;     ///< of the rate
  std::size_t records = 0;  ///< of a suite
  std::string shares = {};  ///< likewise, from the weakest to the strongest level
};

bool belong_together(const Told& a, const Told& b) {
  return a.run->experiment == b.run->experiment && a.subject->event == b.subject->event;
}

Told told_of(const ReportedCurve& reported) {
  const CurveSubject& subject = reported.curve.subject;
  return {.run = &reported.run,
          .subject = &subject,
          .rate = rate_of(reported),
          .sentence = reported.rate ? rate_sentence(subject, *reported.rate) : ""};
}

Told told_of(const ReportedSuite& reported) {
  const SuiteCurve& curve = reported.curve;
  const auto at = [&curve](const SuiteLevel& level) {
    return per_cent(level.estimate) + " % at " + at_intensity(curve.subject, significant(level.intensity, 6));
  };
  return {.run = &reported.run,
          .subject = &curve.subject,
          .rate = rate_of(reported),
          .sentence = reported.rate ? rate_sentence(curve.subject, *reported.rate) : "",
          .records = curve.records.size(),
          .shares = curve.levels.empty()       ? ""
                    : curve.levels.size() == 1 ? at(curve.levels.front())
                                               : at(curve.levels.front()) + " to " + at(curve.levels.back())};
}

/// Of the first option.
std::string beginning(const Told& first) {
  if (first.rate != nullptr) return first.sentence;
  return block_of(*first.subject) + ' ' + did(first.subject->event) + " in " + first.shares + " (mean over " +
         counted(first.records, "ground motion") + ')';
}

/// Of another option: its rate as a multiple of that of the first one.
std::string continuation(const Told& option, const FragilityReport& report) {
  const std::string with = "; with " + analysis::values_in_words(option.subject->others) + ' ';
  if (option.rate == nullptr) return with + "in " + option.shares;
  const auto found = std::ranges::find_if(report.comparisons, [&option](const ReportedComparison& each) {
    return each.run.experiment == option.run->experiment && each.comparison.event == option.subject->event &&
           have_equal_values(each.comparison.option, option.subject->others);
  });
  if (found == report.comparisons.end() || !found->comparison.ratio) {
    return with + rate_with_level(*option.rate, option.subject->confidence);
  }
  return with + rate_in_words(*found->comparison.ratio, found->comparison.ratio_interval) + " times as often";
}

}  // namespace

std::string headline(const FragilityReport& report) {
  constexpr std::size_t most_options = 5;
  std::vector<std::vector<Told>> groups;
  for (const auto& curve : report.curves) {
    const Told told = std::visit([](const auto& reported) { return told_of(reported); }, curve);
    if (told.shares.empty() && told.rate == nullptr) continue;
    const auto found =
        std::ranges::find_if(groups, [&told](const auto& group) { return belong_together(group.front(), told); });
    (found == groups.end() ? groups.emplace_back() : *found).push_back(told);
  }
  std::string lines;
  for (const std::vector<Told>& group : groups) {
    lines += beginning(group.front());
    for (std::size_t i = 1; i < std::min(group.size(), most_options); ++i) lines += continuation(group[i], report);
    if (group.size() > most_options) lines += "; and " + counted(group.size() - most_options, "more option");
    lines += ".\n";
  }
  return lines;
}

}  // namespace rocking
