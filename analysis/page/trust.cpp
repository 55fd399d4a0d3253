#include "analysis/page/trust.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "analysis/overview.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/output/alarms.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// Realisations with some property, of all conditions.
struct Cases {
  std::uint64_t count = 0;
  std::string first;  ///< HTML; empty if there is none
};

Cases cases_of(const RunReport& report, const std::string& kind) {
  Cases cases;
  const Json& conditions = report.text.at("result").at("conditions");
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Json& validity = conditions[i].at("validity");
    const auto count = validity.at(kind).get<std::uint64_t>();
    if (count > 0 && cases.count == 0) {
      cases.first = fmt::format("First: <code>--condition {} --realisation {}</code>.", i,
                                validity.at("first_realisations").at(kind).at(0).get<std::uint64_t>());
    }
    cases.count += count;
  }
  return cases;
}

struct Kind {
  const char* key;
  const char* name;
  const char* none;  ///< the finding if there is none
  const char* some;  ///< text after the number if there are some
  Rating rating;     ///< if there are some
};

constexpr Kind kinds[] = {
    {"painleve", "Painlev&eacute;&#39;s paradox", "Did not occur.", "ended because of it.", Rating::look},
    {"stopped", "event budget", "Every realisation reached its horizon or overturned.",
     "ended because of too many events or a vanishing step.", Rating::look},
    {"contradictions", "sticking and slipping", "At every instant one of the two was consistent with the equations.",
     "had an instant at which neither is consistent with the equations.", Rating::look},
    {"in_transient", "settled at the horizon", "Every response had settled at the horizon.",
     "had not settled at the horizon.", Rating::look},
    {"settled_late", "settled within the sampled periods", "No response settled late.",
     "settled within the sampled periods and are classified by the part after that.", Rating::note},
    {"past_balance", "beyond the balance point", "|&Theta;| was below 1 throughout.", "passed |&Theta;| = 1.",
     Rating::note},
};

Check check_of(const RunReport& report, const Kind& kind) {
  const Cases cases = cases_of(report, kind.key);
  if (cases.count == 0) return {.name = kind.name, .rating = Rating::fine, .finding = kind.none, .where = {}};
  return {.name = kind.name,
          .rating = kind.rating,
          .finding = fmt::format("{} {}", counted(cases.count, "realisation"), kind.some),
          .where = cases.first};
}

/// A loss of contact in the final fall of a block that overturns cannot change its response; one before it can.
Check contact(const RunReport& report) {
  const Cases all = cases_of(report, "left_ground");
  Check check{.name = "contact with the base", .rating = Rating::fine, .finding = {}, .where = all.first};
  if (all.count == 0) {
    check.finding = "The normal force was positive throughout.";
    return check;
  }
  const Json& first = report.text.at("result").at("conditions").at(0).at("validity");
  const bool tells = first.contains("left_ground_before_fall");  // reports of earlier versions do not
  const Cases before = tells ? cases_of(report, "left_ground_before_fall") : all;
  if (before.count > 0) {
    check.rating = Rating::look;
    check.where = before.first;
    check.finding = fmt::format("{} met a normal force of zero or less{}, where the model is not valid.",
                                counted(before.count, "realisation"), tells ? " before any final fall" : "");
  }
  if (all.count > before.count) {
    check.finding += fmt::format("{}{} lost contact only in the final fall of a block that overturned.",
                                 before.count > 0 ? " " : "", counted(all.count - before.count, "realisation"));
  }
  return check;
}

/// The key of the most frequent kind of clamp.
std::string commonest_clamp(const Json& clamps) {
  std::string commonest;
  std::uint64_t most = 0;
  for (const auto& [key, count] : clamps.items()) {
    if (count.get<std::uint64_t>() <= most) continue;
    most = count.get<std::uint64_t>();
    commonest = key;
  }
  return commonest;
}

ClampedShare clamped_share(const ConditionReport& condition, const Json& validity) {
  ClampedShare share{.realisations = validity.at("clamped").get<std::uint64_t>(),
                     .of_realisations = condition.realisations,
                     .draws = 0,
                     .of_draws = validity.value("draws", std::uint64_t{0})};
  for (const auto& [key, count] : validity.at("clamped_draws").items()) share.draws += count.get<std::uint64_t>();
  return share;
}

Check clamped(const RunReport& report) {
  const Cases cases = cases_of(report, "clamped");
  Check check{.name = "clamped random numbers", .rating = Rating::fine, .finding = {}, .where = cases.first};
  if (cases.count == 0) {
    check.finding = "No random number was clamped.";
    return check;
  }
  check.rating = Rating::note;
  check.finding = fmt::format("{} had a random number clamped to its range.", counted(cases.count, "realisation"));
  const Json& conditions = report.text.at("result").at("conditions");
  std::optional<std::size_t> worst;
  ClampedShare largest;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const ClampedShare here = clamped_share(report.conditions[i], conditions[i].at("validity"));
    if (!here.is_alarming() || (worst && here.share_of_draws() <= largest.share_of_draws())) continue;
    worst = i;
    largest = here;
  }
  if (!worst) return check;
  check.rating = Rating::look;
  const std::string commonest = commonest_clamp(conditions[*worst].at("validity").at("clamped_draws"));
  check.finding += fmt::format(" Most at {}: {}; mostly {}.", with_symbols(condition_name(report, *worst)),
                               spoken(largest), escaped(std::string(clamp_remedy(commonest))));
  return check;
}

