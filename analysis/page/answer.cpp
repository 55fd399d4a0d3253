#include "analysis/page/answer.hpp"

#include <fmt/format.h>

#include "analysis/overview.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string overturning(const RunReport& report) {
  const Extreme worst = extreme_of(report, {.kind = section::ResponseKind::overturned});
  if (worst.share.count == 0) {
    return fmt::format(
        "<p>No realisation overturned. In each condition the probability of overturning is below {} % with {} % "
        "confidence.</p>\n",
        per_cent(worst.share.interval.high), level_text(report.conditions[worst.condition].confidence));
  }
  return fmt::format("<p>Overturning is most likely at {}: {}.</p>\n", escaped(condition_name(report, worst.condition)),
                     probability_text(worst.share.estimate, worst.share.interval));
}

std::string least_repeatable(const RunReport& report) {
  const Repeatability found = repeatability_of(report);
  std::string text = fmt::format("<p>In {} of {} all realisations have the same response mode.", found.alike,
                                 counted(found.compared, "condition"));
  if (found.alike == found.compared) return text + "</p>\n";
  const Difference& worst = *report.conditions[*found.least].difference;
  return text + fmt::format(
                    " Least repeatable: {}. There, two runs under the same excitation have different responses with "
                    "probability <strong>{}</strong>.</p>\n",
                    escaped(condition_name(report, *found.least)), probability_text(worst.differ, worst.interval));
}

std::string divergences(const RunReport& report, const char* cause, Divergence Difference::*member) {
  const PooledDivergence pooled = pooled_divergence(report, member);
  if (pooled.pairs == 0) return "";
  std::string text = fmt::format("{}: {} of {} diverge", cause, pooled.diverged, counted(pooled.pairs, "pair"));
  if (pooled.median) {
    text += fmt::format("; median divergence time (median over the conditions): {} {}", significant(*pooled.median, 4),
                        *pooled.median == 1.0 ? "period" : "periods");
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
  if (repeatability_of(report).compared == 0)
    return "<p>There is one realisation per condition: nothing is random, or only one was requested.</p>\n";
  return least_repeatable(report) +
         "<p>Two runs have diverged when their strobe points are more than 0.01 apart. With</p>\n<ul>\n" +
         divergences(report, "independent random numbers", &Difference::by_friction) +
         divergences(report, "common random numbers and another tolerance", &Difference::by_arithmetic) + "</ul>\n";
}

}  // namespace rocking::analysis
