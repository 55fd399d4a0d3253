#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/infer/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const InferRequest*);

[[nodiscard]] const Study& infer_study();

}  // namespace rocking
