#pragma once

#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/infer/infer.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

/// An unknown, and what the tests say of it. Without an answer nothing.
struct ReportedUnknown {
  std::string parameter;
  double from = 0.0;
  double to = 0.0;
  std::optional<double> estimate = std::nullopt;
  std::optional<stats::Interval> interval = std::nullopt;
  std::optional<ReachedBound> reaches = std::nullopt;
  std::vector<infer::ProfilePoint> profile = {};
  std::optional<UnknownPosterior> posterior = std::nullopt;
};

/// A tested condition: counts by group, and the shares at the estimate.
struct ReportedTests {
  std::vector<Parameter> parameters;
  std::vector<std::uint64_t> counts;
  std::vector<double> predicted;
  std::vector<stats::Interval> intervals;
};

struct ReportedCandidate {
  std::vector<Parameter> parameters;
  std::optional<double> region = std::nullopt;
  std::vector<double> deviations;
};

/// Why the tests cannot tell an unknown; empty: they can tell all.
struct Identified {
  std::string reason_why_not;
};

/// The answer of counted tests.
struct InferReport {
  InputFacts input;
  std::uint64_t seed = 0;
  double confidence = 0.95;
  std::uint64_t next_tests = 5;
  std::vector<ReportedUnknown> unknowns = {};
  Identified identified = {};
  std::optional<double> log_likelihood = {};
  std::optional<InferenceFit> fit = {};
  std::optional<double> region_limit = {};
  std::vector<infer::RegionPoint> region = {};
  std::vector<std::string> groups = {};
  std::vector<ReportedTests> tests = {};
  std::vector<ReportedCandidate> candidates = {};
  std::uint64_t realisations = 0;
  InferEnd end = InferEnd::settled;
  std::vector<infer::DesignPoint> design = {};
};

[[nodiscard]] InferReport infer_report(const Experiment& experiment, const CountedTests& tests,
                                       std::uint64_t next_tests, const Inference& found);

/// The tests of a report. Throws base::InputError for a name that no group of response modes has.
[[nodiscard]] CountedTests tests_of(const InferReport& report);

/// The design of an earlier report, of which `asked` wants more. Throws base::InputError if it is not of the same
/// experiment and tests.
[[nodiscard]] std::vector<infer::DesignPoint> design_for(const InferReport& asked, const InferReport& earlier);

[[nodiscard]] const StructType& fields_of(const InferReport*);

/// `infer.json`, and the output of `rocking infer --json`.
[[nodiscard]] const DocumentOf<InferReport>& infer_document();

/// The answer as text.
[[nodiscard]] std::string infer_table(const InferReport& report);

/// Reports lists that do not have one entry for each unknown, condition or group, groups that are none of response
/// modes, and a part of an answer.
void check_infer_report(const InferReport& report, const ReadingPlace& place);

}  // namespace rocking

/// Words that the table and the figures of an inference share. All need an answer.
namespace rocking {

/// `peak ground acceleration PGA [g]: 0.23 [0.2, 0.26]`; `at most 0.16` where the interval begins with the range.
[[nodiscard]] std::string answer_in_words(const ReportedUnknown& unknown);

/// Whether the counts are usual at the estimate, so that the intervals mean something.
[[nodiscard]] bool explains_counts(const InferReport& report);

/// `deviance 5.7, p = 0.58: the estimate explains the counts`.
[[nodiscard]] std::string fit_in_words(const InferReport& report);

/// That the errors of the realisations, which may be alike in all conditions, outweigh the tests in the limits of the intervals
/// and of the region (lib/docs/infer.md), and how many realisations would do. Absent: they do not, or there is no design.
[[nodiscard]] std::optional<std::string> too_few_realisations(const InferReport& report);

/// Whether the tests can tell the unknowns: `no, these tests cannot tell: ...`.
[[nodiscard]] std::string identified_in_words(const InferReport& report);

[[nodiscard]] const StructType& fields_of(const InferQuestion*);

/// Throws as infer_unknowns() where an experiment, or a question about it, cannot be answered.
void check_infer(const Experiment& experiment);
void check_question(const Experiment& experiment, const InferQuestion& question);

/// The question with the tests of its files.
[[nodiscard]] InferQuestion with_tests(const Experiment& experiment, InferQuestion question, const FileSource& files);

/// The same as in question.hpp, of tests that have been read; where it may keep points, it returns those that are finished
/// when it is asked to stop, without an answer.
[[nodiscard]] Inference infer_unknowns(const Experiment& experiment, const InferQuestion& question,
                                       const Execution& execution, const KeepDesign& keep);

/// Checks the `infer.json` of a folder, whose answer must follow from its design: makes about `sample` points of the
/// design again, evenly spaced; absent: eight. `checked` and `different` count points. Which points a design has is not
/// checked. Uses the execution as verify() and throws as it does.
[[nodiscard]] RunCheck verify_infer(const std::filesystem::path& folder, std::optional<std::uint64_t> sample,
                                    const Execution& execution);

[[nodiscard]] const Study& infer_study();

}  // namespace rocking

namespace rocking::analysis {

/// Counted shares of the groups of response modes beside those that the estimate predicts; a panel for each of the
/// first 48 tested conditions. Needs an answer.
[[nodiscard]] Figure fit_figure(const InferReport& report);

/// By how much tests under each candidate condition are expected to narrow the region and each unknown. Needs an
/// answer; nothing without candidates.
[[nodiscard]] std::optional<Figure> candidates_figure(const InferReport& report);

/// What counted tests say of unknown numbers: the likelihood of each, their joint region, whether the estimate explains
/// the counts, and which test would tell most. Empty without an answer.
[[nodiscard]] std::vector<Figure> infer_figures(const InferReport& report);

}  // namespace rocking::analysis
