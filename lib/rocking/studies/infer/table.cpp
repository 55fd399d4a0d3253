#include <algorithm>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/studies/infer/result.hpp"
#include "rocking/studies/infer/words.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

std::string unknowns_table(const InferReport& report) {
  std::vector<TextRow> rows{{"unknown", "estimate", "from", "to"}};
  const bool has_prior = !report.unknowns.empty() && report.unknowns.front().posterior.has_value();
  if (has_prior) rows.front().insert(rows.front().end(), {"posterior mean", "from", "to"});
  for (const ReportedUnknown& unknown : report.unknowns) {
    rows.push_back({unknown.parameter, significant(*unknown.estimate, 3), significant(unknown.interval->low, 3),
                    significant(unknown.interval->high, 3)});
    if (!has_prior) continue;
    const UnknownPosterior& posterior = *unknown.posterior;
    rows.back().insert(rows.back().end(), {significant(posterior.mean, 3), significant(posterior.interval.low, 3),
                                           significant(posterior.interval.high, 3)});
  }
  return aligned(rows) + "from, to: interval with " + level_text(report.confidence) + " % confidence" +
         (has_prior ? ", of the profile likelihood and of the posterior" : " of the profile likelihood") + "\n";
}

TextRow cells_of(const std::vector<Parameter>& parameters) {
  TextRow row;
  for (const Parameter& parameter : parameters) row.push_back(short_value(parameter));
  return row;
}

TextRow keys_of(const std::vector<Parameter>& parameters) {
  TextRow row;
  for (const Parameter& parameter : parameters) row.push_back(last_key(parameter.pointer));
  return row;
}

/// Counted and predicted shares side by side.
std::string tests_table(const InferReport& report) {
  std::vector<TextRow> rows{keys_of(report.tests.front().parameters)};
  rows.front().insert(rows.front().end(), {"mode", "tests", "share", "from", "to", "predicted"});
  for (const ReportedTests& tests : report.tests) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : tests.counts) all += count;
    for (std::size_t g = 0; g < tests.counts.size(); ++g) {
      constexpr double shown = 0.005;
      if (tests.counts[g] == 0 && tests.predicted[g] < shown) continue;
      TextRow row = cells_of(tests.parameters);
      const double share = static_cast<double>(tests.counts[g]) / static_cast<double>(all);
      row.insert(row.end(), {report.groups[g], std::to_string(tests.counts[g]) + " of " + std::to_string(all),
                             fixed_point(share, 2), fixed_point(tests.intervals[g].low, 2),
                             fixed_point(tests.intervals[g].high, 2), fixed_point(tests.predicted[g], 2)});
      rows.push_back(std::move(row));
    }
  }
  return aligned(rows);
}

/// Counts of response modes that no realisation showed, at any value of the unknowns.
std::string never_simulated(const InferReport& report) {
  std::string words;
  for (std::size_t c = 0; c < report.tests.size(); ++c) {
    const ReportedTests& tested = report.tests[c];
    std::string setting;
    for (const Parameter& each : tested.parameters) {
      setting += (setting.empty() ? " with " : ", ") + last_key(each.pointer) + ' ' + short_value(each);
    }
    for (std::size_t g = 0; g < tested.counts.size(); ++g) {
      const auto shows_it = [&](const infer::DesignPoint& point) { return point.counts[c][g] > 0; };
      if (tested.counts[g] == 0 || std::ranges::any_of(report.design, shows_it)) continue;
      words += report.groups[g] + setting + " was counted " + counted(tested.counts[g], "time") +
               ", but never simulated at any value of the unknowns\n";
    }
  }
  return words;
}

std::string candidates_table(const InferReport& report) {
  if (report.candidates.empty()) return "";
  std::vector<TextRow> rows{keys_of(report.candidates.front().parameters)};
  rows.front().emplace_back("region");
  for (const ReportedUnknown& unknown : report.unknowns) rows.front().push_back(last_key(unknown.parameter));
  for (const ReportedCandidate& candidate : report.candidates) {
    TextRow row = cells_of(candidate.parameters);
    row.push_back(fixed_point(*candidate.region, 2));
    for (const double deviation : candidate.deviations) row.push_back(fixed_point(deviation, 2));
    rows.push_back(std::move(row));
  }
  return "\nWith " + counted(report.next_tests, "more test") +
         ", expected size of the region and standard deviations, over the present ones:\n\n" + aligned(rows);
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
  return unknowns_table(report) + (reason.empty() ? "" : reason + "\n") + "\n" + tests_table(report) +
         "fit: " + fit_in_words(report) + "\n" + never_simulated(report) + candidates_table(report) + effort;
}

}  // namespace rocking
