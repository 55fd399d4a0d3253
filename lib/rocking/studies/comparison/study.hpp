#pragma once

#include <cstddef>
#include <span>

#include "rocking/fields/document.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/studies/comparison/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

class Store;

/// A run, and what it is called.
struct ComparedRun {
  const Experiment& experiment;
  std::string name;
};

/// Why two runs have no common random numbers; absent: they have.
[[nodiscard]] std::optional<base::Problem> why_not_comparable(const ComparedRun& first, const ComparedRun& second);

/// Compares realisations of equal key. One entry for each condition; `confidences` has one number for each. The caller
/// makes sure that the two runs have the same seed and records: only then do equal keys mean common random numbers.
[[nodiscard]] std::vector<ConditionComparison> compare(const Store& first, const Store& second,
                                                       std::span<const double> confidences);

/// McNemar tests in a comparison: one for each mode of each condition.
[[nodiscard]] std::size_t number_of_tests(std::span<const ConditionComparison> conditions);

[[nodiscard]] const StructType& fields_of(const Comparison*);

/// The output of `rocking compare --json`.
[[nodiscard]] const DocumentOf<Comparison>& comparison_document();

/// The comparison of two runs with their experiments, which have the same number of conditions.
[[nodiscard]] Comparison comparison_of(const Experiment& first, const Experiment& second,
                                       std::vector<ConditionComparison> conditions);

[[nodiscard]] const Study& comparison_study();

}  // namespace rocking
