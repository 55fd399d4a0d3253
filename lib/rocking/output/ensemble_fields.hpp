#pragma once

#include "rocking/ensemble/result.hpp"
#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/realisation/measures.hpp"

/// How the results of a run stand in documents.
namespace rocking {

[[nodiscard]] const StructType& fields_of(const ConditionResult*);
[[nodiscard]] const StructType& fields_of(const ToleranceSensitivity*);

/// Overturning to one side.
[[nodiscard]] const StructType& fields_of(const SideEstimate*);

/// What was computed for a condition, or for a run.
struct Effort {
  OperationCounts operations;
  Clamps clamps;
};

[[nodiscard]] const StructType& fields_of(const Effort*);

// A list of estimates (std::vector<ModeEstimate>) stands in a document as two objects by response mode.

/// Response mode to count.
[[nodiscard]] const ValueType& mode_counts_type();

/// Response mode to estimate and intervals; read after the counts.
[[nodiscard]] const ValueType& mode_probabilities_type();

/// How the settling of a condition stands in documents.
[[nodiscard]] const StructType& fields_of(const SettlingResult*);

}  // namespace rocking
