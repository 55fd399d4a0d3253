#pragma once

#include <string>
#include <vector>

#include "rocking/text/json.hpp"

namespace rocking {

/// A block and its restitution as a report has them.
struct ReportedImpact {
  double width_m;
  double height_m;
  Json restitution;  ///< as in a canonical experiment
};

/// What impacts leave of the tilt rate, in a sentence (RateRatios).
[[nodiscard]] std::string impacts_text(const std::vector<ReportedImpact>& impacts);

}  // namespace rocking
