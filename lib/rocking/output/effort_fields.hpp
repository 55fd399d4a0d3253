#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/realisation/operation_counts.hpp"

namespace rocking {

/// What was computed for a condition, or for a run.
struct Effort {
  OperationCounts operations;
  Clamps clamps;
};

[[nodiscard]] const StructType& fields_of(const Effort*);

}  // namespace rocking
