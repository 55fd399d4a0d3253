#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/check_normal/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const SamplerQuestion*);

[[nodiscard]] const Study& check_normal_study();

}  // namespace rocking
