#pragma once

#include "rocking/scene/quantity.hpp"

namespace rocking::infer {

/// Logarithm of the density of a law at a value, up to a constant; minus infinity outside of it.
///
/// Throws std::invalid_argument for a number and for single values, which have no density.
[[nodiscard]] double log_density(const Quantity& law, double value);

}  // namespace rocking::infer
