#include "rocking/studies/fragility/sheet.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_records_named = 30;
constexpr std::size_t most_options = 5;

const ResponseEvent& event_of(const SheetContent& sheet) { return sheet.suites.front().curve.subject.event; }

/// `a peak tilt above 0.5 psi (6.2 to 8.9 degrees)`, over the options.
std::string asked_event(const SheetContent& sheet) {
  std::optional<BalanceAngles> balance;
  for (const ReportedSuite& suite : sheet.suites) {
    if (suite.curve.subject.balance) balance = joined(balance, *suite.curve.subject.balance);
  }
  return words_of(event_of(sheet)) + in_degrees(event_of(sheet), balance);
}

std::span<const ReportedSuite> shown_suites(const SheetContent& sheet) {
  return std::span(sheet.suites).first(std::min(sheet.suites.size(), most_options));
}

/// A fact of each option, `1.2 % (width 0.35 m); 1.8 % (width 0.42 m)`; once where it is the same of all. Empty facts are
/// left out.
template <class Fact>
std::string by_option(const SheetContent& sheet, const Fact& fact_of) {
  std::string text, first;
  std::size_t equal = 0;
  for (const ReportedSuite& suite : shown_suites(sheet)) {
    const std::string fact = fact_of(suite);
    if (&suite == sheet.suites.data()) first = fact;
    equal += fact == first ? 1 : 0;
    if (fact.empty()) continue;
    text += (text.empty() ? "" : "; ") + fact + " (" + values_in_words(suite.curve.subject.others) + ')';
  }
  return escaped(equal == shown_suites(sheet).size() ? first : text);
}

/// The answer, a paragraph a line.
std::string answer(const SheetContent& sheet) {
  return "<p class=\"answer\">" + escaped(sheet.headline.substr(0, sheet.headline.find_last_not_of('\n') + 1)) +
         "</p>\n";
}

/// Whether the blocks still stand, where that is asked.
std::string survived(const SheetContent& sheet) {
  if (!sheet.survival) return "";
  std::string words = survival_in_words(*sheet.survival);
  words.front() = 'P';
  std::string text = fmt::format("<p class=\"answer\">{}.</p>\n", escaped(words));
  if (sheet.survival->branches.size() < 2) return text;
  text += "<p class=\"small\">Weights of the hazard curves:";
  for (const SurvivalBranch& branch : sheet.survival->branches) {
    text += fmt::format(" {} {}{}", escaped(last_part(branch.hazard)), rate_text(branch.weight),
                        &branch == &sheet.survival->branches.back() ? ".</p>\n" : ",");
  }
  return text;
}

/// The period of a spectral acceleration, or its range.
std::string periods_sentence(const std::vector<double>& periods) {
  if (periods.empty()) return "";
  const bool is_range = periods.size() > 1;
  return fmt::format(" The spectral acceleration is that at {}T = {}{} s.", is_range ? "periods " : "",
                     significant(periods.front(), 4), is_range ? " to " + significant(periods.back(), 4) : "");
}

std::string paragraph(bool is_warning, const std::string& beginning, const std::string& facts) {
  return facts.empty() ? "" : fmt::format("<p{}>{}{}.</p>\n", is_warning ? " class=\"warning\"" : "", beginning, facts);
}

std::string motions(const SheetContent& sheet) {
  const std::vector<RecordCurve>& records = sheet.suites.front().curve.records;
  std::string names;
  for (std::size_t i = 0; i < std::min(records.size(), most_records_named); ++i) {
    names += (i == 0 ? "" : ", ") + escaped(last_part(records[i].name));
  }
  if (records.size() > most_records_named) names += fmt::format(", and {} more", records.size() - most_records_named);
  const auto missing = left_out_records(sheet.run.left_out);
  return fmt::format(
             "<h2>Hazard and records</h2>\n<p>{}: {}.{}</p>\n<p class=\"small\">{} records, each scaled to {} levels "
             "from {} to {}: {}.</p>\n",
             escaped(last_part(sheet.hazard.name)), escaped(hazard_in_words(sheet.hazard)),
             periods_sentence(sheet.periods), records.size(), sheet.suites.front().curve.levels.size(),
             significant(sheet.suites.front().curve.levels.front().intensity, 3),
             significant(sheet.suites.front().curve.levels.back().intensity, 3), names) +
         paragraph(false, "The block stands ", escaped(floor_in_words(sheet.run))) +
         (missing ? fmt::format("<p class=\"small\">{}.</p>\n", escaped(in_words(*missing))) : "");
}

