#include "rocking/studies/infer/result.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

bool are_equal(const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
  return std::ranges::equal(a, b, [](const Parameter& one, const Parameter& other) {
    return one.pointer == other.pointer && one.value == other.value;
  });
}

/// Of one unknown whose interval reaches a bound.
std::string reason_of(const ReportedUnknown& unknown) {
  const std::string from = significant(unknown.from, 6);
  const std::string to = significant(unknown.to, 6);
  switch (*unknown.reaches) {
    case ReachedBound::none: return "";
    case ReachedBound::from: return unknown.parameter + " may be as small as " + from + ", where its range begins";
    case ReachedBound::to: return unknown.parameter + " may be as large as " + to + ", where its range ends";
    case ReachedBound::both: return unknown.parameter + " may have any value from " + from + " to " + to;
  }
  return "";
}

Identified identified(const std::vector<ReportedUnknown>& unknowns) {
  std::string reason;
  for (const ReportedUnknown& unknown : unknowns) {
    if (!unknown.reaches) return {"there is no answer yet"};
    const std::string one = reason_of(unknown);
    if (!one.empty()) reason += (reason.empty() ? "these tests cannot tell: " : "; ") + one;
  }
  return {reason};
}

}  // namespace

InferReport infer_report(const Experiment& experiment, const CountedTests& tests, std::uint64_t next_tests,
                         const Inference& found) {
  InferReport report{.input = input_of(experiment),
                     .seed = experiment.seed,
                     .confidence = experiment.conditions.front().confidence,
                     .next_tests = next_tests,
                     .realisations = found.realisations,
                     .end = found.end,
                     .design = found.design};
  for (std::size_t k = 0; k < experiment.unknowns.size(); ++k) {
    const Unknown& unknown = experiment.unknowns[k];
    ReportedUnknown reported{.parameter = unknown.pointer, .from = unknown.from, .to = unknown.to};
    if (found.answer) {
      const UnknownAnswer& answer = found.answer->unknowns[k];
      reported.estimate = answer.estimate;
      reported.interval = answer.interval;
      reported.reaches = answer.reaches;
      reported.profile = answer.profile;
      reported.posterior = answer.posterior;
    }
    report.unknowns.push_back(std::move(reported));
  }
  report.identified = identified(report.unknowns);
  for (const ModeGroup& group : tests.groups) report.groups.push_back(group.name);
  for (const TestedCondition& condition : tests.conditions) {
    report.tests.push_back(
        {.parameters = condition.parameters, .counts = condition.counts, .predicted = {}, .intervals = {}});
  }
  for (const TestedCondition& candidate : tests.candidates) {
    report.candidates.push_back({.parameters = candidate.parameters, .deviations = {}});
  }
  if (!found.answer) return report;
  report.log_likelihood = found.answer->log_likelihood;
  report.fit = found.answer->fit;
  report.region_limit = found.answer->region_limit;
  report.region = found.answer->region;
  for (std::size_t i = 0; i < report.tests.size(); ++i) {
    report.tests[i].predicted = found.answer->predicted[i].shares;
    report.tests[i].intervals = found.answer->predicted[i].intervals;
  }
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    report.candidates[i].region = found.answer->candidates[i].region;
    report.candidates[i].deviations = found.answer->candidates[i].deviations;
  }
  return report;
}

CountedTests tests_of(const InferReport& report) {
  CountedTests tests;
  for (std::size_t i = 0; i < report.groups.size(); ++i) {
    const std::string place = "/groups/" + std::to_string(i);
    tests.groups.push_back({.name = report.groups[i], .modes = modes_in_group(report.groups[i], place)});
  }
  for (const ReportedTests& each : report.tests) tests.conditions.push_back({each.parameters, each.counts});
  for (const ReportedCandidate& each : report.candidates) tests.candidates.push_back({each.parameters, {}});
  return tests;
}

std::vector<infer::DesignPoint> design_for(const InferReport& asked, const InferReport& earlier) {
  const auto differ = [](const char* place) {
    throw base::InputError({place, "", "is not that of the earlier answer, whose realisations are therefore of no use",
                            "use the same experiment, tests and candidates, or `--overwrite` without `--resume`"});
  };
  if (asked.input.sha256 != earlier.input.sha256) differ("/input");
  if (asked.seed != earlier.seed) differ("/settings/seed");
  if (asked.groups != earlier.groups) differ("/groups");
  const auto is_same = [](const auto& a, const auto& b) { return are_equal(a.parameters, b.parameters); };
  const auto is_same_test = [&](const ReportedTests& a, const ReportedTests& b) {
    return is_same(a, b) && a.counts == b.counts;
  };
  if (!std::ranges::equal(asked.tests, earlier.tests, is_same_test)) differ("/tests");
  if (!std::ranges::equal(asked.candidates, earlier.candidates, is_same)) differ("/candidates");
  return earlier.design;
}

}  // namespace rocking
