#include "analysis/page/answer.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseKind;
using section::ResponseMode;

struct Prevalence {
  std::uint64_t most_likely = 0;  ///< conditions
  std::uint64_t occurs = 0;       ///< conditions
  std::uint64_t realisations = 0;
};

std::map<ResponseMode, Prevalence> prevalences_of(const RunReport& report) {
  std::map<ResponseMode, Prevalence> found;
  for (const ConditionReport& condition : report.conditions) {
    const ResponseMode* most = nullptr;
    std::uint64_t highest = 0;
    for (const auto& [mode, share] : condition.modes) {
      if (share.count == 0) continue;
      found[mode].occurs += 1;
      found[mode].realisations += share.count;
      if (share.count > highest) {
        highest = share.count;
        most = &mode;
      }
    }
    if (most != nullptr) found[*most].most_likely += 1;
  }
  return found;
}

/// The largest share of a mode in any condition, with its interval, and where.
struct Extreme {
  std::size_t condition = 0;
  ModeShare share;
};

Extreme extreme_of(const RunReport& report, const ResponseMode& mode) {
  Extreme extreme;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto found = report.conditions[i].modes.find(mode);
    if (found == report.conditions[i].modes.end()) continue;
    const ModeShare& share = found->second;
    const bool more = share.count > 0 ? share.estimate > extreme.share.estimate
                                      : extreme.share.count == 0 && share.interval.high > extreme.share.interval.high;
    if (more) extreme = {.condition = i, .share = share};
  }
  return extreme;
}

std::string overturning(const RunReport& report) {
  const Extreme worst = extreme_of(report, {.kind = ResponseKind::overturned});
  if (worst.share.count == 0) {
    return fmt::format(
        "<p>No realisation overturned. In each condition the probability of overturning is below {} % with {} % "
        "confidence.</p>\n",
        per_cent(worst.share.interval.high), report::level_text(report.conditions[worst.condition].confidence));
  }
  return fmt::format("<p>Overturning is most likely at {}: {}.</p>\n", escaped(condition_name(report, worst.condition)),
                     per_cent(worst.share.estimate, worst.share.interval));
}

const Difference* difference_of(const ConditionReport& condition) {
  return condition.difference ? &*condition.difference : nullptr;
}

std::string least_repeatable(const RunReport& report) {
  const Difference* worst = nullptr;
  std::size_t where = 0;
  std::uint64_t alike = 0;
  std::uint64_t compared = 0;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Difference* found = difference_of(report.conditions[i]);
    if (found == nullptr) continue;
    ++compared;
    if (found->differ == 0.0) ++alike;
    if (worst == nullptr || found->differ > worst->differ) {
      worst = found;
      where = i;
    }
  }
  std::string text = fmt::format("<p>In {} of {} all realisations have the same response mode.", alike,
                                 counted(compared, "condition"));
  if (worst == nullptr || worst->differ == 0.0) return text + "</p>\n";
  return text + fmt::format(
                    " Least repeatable: {}. There, two runs under the same excitation have different responses with "
                    "probability <strong>{}</strong>.</p>\n",
                    escaped(condition_name(report, where)), per_cent(worst->differ, worst->interval));
}

std::string partings(const RunReport& report, const char* cause, Parting Difference::*member) {
  std::uint64_t pairs = 0;
  std::uint64_t parted = 0;
  std::vector<double> medians;
  for (const ConditionReport& condition : report.conditions) {
    const Difference* found = difference_of(condition);
    if (found == nullptr) continue;
    const Parting& parting = found->*member;
    pairs += parting.pairs;
    parted += parting.parted;
    if (parting.median) medians.push_back(*parting.median);
  }
  if (pairs == 0) return "";
  std::string text = fmt::format("{}: {} of {} diverge", cause, parted, counted(pairs, "pair"));
  if (!medians.empty()) {
    std::ranges::sort(medians);
    const double middle = medians[medians.size() / 2];
    text += fmt::format("; median divergence time (median over the conditions): {} {}", report::significant(middle, 4),
                        middle == 1.0 ? "period" : "periods");
  }
  return "<li>" + text + ".</li>\n";
}

}  // namespace

std::string responses_in_brief(const RunReport& report) {
  std::string rows;
  for (const auto& [mode, prevalence] : prevalences_of(report)) {
    rows += fmt::format(
        "<tr><th scope=\"row\">{}<span class=\"meaning\">{}</span></th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escaped(to_string(mode)), meaning_of(mode), prevalence.most_likely, prevalence.occurs, prevalence.realisations);
  }
  return fmt::format(
             "<table class=\"brief\"><caption>{}, {}</caption>\n<thead><tr><th scope=\"col\">response</th><th "
             "scope=\"col\">most likely in</th><th scope=\"col\">occurs in</th><th scope=\"col\">realisations</th>"
             "</tr></thead>\n<tbody>\n{}</tbody></table>\n",
             counted(report.conditions.size(), "condition"), counted(realisations_of(report), "realisation"), rows) +
         overturning(report);
}

std::string recurrence_in_brief(const RunReport& report) {
  const bool compared = std::ranges::any_of(report.conditions, difference_of);
  if (!compared)
    return "<p>There is one realisation per condition: nothing is random, or only one was requested.</p>\n";
  return least_repeatable(report) +
         "<p>Two runs have diverged when their strobe points are more than 0.01 apart. With</p>\n<ul>\n" +
         partings(report, "independent random numbers", &Difference::by_friction) +
         partings(report, "common random numbers and another tolerance", &Difference::by_arithmetic) + "</ul>\n";
}

}  // namespace rocking::analysis
