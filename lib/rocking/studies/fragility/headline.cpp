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
  std::string sentence;     ///< of the rate, or of the median of one motion
  std::size_t records = 0;  ///< of a suite
  std::string shares = {};  ///< from the weakest to the strongest level
};

/// Options of one run.
bool belong_together(const Told& a, const Told& b) {
  return a.run->experiment == b.run->experiment && a.run->title == b.run->title &&
         a.subject->event == b.subject->event && !have_equal_values(a.subject->others, b.subject->others);
}

/// `0.0 % at PGA = 0.2 g to 94.3 % at PGA = 0.8 g`.
template <class Curve>
std::string shares_of(const Curve& curve) {
  const auto at = [&curve](const auto& level) {
    return per_cent(level.estimate) + " % at " + at_intensity(curve.subject, significant(level.intensity, 6));
  };
  if (curve.levels.empty()) return "";
  return at(curve.levels.front()) + (curve.levels.size() == 1 ? "" : " to " + at(curve.levels.back()));
}

std::string median_sentence(const FragilityCurve& curve) {
  const CurveSubject& subject = curve.subject;
  return block_of(subject) + ' ' + does(subject.event) + in_degrees(subject.event, subject.balance) +
         " with a probability of 1/2 at " + at_intensity(subject, bounded_in_words(curve.law->median)) +
         (curve.law->is_extrapolated ? ", outside the levels" : "");
}

template <class Reported>
Told told_of(const Reported& reported) {
  const auto& curve = reported.curve;
  Told told{.run = &reported.run,
            .subject = &curve.subject,
            .rate = rate_of(reported),
            .sentence = reported.rate ? rate_sentence(curve.subject, *reported.rate) : "",
            .shares = shares_of(curve)};
  if constexpr (requires { curve.records; }) {
    told.records = curve.records.size();
  } else if (!reported.rate && curve.law) {
    told.sentence = median_sentence(curve);
  }
  return told;
}

/// Of the first option.
std::string beginning(const Told& first) {
  if (!first.sentence.empty()) return first.sentence;
  const CurveSubject& subject = *first.subject;
  return block_of(subject) + ' ' + did(subject.event) + in_degrees(subject.event, subject.balance) + " in " +
         first.shares +
         (first.records > 0 ? " (mean over " + counted(first.records, "ground motion") + ')' : " of the realisations");
}

/// Of another option: its rate as a multiple of that of the first one.
std::string continuation(const Told& option, const FragilityReport& report) {
  const std::string values = analysis::values_in_words(option.subject->others);
  const std::string with = are_named(option.subject->others) ? "; " + values + ": " : "; with " + values + ' ';
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

std::string name_before(std::string_view separator, const FragilityReport& report, const CurveRun& run) {
  const bool are_several = std::ranges::any_of(report.curves, [&run](const auto& curve) {
    return std::visit([](const auto& reported) { return reported.run.title; }, curve) != run.title;
  });
  return are_several && !run.title.empty() ? run.title + std::string(separator) : "";
}

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
    lines += name_before(": ", report, *group.front().run) + beginning(group.front());
    for (std::size_t i = 1; i < std::min(group.size(), most_options); ++i) lines += continuation(group[i], report);
    if (group.size() > most_options) lines += "; and " + counted(group.size() - most_options, "more option");
    lines += ".\n";
  }
  return lines;
}

}  // namespace rocking
