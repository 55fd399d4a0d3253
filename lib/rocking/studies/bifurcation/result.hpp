#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/studies/bifurcation/bifurcation.hpp"

namespace rocking {

/// A step of a bifurcation diagram.
struct ReportedStep {
  double value = 0.0;  ///< of the parameter
  Branch branch = Branch::initial;
  DiagramStep step;
  std::optional<Shaking> shaking;
};

struct ReportedDiagram {
  std::vector<Parameter> others;    ///< values of the other entries of the sweep
  std::vector<ReportedStep> steps;  ///< by branch, then by increasing value
};

/// The bifurcation diagrams of one realisation of an experiment.
struct BifurcationReport {
  InputFacts input;
  std::uint64_t realisation = 0;
  std::string parameter;  ///< JSON pointer of the swept number
  std::vector<ReportedDiagram> diagrams;
};

[[nodiscard]] BifurcationReport bifurcation_report(const Experiment& experiment, std::uint64_t realisation,
                                                   const std::vector<Diagram>& diagrams);

[[nodiscard]] const StructType& fields_of(const BifurcationReport*);

/// `bifurcation.json`, and the output of `rocking bifurcation --json`. Equal input gives equal bytes.
[[nodiscard]] const DocumentOf<BifurcationReport>& bifurcation_document();

}  // namespace rocking
