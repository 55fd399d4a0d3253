#pragma once

#include <variant>

namespace rocking {

/// e is dynamics::inelastic_rate_ratio of each block. Source: Jeong & Yang (2012) Eq. 25.
struct Jy25Restitution {
  friend bool operator==(const Jy25Restitution&, const Jy25Restitution&) = default;
};

/// The ratio abs(w2/w1) of the tilt rates across an impact without slip, as it is measured on a block that goes on over
/// its other edge [-]. e follows from each block: dynamics::restitution_of_rate_ratio.
struct RateRatio {
  double value = 1.0;
  friend bool operator==(const RateRatio&, const RateRatio&) = default;
};

/// The mean of the vertical restitution e of an impact [-], or what it follows from.
using Restitution = std::variant<double, Jy25Restitution, RateRatio>;

}  // namespace rocking
