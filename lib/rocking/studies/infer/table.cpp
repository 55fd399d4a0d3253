#include <algorithm>
#include <cmath>
#include <numeric>

#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// What the interval says: an end of the range is no limit.
std::string limits_in_words(const ReportedUnknown& unknown) {
  const std::string low = significant(unknown.interval->low, 3);
  const std::string high = significant(unknown.interval->high, 3);
  switch (*unknown.reaches) {
    case ReachedBound::none: return significant(*unknown.estimate, 3) + ' ' + interval_in_words(*unknown.interval);
    case ReachedBound::from: return "at most " + high;
    case ReachedBound::to: return "at least " + low;
    case ReachedBound::both: return "any value from " + low + " to " + high;
  }
  return "";
}

}  // namespace

std::string answer_in_words(const ReportedUnknown& unknown) {
  return analysis::label_of(analysis::axis_of_parameter(unknown.parameter)) + ": " + limits_in_words(unknown);
}

namespace {

/// Whether there are more independent counts than unknowns.
bool is_tested(const InferReport& report) {
  return report.tests.size() * (std::max<std::size_t>(report.groups.size(), 1) - 1) > report.unknowns.size();
}

}  // namespace

bool explains_counts(const InferReport& report) { return report.fit->p_value > 1.0 - report.confidence; }

std::optional<std::string> too_few_realisations(const InferReport& report) {
  if (report.design.empty() || report.design.front().counts.size() < report.tests.size()) return std::nullopt;
  constexpr double negligible = 0.3;  // three conditions with a tenth as many tests as realisations
  const auto sum = [](const std::vector<std::uint64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  };
  double share = 0.0, tests = 0.0;
  std::uint64_t realisations = 0;
  for (std::size_t c = 0; c < report.tests.size(); ++c) {
    const auto of_tests = static_cast<double>(report.tests.size() * sum(report.tests[c].counts));
    const std::uint64_t at_point = sum(report.design.front().counts[c]);
    if (of_tests <= share * static_cast<double>(at_point)) continue;
    share = of_tests / static_cast<double>(at_point);
    tests = of_tests;
    realisations = at_point;
  }
  if (!(share > 1.0)) return std::nullopt;
  return "the errors of " + counted(realisations, "realisation") + " of a condition, which may be alike in all " +
         std::to_string(report.tests.size()) + ", have up to " + significant(share, 2) +
         " times the variance of the tests: intervals and region are wider than the tests need, and the region may say "
         "nothing; from " +
         std::to_string(static_cast<std::uint64_t>(std::ceil(tests / negligible))) +
         " realisations on they matter little";
}

std::string fit_in_words(const InferReport& report) {
  const double p = report.fit->p_value;
  const std::string fit = "deviance " + significant(report.fit->statistic, 3) + ", p = " + significant(p, 2);
  if (!explains_counts(report))
    return fit + ": no value of the unknowns explains the counts; the intervals mean nothing";
  if (!is_tested(report))
    return fit + ": there are as many unknowns as independent counts, so that nothing is left to test";
  return fit + ": the estimate explains the counts";
}

std::string identified_in_words(const InferReport& report) {
  const std::string& reason = report.identified.reason_why_not;
  const auto too_few = too_few_realisations(report);
  const std::string warning = too_few ? "warning: " + *too_few + '\n' : "";
  if (!reason.empty()) return "no, " + reason;
  return report.unknowns.size() == 1 ? "yes, the interval ends within the range of the unknown"
                                     : "yes, all intervals end within the ranges of the unknowns";
}

