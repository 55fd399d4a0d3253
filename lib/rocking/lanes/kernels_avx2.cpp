#include "rocking/lanes/units.hpp"

#if defined(__AVX2__) && defined(__FMA__)

#include "rocking/lanes/kernel.hpp"

namespace rocking::lanes {

std::span<const Kernels> avx2_kernels() {
  static constexpr Kernels kernels[] = {kernels_of<2, Pack<4>>("AVX2, pairs")};
  return kernels;
}

}  // namespace rocking::lanes

#else

namespace rocking::lanes {
std::span<const Kernels> avx2_kernels() { return {}; }
}  // namespace rocking::lanes

#endif
