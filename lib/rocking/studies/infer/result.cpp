#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr const char* part_of_answer = "must be there if fit is, and only then";

class AnswerCheck {
 public:
  AnswerCheck(const InferReport& report, const ReadingPlace& place) : report_(&report), place_(&place) {}

  void check() const {
    const std::size_t groups = report_->groups.size();
    const std::size_t unknowns = report_->unknowns.size();
    const bool has_answer = report_->fit.has_value();
    expect(unknowns >= 1 && unknowns <= most_unknowns, "unknowns", "must have one to three entries");
    expect(report_->region_limit.has_value() == has_answer, "region_limit", part_of_answer);
    for (std::size_t i = 0; i < unknowns; ++i) check_unknown(report_->unknowns[i], at("unknowns", i), has_answer);
    for (std::size_t i = 0; i < report_->tests.size(); ++i) {
      const ReportedTests& tested = report_->tests[i];
      expect(tested.counts.size(), groups, at("tests", i) + "/counts", "group");
      expect(tested.predicted.size(), has_answer ? groups : 0, at("tests", i) + "/predicted", "group");
      expect(tested.intervals.size(), has_answer ? groups : 0, at("tests", i) + "/intervals", "group");
    }
    for (std::size_t i = 0; i < report_->candidates.size(); ++i) {
      const ReportedCandidate& candidate = report_->candidates[i];
      expect(candidate.region.has_value() == has_answer, at("candidates", i) + "/region", part_of_answer);
      expect(!candidate.parameters.empty(), at("candidates", i) + "/parameters", "must have an entry");
      expect(candidate.deviations.size(), has_answer ? unknowns : 0, at("candidates", i) + "/deviations", "unknown");
    }
    for (std::size_t i = 0; i < report_->region.size(); ++i) {
      expect(report_->region[i].at.size(), unknowns, at("region", i) + "/at", "unknown");
    }
    for (std::size_t i = 0; i < report_->design.size(); ++i) check_point(report_->design[i], at("design", i));
  }

 private:
  static std::string at(const char* list, std::size_t i) { return std::string(list) + '/' + std::to_string(i); }

  void check_unknown(const ReportedUnknown& unknown, const std::string& place, bool has_answer) const {
    const bool has_all = unknown.estimate && unknown.interval && unknown.reaches && unknown.profile.size() >= 2;
    const bool has_none = !unknown.estimate && !unknown.interval && !unknown.reaches && unknown.profile.empty();
    expect(has_answer ? has_all : has_none, place, part_of_answer);
    expect(std::ranges::is_sorted(unknown.profile, std::ranges::less_equal{}, &infer::ProfilePoint::at),
           place + "/profile", "must have rising values");
  }

  void check_point(const infer::DesignPoint& point, const std::string& place) const {
    expect(point.at.size(), report_->unknowns.size(), place + "/at", "unknown");
    expect(point.counts.size(), report_->tests.size() + report_->candidates.size(), place + "/counts", "condition");
    for (std::size_t c = 0; c < point.counts.size(); ++c) {
      expect(point.counts[c].size(), report_->groups.size(), place + "/counts/" + std::to_string(c), "group");
    }
  }

  void expect(bool holds, const std::string& place, const std::string& reason) const {
    if (!holds) place_->problems->push_back({place_->pointer + '/' + place, "", reason, ""});
  }
  void expect(std::size_t size, std::size_t right, const std::string& place, const char* of_each) const {
    expect(size == right, place,
           "has " + std::to_string(size) + " entries, but must have " + std::to_string(right) + ", one for each " +
               of_each);
  }

  const InferReport* report_;
  const ReadingPlace* place_;
};

}  // namespace

void check_infer_report(const InferReport& report, const ReadingPlace& place) {
  check_input(report.input, place.at("input"));
  AnswerCheck(report, place).check();
  try {
    static_cast<void>(tests_of(report));
  } catch (const base::InputError& error) {
    place.problems->insert(place.problems->end(), error.problems().begin(), error.problems().end());
  }
}

namespace {

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
  const auto is_same = [](const auto& a, const auto& b) { return a.parameters == b.parameters; };
  const auto is_same_test = [&](const ReportedTests& a, const ReportedTests& b) {
    return is_same(a, b) && a.counts == b.counts;
  };
  if (!std::ranges::equal(asked.tests, earlier.tests, is_same_test)) differ("/tests");
  if (!std::ranges::equal(asked.candidates, earlier.candidates, is_same)) differ("/candidates");
  return earlier.design;
}

}  // namespace rocking