Check arithmetic(const RunReport& report) {
  Check check{.name = "sensitivity to tolerance", .rating = Rating::note, .finding = {}, .where = {}};
  const Json& floor = report.text.at("result").at("tolerance_sensitivity");
  if (floor.is_null()) {
    check.finding = "Not measured: no realisation was rerun at another tolerance.";
    return check;
  }
  const std::string noise = floor.at("arithmetic_noise");
  const Json& interval = floor.at("interval");
  check.finding = fmt::format("{} of {} response modes change at a hundred times tighter tolerance {} %, ",
                              floor.at("flips").get<std::uint64_t>(), floor.at("of").get<std::uint64_t>(),
                              per_cent({.low = interval.at(0), .high = interval.at(1)}));
  const std::string half_width = per_cent(floor.at("half_width").get<double>()) + " %.";
  if (noise == "small") {
    check.rating = Rating::fine;
    check.finding += "small compared with the narrowest half-width of an interval, " + half_width;
  } else if (noise == "not_small") {
    check.rating = Rating::look;
    check.finding += "<strong>not</strong> small compared with the narrowest half-width of an interval, " + half_width;
    const Json& tolerance = report.experiment.at("accuracy").at("tolerance");
    check.finding += " Remedy: " + escaped(tolerance_remedy(tolerance.get<double>())) + '.';
  } else {
    check.finding += "too few reruns to compare with the narrowest half-width of an interval, " + half_width;
  }
  return check;
}

/// Unresolved responses are not a failure, but their modes are unknown. Above this share of a condition they are
/// marked.
constexpr double worrying_share = 0.05;

Check unresolved(const RunReport& report) {
  const UnresolvedResponses found = unresolved_responses(report);
  if (found.count == 0)
    return {.name = "unresolved responses",
            .rating = Rating::fine,
            .finding = "Every response is classified.",
            .where = {}};
  const std::string remedy = unresolved_remedy(report);
  return {.name = "unresolved responses",
          .rating = found.largest_share > worrying_share ? Rating::look : Rating::note,
          .finding = fmt::format("{} of {} ({} %); most at {}: {} %.", found.count,
                                 counted(realisations_of(report), "realisation"), per_cent(found.share),
                                 with_symbols(condition_name(report, found.where)), per_cent(found.largest_share)) +
                     (remedy.empty() ? "" : " Remedy: " + escaped(remedy) + '.'),
          .where = {}};
}

Check enough(const RunReport& report) {
  if (!report.is_random()) {
    return {.name = "enough realisations",
            .rating = Rating::fine,
            .finding = "Nothing is random: one realisation of a condition is enough.",
            .where = {}};
  }
  std::uint64_t short_of = 0;
  for (const Json& condition : report.text.at("result").at("conditions")) {
    if (condition.at("stopped_because") == "at_most_reached") ++short_of;
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

std::vector<Check> checks_of(const RunReport& report) {
  std::vector<Check> checks{arithmetic(report), unresolved(report), enough(report), contact(report)};
  for (const Kind& kind : kinds) checks.push_back(check_of(report, kind));
  checks.push_back(clamped(report));
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
         "</ul>\n<p><code>rocking replay</code> with the numbers of a condition and a realisation prints this "
         "realisation "
         "in full.</p>\n";
}

std::string provenance(const RunReport& report) {
  const Json& system = report.text.at("system");
  const auto text = [&system](const char* key) { return escaped(system.at(key).get<std::string>()); };
  return fmt::format(
      "<p>The same experiment file gives the same numbers on every machine: <code>rocking verify</code> runs it again "
      "and "
      "compares the bits.</p>\n<dl class=\"settings\">\n<dt>seed</dt><dd>{}</dd>\n<dt>digest of the "
      "input</dt><dd><code>{}</code></dd>\n<dt>digest of the realisations</dt><dd><code>{}</code></dd>\n<dt>program"
      "</dt><dd>rocking {} {}</dd>\n<dt>built with</dt><dd>{} "
      "{}</dd>\n<dt>machine</dt><dd>{}</dd>\n<dt>begun</dt><dd>{}"
      "</dd>\n<dt>time</dt><dd>{} s on {}</dd>\n</dl>\n",
      escaped(report.experiment.at("seed").get<std::string>()),
      escaped(report.text.at("input").at("sha256").get<std::string>()),
      escaped(report.text.at("result").at("digest").get<std::string>()), text("version"), text("revision"),
      text("compiler"), text("flags"), text("machine"), text("start"),
      significant(system.at("duration_s").get<double>(), 3),
      counted(system.at("threads").get<std::uint64_t>(), "thread"));
}

}  // namespace rocking::analysis
