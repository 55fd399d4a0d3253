#include "analysis/page/sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/overview.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/alarms.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Realisations with some property, of all conditions.
struct AllCases {
  std::uint64_t count = 0;
  std::string first;  ///< HTML; empty if there is none
};

AllCases cases_of(const Report& report, Cases Validity::*kind) {
  AllCases all;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Cases& cases = report.conditions[i].result.validity.*kind;
    if (cases.count > 0 && all.count == 0) {
      all.first = fmt::format("First: <code>--condition {} --realisation {}</code>.", i, cases.first.front());
    }
    all.count += cases.count;
  }
  return all;
}

struct Kind {
  Cases Validity::*cases;
  const char* name;
  const char* none;  ///< the finding if there is none
  const char* some;  ///< text after the number if there are some
  Rating rating;     ///< if there are some
};

constexpr Kind kinds[] = {
    {&Validity::painleve, "Painlev&eacute;&#39;s paradox", "Did not occur.", "ended because of it.", Rating::look},
    {&Validity::stopped, "event budget", "Every realisation reached its horizon or overturned.",
     "ended because of too many events or a vanishing step.", Rating::look},
    {&Validity::contradictions, "sticking and slipping",
     "At every instant one of the two was consistent with the equations.",
     "had an instant at which neither is consistent with the equations.", Rating::look},
    {&Validity::in_transient, "settled at the horizon", "Every response had settled at the horizon.",
     "had not settled at the horizon.", Rating::look},
    {&Validity::settled_late, "settled within the sampled periods", "No response settled late.",
     "settled within the sampled periods and are classified by the part after that.", Rating::note},
    {&Validity::past_balance, "beyond the balance point", "|&Theta;| was below 1 throughout.", "passed |&Theta;| = 1.",
     Rating::note},
};

Check check_of(const Report& report, const Kind& kind) {
  const AllCases cases = cases_of(report, kind.cases);
  if (cases.count == 0) return {.name = kind.name, .rating = Rating::fine, .finding = kind.none, .where = {}};
  return {.name = kind.name,
          .rating = kind.rating,
          .finding = fmt::format("{} {}", counted(cases.count, "realisation"), kind.some),
          .where = cases.first};
}

/// A loss of contact in the final fall of a block that overturns cannot change its response; one before it can.
Check contact(const Report& report) {
  const AllCases all = cases_of(report, &Validity::left_ground);
  Check check{.name = "contact with the base", .rating = Rating::fine, .finding = {}, .where = all.first};
  if (all.count == 0) {
    check.finding = "The normal force was positive throughout.";
    return check;
  }
  const AllCases before = cases_of(report, &Validity::left_ground_before_fall);
  if (before.count > 0) {
    check.rating = Rating::look;
    check.where = before.first;
    check.finding =
        fmt::format("{} met a normal force of zero or less before any final fall, where the model is not valid.",
                    counted(before.count, "realisation"));
  }
  if (all.count > before.count) {
    check.finding += fmt::format("{}{} lost contact only in the final fall of a block that overturned.",
                                 before.count > 0 ? " " : "", counted(all.count - before.count, "realisation"));
  }
  return check;
}

Check clamped(const Report& report) {
  const AllCases cases = cases_of(report, &Validity::clamped);
  Check check{.name = "clamped random numbers", .rating = Rating::fine, .finding = {}, .where = cases.first};
  if (cases.count == 0) {
    check.finding = "No random number was clamped.";
    return check;
  }
  check.rating = Rating::note;
  check.finding = fmt::format("{} had a random number clamped to its range.", counted(cases.count, "realisation"));
  const auto worst = worst_clamps(report);
  if (!worst) return check;
  check.rating = Rating::look;
  check.finding += fmt::format(" Most at {}: {}; mostly {}.", with_symbols(condition_name(report, worst->condition)),
                               in_words(worst->share), escaped(worst->remedy));
  return check;
}

Check arithmetic(const Report& report) {
  Check check{.name = "sensitivity to tolerance", .rating = Rating::note, .finding = {}, .where = {}};
  const auto& found = report.tolerance_sensitivity;
  if (!found) {
    check.finding = "Not measured: no realisation was rerun at another tolerance.";
    return check;
  }
  check.finding = fmt::format("{} of {} response modes change at a hundred times tighter tolerance {} %, ",
                              found->flips.successes, found->flips.trials, per_cent(found->interval));
  const std::string half_width = per_cent(found->half_width) + " %.";
  switch (found->noise) {
    case NumericalError::small:
      check.rating = Rating::fine;
      check.finding += "small compared with the narrowest half-width of an interval, " + half_width;
      break;
    case NumericalError::not_small:
      check.rating = Rating::look;
      check.finding += "<strong>not</strong> small compared with the narrowest half-width of an interval, " +
                       half_width + " Remedy: " + escaped(tolerance_remedy(report.conditions.front().asked.tolerance)) +
                       '.';
      break;
    case NumericalError::undecided:
      check.finding += "too few reruns to compare with the narrowest half-width of an interval, " + half_width;
      break;
  }
  return check;
}

Check unresolved(const Report& report) {
  const UnresolvedResponses found = unresolved_responses(report);
  if (found.count == 0)
    return {.name = "unresolved responses",
            .rating = Rating::fine,
            .finding = "Every response is classified.",
            .where = {}};
  const std::string remedy = unresolved_remedy(report);
  return {.name = "unresolved responses",
          .rating = found.largest_share > worrying_unresolved_share ? Rating::look : Rating::note,
          .finding = fmt::format("{} of {} ({} %); most at {}: {} %.", found.count,
                                 counted(realisations_of(report), "realisation"), per_cent(found.share),
                                 with_symbols(condition_name(report, found.where)), per_cent(found.largest_share)) +
                     (remedy.empty() ? "" : " Remedy: " + escaped(remedy) + '.'),
          .where = {}};
}

