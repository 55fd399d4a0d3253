#include "rocking/studies/infer/check_result.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/output/provenance_fields.hpp"

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

}  // namespace rocking
