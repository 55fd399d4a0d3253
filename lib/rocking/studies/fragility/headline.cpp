// The answer of a report in one sentence, which terminal, page and sheet tell in the same words.

#include <algorithm>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/studies/fragility/words.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// `The block`, or of an option `With width 0.42 m the block`.
std::string block_of(const CurveSubject& subject) {
  const std::string option = analysis::values_in_words(subject.others);
  return option.empty() ? "The block" : "With " + option + " the block";
}

/// `mean annual rate 5.0e-4 [1.9e-4, 1.1e-3] (95 %)`.
std::string rate_with_interval(const AnnualRate& rate, double confidence) {
  return "mean annual rate " + rate_in_words(rate.value, rate.interval) +
         (rate.interval ? " (" + level_text(confidence) + " %)" : "");
}

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
    return with + rate_with_interval(*option.rate, option.subject->confidence);
  }
  return with + rate_in_words(*found->comparison.ratio, found->comparison.ratio_interval) + " times as often";
}

}  // namespace

std::string rate_in_words(double rate, const std::optional<stats::Interval>& interval) {
  return plain_text(look::number(rate, interval, look::rate_form()));
}

std::string in_years_text(double probability) { return rate_text(100.0 * probability); }

std::string at_intensity(const CurveSubject& subject, const std::string& value) {
  const analysis::Axis axis = analysis::axis_of_parameter(subject.parameter);
  return (axis.symbol.empty() ? axis.quantity + ' ' : axis.symbol + " = ") + value +
         (axis.unit.empty() ? "" : ' ' + axis.unit);
}

std::string counted_from_in_words(const CurveSubject& subject) {
  if (!subject.least_uplift) return "from all intensities";
  return "from " + at_intensity(subject, significant(*subject.least_uplift, 3)) + " on";
}

std::string why_counted_in_words(const CurveSubject& subject) {
  const std::string moves = subject.event.is_of_slip() ? "moves" : "lifts";
  return subject.least_uplift ? ", the least that " + moves + " the block"
                              : ", since the least that " + moves + " the block is not known";
}

std::string rate_sentence(const CurveSubject& subject, const AnnualRate& rate) {
  if (rate.value > 0.0) {
    return block_of(subject) + ' ' + does(subject.event) + " about once in " + years_in_words(1.0 / rate.value) +
           " years: " + rate_with_interval(rate, subject.confidence);
  }
  const auto at = [&subject](double intensity) { return at_intensity(subject, significant(intensity, 3)); };
  std::string none = block_of(subject) + " did not " + to_do(subject.event) + " at these levels: ";
  if (rate.hazard_ends) {
    const bool is_below = subject.least_uplift && *rate.hazard_ends <= *subject.least_uplift;
    none = block_of(subject) + " does not " + to_do(subject.event) + " by this hazard curve, whose rate is 0 from " +
           at(*rate.hazard_ends) + " on" +
           (is_below ? ", below the least that lifts the block, " + at(*subject.least_uplift) : "") + ": ";
  }
  if (!rate.interval || !(rate.interval->high > 0.0)) return none + rate_with_interval(rate, subject.confidence);
  return none + "mean annual rate at most " + rate_text(rate.interval->high) + " (" + level_text(subject.confidence) +
         " %), once in " + years_in_words(1.0 / rate.interval->high) + " years";
}

std::string rate_sentence(const CurveSubject& subject, const SuiteRate& rate) {
  const std::string sentence = rate_sentence(subject, rate.chosen);
  if (!(rate.chosen.value > 0.0)) return sentence;
  return sentence + "; what the levels leave open, " + undecided_in_words(rate) + ", raises it to at most " +
         rate_text(rate.at_most) + (rate.is_decided() ? "" : ": add " + added_levels_in_words(rate));
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
    lines += beginning(group.front());
    for (std::size_t i = 1; i < std::min(group.size(), most_options); ++i) lines += continuation(group[i], report);
    if (group.size() > most_options) lines += "; and " + counted(group.size() - most_options, "more option");
    lines += ".\n";
  }
  return lines;
}

}  // namespace rocking
