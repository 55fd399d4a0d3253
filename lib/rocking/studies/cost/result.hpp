#pragma once

#include <string>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/cost/cost.hpp"

namespace rocking {

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

}  // namespace rocking
