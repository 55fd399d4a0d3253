#include "rocking/lanes/kernels.hpp"

#include <vector>

#include "rocking/lanes/units.hpp"

namespace rocking::lanes {
namespace {

std::vector<Kernels> those_that_run_here() {
  std::vector<Kernels> all;
  const auto add = [&all](std::span<const Kernels> kernels) { all.insert(all.end(), kernels.begin(), kernels.end()); };
  add(one_lane_kernels());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) add(avx2_kernels());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
    add(avx512_kernels());
  }
#endif
  add(neon_kernels());  // part of every such processor
  return all;
}

}  // namespace

std::span<const Kernels> available_kernels() {
  static const std::vector<Kernels> kernels = those_that_run_here();
  return kernels;
}

}  // namespace rocking::lanes
