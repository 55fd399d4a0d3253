#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rocking/look/text_table.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/bifurcation/bifurcation.hpp"

namespace rocking {

/// The diagrams of one realisation of an experiment.
struct DrawnDiagrams {
  const Experiment* experiment;
  std::uint64_t realisation;
  std::vector<Diagram> diagrams;
};

/// The strobe points as comma-separated values, one per line: parameter, branch, tilt, tilt_rate, diagram.
[[nodiscard]] std::string bifurcation_csv(const DrawnDiagrams& drawn);

/// Name of the files with all diagrams, without ending.
inline constexpr const char* bifurcation_file = "bifurcation";

/// The points of one diagram, as a table with the columns of `bifurcation_csv`.
struct DiagramTable {
  std::string name;  ///< of its file, without ending
  std::string csv;
};

/// A table for each diagram of a grid; empty if there is only one diagram.
[[nodiscard]] std::vector<DiagramTable> diagram_tables(const DrawnDiagrams& drawn);

/// Names of the files of the diagrams, without ending, by the parameters that are fixed in each:
/// `bifurcation_static_0.35`. `bifurcation` if there is only one.
[[nodiscard]] std::vector<std::string> diagram_names(const Experiment& experiment, std::span<const Diagram> diagrams);

/// The response modes as text: for each diagram where they depend on the start, and a table with a row for each value and
/// a column for each branch. On one screen neighbours with equal response modes are one row, and the first rows are shown.
[[nodiscard]] std::string bifurcation_table(const DrawnDiagrams& drawn, Extent extent = Extent::all);

}  // namespace rocking
