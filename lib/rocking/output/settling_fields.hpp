#pragma once

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/fields/struct_type.hpp"

namespace rocking {

/// How the settling of a condition stands in documents.
[[nodiscard]] const StructType& fields_of(const SettlingResult*);

}  // namespace rocking
