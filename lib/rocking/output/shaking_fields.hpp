#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/scene/shaking.hpp"

namespace rocking {

/// How a shaking stands in documents: the keys that the experiment gives, and the numbers in every unit.
[[nodiscard]] const StructType& fields_of(const Shaking*);

}  // namespace rocking
