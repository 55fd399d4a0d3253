#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rocking/studies/comparison/question.hpp"

namespace rocking {

class Store;

/// The first condition that has another record of a suite in the second experiment; the two have as many conditions.
[[nodiscard]] std::optional<std::size_t> condition_with_other_record(const Experiment& first, const Experiment& second);

/// Compares realisations of equal key. One entry for each condition; `confidences` has one number for each. The caller
/// makes sure that the two runs have the same seed and records: only then do equal keys mean common random numbers.
[[nodiscard]] std::vector<ConditionComparison> compare(const Store& first, const Store& second,
                                                       std::span<const double> confidences);

/// McNemar tests in a comparison: one for each mode of each condition.
[[nodiscard]] std::size_t number_of_tests(std::span<const ConditionComparison> conditions);

}  // namespace rocking
