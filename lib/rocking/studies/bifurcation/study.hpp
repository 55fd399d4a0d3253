#pragma once

#include "rocking/studies/bifurcation/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

[[nodiscard]] const Study& bifurcation_study();

}  // namespace rocking
