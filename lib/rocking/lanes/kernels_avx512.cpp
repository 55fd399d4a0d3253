#include "rocking/lanes/units.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__)

#include "rocking/lanes/kernel.hpp"

namespace rocking::lanes {

std::span<const Kernels> avx512_kernels() {
  static constexpr Kernels kernels[] = {kernels_of<2, Pack<8>>("AVX-512, pairs")};
  return kernels;
}

}  // namespace rocking::lanes

#else

namespace rocking::lanes {
std::span<const Kernels> avx512_kernels() { return {}; }
}  // namespace rocking::lanes

#endif
