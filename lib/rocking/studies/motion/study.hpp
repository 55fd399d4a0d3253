#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/motion/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const GroundMotionRequest*);

[[nodiscard]] const Study& motion_study();

}  // namespace rocking
