#pragma once

#include "rocking/dynamics/block.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking {

/// Bounds of a width and of a height [m].
inline constexpr double least_length = 1e-6;
inline constexpr double largest_length = 1e6;

/// Asked for: a rigid rectangular block of uniform density. Each realisation draws its own width and height where they
/// have laws, and truncates them to the bounds.
struct SceneBlock {
  Quantity width = 1.0;   ///< B [m]
  Quantity height = 4.0;  ///< H [m]
  double gravity = 9.81;  ///< g [m/s^2]
};

/// Two shapes between which every block of a scene lies.
struct ShapeRange {
  dynamics::Geometry most_slender;  ///< smallest B/H
  dynamics::Geometry squattest;     ///< largest B/H
};

/// Two sizes between which every block of a scene lies.
struct SizeRange {
  dynamics::Geometry smallest;  ///< smallest R
  dynamics::Geometry largest;   ///< largest R
};

/// The block with the mean width and the mean height.
[[nodiscard]] dynamics::Block mean_of(const SceneBlock& block);

[[nodiscard]] ShapeRange shapes_of(const SceneBlock& block);
[[nodiscard]] SizeRange sizes_of(const SceneBlock& block);

}  // namespace rocking
