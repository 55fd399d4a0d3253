#pragma once

#include <span>
#include <vector>

#include "rocking/study/study.hpp"

/// The list of the studies. Who adds one adds a line to studies.cpp, and its folder to CMakeLists.txt.
namespace rocking {

/// All studies, in the order of `rocking --help`.
[[nodiscard]] std::span<const Study* const> studies();

/// The figures that studies add to those of a run with a suite of ground motions.
[[nodiscard]] std::vector<analysis::Figure> figures_of_studies(const RunShown& run);

}  // namespace rocking
