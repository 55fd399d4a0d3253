#pragma once

#include "rocking/studies/comparison/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const Study& comparison_study();

}  // namespace rocking