/// The share of balance that a tilt must exceed.
std::optional<double> share_of_balance(const ResponseEvent& event) {
  return event.name == EventName::tilt ? std::optional(event.threshold) : std::nullopt;
}

/// The options to scale beside the curves, and their numbers.
std::string top(const SheetContent& sheet) {
  const std::string event = escaped(asked_event(sheet));
  const std::string curve =
      sheet.curve_png.empty() ? ""
                              : fmt::format(
                                    "<div class=\"curve\"><img src=\"{1}\" alt=\"Probability of {0} as a function of "
                                    "the intensity\"><p class=\"small\">Probability of {0}: means over the records, "
                                    "the law or the nearest shares that do not decrease, and their bands.</p></div>\n",
                                    event, data_address("png", sheet.curve_png));
  return "<div class=\"top\">\n<div class=\"object\">" + object_drawings(sheet.run) + "</div>\n" + curve + "</div>\n" +
         object_facts(sheet.run, share_of_balance(event_of(sheet)));
}

/// A number with its interval below. `label`: heading of its column, for narrow screens.
std::string cell(const std::string& label, const std::string& value, const std::string& interval) {
  return fmt::format("<td data-label=\"{}\">{}{}</td>", label, value,
                     interval.empty() ? "" : "<br><span class=\"small\">" + interval + "</span>");
}

std::string rate_cell(const std::string& label, double rate, const std::optional<stats::Interval>& interval) {
  return cell(label, rate_text(rate), interval ? plain_text(look::interval(interval, look::rate_form())) : "");
}

/// The return period of a rate.
std::string period_cell(const std::string& label, const AnnualRate& rate) {
  const auto years = [](double value) { return value > 0.0 ? years_in_words(1.0 / value) : std::string("&infin;"); };
  return cell(label, years(rate.value),
              rate.interval ? '[' + years(rate.interval->high) + ", " + years(rate.interval->low) + ']' : "");
}

/// Those that are asked for, or the usual ones [years].
std::vector<double> horizons(const SheetContent& sheet) {
  std::vector<double> years;
  for (const RateInYears& each : sheet.suites.front().rate->chosen.in_years) years.push_back(each.years);
  return years.empty() ? std::vector<double>{1.0, 50.0, 475.0} : years;
}

/// The rate of an option as a factor of that of the first one.
std::string factor_cell(const SheetContent& sheet, const ReportedSuite& suite) {
  for (const auto& [run, found] : sheet.comparisons) {
    if (!have_equal_values(found.option, suite.curve.subject.others)) continue;
    return found.ratio ? rate_cell("factor", *found.ratio, found.ratio_interval) : cell("factor", "unknown", "");
  }
  return cell("factor", "1", "");
}

