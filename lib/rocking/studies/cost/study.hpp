#pragma once

#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/cost/cost.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

/// Realisations that a measurement of cost keeps at most: some hundred bytes each per tolerance until all are measured.
inline constexpr std::uint64_t largest_cost_sample = 100'000;

/// The cost of accuracy in an experiment, and the system on which it was measured.
struct MeasuredCost {
  const Experiment* experiment;
  Cost cost;
  SystemFacts system;
};

/// The same as a file has it.
struct CostReport {
  InputFacts input;
  Cost cost;  ///< of one that was read, without `own`, steps and recommendation
  SystemFacts system;
  std::vector<double> planned_seconds;  ///< processor time of each of `cost.planned`
  std::string recommendation;           ///< in words
};

[[nodiscard]] CostReport cost_report(const MeasuredCost& measured);

[[nodiscard]] const StructType& fields_of(const CostReport*);

/// `cost.json`, and the output of `rocking cost --json`. All but `system` has the same bytes for equal experiment,
/// tolerances and sample.
[[nodiscard]] const DocumentOf<CostReport>& cost_document();

/// The results as text: a row for each tolerance, one for each number of realisations, and the recommendation.
[[nodiscard]] std::string cost_table(const MeasuredCost& measured);

/// The recommendation and its reason: one paragraph.
[[nodiscard]] std::string cost_recommendation(const MeasuredCost& measured);

[[nodiscard]] const StructType& fields_of(const CostQuestion*);

/// Throws as cost() where the question cannot be answered.
void check_question(const Experiment& experiment, const CostQuestion& question);

[[nodiscard]] const Study& cost_study();

}  // namespace rocking

namespace rocking::analysis {

/// Figures of the output of `rocking cost`: `cost_tolerance`, error, changed response modes and time against the
/// tolerance; `work_precision`, error against time; `cost_realisations`, half-widths against time, if anything is
/// random.
[[nodiscard]] std::vector<Figure> cost_figures(const CostReport& report);

}  // namespace rocking::analysis
