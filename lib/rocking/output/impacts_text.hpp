#pragma once

#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// A block and its restitution as a report has them.
struct ReportedImpact {
  dynamics::Geometry block;  ///< the mean one
  Json restitution;          ///< as in a canonical experiment
};

/// What impacts leave of the tilt rate, in a sentence (RateRatios).
[[nodiscard]] std::string impacts_text(const std::vector<ReportedImpact>& impacts);

}  // namespace rocking
