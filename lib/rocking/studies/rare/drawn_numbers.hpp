#pragma once

#include <vector>

#include "rocking/random/branched_draws.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/rare/proposal.hpp"

namespace rocking::rare {

/// What of a scene is random.
struct DrawnNumbers {
  std::vector<random::Source> once;  ///< sources of numbers that a realisation draws once
  bool along_the_way = false;
};
[[nodiscard]] DrawnNumbers drawn_numbers(const Scene& scene);

/// The draws of a realisation with these numbers drawn once, each given by a standard normal number: that of a law that
/// follows from a uniform number is its probability.
[[nodiscard]] random::DrawHistory given_draws(const Scene& scene, const std::vector<random::Source>& once,
                                              const Point& point);

}  // namespace rocking::rare
