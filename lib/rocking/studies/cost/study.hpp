#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/cost/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const CostRequest*);

[[nodiscard]] const Study& cost_study();

}  // namespace rocking
