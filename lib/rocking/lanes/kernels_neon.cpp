#include "rocking/lanes/units.hpp"

#if defined(__aarch64__)

#include "rocking/lanes/kernel.hpp"

namespace rocking::lanes {

std::span<const Kernels> neon_kernels() {
  static constexpr Kernels kernels[] = {kernels_of<2, Pack<2>>("NEON, pairs")};
  return kernels;
}

}  // namespace rocking::lanes

#else

namespace rocking::lanes {
std::span<const Kernels> neon_kernels() { return {}; }
}  // namespace rocking::lanes

#endif