Check enough(const Report& report) {
  if (!report.is_random()) {
    return {.name = "enough realisations",
            .rating = Rating::fine,
            .finding = "Nothing is random: one realisation of a condition is enough.",
            .where = {}};
  }
  std::uint64_t short_of = 0;
  for (const ReportedCondition& condition : report.conditions) {
    if (condition.result.stopped_because == StoppedBecause::at_most_reached) ++short_of;
  }
  const std::string width =
      fmt::format("The half-width of the widest interval is {} %.", per_cent(widest_half_width(report)));
  if (short_of == 0) return {.name = "enough realisations", .rating = Rating::fine, .finding = width, .where = {}};
  return {.name = "enough realisations",
          .rating = Rating::look,
          .finding = fmt::format(
              "{} reached the largest number of realisations before the intervals were as narrow as requested. {}",
              counted(short_of, "condition"), width),
          .where = {}};
}

std::string_view word_of(Rating rating) {
  switch (rating) {
    case Rating::fine: return "fine";
    case Rating::note: return "note";
    case Rating::look: return "look";
  }
  return "";
}

std::string badge(Rating rating) {
  constexpr const char* signs[] = {"&#10003;", "&#8226;", "!"};
  return fmt::format("<span class=\"badge {0}\"><span aria-hidden=\"true\">{1}</span> {0}</span>", word_of(rating),
                     signs[static_cast<std::size_t>(rating)]);
}

}  // namespace

std::vector<Check> checks_of(const Report& report) {
  std::vector<Check> checks{arithmetic(report), unresolved(report), enough(report), contact(report)};
  for (const Kind& kind : kinds) checks.push_back(check_of(report, kind));
  checks.push_back(clamped(report));
  if (const auto names = left_out_records(report.left_out)) {
    checks.push_back(
        {.name = "records of the suite", .rating = Rating::look, .finding = escaped(*names) + '.', .where = {}});
  }
  if (const auto far = far_scaled(report.ground_motions)) {
    checks.push_back(
        {.name = "scale factors of the records", .rating = Rating::look, .finding = escaped(*far) + '.', .where = {}});
  }
  if (const auto doubt = restitution_alarm(report)) {
    checks.push_back({.name = "restitution", .rating = Rating::look, .finding = escaped(*doubt) + '.', .where = {}});
  }
  for (const UsedGroundMotion& used : report.ground_motions) {
    if (used.facts.warnings.empty()) continue;
    std::string finding = escaped(used.facts.file) + ':';
    for (const std::string& warning : used.facts.warnings) finding += ' ' + escaped(warning) + '.';
    checks.push_back({.name = "reading of a ground motion", .rating = Rating::look, .finding = finding, .where = {}});
  }
  return checks;
}

std::string trust_in_brief(const std::vector<Check>& checks) {
  const auto fine = std::ranges::count(checks, Rating::fine, &Check::rating);
  std::string text =
      fmt::format("<p>{} of {} checks passed without remark.</p>\n<ul class=\"checks\">\n", fine, checks.size());
  for (const Rating rating : {Rating::look, Rating::note}) {
    for (const Check& check : checks) {
      if (check.rating != rating) continue;
      text += fmt::format("<li>{} {}{}</li>\n", badge(rating), check.name,
                          rating == Rating::look ? ": " + check.finding : "");
    }
  }
  return text + "</ul>\n";
}

std::string trust_in_full(const std::vector<Check>& checks) {
  std::string entries;
  for (const Check& check : checks) {
    entries += fmt::format("<li>{} <b>{}</b><span>{} {}</span></li>\n", badge(check.rating), check.name, check.finding,
                           check.where);
  }
  return "<p>Possible causes of a wrong result, and what was found:</p>\n<ul class=\"checks all\">\n" + entries +
         "</ul>\n<p><code>rocking trajectory</code> with this folder and the numbers of a condition and a realisation "
         "prints "
         "this realisation in full.</p>\n";
}

std::string provenance(const Report& report) {
  const SystemFacts& system = report.system;
  return fmt::format(
      "<p>The same experiment file gives the same numbers on every machine: <code>rocking verify</code> runs it again "
      "and "
      "compares the bits.</p>\n<dl class=\"settings\">\n<dt>seed</dt><dd>{}</dd>\n<dt>digest of the "
      "input</dt><dd><code>{}</code></dd>\n<dt>digest of the realisations</dt><dd><code>{}</code></dd>\n<dt>program"
      "</dt><dd>rocking {} {}</dd>\n<dt>built with</dt><dd>{} "
      "{}</dd>\n<dt>machine</dt><dd>{}</dd>\n<dt>begun</dt><dd>{}"
      "</dd>\n<dt>time</dt><dd>{} s on {}</dd>\n</dl>\n",
      escaped(report.input.experiment.at("seed").get<std::string>()), escaped(report.input.sha256),
      base::to_hex(report.digest), escaped(system.build.version), escaped(system.build.revision),
      escaped(system.build.compiler), escaped(system.build.flags), escaped(system.machine), escaped(system.start),
      significant(system.duration_s, 3), counted(system.threads, "thread"));
}

}  // namespace rocking::analysis
