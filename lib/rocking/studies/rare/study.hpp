#pragma once

#include "rocking/base/digest.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/studies/rare/rare.hpp"
#include "rocking/studies/rare/summarise.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

/// The probability of a rare event for a condition.
struct ReportedRare {
  std::vector<Parameter> parameters;
  double confidence = 0.95;  ///< of the interval
  RareEstimate estimate;
};

/// The probabilities of a rare event for the conditions of an experiment.
struct RareReport {
  InputFacts input;
  RareQuestion question;
  std::uint64_t seed = 0;
  std::vector<ReportedRare> conditions;
  std::vector<RareSuite> suites;

  /// Over the bits of the levels and of every repetition's estimate and work, in order.
  [[nodiscard]] base::Sha256 digest() const;
};

[[nodiscard]] RareReport rare_report(const Experiment& experiment, const RareQuestion& question,
                                     const std::vector<RareEstimate>& found);

/// The estimates of an earlier report by condition, of whose repetitions `asked` wants more. Throws base::InputError if it
/// is not of the same experiment, event or number of particles.
[[nodiscard]] std::vector<RareEstimate> estimates_for(const RareReport& asked, const RareReport& earlier);

[[nodiscard]] const StructType& fields_of(const RareReport*);

/// `rare.json`, and the output of `rocking rare --json`.
[[nodiscard]] const DocumentOf<RareReport>& rare_document();

/// The probabilities as text: a row for each condition, and what is to be known about them. `degrees`: in_degrees() of the
/// event.
[[nodiscard]] std::string rare_table(const RareReport& report, const std::string& degrees = "");

[[nodiscard]] const StructType& fields_of(const RareQuestion*);

/// Throws as rare_probabilities() where the question cannot be answered.
void check_question(const Experiment& experiment, const RareQuestion& question);

/// The same as in question.hpp; where it may keep what is finished, it returns that when it is asked to stop.
[[nodiscard]] std::vector<RareEstimate> rare_probabilities(const Experiment& experiment, const RareQuestion& question,
                                                           const Execution& execution, const KeepRare& keep);

/// Checks the `rare.json` of a folder, which must follow from its repetitions: makes the pilot runs and about `sample`
/// repetitions again, evenly spaced, at least one of each condition; absent: four of each. `checked` and `different`
/// count repetitions. Uses the execution as verify() and throws as it does.
[[nodiscard]] RunCheck verify_rare(const std::filesystem::path& folder, std::optional<std::uint64_t> sample = {},
                                   const Execution& execution = {});

[[nodiscard]] const Study& rare_study();

}  // namespace rocking

namespace rocking::analysis {

/// How a rare event happens when it does: the committor, the probability of the event from each point of the Poincare
/// plane, with the strobe points of a few paths; and the tilt of these paths against time. A panel for each condition,
/// at most six. Empty where there is nothing to draw.
[[nodiscard]] std::vector<Figure> rare_figures(const RareReport& report);

}  // namespace rocking::analysis
