#include "rocking/scene/experiment.hpp"

#include <algorithm>

namespace rocking {
namespace {

/// Drawn lengths are truncated to their bounds.
Reach reach_of_length(const Quantity& length) {
  if (!is_drawn(length)) return reach_of(length);
  const auto [least, largest] = reach_of(length);
  return {.least = std::clamp(least, least_length, largest_length),
          .largest = std::clamp(largest, least_length, largest_length)};
}

}  // namespace

dynamics::Block mean_of(const SceneBlock& block) {
  return {.width = mean_of(block.width), .height = mean_of(block.height), .gravity = block.gravity};
}

ShapeRange shapes_of(const SceneBlock& block) {
  const Reach width = reach_of_length(block.width);
  const Reach height = reach_of_length(block.height);
  return {
      .most_slender = dynamics::geometry_of({.width = width.least, .height = height.largest, .gravity = block.gravity}),
      .squattest = dynamics::geometry_of({.width = width.largest, .height = height.least, .gravity = block.gravity})};
}

SizeRange sizes_of(const SceneBlock& block) {
  const Reach width = reach_of_length(block.width);
  const Reach height = reach_of_length(block.height);
  return {
      .smallest = dynamics::geometry_of({.width = width.least, .height = height.least, .gravity = block.gravity}),
      .largest = dynamics::geometry_of({.width = width.largest, .height = height.largest, .gravity = block.gravity})};
}

}  // namespace rocking
