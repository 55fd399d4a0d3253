#pragma once

#include "rocking/ensemble/result.hpp"
#include "rocking/fields/struct_type.hpp"

/// How the results of a run stand in documents.
namespace rocking {

[[nodiscard]] const StructType& fields_of(const ConditionResult*);
[[nodiscard]] const StructType& fields_of(const ToleranceSensitivity*);

}  // namespace rocking
