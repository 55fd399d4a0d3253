#pragma once

#include <optional>
#include <string>

#include "rocking/fields/document.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/threshold/question.hpp"
#include "rocking/study/study.hpp"

/// Thresholds: where in a range of one number a block overturns or has another event.
namespace rocking {

struct ThresholdReport {
  InputFacts input;
  ThresholdStudy study;
};

[[nodiscard]] const StructType& fields_of(const ThresholdQuestion*);
[[nodiscard]] const StructType& fields_of(const ThresholdReport*);

/// Throws as thresholds() where the question cannot be answered.
void check_question(const Experiment& experiment, const ThresholdQuestion& question);

/// `threshold.json`, and the output of `rocking threshold --json`. Equal input gives equal bytes.
[[nodiscard]] const DocumentOf<ThresholdReport>& threshold_document();

/// `overturns`, or `overturns with a probability above 50 %`. `degrees`: in_degrees() of the event.
[[nodiscard]] std::string what_happens(const ThresholdQuestion& question, const std::string& degrees = "");

/// The answer in a sentence, and a row for each band.
[[nodiscard]] std::string threshold_table(const ThresholdStudy& study, Extent extent = Extent::all);

[[nodiscard]] const Study& threshold_study();

}  // namespace rocking

namespace rocking::analysis {

/// The figure `threshold`: the bands as areas over another swept number, with a panel for each combination of the rest, and
/// the threshold as a line. Absent where no other number takes several values.
[[nodiscard]] std::optional<Figure> threshold_figure(const ThresholdReport& report);

}  // namespace rocking::analysis
