// Whether runs under the same shaking respond alike.

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/words.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string divergences(const Report& report, const char* cause, DivergenceTimes NonRecurrence::*member) {
  const PooledDivergence pooled = pooled_divergence(report, member);
  if (pooled.pairs == 0) return "";
  std::string text = fmt::format("{}: {} of {} diverge", cause, pooled.diverged, counted(pooled.pairs, "pair"));
  if (pooled.median) {
    text += fmt::format("; median divergence time (median over the conditions): {} {}", significant(*pooled.median, 4),
                        *pooled.median == 1.0 ? "period" : "periods");
  }
  return "<li>" + text + ".</li>\n";
}

/// Where nothing differs within any condition.
std::string alike(const Report& report) {
  if (const auto unresolved = unresolved_responses(report); unresolved.count > 0) {
    return fmt::format(
        "Not known: the realisations of each condition were classified alike, but {} of {} as unresolved.",
        unresolved.count, counted(realisations_of(report), "realisation"));
  }
  double most = 0.0;
  for (const ReportedCondition& condition : report.conditions) {
    if (condition.result.non_recurrence) most = std::max(most, condition.result.non_recurrence->differ_interval.high);
  }
  const bool lone = report.conditions.size() == 1;
  const std::string limit = fmt::format(" {} runs differ with a probability of at most {} % ({}).",
                                        lone ? "Two" : "In any one of them, two", per_cent(most), report.level());
  if (report.has_suite()) {
    return "Under each ground motion, at each level, all realisations responded alike, although the block is random: "
           "one realisation of each suffices for the response mode. What differs is the ground motion." +
           limit;
  }
  return (lone ? std::string("All realisations") : std::string("Within each condition all realisations")) +
         " responded alike, although something is random: one realisation" + (lone ? "" : " of each") +
         " suffices for the response mode." + limit;
}

/// Where blocks slide without rocking: how far they slip, in the condition where that is most; otherwise empty.
std::string slip_in_brief(const Report& report) {
  std::optional<std::size_t> farthest;
  double most = 0.0;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const ReportedCondition& condition = report.conditions[i];
    if (!condition.result.peaks.slip || count_of(condition, {.kind = section::ResponseKind::slide}) == 0) continue;
    const double slip = quantile_at(condition.result.peaks.slip->metres, 0.95).value.value_or(0.0);
    if (slip > most) farthest = i;
    most = std::max(most, slip);
  }
  if (!farthest) return "";
  const auto& metres = report.conditions[*farthest].result.peaks.slip->metres;
  const std::string median = significant(quantile_at(metres, 0.5).value.value_or(0.0), 3);
  return fmt::format(
      "<dt>Slip</dt><dd>{}<strong>{} m</strong> in the median, at most {} m in 95 % of the realisations.</dd>\n",
      report.conditions.size() == 1 ? "" : "Farthest at " + with_symbols(condition_name(report, *farthest)) + ": ",
      median, significant(most, 3));
}

}  // namespace

std::string suite_in_brief(const Report& report, const std::string& sentence) {
  return "<p class=\"headline\">" + with_symbols(sentence) + "</p>\n" + object_drawings(report);
}

std::string answer_in_brief(const Report& report) {
  const bool is_random = report.is_random();
  const bool lone = report.conditions.size() == 1;
  const std::string responses = lone && is_random ? shares_in_brief(report)
                                : lone            ? modes_in_brief(report)
                                                  : responses_in_brief(report) + modes_in_brief(report);
  return fmt::format(
      "<dl class=\"short\">\n<dt>Overturning</dt><dd>{}</dd>\n<dt>{}</dt><dd>{}</dd>\n"
      "{}<dt>Repeatability</dt><dd>{}</dd>\n</dl>\n",
      overturning_in_brief(report), is_random && !lone ? "Most likely response" : "Response", responses,
      slip_in_brief(report), repeatability(report));
}

std::string repeatability(const Report& report) {
  const Repeatability found = repeatability_of(report);
  if (!report.is_random()) return "<p>Nothing is random: the same shaking gives the same response.</p>\n";
  if (found.compared == 0) return "<p>There is one realisation per condition, so that none can be compared.</p>\n";
  if (found.alike == found.compared) return "<p>" + alike(report) + "</p>\n";
  const NonRecurrence& worst = *report.conditions[*found.least].result.non_recurrence;
  const bool lone = report.conditions.size() == 1;
  return fmt::format(
      "<p>{}wo runs under the same shaking respond differently with probability <strong>{}</strong>{}.</p>\n",
      lone ? "T" : fmt::format("Least repeatable at {}: t", with_symbols(condition_name(report, *found.least))),
      probability_text(worst.differ, worst.differ_interval),
      lone ? ""
           : fmt::format(". In {} of {} all realisations have the same response mode", found.alike,
                         counted(found.compared, "condition")));
}

std::string recurrence_in_brief(const Report& report) {
  if (report.has_suite()) return repeatability(report);
  if (repeatability_of(report).compared == 0 || !report.is_periodic()) return "";
  return "<p>Two runs under the same shaking have diverged when tilt and tilt rate, compared once a period, differ by "
         "more than 0.01. With</p>\n<ul>\n" +
         divergences(report, "independent random numbers", &NonRecurrence::friction) +
         divergences(report, "common random numbers and another tolerance", &NonRecurrence::arithmetic) + "</ul>\n";
}

}  // namespace rocking::analysis
