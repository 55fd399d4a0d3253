#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/rare/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const RareRequest*);

[[nodiscard]] const Study& rare_study();

}  // namespace rocking
