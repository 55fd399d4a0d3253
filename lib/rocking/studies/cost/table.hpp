#pragma once

#include <string>

#include "rocking/studies/cost/result.hpp"

namespace rocking {

/// The results as text: a row for each tolerance, one for each number of realisations, and the recommendation.
[[nodiscard]] std::string cost_table(const MeasuredCost& measured);

/// The recommendation and its reason: one paragraph.
[[nodiscard]] std::string cost_recommendation(const MeasuredCost& measured);

}  // namespace rocking