std::string rates(const SheetContent& sheet) {
  const bool has_options = !sheet.comparisons.empty();
  const std::vector<double> years = horizons(sheet);
  std::vector<std::string> headings{"per year", "once in [years]"};
  const auto heading_of = [](double time) {
    return fmt::format("in {} {} [%]", base::shortest(time), time == 1.0 ? "year" : "years");
  };
  for (const double each : years) headings.push_back(heading_of(each));
  if (has_options) headings.emplace_back("factor");
  std::string rows, head;
  for (const std::string& heading : headings) head += "<th>" + heading + "</th>";
  for (const ReportedSuite& suite : shown_suites(sheet)) {
    const AnnualRate& rate = suite.rate->chosen;
    const std::string option = values_in_words(suite.curve.subject.others);
    rows += "<tr><th>" + escaped(option.empty() ? asked_event(sheet) : option) + "</th>" +
            rate_cell(headings[0], rate.value, rate.interval) + period_cell(headings[1], rate);
    for (const auto& [horizon, probability, interval] : in_years(rate, years)) {
      rows += cell(heading_of(horizon), in_years_text(probability),
                   interval ? '[' + in_years_text(interval->low) + ", " + in_years_text(interval->high) + ']' : "");
    }
    rows += (has_options ? factor_cell(sheet, suite) : "") + "</tr>\n";
  }
  std::string notes =
      fmt::format("In brackets: {} % intervals.", level_text(sheet.suites.front().curve.subject.confidence));
  if (has_options) {
    notes += fmt::format(
        " Factor: rate over that of the first row, with the same records and random numbers, by {} as the rates.",
        source_in_words(sheet.comparisons.front().comparison.source));
  }
  if (sheet.suites.size() > most_options) {
    notes += fmt::format(" {} more options are in the output of the command.", sheet.suites.size() - most_options);
  }
  return fmt::format(
      "<h2>Rate of {}</h2>\n<table><thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}</tbody></table>\n<p "
      "class=\"small\">{}</p>\n",
      escaped(asked_event(sheet)), head, rows, notes);
}

/// What was found when the ground motions were read.
std::string reading_warnings(const Report& run) {
  std::string text;
  std::size_t count = 0;
  constexpr std::size_t most_named = 5;
  for (const UsedGroundMotion& used : run.ground_motions) {
    for (const std::string& warning : used.facts.warnings) {
      if (++count <= most_named) text += (text.empty() ? "" : "; ") + last_part(used.facts.file) + ' ' + warning;
    }
  }
  if (count > most_named) text += "; and " + std::to_string(count - most_named) + " more on the page of the run";
  return paragraph(true, "Reading of the records: ", escaped(text));
}

/// What limits the answer, beside the model: the hazard curve, the records and the levels.
std::string limits(const SheetContent& sheet) {
  const bool is_far = std::ranges::any_of(sheet.suites, [](const ReportedSuite& suite) {
    return suite.rate->chosen.extrapolated_hazard > most_extrapolated_hazard;
  });
  return "<h2>Limits of the data</h2>\n" +
         paragraph(true, "A look is needed: ",
                   by_option(sheet,
                             [](const ReportedSuite& suite) {
                               std::string text;
                               for (const std::string& doubt : hazard_doubts(suite.rate->chosen))
                                 text += (text.empty() ? "" : "; ") + doubt;
                               return text;
                             })) +
         paragraph(is_far, "From beyond the last point of the hazard curve: ",
                   by_option(sheet,
                             [](const ReportedSuite& suite) {
                               const AnnualRate& rate = suite.rate->chosen;
                               return rate.value > 0.0 ? per_cent(rate.extrapolated_hazard) + " % of the rate" : "";
                             })) +
         paragraph(true, "Records: ", escaped(in_words(far_scaled(sheet.run.ground_motions)))) +
         reading_warnings(sheet.run) +
         paragraph(true, "The rates by law and by isotonic shares differ: ",
                   by_option(sheet,
                             [](const ReportedSuite& suite) {
                               const SuiteRate& rate = *suite.rate;
                               if (rate.do_estimates_agree()) return std::string();
                               return disagreement_in_words(rate) + ", add the levels " + added_levels_in_words(rate);
                             })) +
         paragraph(true, "Undecided by the levels: ", by_option(sheet, [](const ReportedSuite& suite) {
                     const SuiteRate& rate = *suite.rate;
                     if (rate.is_decided()) return std::string();
                     return undecided_in_words(rate) + ", add the levels " + added_levels_in_words(rate);
                   }));
}