namespace {

using look::decimals;
using look::number;

void add_estimate(look::Row& row, double value, const stats::Interval& interval) {
  for (const double each : {value, interval.low, interval.high}) row.push_back(number(each, 3));
}

std::string unknowns_table(const InferReport& report) {
  look::Table table;
  add_columns(table, {"unknown", "estimate", "from", "to"});
  const bool has_prior = !report.unknowns.empty() && report.unknowns.front().posterior.has_value();
  if (has_prior) add_columns(table, {"posterior mean", "from", "to"});
  for (const ReportedUnknown& unknown : report.unknowns) {
    look::Row& row = table.rows.emplace_back(look::Row{unknown.parameter});
    add_estimate(row, *unknown.estimate, *unknown.interval);
    if (has_prior) add_estimate(row, unknown.posterior->mean, unknown.posterior->interval);
  }
  table.notes = "from, to: interval with " + level_text(report.confidence) + " % confidence" +
                (has_prior ? ", of the profile likelihood and of the posterior" : " of the profile likelihood") + "\n";
  return to_terminal(table);
}

/// Counted and predicted shares side by side.
std::string tests_table(const InferReport& report) {
  look::Table table = table_of(report.tests.front().parameters, {"mode", "tests", "share", "from", "to", "predicted"});
  for (const ReportedTests& tests : report.tests) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : tests.counts) all += count;
    for (std::size_t g = 0; g < tests.counts.size(); ++g) {
      constexpr double shown = 0.005;
      if (tests.counts[g] == 0 && tests.predicted[g] < shown) continue;
      look::Row& row = table.rows.emplace_back(
          row_of(tests.parameters, {report.groups[g], std::to_string(tests.counts[g]) + " of " + std::to_string(all)}));
      const double share = static_cast<double>(tests.counts[g]) / static_cast<double>(all);
      for (const double each : {share, tests.intervals[g].low, tests.intervals[g].high, tests.predicted[g]}) {
        row.push_back(number(each, decimals(2)));
      }
    }
  }
  return to_terminal(table);
}

/// Counts of response modes that no realisation showed, at any value of the unknowns.
std::string never_simulated(const InferReport& report) {
  std::string words;
  for (std::size_t c = 0; c < report.tests.size(); ++c) {
    const ReportedTests& tested = report.tests[c];
    const std::string setting = values_of(tested.parameters);
    for (std::size_t g = 0; g < tested.counts.size(); ++g) {
      const auto shows_it = [&](const infer::DesignPoint& point) { return point.counts[c][g] > 0; };
      if (tested.counts[g] == 0 || std::ranges::any_of(report.design, shows_it)) continue;
      words += report.groups[g] + (setting.empty() ? "" : " with " + setting) + " was counted " +
               counted(tested.counts[g], "time") + ", but never simulated at any value of the unknowns\n";
    }
  }
  return words;
}

std::string candidates_table(const InferReport& report) {
  if (report.candidates.empty()) return "";
  look::Table table = table_of(report.candidates.front().parameters, {"region"});
  for (const ReportedUnknown& unknown : report.unknowns) add_columns(table, {last_key(unknown.parameter)});
  for (const ReportedCandidate& candidate : report.candidates) {
    look::Row& row = table.rows.emplace_back(row_of(candidate.parameters, {number(*candidate.region, decimals(2))}));
    for (const double deviation : candidate.deviations) row.push_back(number(deviation, decimals(2)));
  }
  table.title = "\nWith " + counted(report.next_tests, "more test") +
                ", expected size of the region and standard deviations, over the present ones:\n";
  return to_terminal(table);
}

std::string end_words(InferEnd end) {
  switch (end) {
    case InferEnd::settled: return "";
    case InferEnd::most_points: return "the largest design was reached before the intervals had settled\n";
    case InferEnd::out_of_time: return "the time was up before the intervals had settled\n";
    case InferEnd::stopped: return "it was stopped before the intervals had settled\n";
  }
  return "";
}

}  // namespace

std::string infer_table(const InferReport& report) {
  const std::string effort = counted(report.realisations, "realisation") + " at " +
                             counted(report.design.size(), "point") + " of the unknowns\n" + end_words(report.end);
  if (!report.fit) {
    const bool is_stopped = report.end == InferEnd::stopped;
    return std::string("There is no answer yet") + (is_stopped ? "" : ": the first design is not finished") + ".\n" +
           effort;
  }
  const std::string& reason = report.identified.reason_why_not;
  const auto too_few = too_few_realisations(report);
  const std::string warning = too_few ? "warning: " + *too_few + '\n' : "";
  std::string answers = explains_counts(report) ? "" : fit_in_words(report) + '\n';
  for (const ReportedUnknown& unknown : report.unknowns) {
    answers += answer_in_words(unknown) + (&unknown == &report.unknowns.back() ? "" : "; ");
  }
  return answers + ", with " + level_text(report.confidence) + " % confidence\n\n" + unknowns_table(report) +
         (reason.empty() ? "" : reason + "\n") + warning + "\n" + tests_table(report) + "fit: " + fit_in_words(report) +
         "\n" + never_simulated(report) + candidates_table(report) + effort;
}

}  // namespace rocking
