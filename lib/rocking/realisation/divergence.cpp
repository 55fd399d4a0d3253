#include "rocking/realisation/divergence.hpp"

#include <algorithm>
#include <cstddef>

namespace rocking {

std::optional<std::int64_t> divergence_period(const RealisationResult& a, const RealisationResult& b) {
  constexpr double apart = 0.01;
  const std::size_t common = std::min(a.strobe.size(), b.strobe.size());
  for (std::size_t k = 0; k < common; ++k) {
    const double tilt = a.strobe[k].tilt - b.strobe[k].tilt;
    const double rate = a.strobe[k].tilt_rate - b.strobe[k].tilt_rate;
    if (tilt * tilt + rate * rate > apart * apart) return static_cast<std::int64_t>(k) + 1;
  }
  if (a.strobe.size() != b.strobe.size()) return static_cast<std::int64_t>(common) + 1;
  return std::nullopt;
}

}  // namespace rocking
