#include "rocking/lanes/kernel.hpp"
#include "rocking/lanes/units.hpp"

namespace rocking::lanes {

std::span<const Kernels> one_lane_kernels() {
  static constexpr Kernels kernels[] = {kernels_of<1, double>("one lane")};
  return kernels;
}

}  // namespace rocking::lanes
