#include "rocking/output/infer_report.hpp"

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
    if (!unknown.reaches) return {"the first design was not finished"};
    const std::string one = reason_of(unknown);
    if (!one.empty()) reason += (reason.empty() ? "these tests cannot tell: " : "; ") + one;
  }
  return {reason};
}

/// Lists of the answer are empty where there is none.
void check_sizes(const InferReport& report) {
  const auto expect = [](std::size_t size, std::size_t right, const std::string& place, const char* of_each) {
    if (size == right) return;
    throw base::InputError({place, std::to_string(size) + " entries",
                            "must have " + std::to_string(right) + ", one for each " + of_each, "make the file again"});
  };
  const std::size_t groups = report.groups.size();
  const std::size_t unknowns = report.unknowns.size();
  const bool has_answer = report.fit.has_value();
  for (std::size_t i = 0; i < report.tests.size(); ++i) {
    const ReportedTests& tested = report.tests[i];
    const std::string place = "/tests/" + std::to_string(i);
    expect(tested.counts.size(), groups, place + "/counts", "group");
    expect(tested.predicted.size(), has_answer ? groups : 0, place + "/predicted", "group");
    expect(tested.intervals.size(), has_answer ? groups : 0, place + "/intervals", "group");
  }
  for (std::size_t i = 0; i < report.candidates.size(); ++i) {
    expect(report.candidates[i].deviations.size(), has_answer ? unknowns : 0,
           "/candidates/" + std::to_string(i) + "/deviations", "unknown");
  }
  for (std::size_t i = 0; i < report.region.size(); ++i) {
    expect(report.region[i].at.size(), unknowns, "/region/" + std::to_string(i) + "/at", "unknown");
  }
  for (std::size_t i = 0; i < report.design.size(); ++i) {
    const infer::DesignPoint& point = report.design[i];
    const std::string place = "/design/" + std::to_string(i);
    expect(point.at.size(), unknowns, place + "/at", "unknown");
    expect(point.counts.size(), report.tests.size() + report.candidates.size(), place + "/counts", "condition");
    for (std::size_t c = 0; c < point.counts.size(); ++c) {
      expect(point.counts[c].size(), groups, place + "/counts/" + std::to_string(c), "group");
    }
  }
}

}  // namespace

InferReport read_infer_report(const Json& json) {
  InferReport report = infer_document().read(json);
  static_cast<void>(tests_of(report));  // throws where a group has no sense
  check_sizes(report);
  return report;
}

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
