#pragma once

#include <optional>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/hazard.hpp"

namespace rocking {

/// What is wrong with a point of a hazard curve.
struct HazardFault {
  double HazardPoint::*number;  ///< of the point
  const char* reason;
  const char* remedy;
};

/// The fault of a point after the one before it, which is null for the first; absent if there is none.
[[nodiscard]] std::optional<HazardFault> fault_of(const HazardPoint& point, const HazardPoint* before);

/// What is wrong with the points of a curve as a whole, which have no fault; absent if nothing is. Its place is the name.
[[nodiscard]] std::optional<base::Problem> problem_of_whole(const HazardCurve& hazard);

/// What is wrong with a curve that was set in C++, at places within `hazard`.
[[nodiscard]] std::vector<base::Problem> problems_of(const HazardCurve& hazard);

}  // namespace rocking
