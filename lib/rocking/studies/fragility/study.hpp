#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const FragilityQuestion*);

[[nodiscard]] const Study& fragility_study();

}  // namespace rocking
