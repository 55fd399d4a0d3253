#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/orbits/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const StructType& fields_of(const OrbitsRequest*);

[[nodiscard]] const Study& orbits_study();

}  // namespace rocking
