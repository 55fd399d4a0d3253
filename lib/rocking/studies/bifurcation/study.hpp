#pragma once

#include <optional>

#include "rocking/ensemble/run.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/studies/bifurcation/question.hpp"
#include "rocking/study/study.hpp"

/// Bifurcation diagrams: responses against a swept parameter, where several may coexist.
namespace rocking {

/// The conditions of each diagram of an experiment, without branches. Throws base::InputError if there is no sweep, if
/// a value of its first entry is not a number, or if a base motion is recorded (its responses do not repeat).
[[nodiscard]] std::vector<Diagram> diagrams_of(const Experiment& experiment);

/// A step of a bifurcation diagram.
struct ReportedStep {
  double value = 0.0;  ///< of the parameter
  DiagramBranch branch = DiagramBranch::initial;
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

/// The strobe points as comma-separated values, one per line: parameter, branch, tilt, tilt_rate, diagram.
[[nodiscard]] std::string bifurcation_csv(const Experiment& experiment, const std::vector<Diagram>& diagrams);

/// The response modes as text: for each diagram where they depend on the start, and a table with a row for each value and
/// a column for each branch. On one screen neighbours with equal response modes are one row, and the first rows are shown.
[[nodiscard]] std::string bifurcation_table(const Experiment& experiment, const std::vector<Diagram>& diagrams,
                                            Extent extent = Extent::all);

[[nodiscard]] const Study& bifurcation_study();

}  // namespace rocking

namespace rocking::analysis {

/// The figures `bifurcation` of the output of `rocking bifurcation`, one for each diagram: Theta at the strobe against
/// the parameter, with a panel for each way in which steps begin. A small number of points is drawn as markers in the
/// style of their response mode. A large number is drawn as an image whose cells are shaded by the logarithm of their
/// number of points; a single point is clearly visible.
[[nodiscard]] std::vector<Figure> bifurcation_figures(const BifurcationReport& report);

}  // namespace rocking::analysis