std::string basis(const SheetContent& sheet) {
  const ReportedSuite& object = sheet.suites.front();
  const SuiteRate& rate = *object.rate;
  std::string ways;
  for (const RateEstimate& estimate : rate.estimates) {
    ways += fmt::format("{}{} {}", ways.empty() ? "" : "; ", source_in_words(estimate.source, rate),
                        rate_text(estimate.value));
  }
  const std::string option = sheet.suites.size() > 1 ? values_in_words(object.curve.subject.others) + ": per" : "Per";
  std::string text = fmt::format("<p>{} year by {}.", escaped(option), ways);
  if (object.curve.outcome == stats::FragilityOutcome::rejected) {
    text += fmt::format(" The lognormal law is rejected (p = {}); the isotonic shares take its place.",
                        significant(object.curve.test->p_value, 2));
  }
  const auto most = std::ranges::max_element(rate.by_record, {}, &RateOfRecord::share);
  if (most != rate.by_record.end() && most->share > 0.0) {
    text += fmt::format(" The record that contributes most, {}, has {} % of the rate.", escaped(last_part(most->name)),
                        per_cent(most->share));
  }
  return "<h2>What the answer rests on</h2>\n" + text + "</p>\n";
}

std::string assumptions(const SheetContent& sheet) {
  return fmt::format(
      "<h2>Assumptions</h2>\n<ol>\n<li>One rigid block on a level, rigid floor, in one vertical plane; without "
      "anchorage, neighbours, twist or flexibility.</li>\n<li>Energy is lost in impacts and by friction as stated in "
      "the question. Give measured values if there are any.</li>\n<li>The hazard curve is taken as exact. The rate "
      "counts {}{}.</li>\n<li>Intervals cover the choice of the records and the random numbers, nothing else. Records "
      "that are scaled far do not become stronger earthquakes.</li>\n<li>Earthquakes follow each other as a Poisson "
      "process. {}</li>\n</ol>\n",
      by_option(sheet, [](const ReportedSuite& suite) { return counted_from_in_words(suite.curve.subject); }),
      why_counted_in_words(sheet.suites.front().curve.subject),
      event_of(sheet).is_overturning() ? "Damage without overturning is not counted."
                                       : "An object that overturns is counted too. Other damage is not.");
}

std::string signature(const SheetNotes& notes) {
  return fmt::format("<div class=\"sign\"><p>Project: {}</p><p>Date: {}</p><p>Signature:</p></div>\n",
                     escaped(notes.project), escaped(notes.date));
}

std::string footer(const SheetContent& sheet) {
  return fmt::format(
      "<footer>Experiment SHA-256 <code>{}</code>; results SHA-256 <code>{}</code>; rocking {}. Made by "
      "<code>{}</code></footer>\n",
      base::to_hex(sheet.suites.front().run.experiment), base::to_hex(sheet.run.digest), escaped(sheet.program),
      escaped(sheet.notes.command));
}

}  // namespace

std::string sheet_text(const SheetContent& sheet) {
  const std::string title =
      sheet.run.title().empty() ? "How often does it " + to_do(event_of(sheet)) + "?" : sheet.run.title();
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
             "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; img-src data:\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<title>{}</title>\n<style>{}</style>\n</head>\n<body{}>\n<h1>{}</h1>\n",
             policy_hash(sheet_style()), escaped(title), sheet_style(),
             sheet.suites.size() > 3 ? " class=\"many\"" : "", escaped(title)) +
         answer(sheet) + survived(sheet) + top(sheet) + rates(sheet) +
         "<div class=\"columns\">\n<div>\n<h2>Question</h2>\n" + question_in_brief(sheet.run) + limits(sheet) +
         "</div>\n<div>\n" + motions(sheet) + basis(sheet) + assumptions(sheet) + "</div>\n</div>\n" +
         signature(sheet.notes) + footer(sheet) + "</body>\n</html>\n";
}

}  // namespace rocking::analysis
