#pragma once

namespace rocking {

/// Values of a parameter within which orbits are followed: low < high.
struct ParameterRange {
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double value(double q) const { return low + q * (high - low); }
  [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

}  // namespace rocking
