#pragma once

#include <string>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/comparison/comparison.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const Comparison*);

/// The output of `rocking compare --json`.
[[nodiscard]] const DocumentOf<Comparison>& comparison_document();

/// The comparison of two runs with their experiments, which have the same number of conditions.
[[nodiscard]] Comparison comparison_of(const Experiment& first, const Experiment& second,
                                       std::vector<ConditionComparison> conditions);

/// The comparison as text: differences between the experiments, how many realisations changed their response mode, and a row
/// for each condition and mode; on one screen the rows of smallest p. `first`: the experiment of the first run.
[[nodiscard]] std::string comparison_table(const Comparison& found, const Experiment& first,
                                           Extent extent = Extent::all);

}  // namespace rocking
